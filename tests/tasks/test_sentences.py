"""Sentences of somebody who may only ask, said to the whole task service."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from task_stage import TaskStage

from housefly.messages import OrderKind
from housefly.tasks.api.questions import BoardQuestion, RequestTask, Sentence, SetMode
from housefly.tasks.api.values import HouseMode
from housefly.tasks.api.values import TaskStage as Stage
from housefly.tasks.execution.step_inbox import is_of_task


@pytest.fixture
def stage(tmp_path: Path) -> Iterator[TaskStage]:
    stage = TaskStage(tmp_path)
    yield stage
    stage.close()


@pytest.mark.parametrize(
    "text", ["come home", "wait", "go on", "cancel", "set the house to home", "we are back"]
)
def test_who_may_not_fly_changes_nothing_by_a_sentence(stage: TaskStage, text: str) -> None:
    stage.ask(RequestTask("look", {"subject": "refrigerator"}, by="kim"))
    stage.ask(SetMode(HouseMode.AWAY, "kim"))
    before = stage.ask(BoardQuestion())
    answer = stage.ask(Sentence(text, by="eve", may_fly=False))
    assert answer.understood and "may fly" in answer.words
    after = stage.ask(BoardQuestion())
    assert (after.mode, after.tasks, after.ended) == (before.mode, before.tasks, before.ended)
    assert stage.orders == []


@pytest.mark.parametrize(("text", "kind"), [("stop", OrderKind.STOP), ("land", OrderKind.LAND)])
def test_who_may_not_fly_stops_and_lands(stage: TaskStage, text: str, kind: OrderKind) -> None:
    stage.stand()
    stage.ask(Sentence(text, by="eve", may_fly=False))
    assert [order.kind for order in stage.orders] == [kind]


def test_who_may_not_fly_ends_his_own_task(stage: TaskStage) -> None:
    for name, subject in (("kim", "refrigerator"), ("eve", "sofa")):
        stage.ask(RequestTask("look", {"subject": subject}, by=name))
    answer = stage.ask(Sentence("cancel", by="eve", may_fly=False))
    assert answer.task is not None and answer.task.asked_by == "eve"
    assert answer.task.state is Stage.CANCELLED
    assert [task.asked_by for task in stage.ask(BoardQuestion()).tasks] == ["kim"]


def test_no_name_makes_the_order_of_a_sentence_one_of_a_task(stage: TaskStage) -> None:
    stage.stand()
    stage.ask(Sentence("come home", by="task 1: look"))
    (order,) = stage.orders
    assert order.kind is OrderKind.HOME and not is_of_task(order)
