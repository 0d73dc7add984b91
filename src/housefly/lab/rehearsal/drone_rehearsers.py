"""The rehearsals of several drones: each has a worker of its own, started when it is needed."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Future
from threading import Lock

from housefly.lab.rehearsal.rehearser import Rehearser
from housefly.tasks.api.values import RehearsalReport
from housefly.tasks.document.task_document import BoundTask


class DroneRehearsers:
    """Hands each rehearsal to the worker of its drone; thread-safe.

    Args:
        starts: start the rehearsals of a drone, by its name; at least one.
    """

    def __init__(self, starts: Mapping[str, Callable[[], Rehearser]]) -> None:
        self._starts, self._lock = starts, Lock()
        self._first = next(iter(starts))
        self._running: dict[str, Rehearser] = {}

    def start(self) -> None:
        """Start the first drone's worker, so that its first rehearsal need not wait."""
        self._of(self._first)

    def rehearse(self, task: BoundTask, drone: str) -> Future[RehearsalReport]:
        """Begin a rehearsal with a drone, "" for the first, in the room as it is now."""
        return self._of(drone or self._first).rehearse(task)

    def rehearse_ahead(self, tasks: Sequence[BoundTask]) -> None:
        """Rehearse what may be asked for at any moment, with the first drone; see ``Rehearser``."""
        self._of(self._first).rehearse_ahead(tasks)

    def close(self) -> None:
        """End all workers."""
        with self._lock:
            for rehearser in self._running.values():
                rehearser.close()

    def _of(self, drone: str) -> Rehearser:
        with self._lock:
            if drone not in self._running:
                self._running[drone] = self._starts[drone]()
            return self._running[drone]
