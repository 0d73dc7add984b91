"""Counts what was dropped and why, and words it."""

from __future__ import annotations

from collections import Counter, deque
from threading import Lock

from housefly.hub.store.backlog import Dropped

_RECENT = 60.0
"""Period of the report [s]."""

_Counts = Counter[tuple[str, str]]
"""Numbers of rows by table ("poses", "events") and reason."""


class Losses:
    """What was dropped in the last minute, and in total."""

    def __init__(self) -> None:
        self.ever: _Counts = Counter()
        self._recent: deque[tuple[float, _Counts]] = deque()
        self._lock = Lock()

    def count(self, dropped: Dropped, reason: str, now: float) -> None:
        """Count rows that were dropped at a monotonic time [s]."""
        counts = Counter({("poses", reason): dropped.poses, ("events", reason): dropped.events})
        with self._lock:
            self.ever += counts
            if self._recent and int(self._recent[-1][0]) == int(now):
                self._recent[-1][1].update(counts)
            else:
                self._recent.append((now, counts))
            self._forget(now)

    def words(self, now: float) -> str:
        """Return the losses of the last minute in words, "" if none.

        For example "dropped 1 200 poses in the last minute: disk is full".
        """
        with self._lock:
            self._forget(now)
            recent: _Counts = sum((counts for _, counts in self._recent), Counter())
        parts = [
            f"{count:,} {rows}".replace(",", " ") + f" in the last minute: {reason}"
            for (rows, reason), count in recent.items()
        ]
        return f"dropped {', '.join(parts)}" if parts else ""

    def _forget(self, now: float) -> None:
        while self._recent and self._recent[0][0] < now - _RECENT:
            self._recent.popleft()
