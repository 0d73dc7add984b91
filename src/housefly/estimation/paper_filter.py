"""The Kalman filter as the paper describes it (V-D): state (x, x', y, y'), input = commands, measurement on arrival.

It knows neither latency nor the attitude lag nor drag: the baseline that mode default is measured against.
"""

from __future__ import annotations

from math import sqrt

from housefly.config import ControlConfig
from housefly.estimation.contracts import Forecast
from housefly.estimation.door import Door
from housefly.estimation.drift_axis import Drift, drifted, seen
from housefly.estimation.height_yaw import GATE_FLOOR, plausible
from housefly.geometry import Vec2
from housefly.messages import Estimate, Sighting


class PaperFilter(Door):
    """Position and velocity in x and y; height and yaw beside them."""

    def __init__(self, control: ControlConfig, body: str) -> None:
        super().__init__(body, control.position_noise)
        self._noise = control.acceleration_noise
        self._variance = control.position_noise**2
        self._x = self._y = Drift(0.0, 0.0, 0.0, 0.0, 0.0)
        self._input: Vec2 = (0.0, 0.0)
        self._at = 0.0
        self._doubt = self._variance

    def sent(self, now: float, acceleration: Vec2, flown: bool) -> None:
        """Note the world acceleration [m/s^2] commanded from now on; zero when the drone flies itself."""
        self._advance(now)
        self._input = acceleration if flown else (0.0, 0.0)

    def estimate(self, now: float) -> Estimate | None:
        """Return where the drone is now, or None before the first sighting."""
        if self._upright is None:
            return None
        self._advance(now)
        z, climb, yaw = self._upright.at(now)
        velocity = (self._x.v, self._y.v, climb)
        return Estimate(now, (self._x.x, self._y.x, z), velocity, yaw, now - self._last_capture, sqrt(self._x.xx))

    def forecast(self, now: float) -> Forecast | None:
        """Return the estimate itself: the paper compensates no delay and no disturbance."""
        if self._upright is None:
            return None
        self._advance(now)
        return Forecast((self._x.x, self._y.x), (self._x.v, self._y.v), (0.0, 0.0))

    def _start(self, sighting: Sighting, now: float) -> None:
        x, y, _ = sighting.pose.position
        self._x = Drift(x, 0.0, self._variance, 0.0, 0.1)
        self._y = Drift(y, 0.0, self._variance, 0.0, 0.1)
        self._at = now

    def _believes(self, sighting: Sighting, now: float, refusing: bool) -> bool:
        self._advance(now)
        self._doubt = self._doubt if refusing else self._x.xx + self._variance
        dx, dy = sighting.pose.position[0] - self._x.x, sighting.pose.position[1] - self._y.x
        return plausible(dx * dx + dy * dy, self._doubt, GATE_FLOOR)

    def _take(self, sighting: Sighting, now: float) -> None:
        x, y, _ = sighting.pose.position
        self._x = Drift(*seen(self._x, x - self._x.x, self._variance))
        self._y = Drift(*seen(self._y, y - self._y.x, self._variance))

    def _advance(self, now: float) -> None:
        dt = now - self._at
        if dt > 0.0:
            self._x = Drift(*drifted(self._x, self._input[0], self._noise, dt))
            self._y = Drift(*drifted(self._y, self._input[1], self._noise, dt))
            self._at = now
