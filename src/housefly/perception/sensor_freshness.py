"""Until when the sensors that look for people were believed."""

from __future__ import annotations

from collections.abc import Iterable
from math import inf


class SensorFreshness:
    """Remembers of each sensor when its newest believed scan or image was taken.

    Args:
        names: of the sensors.
    """

    def __init__(self, names: Iterable[str]) -> None:
        self._believed = dict.fromkeys(names, -inf)

    @property
    def seen_at(self) -> float:
        """Until when each of them was believed [s]; -inf before the first word of one, inf where
        there is none.
        """
        return min(self._believed.values(), default=inf)

    def believed(self, name: str, captured_at: float) -> None:
        """Note a scan or image that was taken in, with the time at which it was taken [s]."""
        self._believed[name] = max(self._believed[name], captured_at)
