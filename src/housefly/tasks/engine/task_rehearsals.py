"""Rehearsals under way: begun in the background one at a time, looked at each tick."""

from __future__ import annotations

import heapq
import logging
from collections.abc import Callable
from concurrent.futures import CancelledError, Future
from enum import IntEnum
from itertools import count
from threading import Lock
from typing import NamedTuple

from housefly.errors import HouseflyError, TaskError
from housefly.messages.words import Words, error_words, literal
from housefly.tasks.api.values import ATTENDED, ReasonCode, RehearsalReport, RequestSurface
from housefly.tasks.document.task_document import BoundTask
from housefly.tasks.engine.task_outlet import TaskRehearser
from housefly.tasks.engine.task_record import TaskRecord

_log = logging.getLogger(__name__)

REHEARSAL_VALID_TIME = 20.0
"""A rehearsal older than this [s] is done again before the flight: the room may have changed."""
ATTEMPTS_MAX = 3
"""So often is a rehearsal tried that could not be done at all: its worker may have died."""
_WAIT_MAX = 30.0
"""Longest wait for a rehearsal that somebody asked for by itself [s]."""
STANDALONE_MAX, STANDALONE_OF_MACHINES_MAX = 3, 1
"""So many rehearsals asked for by themselves wait or go on at once, and of those so many that no
person asked for.
"""

PendingReport = Future[RehearsalReport]


class RehearsalUrgency(IntEnum):
    """Who waits for a rehearsal; the smaller goes first."""

    FLIGHT = 0
    PERSON = 1
    MACHINE = 2


class TaskRehearsals:
    """Begins rehearsals and takes their reports.

    Args:
        rehearser: flies in lock step, elsewhere.
    """

    def __init__(self, rehearser: TaskRehearser) -> None:
        self._queue, self._lock = RehearsalQueue(rehearser), Lock()
        self._standalone: list[RehearsalUrgency] = []

    @property
    def standalone(self) -> int:
        """How many that were asked for by themselves wait or go on."""
        with self._lock:
            return len(self._standalone)

    def begin(
        self, record: TaskRecord, urgency: RehearsalUrgency = RehearsalUrgency.FLIGHT
    ) -> None:
        """Begin the rehearsal of a task; one that waits already may become the next."""
        if record.rehearsal is None:
            record.rehearsal = self._queue.begin(record.task, urgency, record.drone)
        elif urgency is RehearsalUrgency.FLIGHT:
            self._queue.move_to_front(record.task, record.rehearsal)

    def take_report(self, record: TaskRecord, unix: float) -> RehearsalReport | None:
        """Return what a rehearsal found, once; None while it goes on.

        Args:
            record: of the task.
            unix: Unix time [s].
        """
        future = record.rehearsal
        if future is None or not future.done():
            return None
        report = report_of(future)
        record.rehearsal = None
        record.attempts += 1
        if report.code is ReasonCode.NOT_READY and record.attempts % ATTEMPTS_MAX:
            self.begin(record)
            return None
        record.rehearsed_at = unix
        return report

    def is_fresh(self, record: TaskRecord, unix: float) -> bool:
        """Return whether the newest rehearsal still counts."""
        return 0.0 <= unix - record.rehearsed_at <= REHEARSAL_VALID_TIME

    def rehearse_and_wait(
        self,
        task: BoundTask,
        surface: RequestSurface = RequestSurface.CONSOLE,
        drone: str = "",
    ) -> RehearsalReport:
        """Rehearse and wait.

        Args:
            task: which.
            surface: where it was asked for.
            drone: with which; "" for any.

        Raises:
            TaskError: too many are under way, or it takes too long.
        """
        is_person = surface in ATTENDED
        urgency = RehearsalUrgency.PERSON if is_person else RehearsalUrgency.MACHINE
        self._admit(urgency)
        future = self._queue.begin(task, urgency, drone)
        try:
            future.exception(_WAIT_MAX)
        except TimeoutError as error:
            future.cancel()
            raise TaskError(
                f"the rehearsal takes longer than {_WAIT_MAX:.0f} s; ask again later",
                ReasonCode.NOT_READY.value,
            ) from error
        finally:
            with self._lock:
                self._standalone.remove(urgency)
        return report_of(future)

    def _admit(self, urgency: RehearsalUrgency) -> None:
        """Count one more that was asked for by itself; raises TaskError where that is too many."""
        with self._lock:
            machines = self._standalone.count(RehearsalUrgency.MACHINE)
            is_machine = urgency is RehearsalUrgency.MACHINE
            if len(self._standalone) >= STANDALONE_MAX or (
                is_machine and machines >= STANDALONE_OF_MACHINES_MAX
            ):
                raise TaskError(
                    f"{len(self._standalone)} rehearsals are under way; ask again in a few seconds",
                    ReasonCode.RATE_LIMIT.value,
                )
            self._standalone.append(urgency)


