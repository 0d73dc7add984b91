"""A thread that writes to the disk, so that nobody else ever waits for it."""

from __future__ import annotations

import logging
import threading
from collections import deque
from collections.abc import Callable

_LOG = logging.getLogger(__name__)

Job = Callable[[], None]


class WriterThread:
    """Does jobs one after the other.

    Args:
        waiting_max: jobs that may wait; of the droppable ones one more is refused.
    """

    def __init__(self, waiting_max: int) -> None:
        self._waiting_max = waiting_max
        self._jobs: deque[Job] = deque()
        self._wake = threading.Condition()
        self._is_busy, self._is_ending = False, False
        self._thread = threading.Thread(target=self._work, name="evidence", daemon=True)
        self._thread.start()

    def put(self, job: Job, *, droppable: bool = False) -> bool:
        """Do a job soon and return True, or False when too many wait already."""
        with self._wake:
            if self._is_ending or (droppable and len(self._jobs) >= self._waiting_max):
                return False
            self._jobs.append(job)
            self._wake.notify_all()
        return True

    def flush(self, timeout: float) -> bool:
        """Wait until every job is done; False when it takes longer [s]."""
        with self._wake:
            return self._wake.wait_for(lambda: not (self._jobs or self._is_busy), timeout)

    def close(self, timeout: float) -> None:
        """Do what waits, for at most so long [s], then end."""
        with self._wake:
            self._is_ending = True
            self._wake.notify_all()
        self._thread.join(timeout)

    def _work(self) -> None:
        while (job := self._next()) is not None:
            try:
                job()
            except Exception:  # the thread must outlive whatever one clip does to it
                _LOG.exception("a clip or snapshot could not be written")
            with self._wake:
                self._is_busy = False
                self._wake.notify_all()

    def _next(self) -> Job | None:
        with self._wake:
            self._wake.wait_for(lambda: self._jobs or self._is_ending)
            if not self._jobs:
                return None
            self._is_busy = True
            return self._jobs.popleft()
