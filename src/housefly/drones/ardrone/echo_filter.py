"""Raw ultrasound without single wrong echoes: a jump counts once the next echo says so, too."""

from __future__ import annotations

from math import isfinite, nan

STEP_MIN = 0.15
"""A drone moves less than this between two echoes [m]: more is a step below it, or wrong."""
PING_PERIOD_MAX = 0.05
"""A height that is told for longer than this was measured again [s]: there are 22 or 25 a second,
and each is repeated in the reports that follow.
"""


class EchoFilter:
    """Filters the heights of one drone; a jump is late by one echo, all else is not."""

    def __init__(self) -> None:
        self._believed, self._newest, self._newest_at = nan, nan, nan

    def filtered(self, height: float, at: float) -> float:
        """Return the height that is believed [m] after a report of a time [s]."""
        if height == self._newest and at - self._newest_at < PING_PERIOD_MAX:
            return self._believed
        before, self._newest, self._newest_at = self._newest, height, at
        is_first = not isfinite(self._believed)
        if is_first or min(abs(height - self._believed), abs(height - before)) <= STEP_MIN:
            self._believed = height
        return self._believed
