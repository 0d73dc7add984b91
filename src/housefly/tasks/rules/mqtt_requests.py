"""Questions and requests that come over MQTT: checked, and asked of a person before they fly."""

from __future__ import annotations

import json
from dataclasses import replace

from housefly.config.tasks import TasksConfig
from housefly.errors import TaskError, WireError
from housefly.tasks.api.json import task_question_from_json
from housefly.tasks.api.questions import (
    BoardQuestion,
    CancelTask,
    RehearseTask,
    RequestTask,
    Sentence,
    ServicesQuestion,
    TaskQuestion,
)
from housefly.tasks.api.values import Confirm, Priority, ReasonCode, RequestSurface
from housefly.tasks.rules.trigger import MAX_MQTT_PAYLOAD
from housefly.wires.devices import task_topic

REQUEST = "request"
"""Last level of the topic of requests; a client's own has its name behind it."""
ANSWER = "answer"
"""Last level of the topic of answers."""
_ALLOWED = (RequestTask, RehearseTask, CancelTask, BoardQuestion, ServicesQuestion, Sentence)
"""What may be asked over MQTT: nobody says yes to anything there, and nobody sets a mode."""


def request_topics(site: str, config: TasksConfig) -> tuple[str, ...]:
    """Return the topics on which requests are taken."""
    if config.mqtt_requests == "off":
        return ()
    names = config.mqtt_clients
    return tuple(
        task_topic(site, what) for what in ([f"{REQUEST}/{name}" for name in names] or [REQUEST])
    )


def mqtt_question(topic: str, payload: bytes, config: TasksConfig) -> TaskQuestion:
    """Return what a message on a topic of requests asks, in the name of its client.

    Raises:
        WireError: it is no question.
        TaskError: NOT_ALLOWED here.
    """
    if len(payload) > MAX_MQTT_PAYLOAD:
        raise WireError(f"{len(payload)} bytes; allowed: {MAX_MQTT_PAYLOAD}")
    try:
        tree = json.loads(payload)
    except (ValueError, RecursionError) as error:
        raise WireError("this is no JSON") from error
    if not isinstance(tree, dict):
        raise WireError("this is no JSON object")
    question = task_question_from_json(json.dumps({"ask": "request", **tree}))
    if not isinstance(question, _ALLOWED):
        raise TaskError(f"{question.ask!r} is not asked over MQTT", ReasonCode.NOT_ALLOWED.value)
    name, surface = client_of(topic), RequestSurface.MQTT
    by, owner = f"MQTT client {name}" if name else "somebody on MQTT", f"mqtt {name}"
    confirm = _confirm(question, config) if isinstance(question, RequestTask | Sentence) else None
    match question:
        case RequestTask():
            assert confirm is not None
            # An alarm would take the drone from whoever flies.
            priority = Priority.PERSON if question.priority is Priority.ALARM else question.priority
            return replace(
                question,
                by=by,
                surface=surface,
                cause="mqtt",
                confirm=confirm,
                priority=priority,
                owner=owner,
            )
        case Sentence():
            assert confirm is not None
            told = replace(question, by=by, surface=surface, confirm=confirm)
            return replace(told, may_fly=False, owner=owner)
        case RehearseTask():
            return replace(question, surface=surface)
        case CancelTask():
            return replace(question, by=by, only_of="")
    return question


def client_of(topic: str) -> str:
    """Return the name of the client whose topic this is, "" for the topic of all."""
    level = topic.rsplit("/", 1)[-1]
    return "" if level == REQUEST else level


def _confirm(question: RequestTask | Sentence, config: TasksConfig) -> Confirm:
    is_trusted = config.mqtt_requests == "auto" and question.confirm is Confirm.AUTO
    return Confirm.AUTO if is_trusted else Confirm.ASK
