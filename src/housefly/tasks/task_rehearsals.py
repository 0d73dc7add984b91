"""Rehearsals under way: begun in the background, looked at each tick."""

from __future__ import annotations

import logging
from concurrent.futures import Future

from housefly.errors import HouseflyError, TaskError
from housefly.tasks.api.values import ReasonCode, RehearsalReport
from housefly.tasks.document.task_document import BoundTask
from housefly.tasks.task_outlet import TaskRehearser
from housefly.tasks.task_record import TaskRecord

_log = logging.getLogger(__name__)

FRESH_TIME = 20.0
"""A rehearsal older than this [s] is done again before the flight: the room may have changed."""
ATTEMPTS = 3
"""So often is a rehearsal tried that could not be done at all: the first one after a start may have
to wait until everything is loaded.
"""
_PATIENCE = 30.0
"""Longest wait for a rehearsal that somebody asked for by itself [s]."""


class TaskRehearsals:
    """Begins rehearsals and takes their reports.

    Args:
        rehearser: flies in lock step, elsewhere.
    """

    def __init__(self, rehearser: TaskRehearser) -> None:
        self._rehearser = rehearser

    def begin(self, record: TaskRecord) -> None:
        """Begin the rehearsal of a task, unless one is under way."""
        if record.rehearsal is None:
            record.rehearsal = self._begun(record.task)

    def taken(self, record: TaskRecord, unix: float) -> RehearsalReport | None:
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
        if report.code is ReasonCode.NOT_READY and record.attempts % ATTEMPTS:
            self.begin(record)
            return None
        record.rehearsed_at = unix
        return report

    def is_fresh(self, record: TaskRecord, unix: float) -> bool:
        """Return whether the newest rehearsal still counts."""
        return 0.0 <= unix - record.rehearsed_at <= FRESH_TIME

    def now(self, task: BoundTask) -> RehearsalReport:
        """Rehearse and wait; raises TaskError when it takes too long."""
        future = self._begun(task)
        try:
            future.exception(_PATIENCE)
        except TimeoutError as error:
            raise TaskError(
                f"the rehearsal takes longer than {_PATIENCE:.0f} s; ask again later",
                ReasonCode.NOT_READY.value,
            ) from error
        return report_of(future)

    def _begun(self, task: BoundTask) -> Future[RehearsalReport]:
        try:
            return self._rehearser.rehearse(task)
        except Exception as error:
            failed: Future[RehearsalReport] = Future()
            failed.set_exception(error)
            return failed


def report_of(future: Future[RehearsalReport]) -> RehearsalReport:
    """Return what a finished rehearsal found; one that failed lets nothing fly."""
    error = future.exception()
    if error is None:
        return future.result()
    if isinstance(error, TaskError):
        return RehearsalReport(False, ReasonCode(error.code), str(error))
    _log.error("a rehearsal failed", exc_info=error)
    words = str(error) if isinstance(error, HouseflyError) else type(error).__name__
    return RehearsalReport(
        False, ReasonCode.NOT_READY, f"it could not be rehearsed ({words}), so it does not fly"
    )
