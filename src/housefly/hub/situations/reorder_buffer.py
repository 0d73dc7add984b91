"""Sorts sensor items by time for the detectors; handles late, duplicate and future ones."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from heapq import heappop, heappush
from math import isfinite

from housefly.hub.situations.situation import DetectorInput, time_of
from housefly.messages import Observation, RoomEvent

REORDER_DELAY = 0.5
"""How late an item may arrive and still be sorted in [s]."""
MAX_AHEAD = 2.0
"""Items further in the future are refused [s]."""
LATE_EVENT = 60.0
"""A late event up to this age counts as one of now [s]: better a late bell than none."""
_JUST_AFTER = 1e-6
"""Such an event is dated this long after the last released item [s]."""
MAX_WAITING = 20_000
"""At most this many items wait; more are refused."""

_Key = tuple[float, bool, str, str, str]


class ReorderBuffer:
    """Holds items back until no earlier ones can arrive.

    Attributes:
        counts: what was refused, by reason and source.
    """

    def __init__(self) -> None:
        self.counts: Counter[tuple[str, str]] = Counter()
        self._waiting: list[tuple[_Key, int, DetectorInput]] = []
        self._keys: set[_Key] = set()
        self._heard: dict[_Key, float] = {}
        self._number = 0

    def add(self, item: DetectorInput, passed: float, now: float) -> None:
        """Add an item.

        Args:
            item: in any order.
            passed: time up to which items were released [s, Unix time].
            now: [s, Unix time].
        """
        key, reason = _key(item), self._refusal(item, passed, now)
        if key in self._keys or key in self._heard:
            reason = "doubled"
        if reason == "late" and isinstance(item, RoomEvent) and now - item.at <= LATE_EVENT:
            self.counts[reason, item.source] += 1
            self._heard[key] = item.at
            item, reason = (
                replace(
                    item, at=passed + _JUST_AFTER, facts=(*item.facts, ("late", now - item.at))
                ),
                "",
            )
            key = _key(item)
        if reason:
            self.counts[reason, item.source] += 1
            return
        self._number += 1
        self._keys.add(key)
        heappush(self._waiting, (key, self._number, item))

    def until(self, time: float) -> tuple[DetectorInput, ...]:
        """Return the items up to and including a time [s, Unix time], oldest first."""
        released = []
        while self._waiting and self._waiting[0][0][0] <= time:
            key, _, item = heappop(self._waiting)
            self._keys.discard(key)
            released.append(item)
            if isinstance(item, RoomEvent):
                self._heard[key] = item.at
        self._heard = {key: at for key, at in self._heard.items() if at > time - LATE_EVENT}
        return tuple(released)

    def _refusal(self, item: DetectorInput, passed: float, now: float) -> str:
        at = time_of(item)
        if not isfinite(at) or not _is_finite(item):
            return "not a number"
        if at > now + MAX_AHEAD:
            return "from the future"
        if len(self._waiting) >= MAX_WAITING:
            return "too many"
        return "late" if at <= passed else ""


def _key(item: DetectorInput) -> _Key:
    """Return a sort key independent of arrival: a report precedes the state that reflects it."""
    rest = replace(item, received_at=0.0) if isinstance(item, Observation) else item
    return time_of(item), isinstance(item, Observation), item.source, item.thing, repr(rest)


def _is_finite(item: DetectorInput) -> bool:
    return (
        not isinstance(item, Observation)
        or item.position is None
        or all(isfinite(value) for value in item.position)
    )
