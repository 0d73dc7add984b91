from __future__ import annotations

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.tasks import TasksConfig
from housefly.errors import TaskError, WireError
from housefly.tasks.api.questions import CancelTask, RequestTask, Sentence
from housefly.tasks.api.values import Confirm, Priority, RequestSurface
from housefly.tasks.rules.mqtt_requests import mqtt_question, request_topics

TOPIC = "housefly/home/task/request"
ASK = TasksConfig()
AUTO = TasksConfig(mqtt_requests="auto", mqtt_clients=("panel",))


def question(text: str, config: TasksConfig = ASK, topic: str = TOPIC) -> object:
    return mqtt_question(topic, text.encode(), config)


def test_a_request_is_asked_of_a_person_whatever_it_says_of_itself() -> None:
    told = {
        "service": "look",
        "parameters": {"subject": "sofa"},
        "by": "the owner",
        "surface": "console",
        "confirm": "auto",
        "cause": "rule:bell",
        "priority": "alarm",
    }
    found = question(json.dumps(told))
    assert isinstance(found, RequestTask)
    assert (found.service, found.parameters) == ("look", {"subject": "sofa"})
    assert (found.by, found.surface) == ("somebody on MQTT", RequestSurface.MQTT)
    assert (found.confirm, found.priority) == (Confirm.ASK, Priority.PERSON)
    assert found.cause == "mqtt"


def test_a_client_that_the_site_trusts_flies_without_a_question() -> None:
    topic = f"{TOPIC}/panel"
    found = question('{"service": "look"}', AUTO, topic)
    assert isinstance(found, RequestTask)
    assert (found.by, found.confirm) == ("MQTT client panel", Confirm.AUTO)
    asked = question('{"service": "look", "confirm": "ask"}', AUTO, topic)
    assert isinstance(asked, RequestTask) and asked.confirm is Confirm.ASK


def test_trust_needs_names() -> None:
    with pytest.raises(ValueError, match="mqtt_clients"):
        TasksConfig(mqtt_requests="auto")
    assert request_topics("home", AUTO) == (f"{TOPIC}/panel",)
    assert request_topics("home", ASK) == (TOPIC,)
    assert request_topics("home", TasksConfig(mqtt_requests="off")) == ()


def test_a_sentence_and_a_cancellation_come_in_the_name_of_the_client() -> None:
    told = {"ask": "sentence", "text": "fly now", "by": "me", "confirm": "auto", "may_fly": True}
    said = question(json.dumps(told))
    assert isinstance(said, Sentence) and not said.may_fly
    assert (said.by, said.confirm, said.surface) == (
        "somebody on MQTT",
        Confirm.ASK,
        RequestSurface.MQTT,
    )
    assert question('{"ask": "cancel", "task": 0}') == CancelTask(0, "somebody on MQTT")


@pytest.mark.parametrize(
    "text",
    [
        '{"ask": "reply", "task": 1, "question": "confirm", "choice": "yes"}',
        '{"ask": "mode", "mode": "home"}',
        '{"ask": "webhook", "name": "parcel"}',
        '{"ask": "continue", "task": 1}',
    ],
)
def test_nobody_says_yes_or_sets_a_mode_over_mqtt(text: str) -> None:
    for config in (ASK, AUTO):
        with pytest.raises(TaskError, match="not asked over MQTT"):
            question(text, config)


@pytest.mark.parametrize(
    "text", ["", "fly now", "[]", "1", '{"service": 3}', "{" * 3000, "x" * 5000]
)
def test_what_is_no_request_is_refused_in_words(text: str) -> None:
    with pytest.raises(WireError):
        question(text)


@given(st.binary(max_size=200))
def test_no_bytes_are_anything_but_a_question_or_a_refusal(payload: bytes) -> None:
    try:
        found = mqtt_question(TOPIC, payload, ASK)
    except (WireError, TaskError):
        return
    assert not isinstance(found, RequestTask | Sentence) or found.confirm is Confirm.ASK
