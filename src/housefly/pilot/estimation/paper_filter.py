"""Mode paper's estimator: the paper's Kalman filter behind the common door.

It knows neither latency nor the attitude lag nor drag: the baseline that mode default is measured
    against.
"""

from __future__ import annotations

from math import sqrt

from housefly.config.site import ControlConfig
from housefly.geometry import Vec2
from housefly.messages import Estimate, Sighting
from housefly.pilot.estimation.contracts import Forecast
from housefly.pilot.estimation.door import Door
from housefly.pilot.estimation.drift_axis import Drift
from housefly.pilot.estimation.height_yaw import upright_at
from housefly.pilot.estimation.plain import (
    Plain,
    plain_advanced,
    plain_begun,
    plain_commanded,
    plain_judged,
    plain_measured,
)

NOTHING = Drift(0.0, 0.0, 0.0, 0.0, 0.0)


class PaperFilter(Door):
    """Position and velocity in x and y; height and yaw beside them."""

    def __init__(self, control: ControlConfig, body: str) -> None:
        super().__init__(body, control.position_noise)
        self._noise = control.acceleration_noise
        self._variance = control.position_noise**2
        self._state = Plain(NOTHING, NOTHING, 0.0, 0.0, 0.0, self._variance)

    def sent(self, now: float, acceleration: Vec2, flown: bool) -> None:
        """Note the world acceleration [m/s^2] commanded from now on; zero when the drone flies
        itself.
        """
        self._state = plain_commanded(self._now(now), *acceleration, flown)

    def estimate(self, now: float) -> Estimate | None:
        """Return where the drone is now, or None before the first sighting."""
        if self._upright is None:
            return None
        self._state = p = self._now(now)
        z, climb, yaw = upright_at(self._upright, now)
        return Estimate(
            now,
            (p.x.x, p.y.x, z),
            (p.x.v, p.y.v, climb),
            yaw,
            now - self._last_capture,
            sqrt(p.x.xx),
        )

    def forecast(self, now: float) -> Forecast | None:
        """Return the estimate itself: the paper compensates no delay and no disturbance."""
        if self._upright is None:
            return None
        self._state = p = self._now(now)
        return Forecast((p.x.x, p.y.x), (p.x.v, p.y.v), (0.0, 0.0))

    def _start(self, sighting: Sighting, now: float) -> None:
        x, y, _ = sighting.pose.position
        self._state = plain_begun(self._state, x, y, now, self._variance)

    def _believes(self, sighting: Sighting, now: float, refusing: bool) -> bool:
        x, y, _ = sighting.pose.position
        believed, self._state = plain_judged(self._now(now), x, y, refusing, self._variance)
        return believed

    def _take(self, sighting: Sighting, now: float) -> None:
        x, y, _ = sighting.pose.position
        self._state = plain_measured(self._state, x, y, self._variance)

    def _now(self, now: float) -> Plain:
        return plain_advanced(self._state, self._noise, now)
