"""How many sockets of one kind may be open: in all, and of one session."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field

from housefly.web.http.rate_limit import CommandLimiter

SEATS = 32
"""Sockets of one kind."""
SEATS_OF_ONE = 8
"""Sockets of one kind that one session may hold."""

OPENED_RATE, OPENED_AT_ONCE = 2.0, 24.0
"""Sockets of one kind that one session may open a second, and after a pause at once."""
_SESSIONS_KEPT = 10_000


@dataclass(slots=True)
class Seats:
    """Counts open sockets by session; nobody can hold all of them."""

    most: int = SEATS
    each: int = SEATS_OF_ONE
    _taken: Counter[str] = field(default_factory=Counter)
    _asked: dict[str, CommandLimiter] = field(default_factory=dict)

    @contextmanager
    def taken(self, session: str) -> Iterator[bool]:
        """Take a seat until the block ends; yields False when there is none."""
        free = (
            self._taken.total() < self.most
            and self._taken[session] < self.each
            and self._limiter(session).spend(time.monotonic())
        )
        self._taken[session] += free
        try:
            yield free
        finally:
            self._taken[session] -= free
            if not self._taken[session]:
                del self._taken[session]

    def _limiter(self, session: str) -> CommandLimiter:
        if len(self._asked) > _SESSIONS_KEPT:
            self._asked.clear()
        return self._asked.setdefault(
            session, CommandLimiter(OPENED_AT_ONCE, rate=OPENED_RATE, burst=OPENED_AT_ONCE)
        )
