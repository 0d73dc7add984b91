"""Puts what sensors tell into order of time before detectors see it: late, doubled, undated and
future items included.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from heapq import heappop, heappush
from math import isfinite

from housefly.hub.situations.situation import Item, time_of
from housefly.messages import Happening, Observation

PATIENCE = 0.5
"""Items may come this late after they were so, and still are put in order [s]."""
FUTURE = 2.0
"""Items that claim to be further ahead of us are refused [s]."""
LATE_HAPPENING = 60.0
"""A happening that comes too late is taken as one of now, up to this age [s]: better a bell that is
heard late than never.
"""
JUST_AFTER = 1e-6
"""Such a happening is put this long after what was released [s]."""
MOST = 20_000
"""So many items may wait; more are refused."""

Key = tuple[float, bool, str, str, str]


class Stream:
    """Holds items back until none can come before them any more.

    Attributes:
        counts: what was refused, by reason and source.
    """

    def __init__(self) -> None:
        self.counts: Counter[tuple[str, str]] = Counter()
        self._waiting: list[tuple[Key, int, Item]] = []
        self._keys: set[Key] = set()
        self._heard: dict[Key, float] = {}
        self._number = 0

    def add(self, item: Item, passed: float, now: float) -> None:
        """Add an item.

        Args:
            item: in any order.
            passed: up to when items were released [s, Unix time].
            now: [s, Unix time].
        """
        key, reason = _key(item), self._refusal(item, passed, now)
        if key in self._keys or key in self._heard:
            reason = "doubled"
        if reason == "late" and isinstance(item, Happening) and now - item.at <= LATE_HAPPENING:
            self.counts[reason, item.source] += 1
            self._heard[key] = item.at
            item, reason = (
                replace(item, at=passed + JUST_AFTER, facts=(*item.facts, ("late", now - item.at))),
                "",
            )
            key = _key(item)
        if reason:
            self.counts[reason, item.source] += 1
            return
        self._number += 1
        self._keys.add(key)
        heappush(self._waiting, (key, self._number, item))

    def until(self, time: float) -> tuple[Item, ...]:
        """Return the items up to and with a time [s, Unix time], oldest first; those of one time in
        an order of their own.
        """
        released = []
        while self._waiting and self._waiting[0][0][0] <= time:
            key, _, item = heappop(self._waiting)
            self._keys.discard(key)
            released.append(item)
            if isinstance(item, Happening):
                self._heard[key] = item.at
        self._heard = {key: at for key, at in self._heard.items() if at > time - LATE_HAPPENING}
        return tuple(released)

    def _refusal(self, item: Item, passed: float, now: float) -> str:
        at = time_of(item)
        if not isfinite(at) or not _is_finite(item):
            return "not a number"
        if at > now + FUTURE:
            return "from the future"
        if len(self._waiting) >= MOST:
            return "too many"
        return "late" if at <= passed else ""


def _key(item: Item) -> Key:
    """Return an order that does not depend on arrival: a report before the state that already knows
    of it.
    """
    rest = replace(item, received_at=0.0) if isinstance(item, Observation) else item
    return time_of(item), isinstance(item, Observation), item.source, item.thing, repr(rest)


def _is_finite(item: Item) -> bool:
    return (
        not isinstance(item, Observation)
        or item.position is None
        or all(isfinite(value) for value in item.position)
    )
