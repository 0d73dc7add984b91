"""The AR.Drone's inner loops: references in, thrust and torque out.

The poles are the site's (``drone.attitude_lag``, ``climb_lag``, ``yaw_lag``); their defaults are
c3, c7 and c5 of tum-vision/tum_ardrone, DroneKalmanFilter. The loops act on what the sensors
measured, never on the truth.
"""

from __future__ import annotations

from math import atan, copysign, cos, sin
from typing import NamedTuple

from housefly.config.drone import DroneConfig
from housefly.config.twin import RATE_POLE
from housefly.geometry import GRAVITY
from housefly.messages.stick import Stick
from housefly.twin.contracts import OnboardLimits
from housefly.twin.drone_mechanics import USUAL, mechanics_of
from housefly.twin.simulated_body import CONTROL_PERIOD, SensorReading, Wrench

_SINK_FACTOR = 2.0
"""The same stick sinks twice as fast as it climbs."""
_HEIGHT_POLE = 0.5
"""Gain of the height hold [1/s]; with a climb pole of 1.4 1/s its damping ratio is 0.84."""
_BRAKE_POLE = 2.0
"""Deceleration per measured speed in hover [1/s]; well damped with attitude lag and flow delay."""
_TRIM_POLE = 0.4
_TRIM_SPEED = 0.3
"""Integral gain of the hover [1/s^2], active below this speed [m/s]; learns the attitude offset."""
THRUST_MAX = USUAL.thrust_max
"""Four motors of an AR.Drone at full throttle [N]."""
_ANGULAR_ACCELERATION_MAX = 300.0
"""Bound of torque over inertia [rad/s^2]; tames a crash."""

_STICK_DEAD = 1e-3


class LoopReferences(NamedTuple):
    """Tilt [rad], climb rate [m/s] and yaw rate [rad/s] for the loops to reach."""

    phi: float
    theta: float
    climb: float
    yaw_rate: float


class InnerLoops:
    """Attitude, vertical speed, yaw rate, height hold and optical flow hover of one drone."""

    def __init__(self, drone: DroneConfig) -> None:
        self._mechanics = mechanics_of(drone.airframe)
        self._gain = drone.attitude_gain
        self._climb_pole, self._yaw_pole = drone.climb_lag, drone.yaw_lag
        if drone.profile:
            # A profile's pole was fitted with the delay of the tilt, the body rate loop in it.
            self._yaw_pole = 1.0 / (1.0 / drone.yaw_lag + 1.0 / RATE_POLE)
        # The rate loop adds a small lag of its own; this gain puts the slow pole of the cascade on
        # the identified one.
        self._attitude_gain = drone.attitude_lag * (RATE_POLE - drone.attitude_lag) / RATE_POLE
        self._held_height: float | None = None
        self._trim = (0.0, 0.0)

    def hold_height(self, height: float | None) -> None:
        """Hold this height [m] from now on; None takes the height where the climb comes to rest."""
        self._held_height = height

    def fly(self, stick: Stick, limits: OnboardLimits, measured: SensorReading) -> LoopReferences:
        """Return the references of a stick that is not hovering."""
        return LoopReferences(
            phi=-_clip(stick.left, 1.0) * limits.tilt * self._gain,
            theta=_clip(stick.forward, 1.0) * limits.tilt * self._gain,
            climb=self._climb(_clip(stick.up, 1.0), limits, measured),
            yaw_rate=_clip(stick.turn, 1.0) * limits.yaw_rate,
        )

    def hover(
        self, limits: OnboardLimits, measured: SensorReading, climb: float | None = None
    ) -> LoopReferences:
        """Return the references that stop the drone; ``climb`` overrides the height hold."""
        forward, left = measured.forward, measured.left
        if abs(forward) < _TRIM_SPEED and abs(left) < _TRIM_SPEED:
            self._trim = (
                self._trim[0] - _TRIM_POLE * forward * CONTROL_PERIOD,
                self._trim[1] - _TRIM_POLE * left * CONTROL_PERIOD,
            )
        return LoopReferences(
            phi=-_clip(atan((self._trim[1] - _BRAKE_POLE * left) / GRAVITY), limits.tilt),
            theta=_clip(atan((self._trim[0] - _BRAKE_POLE * forward) / GRAVITY), limits.tilt),
            climb=self._climb(0.0, limits, measured) if climb is None else climb,
            yaw_rate=0.0,
        )

    def wrench(self, references: LoopReferences, measured: SensorReading) -> Wrench:
        """Return thrust and torques that reach the references with the identified poles."""
        phi, theta = measured.phi, measured.theta
        phi_rate = self._attitude_gain * (references.phi - phi)
        theta_rate = self._attitude_gain * (references.theta - theta)
        psi_rate = references.yaw_rate
        cr, sr, cp, sp = cos(phi), sin(phi), cos(theta), sin(theta)
        p, q, r = measured.rate
        upright = max(cr * cp, 0.5)
        lift = (
            self._mechanics.mass
            * (GRAVITY + self._climb_pole * (references.climb - measured.climb))
            / upright
        )
        return Wrench(
            thrust=min(max(lift, 0.0), self._mechanics.thrust_max),
            roll=self._torque(0, RATE_POLE, phi_rate - sp * psi_rate - p),
            pitch=self._torque(1, RATE_POLE, cr * theta_rate + cp * sr * psi_rate - q),
            yaw=self._torque(2, self._yaw_pole, cp * cr * psi_rate - sr * theta_rate - r),
        )

    def _climb(self, up: float, limits: OnboardLimits, measured: SensorReading) -> float:
        ceiling = _HEIGHT_POLE * (limits.altitude - measured.height)
        if abs(up) > _STICK_DEAD:
            self._held_height = None
            wanted = up * limits.climb * (_SINK_FACTOR if up < 0 else 1.0)
        else:
            if self._held_height is None:
                self._held_height = measured.height + measured.climb / self._climb_pole
            wanted = _HEIGHT_POLE * (self._held_height - measured.height)
        return min(_clip(wanted, limits.climb), ceiling)

    def _torque(self, axis: int, pole: float, rate_error: float) -> float:
        return self._mechanics.inertia[axis] * _clip(pole * rate_error, _ANGULAR_ACCELERATION_MAX)


def _clip(value: float, bound: float) -> float:
    return value if -bound <= value <= bound else copysign(bound, value)
