"""Who asks, how often and in whose name: attacks on the queue of the whole service."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from task_stage import TaskStage

from housefly.config.tasks import TasksConfig
from housefly.errors import TaskError
from housefly.messages import OrderKind
from housefly.tasks.api.json import task_question_to_json
from housefly.tasks.api.questions import (
    BoardQuestion,
    CancelTask,
    RehearseTask,
    ReplyToTask,
    RequestTask,
    Sentence,
    TaskHistoryQuestion,
)
from housefly.tasks.api.values import ReasonCode, RequestSurface
from housefly.tasks.api.values import TaskStage as Stage
from housefly.tasks.rules.mqtt_requests import mqtt_question

MQTT, ASSISTANT, ROS = RequestSurface.MQTT, RequestSurface.ASSISTANT, RequestSurface.ROS
TOPIC = "housefly/bsen/task/request"


@pytest.fixture
def stage(tmp_path: Path) -> Iterator[TaskStage]:
    stage = TaskStage(tmp_path, hub__enabled=False)
    yield stage
    stage.close()


def look(time: float, surface: RequestSurface = RequestSurface.CONSOLE, **more: str) -> RequestTask:
    return RequestTask("look", {"subject": "sofa", "time": time}, surface=surface, **more)  # type: ignore[arg-type]


def refusals(stage: TaskStage, questions: list[RequestTask]) -> list[TaskError]:
    found = []
    for question in questions:
        try:
            stage.ask(question)
        except TaskError as error:
            found.append(error)
    return found


@pytest.mark.parametrize("surface", [MQTT, ASSISTANT, ROS])
def test_a_flood_of_requests_leaves_room_for_people_and_hides_no_history(
    stage: TaskStage, surface: RequestSurface
) -> None:
    own = stage.ask(look(30.0, by="kim")).tasks[0]
    codes = {
        error.code for error in refusals(stage, [look(1 + k / 100, surface) for k in range(1000)])
    }
    assert codes == {"queue_full", "rate_limit"}
    assert stage.ask(look(20.0, by="kim")).tasks[0].state is Stage.QUEUED
    board = stage.ask(BoardQuestion())
    assert len([task for task in board.tasks if task.surface is surface]) == 5
    assert own.id in {task.id for task in board.tasks}
    assert len(stage.ask(TaskHistoryQuestion(limit=1000)).tasks) <= 2 + 20


def test_stop_is_never_too_much(stage: TaskStage) -> None:
    stage.stand()
    refusals(stage, [look(1 + k / 10, MQTT) for k in range(100)])
    with pytest.raises(TaskError) as caught:
        stage.ask(Sentence("look at the sofa", surface=MQTT))
    assert caught.value.code == "rate_limit" and "wait" in str(caught.value)
    stage.ask(Sentence("STOP", surface=MQTT))
    assert [order.kind for order in stage.orders] == [OrderKind.STOP]
    stage.stand(10.0)
    assert stage.ask(Sentence("where is the sofa", surface=MQTT)).understood


def test_who_has_the_same_name_ends_nothing_of_somebody_else(stage: TaskStage) -> None:
    first = stage.ask(look(1.0, by="kim", owner="browser 1")).tasks[0].id
    second = stage.ask(look(2.0, by="kim", owner="browser 2")).tasks[0].id
    for number in (first, 0):
        with pytest.raises(TaskError, match="only what you asked for") as caught:
            stage.ask(CancelTask(number, "kim", only_of="browser 3"))
        assert caught.value.code == ReasonCode.NOT_ALLOWED.value
    for owner in ("", "browser 3"):
        answer = stage.ask(Sentence("cancel", by="kim", may_fly=False, owner=owner))
        assert answer.task is None and answer.code is ReasonCode.NOT_ALLOWED
    assert len(stage.ask(BoardQuestion()).tasks) == 2
    answer = stage.ask(Sentence("cancel", by="kim", may_fly=False, owner="browser 2"))
    assert answer.task is not None and answer.task.id == second
    assert stage.ask(CancelTask(0, "kim", only_of="browser 1")).tasks[0].id == first


def test_who_gives_himself_the_name_of_a_machine_is_none(stage: TaskStage) -> None:
    stage.ask(look(1.0, by="somebody on MQTT", owner="browser 1"))
    said = mqtt_question(TOPIC, b'{"ask": "sentence", "text": "cancel"}', TasksConfig())
    assert stage.ask(said).task is None
    assert len(stage.ask(BoardQuestion()).tasks) == 1


@pytest.mark.parametrize(
    "text",
    [
        b'{"service": "look", "owner": "browser 1", "by": "kim", "surface": "console"}',
        b'{"ask": "sentence", "text": "go and see", "owner": "browser 1", "may_fly": true}',
        b'{"ask": "rehearse", "service": "visitor", "surface": "console"}',
    ],
)
def test_no_message_says_for_somebody_else_who_asks(text: bytes) -> None:
    question = mqtt_question(TOPIC, text, TasksConfig())
    assert getattr(question, "surface") is MQTT  # noqa: B009
    assert getattr(question, "owner", "mqtt ") == "mqtt "


def test_the_same_answer_from_two_phones_counts_once(stage: TaskStage) -> None:
    stage.stand()
    number = stage.ask(look(1.0, ASSISTANT)).tasks[0].id
    assert stage.ask(ReplyToTask(number, "confirm", "yes", "ann")).tasks[0].words == "ann said yes"
    for choice in ("yes", "no"):
        with pytest.raises(TaskError, match="asks nothing now"):
            stage.ask(ReplyToTask(number, "confirm", choice, "bob"))
    stage.stand()
    assert stage.task(number).state is Stage.RUNNING and len(stage.orders) == 1


def test_an_answer_after_the_request_was_withdrawn_starts_nothing(stage: TaskStage) -> None:
    stage.stand()
    number = stage.ask(look(1.0, ASSISTANT)).tasks[0].id
    stage.ask(CancelTask(number, "an assistant"))
    with pytest.raises(TaskError, match="no open task") as caught:
        stage.ask(ReplyToTask(number, "confirm", "yes", "kim"))
    assert caught.value.code == "unknown_task"
    stage.stand(2.0)
    assert stage.orders == [] and stage.task(number).state is Stage.CANCELLED


@pytest.mark.parametrize("nested", ["[" * 5000 + "]" * 5000, '{"a":' * 5000 + "1" + "}" * 5000])
def test_deep_and_large_questions_are_refused_in_words(stage: TaskStage, nested: str) -> None:
    for text in (nested, f'{{"ask": "request", "service": {nested}}}', '"' + "x" * 10**6 + '"'):
        assert '"error"' in stage.service.answer(text)
    wrong = task_question_to_json(RehearseTask("look")).replace('"look"', "[1]")
    assert '"error"' in stage.service.answer(wrong)
