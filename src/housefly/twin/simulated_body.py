"""What the simulated drone is, measures and does in one control period, whatever its model."""

from __future__ import annotations

from typing import NamedTuple

from housefly.geometry import Quaternion, Vec3

CONTROL_PERIOD = 0.005
"""The firmware's control period [s] (200 Hz)."""
PHYSICS_STEPS = 2
"""Physics steps per control period: 2.5 ms, enough for a soft hull to hit a wall at full speed."""
PHYSICS_PERIOD = CONTROL_PERIOD / PHYSICS_STEPS
"""What moves is integrated so often [s]."""


class BodyState(NamedTuple):
    """True state of the rigid body.

    Attributes:
        position: world [m].
        orientation: (w, x, y, z), body to world.
        velocity: world [m/s].
        acceleration: world [m/s^2].
        rate: body [rad/s].
    """

    position: Vec3
    orientation: Quaternion
    velocity: Vec3
    acceleration: Vec3
    rate: Vec3


class SensorReading(NamedTuple):
    """One reading of all onboard sensors.

    Attributes:
        phi, theta, psi: attitude [rad]; psi since power-on.
        rate: body [rad/s].
        height: [m].
        climb, forward, left: speeds [m/s].
        acceleration: specific force, body [m/s^2].
    """

    phi: float
    theta: float
    psi: float
    rate: Vec3
    height: float
    climb: float
    forward: float
    left: float
    acceleration: Vec3


class Wrench(NamedTuple):
    """Thrust along body z [N] and torques about the body axes [N m]."""

    thrust: float
    roll: float
    pitch: float
    yaw: float


MOTORS_OFF = Wrench(0.0, 0.0, 0.0, 0.0)
