"""What people want to be told once: kept, also over a restart, until it is due, or for a day."""

from __future__ import annotations

import logging
from collections.abc import Callable
from contextlib import AbstractContextManager
from dataclasses import dataclass

from pydantic import TypeAdapter, ValidationError

from housefly.errors import StoreError
from housefly.tasks.intents.intent_reply import Notice
from housefly.tasks.scheduler.task_store import TaskStore

_log = logging.getLogger(__name__)

MOST, MOST_OF_ONE = 50, 10
"""So many notices wait at all, and so many of one who asked."""
_KEPT_FOR = 86400.0
"""A notice that nothing made due for so long, or that is due for so long, is forgotten [s]."""


@dataclass(frozen=True, slots=True)
class KeptNotice:
    """A notice, who asked for it, and since when it waits [Unix time, s]."""

    since: float
    source: str
    notice: Notice


_KEPT: TypeAdapter[KeptNotice] = TypeAdapter(KeptNotice)


class Notices:
    """The notices that wait; thread-safe.

    Args:
        store: keeps them over a restart.
        lock: guards the store.
        wall: Unix time [s].
    """

    def __init__(
        self, store: TaskStore, lock: AbstractContextManager[object], wall: Callable[[], float]
    ) -> None:
        self._store, self._lock, self._wall = store, lock, wall
        self._waiting = _read(store)

    def add(self, notice: Notice, source: str) -> bool:
        """Keep a notice from now on; False when too many wait already.

        Args:
            notice: what is to be told; the same again is kept once.
            source: who asked for it; nobody takes the room of others.
        """
        with self._lock:
            others = [one for one in self._waiting if (one.notice, one.source) != (notice, source)]
            own = sum(one.source == source for one in others)
            if len(others) >= MOST or own >= MOST_OF_ONE:
                return False
            self._keep([*others, KeptNotice(self._wall(), source, notice)])
            return True

    def due(self, kind: str, thing: str) -> tuple[str, ...]:
        """Return what is to be said about an event of the room, once."""
        return self._taken(lambda one: one.notice.is_due(kind, thing))

    def due_by_time(self) -> tuple[str, ...]:
        """Return what is to be said because it is time, once; forget what is too old."""
        now = self._wall()
        self._taken(lambda one: now - (one.notice.at or one.since) > _KEPT_FOR)
        return self._taken(lambda one: one.notice.is_due_at(now))

    def _taken(self, is_due: Callable[[KeptNotice], bool]) -> tuple[str, ...]:
        with self._lock:
            due = [one for one in self._waiting if is_due(one)]
            if due:
                self._keep([one for one in self._waiting if one not in due])
        return tuple(dict.fromkeys(one.notice.words for one in due))

    def _keep(self, waiting: list[KeptNotice]) -> None:
        self._waiting = waiting
        try:
            self._store.save_notices([_KEPT.dump_json(one).decode() for one in waiting])
        except StoreError as error:  # told all the same, as long as the program runs
            _log.error("what people want to be told is not kept: %s", error)


def _read(store: TaskStore) -> list[KeptNotice]:
    found = []
    for text in store.kept_notices():
        try:
            found.append(_KEPT.validate_json(text))
        except ValidationError:
            _log.error("this is nothing that people want to be told: %s", text[:100])
    return found
