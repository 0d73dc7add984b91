"""The numbers of the safety gate, compiled: how old is too old, and what may leave."""

from __future__ import annotations

from enum import IntEnum
from math import isfinite
from typing import NamedTuple

from housefly.numeric import clipped, compiled
from housefly.pilot.control.steering import ControlOutput


class SafetyModeCode(IntEnum):
    """The modes as compiled code knows them, in the order of ``messages.SafetyMode``."""

    NOMINAL = 0
    WARN = 1
    SLOW = 2
    HOLD = 3
    RETURN = 4
    STOPPED = 5
    LAND = 6
    DESCEND = 7
    CUT = 8


DESCENT_RATE = 0.3
"""How fast a level descent sinks [m/s]."""


class CommandLimits(NamedTuple):
    """Largest tilt of an axis [rad], climb rate [m/s] and yaw rate [rad/s]."""

    tilt_max: float
    vertical_speed_max: float
    yaw_rate_max: float


class GatedCommand(NamedTuple):
    """What leaves the gate.

    Attributes:
        mode: a ``SafetyModeCode``.
        flown: our setpoint flies the drone; else its own hover does, or it stands.
        theta, phi, vz, yaw_rate: the setpoint within its limits, zero when it is not flown.
    """

    mode: int
    flown: bool
    theta: float
    phi: float
    vz: float
    yaw_rate: float


@compiled
def too_old(age: float, bound: float) -> bool:
    """Return whether something is older than it may be [s]; an age that is not a number is."""
    return not age <= bound


@compiled
def is_flown_in(mode: int) -> bool:
    """Return whether our setpoints fly the drone in this ``SafetyModeCode``."""
    return mode <= SafetyModeCode.SLOW.value or mode == SafetyModeCode.RETURN.value


@compiled
def pose_age_mode(age: float, level_after: float, land_after: float) -> int:
    """Return the ``SafetyModeCode`` that the age of the pose asks for; times in seconds."""
    if too_old(age, land_after):
        return SafetyModeCode.LAND.value
    if too_old(age, level_after):
        return SafetyModeCode.HOLD.value
    return SafetyModeCode.NOMINAL.value


@compiled
def gated(
    asked: ControlOutput, flying: bool, mode: int, airborne: bool, limits: CommandLimits
) -> GatedCommand:
    """Return what may leave the gate.

    Args:
        asked: by control.
        flying: control flies; else it leaves the drone to its own hover.
        mode: the ``SafetyModeCode`` that the rules found.
        airborne: the propellers carry the drone.
        limits: of the command.
    """
    tilt_is_finite = isfinite(asked.theta) and isfinite(asked.phi)
    is_finite = tilt_is_finite and isfinite(asked.vz) and isfinite(asked.yaw_rate)
    if flying and not is_finite and is_flown_in(mode):
        mode = SafetyModeCode.HOLD.value
    if mode == SafetyModeCode.DESCEND.value and airborne:
        sink = -min(DESCENT_RATE, limits.vertical_speed_max)
        is_braked = flying and is_finite
        theta = clipped(asked.theta, limits.tilt_max) if is_braked else 0.0
        phi = clipped(asked.phi, limits.tilt_max) if is_braked else 0.0
        return GatedCommand(mode, True, theta, phi, sink, 0.0)
    if not (flying and airborne and is_finite and is_flown_in(mode)):
        return GatedCommand(mode, False, 0.0, 0.0, 0.0, 0.0)
    return GatedCommand(
        mode=mode,
        flown=True,
        theta=clipped(asked.theta, limits.tilt_max),
        phi=clipped(asked.phi, limits.tilt_max),
        vz=clipped(asked.vz, limits.vertical_speed_max),
        yaw_rate=clipped(asked.yaw_rate, limits.yaw_rate_max),
    )