def report_of(future: Future[RehearsalReport]) -> RehearsalReport:
    """Return what a finished rehearsal found; one that failed lets nothing fly."""
    try:
        error = future.exception()
    except CancelledError as cancelled:
        error = cancelled
    if error is None:
        return future.result()
    if isinstance(error, TaskError):
        return RehearsalReport(False, ReasonCode(error.code), error_words(error))
    _log.error("a rehearsal failed", exc_info=error)
    is_ours = isinstance(error, HouseflyError)
    why = error_words(error) if is_ours else literal(type(error).__name__)
    return RehearsalReport(
        False,
        ReasonCode.NOT_READY,
        Words("it could not be rehearsed ({why}), so it does not fly", why=why),
    )


class _Waiting(NamedTuple):
    """A rehearsal that waits for its turn; the smallest urgency and order goes first.

    ``report`` is what its caller holds.
    """

    urgency: int
    order: int
    task: BoundTask
    drone: str
    report: PendingReport


class RehearsalQueue:
    """Hands rehearsals to the rehearser one by one; thread-safe.

    Args:
        rehearser: flies in lock step, elsewhere.
    """

    def __init__(self, rehearser: TaskRehearser) -> None:
        self._rehearser, self._lock = rehearser, Lock()
        self._order = count()
        self._waiting: list[_Waiting] = []
        self._is_busy = False

    def begin(self, task: BoundTask, urgency: RehearsalUrgency, drone: str = "") -> PendingReport:
        """Return the report to come; cancelled before its turn, it is not rehearsed at all."""
        report: PendingReport = Future()
        self._add(task, urgency, drone, report)
        return report

    def move_to_front(self, task: BoundTask, report: PendingReport) -> None:
        """Let a rehearsal that waits be the next."""
        with self._lock:
            found = next(
                (one for one in self._waiting if one.report is report and one.urgency), None
            )
        if found is not None:
            self._add(task, RehearsalUrgency.FLIGHT, found.drone, report)

    def _add(
        self, task: BoundTask, urgency: RehearsalUrgency, drone: str, report: PendingReport
    ) -> None:
        with self._lock:
            waiting = _Waiting(urgency, next(self._order), task, drone, report)
            heapq.heappush(self._waiting, waiting)
        self._begin_next()

    def _begin_next(self) -> None:
        while True:
            with self._lock:
                if self._is_busy or not self._waiting:
                    return
                _, _, task, drone, report = heapq.heappop(self._waiting)
                # One that was hurried stands here twice; one that nobody waits for is cancelled.
                if report.running() or report.done() or not report.set_running_or_notify_cancel():
                    continue
                self._is_busy = True
            _begin_safely(self._rehearser.rehearse, task, drone).add_done_callback(
                lambda found, report=report: self._deliver(found, report)  # type: ignore[misc]
            )

    def _deliver(self, found: PendingReport, report: PendingReport) -> None:
        error = found.exception()
        if error is None:
            report.set_result(found.result())
        else:
            report.set_exception(error)
        with self._lock:
            self._is_busy = False
        self._begin_next()


def _begin_safely(
    rehearse: Callable[[BoundTask, str], PendingReport], task: BoundTask, drone: str
) -> PendingReport:
    try:
        return rehearse(task, drone)
    except Exception as error:
        failed: PendingReport = Future()
        failed.set_exception(error)
        return failed
