"""The altitude that the drone tells beside its raw ultrasound: a jump of the ground is left out.

A real drone takes a jump of the echo for something below it and keeps its altitude (AutonomyLab,
ardrone_autonomy, issue 145; Parrot's patent EP 2644240), so that it does not leap above a table.
"""

from __future__ import annotations

from math import inf

from housefly.twin.contracts import OnboardState

_CLIMB_MAX = 1.5
"""No drone climbs or sinks faster [m/s]: what changes faster is the ground."""
_PING_PERIOD, _NOISE = 0.04, 0.05
"""The ultrasound measures so often [s], so well [m]."""


class AltitudeEstimator:
    """Follows one drone from its take-off to its landing."""

    def __init__(self) -> None:
        self._at, self._measured, self._ground = -inf, 0.0, 0.0

    def altitude(self, onboard: OnboardState) -> float:
        """Return the altitude above the place of the take-off [m]; call once for each report."""
        change = onboard.height - self._measured
        dt = max(onboard.at - self._at, _PING_PERIOD)
        if not onboard.flight.airborne:
            self._ground = 0.0
        elif abs(change) > _CLIMB_MAX * dt + _NOISE:
            self._ground -= change
        self._at, self._measured = onboard.at, onboard.height
        return max(0.0, onboard.height + self._ground)
