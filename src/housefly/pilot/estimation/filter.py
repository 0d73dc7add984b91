"""Mode default's estimator: measurements count at the time of capture, then everything rolls
forward.

Irregular intervals, dropouts, latency, the command delay and the attitude lag are all in the model,
so none of them costs phase.
"""

from __future__ import annotations

from math import sqrt

import numpy as np

from housefly.config.site import ControlConfig, DroneConfig
from housefly.geometry import Vec2
from housefly.messages import Estimate, Sighting
from housefly.pilot.estimation.contracts import Forecast
from housefly.pilot.estimation.door import Door
from housefly.pilot.estimation.height_yaw import GATE_FLOOR, plausible, upright_at
from housefly.pilot.estimation.horizon import (
    SPAN,
    Horizon,
    Reached,
    Spans,
    advanced,
    begun,
    commanded,
    looked,
    measured,
    opened,
    reached,
    settled,
)
from housefly.pilot.estimation.intake import OLDEST
from housefly.pilot.estimation.lagged_axis import AxisModel, first_spread

HOVER_BRAKE = 1.5
"""How quickly the drone's own hover stops it, on top of drag [1/s]."""
WANDER = 0.2
"""How fast the disturbance may change [m/s^2 per sqrt(s)]."""
SPANS = 1024
"""Spans kept: more than two seconds at the fastest loop rate, twice over."""


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
        self._first = first_spread(self._variance, control.acceleration_noise)
        self._spans: Spans = np.zeros(SPANS, SPAN)
        self._horizon: Horizon | None = None
        self._doubt = self._variance
        self._there: Reached | None = None

    def sent(self, now: float, acceleration: Vec2, flown: bool) -> None:
        """Note the world acceleration [m/s^2] commanded from now on; not flown means that the drone
        flies itself.
        """
        commanded(self._now(now), self._spans, acceleration[0], acceleration[1], flown)

    def estimate(self, now: float) -> Estimate | None:
        """Return where the drone is now, or None before the first sighting."""
        if self._upright is None:
            return None
        h = settled(self._now(now), self._spans, self._model, self._delay, now - OLDEST)
        self._horizon = h
        x, y = looked(h, self._spans, self._model, self._delay, now)
        doubt = sqrt(reached(h, self._spans, self._model, self._delay, now).spread.xx)
        z, climb, yaw = upright_at(self._upright, now)
        return Estimate(now, (x.x, y.x, z), (x.v, y.v, climb), yaw, now - self._last_capture, doubt)

    def forecast(self, now: float) -> Forecast | None:
        """Return the horizontal state when a command given now begins to act: one command delay
        ahead.
        """
        if self._upright is None:
            return None
        x, y = looked(self._now(now), self._spans, self._model, self._delay, now + self._delay)
        return Forecast((x.x, y.x), (x.v, y.v), (x.d, y.d))

    def _start(self, sighting: Sighting, now: float) -> None:
        x, y, _ = sighting.pose.position
        h = self._opened(now)
        self._horizon = begun(
            h, self._spans, self._model, self._delay, sighting.captured_at, x, y, self._first
        )

    def _believes(self, sighting: Sighting, now: float, refusing: bool) -> bool:
        there = reached(
            self._opened(now), self._spans, self._model, self._delay, sighting.captured_at
        )
        self._there = there
        self._doubt = self._doubt if refusing else there.spread.xx + self._variance
        dx, dy = sighting.pose.position[0] - there.x.x, sighting.pose.position[1] - there.y.x
        return plausible(dx * dx + dy * dy, self._doubt, GATE_FLOOR)

    def _take(self, sighting: Sighting, now: float) -> None:
        assert self._there is not None
        x, y, _ = sighting.pose.position
        h, at = self._opened(now), sighting.captured_at
        self._horizon = measured(
            h, self._spans, self._model, self._delay, at, self._there, x, y, self._variance
        )

    def _opened(self, now: float) -> Horizon:
        if self._horizon is None:
            self._horizon = opened(self._spans, now, self._first)
        return self._horizon

    def _now(self, now: float) -> Horizon:
        self._horizon = advanced(self._opened(now), self._spans, self._model, self._delay, now)
        return self._horizon
