"""What was refused, for the audit log: each one, until somebody is refused too often.

Then it is one line a second, with the number of those before it: a flood neither fills the disk nor
drives what matters out of the file.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from housefly.clock import Clock
from housefly.web.http.rate_limit import CommandLimiter

_RATE, _BURST = 1.0, 10.0
"""Lines a second of one session, and at once after a pause."""
_MAX_KNOWN = 1000
_WORDS_LENGTH = 300
"""A line is cut after so many characters: what was refused may be long."""
_TOO_MANY = "too many commands at once, not read"


@dataclass(slots=True)
class _Refused:
    """What one session was refused and is not written yet."""

    limiter: CommandLimiter
    who: str = ""
    words: str = ""
    number: int = 0


class RefusalLog:
    """Counts refusals of each session; everything happens on one asyncio loop.

    Args:
        record: takes who, the name of the session and what, as ``AuditLog.record``.
        clock: the server's clock.
    """

    def __init__(self, record: Callable[[str, str, str], None], clock: Clock) -> None:
        self._record, self._clock = record, clock
        self._refused: dict[tuple[str, bool], _Refused] = {}

    def refused(self, who: str, session: str, what: str) -> None:
        """Write a refusal down, or count it when this session was refused too often."""
        self._count((session, False), who, what, _BURST)

    def flooded(self, who: str, session: str) -> None:
        """Write down that a command was not read, because there were too many."""
        self._count((session, True), who, _TOO_MANY, 1.0)

    def write_counted(self, *, at_the_end: bool = False) -> None:
        """Write what was counted and may be written now, or all of it."""
        for (session, _), one in self._refused.items():
            self._write(session, one, at_once=at_the_end)

    def _count(self, key: tuple[str, bool], who: str, what: str, burst: float) -> None:
        if key not in self._refused and len(self._refused) >= _MAX_KNOWN:
            oldest = next(iter(self._refused))
            self._write(oldest[0], self._refused.pop(oldest), at_once=True)
        fresh = CommandLimiter(burst, self._clock.now(), 0, _RATE, burst)
        one = self._refused.setdefault(key, _Refused(fresh))
        one.who, one.words, one.number = who, what[:_WORDS_LENGTH], one.number + 1
        self._write(key[0], one)

    def _write(self, session: str, one: _Refused, *, at_once: bool = False) -> None:
        if one.number and (one.limiter.spend(self._clock.now()) or at_once):
            also = f" (the last of {one.number})" if one.number > 1 else ""
            self._record(one.who, session, one.words + also)
            one.number = 0
