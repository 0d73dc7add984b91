"""Documents of somebody in a hurry: each is refused in words, or flown to a defined end."""

from __future__ import annotations

import pytest
from scripted_pilot import Flight, ScriptedPilot, ScriptedRoom, view

from housefly.errors import TaskError
from housefly.messages import OrderKind, Phase
from housefly.tasks.api.values import ReasonCode, TaskStage
from housefly.tasks.document.binding import bind
from housefly.tasks.document.document_parser import read_task
from housefly.tasks.execution.task_run import TaskRun


def flight(text: str) -> Flight:
    known = ScriptedRoom({"fridge": view("fridge", 2.0, 1.0), "tv": view("tv", -1.0, 2.0)})
    return Flight(TaskRun(bind(read_task(f"name: odd\n{text}\n", "odd.yaml"), {}), known),
                  ScriptedPilot())  # fmt: skip


@pytest.mark.parametrize(
    ("steps", "line", "words"),
    [
        ("  - repeat: 0\n    do: [take_off]", 3, "times: allowed: 1 to 1000"),
        ("  - parallel:\n      - look_at: fridge\n      - [{parallel: [{go_to: tv}, {wait: 1 s}]}]",
         3, "only one of the parallel steps may move the drone"),
        ("  - wait: -1 s", 3, "time: allowed: 0 to 86400 s"),
        ("  []", 2, "expected a list of steps"),
    ],
)  # fmt: skip
def test_what_makes_no_sense_is_refused_with_its_line(steps: str, line: int, words: str) -> None:
    with pytest.raises(TaskError) as caught:
        flight(f"steps:\n{steps}")
    assert f"odd.yaml, line {line}: " in str(caught.value) and words in str(caught.value)


@pytest.mark.parametrize(
    ("steps", "code", "words"),
    [
        ("  - timeout: 500 ms\n    do: [take_off]\n  - land", ReasonCode.TIMEOUT, "0.5 s"),
        ("  - take_off:\n    timeout: 0.2 s", ReasonCode.TIMEOUT, "longer than 0.2 s"),
        ("  - timeout: 3 s\n    do: [{look_at: fridge}, {wait: 1 h}]\n"
         "    otherwise: [{timeout: 1 s, do: [{look_at: tv}]}]", ReasonCode.TIMEOUT, "1 s"),
        ("  - parallel: [{ask: {question: Well, wait: 9 s}}, {look_at: fridge}]",
         ReasonCode.OK, "done"),
        ("  - parallel: [{ask: {question: Well, wait: 9 s}}, {look_at: moon}]",
         ReasonCode.UNKNOWN_THING, "moon"),
        ("  - take_off\n  - parallel: [{record: 2 s}, {record: 3 s}, {look_at: tv}]",
         ReasonCode.OK, "done"),
        ("  - take_off\n  - land\n  - land\n  - return_home\n  - take_off", ReasonCode.OK, "done"),
        ("  - timeout: 0.3 s\n    do: [take_off]\n    may_fail: true\n  - take_off",
         ReasonCode.OK, "done"),
    ],
)  # fmt: skip
def test_what_is_only_odd_ends_on_the_pad(steps: str, code: ReasonCode, words: str) -> None:
    flown = flight(f"steps:\n{steps}").fly()
    for _ in range(20):
        flown.tick()
    assert flown.run.code is code and words in flown.run.words
    assert flown.stands_on_pad()


@pytest.mark.parametrize(
    "on_cancel",
    [
        "[{ask: {question: Sure, wait: 30 min, as: sure}}, {wait: 1 h}]",
        "[{repeat: 1000, do: [{look_at: fridge}, {look_at: tv}]}]",
        "[{retry: 10, do: [{look_at: moon}]}]",
        "[land, take_off, {look_at: tv}, {wait: 1 h}]",
        "[return_home, {wait: 1 h}]",
    ],
)
def test_whatever_is_done_on_a_cancel_ends_on_the_ground(on_cancel: str) -> None:
    flown = flight(f"steps:\n  - look_at: fridge\n  - wait: 1 h\non_cancel: {on_cancel}")
    for _ in range(60):
        flown.tick()
    flown.run.cancel("enough")
    lands = on_cancel.startswith("[land")
    began = flown.pilot.now
    flown.fly(1500)
    assert flown.run.stage is TaskStage.CANCELLED and flown.pilot.now - began < 80.0
    assert flown.pilot.phase is Phase.IDLE and flown.stands_on_pad() is not lands
    if lands:
        assert not any(order.kind is OrderKind.TAKE_OFF for order in flown.orders)
