"""Which rehearsal is next: one at a time, what flies before who only asks, people first."""

from __future__ import annotations

import heapq
from collections.abc import Callable
from concurrent.futures import Future
from enum import IntEnum
from itertools import count
from threading import Lock

from housefly.tasks.api.values import RehearsalReport
from housefly.tasks.document.task_document import BoundTask
from housefly.tasks.task_outlet import TaskRehearser

Report = Future[RehearsalReport]


class RehearsalUrgency(IntEnum):
    """Who waits for a rehearsal; the smaller goes first."""

    FLIGHT = 0
    PERSON = 1
    MACHINE = 2


class RehearsalTurns:
    """Hands rehearsals to the rehearser one by one; thread-safe.

    Args:
        rehearser: flies in lock step, elsewhere.
    """

    def __init__(self, rehearser: TaskRehearser) -> None:
        self._rehearser, self._lock = rehearser, Lock()
        self._number = count()
        self._waiting: list[tuple[int, int, BoundTask, str, Report]] = []
        self._is_busy = False

    def begin(self, task: BoundTask, urgency: RehearsalUrgency, drone: str = "") -> Report:
        """Return the report to come; cancelled before its turn, it is not rehearsed at all."""
        report: Report = Future()
        self._add(task, urgency, drone, report)
        return report

    def hurry(self, task: BoundTask, report: Report) -> None:
        """Let a rehearsal that waits be the next."""
        with self._lock:
            found = next((one for one in self._waiting if one[4] is report and one[0]), None)
        if found is not None:
            self._add(task, RehearsalUrgency.FLIGHT, found[3], report)

    def _add(self, task: BoundTask, urgency: RehearsalUrgency, drone: str, report: Report) -> None:
        with self._lock:
            heapq.heappush(self._waiting, (urgency, next(self._number), task, drone, report))
        self._next()

    def _next(self) -> None:
        while True:
            with self._lock:
                if self._is_busy or not self._waiting:
                    return
                _, _, task, drone, report = heapq.heappop(self._waiting)
                # One that was hurried stands here twice; one that nobody waits for is cancelled.
                if report.running() or report.done() or not report.set_running_or_notify_cancel():
                    continue
                self._is_busy = True
            _begun(self._rehearser.rehearse, task, drone).add_done_callback(
                lambda found, report=report: self._ended(found, report)  # type: ignore[misc]
            )

    def _ended(self, found: Report, report: Report) -> None:
        error = found.exception()
        if error is None:
            report.set_result(found.result())
        else:
            report.set_exception(error)
        with self._lock:
            self._is_busy = False
        self._next()


def _begun(rehearse: Callable[[BoundTask, str], Report], task: BoundTask, drone: str) -> Report:
    try:
        return rehearse(task, drone)
    except Exception as error:
        failed: Report = Future()
        failed.set_exception(error)
        return failed
