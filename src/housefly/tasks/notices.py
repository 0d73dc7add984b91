"""What people want to be told once: kept until it is due, or for a day."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from threading import Lock

from housefly.tasks.intents.intent_reply import Notice

_MAX = 50
_KEPT_FOR = 86400.0
"""A notice that nothing made due for so long is forgotten [s]."""


class Notices:
    """The notices that wait; thread-safe. They do not outlive the process."""

    def __init__(self) -> None:
        self._waiting: deque[tuple[float, Notice]] = deque(maxlen=_MAX)
        self._lock = Lock()

    def add(self, notice: Notice, now: float) -> None:
        """Keep a notice from now on [Unix time, s]; of too many the oldest is dropped."""
        with self._lock:
            self._waiting.append((now, notice))

    def due(self, kind: str, thing: str) -> tuple[str, ...]:
        """Return what is to be said about an event of the room, once."""
        return self._taken(lambda since, notice: notice.is_due(kind, thing))

    def due_at(self, now: float) -> tuple[str, ...]:
        """Return what is to be said because it is time [Unix time, s], once."""
        words = self._taken(lambda since, notice: notice.is_due_at(now))
        self._taken(lambda since, notice: now - since > _KEPT_FOR and notice.at is None)
        return words

    def _taken(self, is_due: Callable[[float, Notice], bool]) -> tuple[str, ...]:
        with self._lock:
            due = [entry for entry in self._waiting if is_due(*entry)]
            for entry in due:
                self._waiting.remove(entry)
        return tuple(notice.words for _, notice in due)
