"""Tilt, turn and throttle as channels of SET_RAW_RC, and back: its curves inverted.

In ANGLE mode a stick asks for its share of the angle limit by the curve of its turn rates: full
sticks lean to the limit, and half of a stick leans by less than half where there is expo (flight/
pid.c, fc/rc.c). The curves rise, so they are inverted by halving.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from math import copysign, degrees, radians

from housefly.wires.betaflight.settings import AxisRates, FcSettings, RatesType

FULL = 500
"""Of a stick, from its middle [us]."""
THROTTLE_OFF, THROTTLE_FULL = 1000, 2000
"""Positions [us]."""
_SUPER_MIN = 0.01
_RATE_STEP = 2.0
_RATE_STEEP = 14.54
_HALVINGS = 24


@dataclass(frozen=True, slots=True)
class RadioSticks:
    """What a person at a radio would do.

    Attributes:
        phi, theta: wanted lean [rad].
        yaw_rate: wanted turn [rad/s], counter-clockwise.
        throttle: share of what lies between idle and full motors, 0 to 1; None is off.
    """

    phi: float = 0.0
    theta: float = 0.0
    yaw_rate: float = 0.0
    throttle: float | None = None


def _betaflight(axis: AxisRates, x: float) -> float:
    expo, rc_rate = axis.expo / 100, axis.rc_rate / 100
    bent = x * (x**3 * expo + 1.0 - expo)
    steep = rc_rate + _RATE_STEEP * max(0.0, rc_rate - _RATE_STEP)
    return 200.0 * steep * bent / max(1.0 - x * axis.rate / 100, _SUPER_MIN)


def _raceflight(axis: AxisRates, x: float) -> float:
    bent = x * (1.0 + axis.expo / 100 * (x * x - 1.0))
    return 10.0 * axis.rc_rate * bent * (1.0 + x * axis.rate / 100)


def _kiss(axis: AxisRates, x: float) -> float:
    expo = axis.expo / 100
    bent = x**3 * expo + x * (1.0 - expo)
    return 2.0 * axis.rc_rate * bent / max(1.0 - x * axis.rate / 100, _SUPER_MIN)


def _actual(axis: AxisRates, x: float) -> float:
    expo, centre = axis.expo / 100, 10.0 * axis.rc_rate
    bent = x * (x**5 * expo + x * (1.0 - expo))
    return x * centre + max(0.0, 10.0 * axis.rate - centre) * bent


def _quick(axis: AxisRates, x: float) -> float:
    # without expo both of its variants are alike; with it a person has to say which
    rate = max(2.0 * axis.rc_rate, 1.0)
    full = max(10.0 * axis.rate, rate)
    return x * rate / max(1.0 - x * (1.0 - rate / full), _SUPER_MIN)


_CURVES: dict[RatesType, Callable[[AxisRates, float], float]] = {
    RatesType.BETAFLIGHT: _betaflight,
    RatesType.RACEFLIGHT: _raceflight,
    RatesType.KISS: _kiss,
    RatesType.ACTUAL: _actual,
    RatesType.QUICK: _quick,
}


def turn_rate(kind: RatesType, axis: AxisRates, deflection: float) -> float:
    """Return the turn rate that a stick asks for [degree/s], by its deflection, -1 to 1."""
    return copysign(_CURVES[kind](axis, min(abs(deflection), 1.0)), deflection)


@lru_cache(maxsize=4096)
def deflection_for(kind: RatesType, axis: AxisRates, rate: float) -> float:
    """Return the deflection of a stick, -1 to 1, that asks for a turn rate [degree/s], or for most.

    Args:
        kind: of the curve.
        axis: its numbers.
        rate: wanted.
    """
    curve, wanted = _CURVES[kind], abs(rate)
    if curve(axis, 1.0) <= wanted:
        return copysign(1.0, rate)
    low, high = 0.0, 1.0
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if curve(axis, middle) < wanted else (low, middle)
    return copysign(0.5 * (low + high), rate)


def flight_channels(sticks: RadioSticks, fc: FcSettings) -> tuple[int, int, int, int]:
    """Return roll, pitch, yaw and throttle [us] of sticks."""
    roll = _tilt_position(sticks.phi, fc.tuning.roll, fc)
    pitch = _tilt_position(sticks.theta, fc.tuning.pitch, fc)
    turn = deflection_for(fc.tuning.kind, fc.tuning.yaw, -degrees(sticks.yaw_rate))
    yaw = _position(turn, fc.yaw_deadband, fc.middle)
    return roll, pitch, yaw, throttle_position(sticks.throttle, fc)


def throttle_position(throttle: float | None, fc: FcSettings) -> int:
    """Return the position of a throttle stick [us]: off, or above what counts as off."""
    if throttle is None:
        return THROTTLE_OFF
    share = min(max(throttle, 0.0), 1.0)
    return round(fc.throttle_low + share * (THROTTLE_FULL - fc.throttle_low))


def radio_sticks_of(channels: tuple[int, int, int, int], fc: FcSettings) -> RadioSticks:
    """Return what roll, pitch, yaw and throttle [us] ask for in ANGLE mode."""
    roll, pitch, yaw, throttle = channels
    turn = turn_rate(fc.tuning.kind, fc.tuning.yaw, _deflection(yaw, fc.yaw_deadband, fc.middle))
    span = THROTTLE_FULL - fc.throttle_low
    is_off = throttle < fc.throttle_low
    return RadioSticks(
        phi=_tilt(roll, fc.tuning.roll, fc),
        theta=_tilt(pitch, fc.tuning.pitch, fc),
        yaw_rate=-radians(turn),
        throttle=None if is_off else min((throttle - fc.throttle_low) / span, 1.0),
    )


def _tilt_position(angle: float, axis: AxisRates, fc: FcSettings) -> int:
    full = turn_rate(fc.tuning.kind, axis, 1.0)
    share = degrees(angle) / max(fc.angle_limit, 1)
    deflection = deflection_for(fc.tuning.kind, axis, round(share * full, 3))
    return _position(deflection, fc.deadband, fc.middle)


def _tilt(position: int, axis: AxisRates, fc: FcSettings) -> float:
    full = turn_rate(fc.tuning.kind, axis, 1.0)
    rate = turn_rate(fc.tuning.kind, axis, _deflection(position, fc.deadband, fc.middle))
    return radians(fc.angle_limit * rate / full) if full else 0.0


def _position(deflection: float, deadband: int, middle: int) -> int:
    moved = deflection * (FULL - deadband)
    return round(middle + moved + copysign(deadband if abs(moved) >= 0.5 else 0, deflection))


def _deflection(position: int, deadband: int, middle: int) -> float:
    off = min(max(position - middle, -FULL), FULL)
    beyond = max(abs(off) - deadband, 0) / (FULL - deadband)
    return copysign(beyond, off)


def raw_channels(
    flight: tuple[int, int, int, int], positions: tuple[int, ...], fc: FcSettings
) -> tuple[int, ...]:
    """Return the channels of SET_RAW_RC [us]: the sticks in the order of the controller, switches.

    Args:
        flight: roll, pitch, yaw and throttle [us].
        positions: of the switches [us].
        fc: gives the order.
    """
    channels = [fc.middle] * 8
    for number, position in enumerate(positions):
        channels[4 + number : 5 + number] = [position]
    for channel, position in zip(fc.order, flight, strict=True):
        channels[channel] = position
    return tuple(channels)
