"""Rehearsals: one at a time, flights first, people before machines, and never too many."""

from __future__ import annotations

import threading
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path

import pytest
from task_stage import GOOD, TaskStage

from housefly.errors import TaskError
from housefly.tasks.api.questions import BoardQuestion, RehearseTask
from housefly.tasks.api.values import RehearsalReport, RequestSurface
from housefly.tasks.document.library import BoundTask, bind, load_library
from housefly.tasks.engine.task_record import TaskRecord
from housefly.tasks.engine.task_rehearsals import (
    STANDALONE_MAX,
    RehearsalQueue,
    RehearsalUrgency,
    TaskRehearsals,
)

LIBRARY = load_library()
FLIGHT, PERSON, MACHINE = RehearsalUrgency


def task(place: str) -> BoundTask:
    return bind(LIBRARY["look"], {"subject": place})


class OneByOne:
    """Rehearses when a test says so."""

    def __init__(self) -> None:
        self.begun: list[tuple[str, Future[RehearsalReport]]] = []
        self.changed = threading.Event()

    def rehearse(self, task: BoundTask, drone: str) -> Future[RehearsalReport]:
        found: Future[RehearsalReport] = Future()
        self.begun.append((str(task.parameters["subject"]), found))
        self.changed.set()
        return found

    @property
    def order(self) -> list[str]:
        return [name for name, _ in self.begun]

    def end(self) -> None:
        self.begun[-1][1].set_result(GOOD)


def test_flights_go_first_then_people_then_machines_one_at_a_time() -> None:
    rehearser = OneByOne()
    queue = RehearsalQueue(rehearser)
    for name, urgency in (("a", MACHINE), ("b", MACHINE), ("c", PERSON), ("d", FLIGHT)):
        queue.begin(task(name), urgency)
    assert rehearser.order == ["a"]
    for _ in range(3):
        rehearser.end()
    assert rehearser.order == ["a", "d", "c", "b"]


def test_what_is_wanted_more_urgently_later_is_rehearsed_once() -> None:
    rehearser = OneByOne()
    queue = RehearsalQueue(rehearser)
    reports = {name: queue.begin(task(name), MACHINE) for name in "abc"}
    queue.move_to_front(task("c"), reports["c"])
    for _ in range(3):
        rehearser.end()
    assert rehearser.order == ["a", "c", "b"]
    assert all(report.result(0.0) == GOOD for report in reports.values())


def test_what_nobody_waits_for_any_more_is_not_rehearsed() -> None:
    rehearser = OneByOne()
    queue = RehearsalQueue(rehearser)
    reports = [queue.begin(task(name), MACHINE) for name in "abc"]
    assert reports[1].cancel() and not reports[0].cancel()
    rehearser.end()
    assert rehearser.order == ["a", "c"]


def test_a_rehearser_that_breaks_holds_up_no_other() -> None:
    class Broken:
        def rehearse(self, task: BoundTask, drone: str) -> Future[RehearsalReport]:
            raise RuntimeError

    queue = RehearsalQueue(Broken())
    for _ in "ab":
        assert isinstance(queue.begin(task("a"), FLIGHT).exception(0.0), RuntimeError)


def waiting(ready: Callable[[], bool]) -> None:
    deadline = threading.Event()
    for _ in range(1000):
        if ready():
            return
        deadline.wait(0.01)
    raise AssertionError


@pytest.mark.parametrize("machines", [0, 5])
def test_so_many_ask_for_rehearsals_at_once_and_a_flight_goes_first(machines: int) -> None:
    rehearser = OneByOne()
    rehearsals = TaskRehearsals(rehearser)
    surfaces = [RequestSurface.MQTT] * machines + [RequestSurface.HTTP] * 5
    with ThreadPoolExecutor(len(surfaces)) as threads:
        asked = []
        for surface in surfaces:
            asked.append(threads.submit(rehearsals.rehearse_and_wait, task(surface.value), surface))
            waiting(lambda: rehearsals.standalone == sum(not one.done() for one in asked))
        refused = [one for one in asked if one.done()]
        assert len(asked) - len(refused) == STANDALONE_MAX
        for one in refused:
            error = one.exception()
            assert isinstance(error, TaskError) and error.code == "rate_limit"
            assert "ask again" in str(error)
        record = TaskRecord(task("flight"))
        rehearsals.begin(record)
        rehearser.end()
        assert rehearser.order[1] == "flight"
        for _ in range(STANDALONE_MAX):
            rehearser.end()
        for one in asked:
            if one not in refused:
                assert one.result(10.0) == GOOD
        assert rehearser.order.count("mqtt") == min(machines, 1)
    assert rehearsals.standalone == 0


def test_many_rehearsals_hold_up_no_other_question(tmp_path: Path) -> None:
    stage = TaskStage(tmp_path, hub__enabled=False)
    stage.rehearsals.is_slow = True
    question = RehearseTask("look", {"subject": "sofa"})
    with ThreadPoolExecutor(6) as answerers:  # as many as the bus has
        asked = [answerers.submit(stage.ask, question) for _ in range(60)]
        board = answerers.submit(stage.ask, BoardQuestion())
        assert board.result(10.0).tasks == ()
        waiting(lambda: sum(one.done() for one in asked) == 60 - STANDALONE_MAX)
        waiting(lambda: bool(stage.rehearsals.finish() or all(one.done() for one in asked)))
    codes = [error.code for one in asked if isinstance(error := one.exception(), TaskError)]
    assert codes == ["rate_limit"] * (60 - STANDALONE_MAX)
    stage.close()
