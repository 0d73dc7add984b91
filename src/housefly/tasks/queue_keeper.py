"""Keeps what changes in the queue, also over a disk that refuses for a while."""

from __future__ import annotations

import logging
from collections.abc import Iterable

from housefly.errors import StoreError
from housefly.tasks.scheduler.task_store import KeptTask, TaskStore

_log = logging.getLogger(__name__)


class QueueKeeper:
    """Writes tasks to their store; a disk that refuses ends no flight, it is told in the log.

    Args:
        store: of the queue.

    Attributes:
        problem: why the queue cannot be kept, in words, or "".
    """

    def __init__(self, store: TaskStore) -> None:
        self.problem = ""
        self._store = store
        self._unsaved: dict[int, KeptTask] = {}

    def keep(self, tasks: Iterable[KeptTask]) -> None:
        """Keep tasks, with all that was refused before."""
        self._unsaved |= {kept.task.id: kept for kept in tasks}
        try:
            self._store.save(list(self._unsaved.values()))
            self.problem, self._unsaved = "", {}
        except StoreError as error:
            if str(error) != self.problem:
                _log.error("the queue is not kept: %s", error)
            self.problem = str(error)

    def retry(self) -> None:
        """Keep what was refused, as soon as there is room."""
        if self._unsaved:
            self.keep(())
