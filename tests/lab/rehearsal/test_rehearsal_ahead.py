"""Rehearsals ahead: they hold in the same room only, and save a bell the wait."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

import pytest
from task_flights import premises, shipped

from housefly.errors import LinkError
from housefly.hub.api.questions import Question
from housefly.lab.rehearsal.rehearsal_ahead import (
    KEPT_TIME,
    RehearsedAhead,
    is_same_room,
    tasks_ahead,
)
from housefly.lab.rehearsal.rehearser import Rehearser
from housefly.lab.rehearsal.room_now import RoomNow
from housefly.messages import Obstacle
from housefly.tasks.api.values import ParameterValue, ReasonCode, RehearsalReport
from housefly.tasks.document.library import bind, read_task
from housefly.tasks.document.task_document import BoundTask
from housefly.tasks.execution.task_room import SeenPerson
from housefly.tasks.rules.rule import Rule

VISITOR = SeenPerson("visitor", (0.85, 4.2, 0.0), (0.0, 0.0), 0.1)
BOX = Obstacle("1", (8.0, 3.3), 0.25, source="laser-1", top=1.5)
STILL = RoomNow(at=10.0, drone=(10.55, 1.25, 0.05), battery=0.9, people=(VISITOR,))
GOOD = RehearsalReport(True, ReasonCode.OK, "it can be flown")
TASK = shipped("look", subject="tv", time=1.0)


@pytest.mark.parametrize(
    "change",
    [
        {"drone": (10.75, 1.25, 0.05)},
        {"drone": None},
        {"yaw": 0.3},
        {"is_airborne": True},
        {"battery": 0.87},
        {"battery": None},
        {"people": ()},
        {"people": (replace(VISITOR, position=(1.05, 4.2, 0.0)),)},
        {"people": (replace(VISITOR, id="person-1"),)},
        {"obstacles": (BOX,)},
        {"at": 10.1 + KEPT_TIME},
        {"at": 9.9},
    ],
    ids=str,
)
def test_a_rehearsal_ahead_holds_in_the_same_room_only(change: Mapping[str, Any]) -> None:
    ahead = RehearsedAhead(TASK, STILL, GOOD)
    assert ahead.holds(TASK, replace(STILL, at=10.0 + KEPT_TIME, battery=0.89))
    assert not ahead.holds(TASK, replace(STILL, **change))
    assert not ahead.holds(shipped("look", subject="tv", time=2.0), STILL)


@pytest.mark.parametrize(
    "change", [{"position": (8.2, 3.3)}, {"radius": 0.4}, {"top": 1.8}, {"id": "2"}], ids=str
)
def test_an_obstacle_that_changed_makes_another_room(change: Mapping[str, Any]) -> None:
    with_box = replace(STILL, obstacles=(BOX,))
    assert is_same_room(with_box, replace(with_box, obstacles=(replace(BOX, seen_at=3.0),)))
    assert not is_same_room(with_box, replace(STILL, obstacles=(replace(BOX, **change),)))


def rule(confirm: str, enabled: bool = True, **parameters: ParameterValue) -> Rule:
    when = {"event": "bell pressed"}
    then = {"service": "visitor", "parameters": parameters}
    tree = {"name": "r", "when": when, "then": then, "confirm": confirm, "enabled": enabled}
    return Rule.model_validate(tree)


def bound(service: str, parameters: Mapping[str, ParameterValue]) -> BoundTask:
    return shipped(service, **parameters)


def test_only_what_flies_unasked_and_is_known_before_is_rehearsed_ahead() -> None:
    rules = (
        rule("auto", stay=10.0),
        rule("ask", stay=20.0),
        rule("auto", enabled=False, stay=30.0),
        rule("auto", door="$event.thing"),
        rule("auto", nonsense="sofa"),
    )
    assert tasks_ahead(rules, bound) == (shipped("visitor", stay=10.0),)


@pytest.mark.parametrize(
    "step",
    [
        "if: {any: [{is: {thing: stove, state: on}}]}\n    then: [{look_at: kitchen}]",
        "wait: {time: 5 s, until: {stale: tv}}",
        "timeout: 9 s\n    do: [check_people]",
        "for_each: every person\n    do: [{look_at: $each}]",
    ],
)
def test_a_task_whose_way_the_memory_decides_is_rehearsed_when_it_is_asked_for(step: str) -> None:
    """What fires the rule may be the very thing that changes the way."""
    text = f"name: t\nsteps:\n  - take_off\n  - {step}\n  - return_home"
    assert tasks_ahead((rule("auto"),), lambda *_: bind(read_task(text), {})) == ()


class House:
    """A room that a test changes, and a memory that knows nothing; one worker rehearses in it."""

    def __init__(self) -> None:
        self.room = STILL
        self.asked: list[Question] = []
        self.rehearser = Rehearser(premises(), lambda: self.room, self.forget, 60.0)

    def forget(self, question: Question) -> Any:
        self.asked.append(question)
        raise LinkError("nobody remembers anything")


@pytest.fixture(scope="module")
def one_house() -> Iterator[House]:
    one = House()
    yield one
    one.rehearser.close()


@pytest.fixture
def house(one_house: House) -> House:
    """Return it as it was; its worker may know what another test asked: each asks its own."""
    one_house.room, one_house.asked = STILL, []
    return one_house


def test_a_still_room_is_rehearsed_ahead_and_the_answer_is_there_at_once(house: House) -> None:
    rehearser = house.rehearser
    rehearser.rehearse_ahead((TASK,))
    assert rehearser.rehearse(TASK).result().took > 0.0, "it was looked at once only"
    rehearser.rehearse_ahead((TASK,))
    deadline = time.monotonic() + 60.0
    while rehearser.rehearse(TASK).result().took and time.monotonic() < deadline:
        pass
    known = rehearser.rehearse(TASK)
    assert known.done() and known.result().may_fly and known.result().took == 0.0
    house.room = replace(STILL, people=())
    assert rehearser.rehearse(TASK).result().took > 0.0, "the visitor has left"


@pytest.mark.interop
def test_what_is_refused_ahead_is_left_alone_for_a_time_and_does_not_hold_up_the_next(
    house: House,
) -> None:
    rehearser = house.rehearser
    refused, other = shipped("look", subject="grandma's cup"), shipped("look", subject="tv")
    for _ in range(8):
        rehearser.rehearse_ahead((refused, other))
        if rehearser.rehearse(other).result().took == 0.0:
            break
    else:
        pytest.fail("what is refused is rehearsed again and again")
    rehearser.rehearse_ahead((refused, other))
    cups = [one for one in house.asked if getattr(one, "thing", "") == "grandma's cup"]
    assert len(cups) == 1
    told = len(house.asked)
    assert not rehearser.rehearse(refused).result().may_fly
    assert len(house.asked) > told, "a refusal is looked at anew"
