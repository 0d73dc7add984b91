"""When a drone that wants it is told where it is."""

from __future__ import annotations

from math import inf

from housefly.messages import Sighting

_EARLY = 0.2
"""A sighting may come this share of a period early: trackers jitter."""


class PoseRate:
    """Lets sightings pass: each once, in order, and no more often than the drone wants.

    Args:
        rate_hz: as its capabilities say; None lets none pass.
    """

    def __init__(self, rate_hz: float | None) -> None:
        self._pause = inf if rate_hz is None else (1.0 - _EARLY) / rate_hz
        self._told_at = -inf

    def due(self, seen: Sighting | None) -> Sighting | None:
        """Return the sighting if the drone is to be told of it now."""
        if seen is None or self._pause == inf or seen.captured_at - self._told_at < self._pause:
            return None
        self._told_at = seen.captured_at
        return seen
