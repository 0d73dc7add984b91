"""What a pilot's sticks say: fractions of what a full stick means."""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite

from housefly.messages.steering import Setpoint


@dataclass(frozen=True, slots=True)
class Maxima:
    """What a full stick means: tilt [rad], climb rate [m/s], yaw rate [rad/s]."""

    tilt: float
    climb: float
    yaw_rate: float


@dataclass(frozen=True, slots=True)
class Stick:
    """Both sticks, fractions -1..1 of the maxima.

    Attributes:
        forward, left, up: along the body axes.
        turn: counter-clockwise.
        hover: the sticks are let go; the drone holds its place and ignores the rest.
    """

    forward: float = 0.0
    left: float = 0.0
    up: float = 0.0
    turn: float = 0.0
    hover: bool = True


def stick_from_setpoint(setpoint: Setpoint, maxima: Maxima) -> Stick:
    """Return the sticks of a setpoint, each part cut to the maxima, or centred if not finite."""
    return Stick(
        forward=stick_fraction(setpoint.theta, maxima.tilt),
        left=-stick_fraction(setpoint.phi, maxima.tilt),
        up=stick_fraction(setpoint.vz, maxima.climb),
        turn=stick_fraction(setpoint.yaw_rate, maxima.yaw_rate),
        hover=False,
    )


def stick_fraction(value: float, maximum: float) -> float:
    """Return a value as a share of its maximum, cut to -1..1; 0 if it is not finite."""
    # Comparisons with nan would make it a full stick.
    return max(-1.0, min(1.0, value / maximum)) if isfinite(value) else 0.0
