"""Height and yaw: two small constant-rate filters, the same in both modes, with the innovation gate
for the whole pose.
"""

from __future__ import annotations

from typing import NamedTuple

from housefly.numeric import compiled, wrapped
from housefly.pilot.estimation.drift_axis import Drift, drifted, seen

CLIMB_NOISE = 1.0
"""Unmodelled vertical acceleration [m/s^1.5]."""
TURN_NOISE = 2.0
"""Unmodelled yaw acceleration [rad/s^1.5]."""
YAW_PER_METRE = 3.0
"""Yaw noise over position noise [rad/m]: markers sit a third of a metre apart."""
BLIND_REACH = 0.3
"""Longest time that height and yaw are extrapolated [s]; the drone's own loops stop both soon."""
FIRST_RATE_VARIANCE = 0.1
"""Variance of the unknown rates at the first sighting [m^2/s^2, rad^2/s^2]."""
GATE_SIGMAS = 6.0
"""A sighting further off than this many standard deviations is a spike, unless it is closer than
the floors below.
"""
GATE_FLOOR = 0.15
"""Never refuse a position closer than this [m]."""
GATE_FLOOR_YAW = 0.35
"""Never refuse a yaw closer than this [rad]."""


class Upright(NamedTuple):
    """Height z [m] and heading psi [rad] with their rates.

    Attributes:
        z, yaw: filter states at the last sighting.
        at: when that was captured [s].
        z_doubt, yaw_doubt: variance by which the next sighting is judged [m^2, rad^2].
    """

    z: Drift
    yaw: Drift
    at: float
    z_doubt: float
    yaw_doubt: float


@compiled
def plausible(distance_squared: float, variance: float, floor: float) -> bool:
    """Return whether an innovation is small enough to be believed."""
    return distance_squared <= max(GATE_SIGMAS * GATE_SIGMAS * variance, floor * floor)


@compiled
def stood(z: float, yaw: float, at: float, position_noise: float) -> Upright:
    """Return height and heading first seen at a time [s]."""
    z_variance, yaw_variance = _variances(position_noise)
    return Upright(
        Drift(z, 0.0, z_variance, 0.0, FIRST_RATE_VARIANCE),
        Drift(yaw, 0.0, yaw_variance, 0.0, FIRST_RATE_VARIANCE),
        at,
        z_variance,
        yaw_variance,
    )


@compiled
def upright_at(u: Upright, now: float) -> tuple[float, float, float]:
    """Return height [m], climb rate [m/s] and yaw [rad] now [s], extrapolated no further than
    ``BLIND_REACH``.
    """
    ahead = min(max(now - u.at, 0.0), BLIND_REACH)
    return u.z.x + ahead * u.z.v, u.z.v, wrapped(u.yaw.x + ahead * u.yaw.v)


@compiled
def upright_seen(
    u: Upright, z: float, yaw: float, at: float, refusing: bool, position_noise: float
) -> tuple[bool, Upright, Upright]:
    """Return whether a pose captured at a time [s] is believed, and the states without it and with
    it.

    While sightings are being refused the doubt does not grow: else every jump would be believed in
        the end.
    """
    z_variance, yaw_variance = _variances(position_noise)
    dt = at - u.at
    z_then, yaw_then = drifted(u.z, 0.0, CLIMB_NOISE, dt), drifted(u.yaw, 0.0, TURN_NOISE, dt)
    z_doubt = u.z_doubt if refusing else z_then.xx + z_variance
    yaw_doubt = u.yaw_doubt if refusing else yaw_then.xx + yaw_variance
    rise, turn = z - z_then.x, wrapped(yaw - yaw_then.x)
    believed = plausible(rise * rise, z_doubt, GATE_FLOOR) and plausible(
        turn * turn, yaw_doubt, GATE_FLOOR_YAW
    )
    without = Upright(u.z, u.yaw, u.at, z_doubt, yaw_doubt)
    taken = Upright(
        seen(z_then, rise, z_variance), seen(yaw_then, turn, yaw_variance), at, z_doubt, yaw_doubt
    )
    return believed, without, taken


@compiled
def _variances(position_noise: float) -> tuple[float, float]:
    """Return the variances of a seen height [m^2] and heading [rad^2]."""
    yaw_noise = YAW_PER_METRE * position_noise
    return position_noise * position_noise, yaw_noise * yaw_noise
