"""Height and yaw: two constant-velocity filters, the same in both modes, and the pose's gate."""

from __future__ import annotations

from typing import NamedTuple

from housefly.numeric import compiled, wrapped
from housefly.pilot.estimation.constant_velocity import ConstantVelocity, cv_predicted, cv_updated

CLIMB_PROCESS_NOISE = 1.0
"""Unmodelled vertical acceleration [m/s^1.5]."""
YAW_PROCESS_NOISE = 2.0
"""Unmodelled yaw acceleration [rad/s^1.5]."""
YAW_NOISE_RATIO = 3.0
"""Yaw noise over position noise [rad/m]: markers sit a third of a metre apart."""
EXTRAPOLATION_MAX = 0.3
"""Longest time that height and yaw are extrapolated [s]; the drone's own loops stop both soon."""
INITIAL_RATE_VARIANCE = 0.1
"""Variance of the unknown rates at the first sighting [m^2/s^2, rad^2/s^2]."""
INNOVATION_GATE_SIGMAS = 6.0
"""A sighting further off than this many standard deviations is a spike, unless it is closer than
the floors below.
"""
POSITION_GATE_FLOOR = 0.15
"""Never refuse a position closer than this [m]."""
YAW_GATE_FLOOR = 0.35
"""Never refuse a yaw closer than this [rad]."""


class HeightYawState(NamedTuple):
    """Height z [m] and heading psi [rad] with their rates.

    Attributes:
        z, yaw: filter states at the last sighting.
        at: when that was captured [s].
        z_innovation, yaw_innovation: variance by which the next sighting is judged [m^2, rad^2].
    """

    z: ConstantVelocity
    yaw: ConstantVelocity
    at: float
    z_innovation: float
    yaw_innovation: float


@compiled
def within_gate(distance_squared: float, variance: float, floor: float) -> bool:
    """Return whether an innovation is small enough."""
    return distance_squared <= max(
        INNOVATION_GATE_SIGMAS * INNOVATION_GATE_SIGMAS * variance, floor * floor
    )


@compiled
def height_yaw_initialized(
    z: float, yaw: float, at: float, position_noise: float
) -> HeightYawState:
    """Return height and heading first seen at a time [s]."""
    z_variance, yaw_variance = _variances(position_noise)
    return HeightYawState(
        z=ConstantVelocity(z, 0.0, z_variance, 0.0, INITIAL_RATE_VARIANCE),
        yaw=ConstantVelocity(yaw, 0.0, yaw_variance, 0.0, INITIAL_RATE_VARIANCE),
        at=at,
        z_innovation=z_variance,
        yaw_innovation=yaw_variance,
    )


@compiled
def height_yaw_at(u: HeightYawState, now: float) -> tuple[float, float, float]:
    """Return height [m], climb rate [m/s] and yaw [rad] now [s], extrapolated for a while."""
    ahead = min(max(now - u.at, 0.0), EXTRAPOLATION_MAX)
    return u.z.x + ahead * u.z.v, u.z.v, wrapped(u.yaw.x + ahead * u.yaw.v)


@compiled
def height_yaw_updated(
    u: HeightYawState, z: float, yaw: float, at: float, rejecting: bool, position_noise: float
) -> tuple[bool, HeightYawState, HeightYawState]:
    """Return whether a pose captured at a time [s] is plausible, and the states after either.

    While sightings are rejected the variances do not grow: any jump would pass in the end.

    Returns:
        plausible, the state after rejecting the pose, the state after accepting it.
    """
    z_variance, yaw_variance = _variances(position_noise)
    dt = at - u.at
    z_then = cv_predicted(u.z, 0.0, CLIMB_PROCESS_NOISE, dt)
    yaw_then = cv_predicted(u.yaw, 0.0, YAW_PROCESS_NOISE, dt)
    z_innovation = u.z_innovation if rejecting else z_then.xx + z_variance
    yaw_innovation = u.yaw_innovation if rejecting else yaw_then.xx + yaw_variance
    rise, turn = z - z_then.x, wrapped(yaw - yaw_then.x)
    z_is_near = within_gate(rise * rise, z_innovation, POSITION_GATE_FLOOR)
    plausible = z_is_near and within_gate(turn * turn, yaw_innovation, YAW_GATE_FLOOR)
    rejected = HeightYawState(
        z=u.z, yaw=u.yaw, at=u.at, z_innovation=z_innovation, yaw_innovation=yaw_innovation
    )
    accepted = HeightYawState(
        z=cv_updated(z_then, rise, z_variance),
        yaw=cv_updated(yaw_then, turn, yaw_variance),
        at=at,
        z_innovation=z_innovation,
        yaw_innovation=yaw_innovation,
    )
    return plausible, rejected, accepted


@compiled
def _variances(position_noise: float) -> tuple[float, float]:
    """Return the variances of a seen height [m^2] and heading [rad^2]."""
    yaw_noise = YAW_NOISE_RATIO * position_noise
    return position_noise * position_noise, yaw_noise * yaw_noise
