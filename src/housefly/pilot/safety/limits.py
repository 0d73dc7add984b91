"""The numbers of the last gate, compiled: how old is too old, how far is too far."""

from __future__ import annotations

from housefly.numeric import clipped, compiled


@compiled
def too_old(age: float, bound: float) -> bool:
    """Return whether something is older than it may be [s]; an age that is not a number is too old."""
    return not age <= bound


@compiled
def limited(
    theta: float,
    phi: float,
    vz: float,
    yaw_rate: float,
    tilt_max: float,
    climb_max: float,
    turn_max: float,
) -> tuple[float, float, float, float]:
    """Return pitch, roll [rad], climb rate [m/s] and yaw rate [rad/s], each within its limit."""
    return (
        clipped(theta, tilt_max),
        clipped(phi, tilt_max),
        clipped(vz, climb_max),
        clipped(yaw_rate, turn_max),
    )
