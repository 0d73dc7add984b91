"""Questions and requests that come over MQTT: checked, and asked of a person before they fly."""

from __future__ import annotations

import json

from housefly.config.tasks import TasksConfig
from housefly.errors import WireError
from housefly.tasks.api.questions import TaskQuestion
from housefly.tasks.api.values import RequestSurface
from housefly.tasks.rules.outside_question import outside_question
from housefly.tasks.rules.trigger import MAX_MQTT_PAYLOAD
from housefly.wires.devices import task_topic

REQUEST = "request"
"""Last level of the topic of requests; a client's own has its name behind it."""
ANSWER = "answer"
"""Last level of the topic of answers."""


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
    name = client_of(topic)
    return outside_question(
        json.dumps({"ask": "request", **tree}),
        by=f"MQTT client {name}" if name else "somebody on MQTT",
        owner=f"mqtt {name}",
        surface=RequestSurface.MQTT,
        is_trusted=config.mqtt_requests == "auto",
    )


def client_of(topic: str) -> str:
    """Return the name of the client whose topic this is, "" for the topic of all."""
    level = topic.rsplit("/", 1)[-1]
    return "" if level == REQUEST else level
