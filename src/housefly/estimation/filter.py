"""The Kalman filter of mode default: measurements count at the time of capture, then everything rolls forward.

Irregular intervals, dropouts, latency, the command delay and the attitude lag are all in the model, so none of them costs phase.
"""

from __future__ import annotations

from math import sqrt

from housefly.config import ControlConfig, DroneConfig
from housefly.estimation.commands import CommandHistory
from housefly.estimation.contracts import Forecast
from housefly.estimation.door import Door
from housefly.estimation.height_yaw import GATE_FLOOR, plausible
from housefly.estimation.intake import OLDEST
from housefly.estimation.lagged_axis import Axis, AxisModel, Spread, corrected, narrowed
from housefly.geometry import Vec2
from housefly.messages import Estimate, Sighting

HOVER_BRAKE = 1.5
"""How quickly the drone's own hover stops it, on top of drag [1/s]."""
WANDER = 0.2
"""How fast the disturbance may change [m/s^2 per sqrt(s)]."""
FIRST_DISTURBANCE = 0.2
"""One-sigma disturbance before anything was seen [m/s^2]."""


class PoseFilter(Door):
    """Position, velocity, tilt acceleration and disturbance in x and y; height and yaw beside them."""

    def __init__(self, drone: DroneConfig, control: ControlConfig, body: str) -> None:
        super().__init__(body, control.position_noise)
        self._delay = drone.command_delay
        self._variance = control.position_noise**2
        self._model = AxisModel(
            drone.attitude_lag,
            drone.attitude_gain,
            drone.drag,
            drone.drag + HOVER_BRAKE,
            control.acceleration_noise,
            WANDER,
        )
        self._history = CommandHistory(drone.command_delay)
        self._at = 0.0
        self._x = self._y = Axis(0.0, 0.0, 0.0, 0.0)
        self._spread = self._first_spread()
        self._doubt = self._variance

    def sent(self, now: float, acceleration: Vec2, flown: bool) -> None:
        """Note the world acceleration [m/s^2] commanded from now on; not flown means that the drone flies itself."""
        self._history.add(now, acceleration[0], acceleration[1], flown)

    def estimate(self, now: float) -> Estimate | None:
        """Return where the drone is now, or None before the first sighting."""
        if self._upright is None:
            return None
        self._settle(now - OLDEST)
        x, y, spread = self._rolled(now)
        z, climb, yaw = self._upright.at(now)
        return Estimate(now, (x.x, y.x, z), (x.v, y.v, climb), yaw, now - self._last_capture, sqrt(spread.xx))

    def forecast(self, now: float) -> Forecast | None:
        """Return the horizontal state when a command given now begins to act: one command delay ahead."""
        if self._upright is None:
            return None
        x, y, _ = self._rolled(now + self._delay)
        return Forecast((x.x, y.x), (x.v, y.v), (x.d, y.d))

    def _start(self, sighting: Sighting, now: float) -> None:
        x, y, _ = sighting.pose.position
        self._x, self._y = Axis(x, 0.0, 0.0, 0.0), Axis(y, 0.0, 0.0, 0.0)
        self._spread = self._first_spread()
        self._at = sighting.captured_at

    def _believes(self, sighting: Sighting, now: float, refusing: bool) -> bool:
        x, y, spread = self._rolled(sighting.captured_at)
        self._doubt = self._doubt if refusing else spread.xx + self._variance
        dx, dy = sighting.pose.position[0] - x.x, sighting.pose.position[1] - y.x
        return plausible(dx * dx + dy * dy, self._doubt, GATE_FLOOR)

    def _take(self, sighting: Sighting, now: float) -> None:
        self._settle(sighting.captured_at)
        x, y, _ = sighting.pose.position
        self._x = Axis(*corrected(self._x, self._spread, x, self._variance))
        self._y = Axis(*corrected(self._y, self._spread, y, self._variance))
        self._spread = Spread(*narrowed(self._spread, self._variance))

    def _settle(self, at: float) -> None:
        """Move the base of the filter forward to a time before which nothing can arrive any more."""
        if at > self._at:
            self._x, self._y, self._spread = self._rolled(at)
            self._at = at

    def _rolled(self, at: float) -> tuple[Axis, Axis, Spread]:
        return self._history.roll(self._x, self._y, self._spread, self._at, at, self._model)

    def _first_spread(self) -> Spread:
        noise, doubt = self._model.noise, FIRST_DISTURBANCE
        return Spread(self._variance, 0.0, 0.0, 0.0, 0.05, 0.0, 0.0, noise * noise, 0.0, doubt * doubt)
