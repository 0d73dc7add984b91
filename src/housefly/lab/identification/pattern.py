"""The steps flown to identify a drone: a few, repeated, each ending close to where it began."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum
from math import exp, floor, tan

from housefly.geometry import GRAVITY
from housefly.messages import Setpoint


class Axis(Enum):
    """What a block moves."""

    PITCH = "pitch"
    ROLL = "roll"
    CLIMB = "climb"
    TURN = "turn"


TILT_AXES = (Axis.PITCH, Axis.ROLL)


_THERE_AND_BACK = (1.0, -1.0, -1.0, 1.0)
"""Signs of the parts of a block that ends at rest where it began."""
_UP_AND_DOWN = (1.0, -1.0)
"""Signs of a climb block.

A drone may sink twice as fast as it climbs for the same stick, so four parts would lead to the
floor.
"""


@dataclass(frozen=True, slots=True)
class Block:
    """A few parts of equal length, then zero for ``tail``.

    Attributes:
        axis: what moves.
        amplitude: with the sign of the first part [rad, m/s or rad/s].
        part: length of a part [s].
        signs: of the parts.
        tail: how long the drone is left level afterwards [s]; what it does then tells lag and drag.
    """

    axis: Axis
    amplitude: float
    part: float
    signs: tuple[float, ...] = _THERE_AND_BACK
    tail: float = 0.3

    @property
    def duration(self) -> float:
        """Of the whole block [s]."""
        return len(self.signs) * self.part + self.tail

    def asked(self, elapsed: float) -> float:
        """Return the command ``elapsed`` seconds after the block began."""
        index = floor(elapsed / self.part)
        return self.amplitude * self.signs[index] if 0 <= index < len(self.signs) else 0.0

    def setpoint(self, elapsed: float) -> Setpoint:
        """Return the setpoint at that time; every other axis is zero."""
        value = self.asked(elapsed)
        return {
            Axis.PITCH: Setpoint(theta=value),
            Axis.ROLL: Setpoint(phi=value),
            Axis.CLIMB: Setpoint(vz=value),
            Axis.TURN: Setpoint(yaw_rate=value),
        }[self.axis]

    def reversed(self) -> Block:
        """Return the block with opposite signs."""
        return replace(self, amplitude=-self.amplitude)


_TILT_SHARE = 0.4
"""Share of the largest tilt that is commanded, as in the paper's Fig. 11."""
_TILT_PART, _CLIMB_PART, _TURN_PART = 0.6, 1.0, 0.5
"""Lengths of the parts [s]."""
_CLIMB_SPEED, _TURN_RATE = 0.25, 0.8
"""Amplitudes [m/s, rad/s]."""
_SLACK = 2.0
"""Excursions are predicted for drones this many times quicker or slower than believed."""


def blocks(repeats: int, tilt_max: float) -> tuple[Block, ...]:
    """Return all blocks of a flight: each axis ``repeats`` times, in alternating directions."""
    tilt = _TILT_SHARE * tilt_max
    kinds = (
        Block(Axis.PITCH, tilt, _TILT_PART),
        Block(Axis.ROLL, tilt, _TILT_PART),
        Block(Axis.TURN, _TURN_RATE, _TURN_PART),
        Block(Axis.CLIMB, _CLIMB_SPEED, _CLIMB_PART, _UP_AND_DOWN, tail=0.0),
    )
    return tuple(
        kind if turn % 2 == 0 else kind.reversed() for turn in range(repeats) for kind in kinds
    )


def excursion(block: Block, lag: float, gain: float, drag: float, delay: float) -> float:
    """Return the farthest that a tilt block takes a drone [m], with its delay and level tail."""
    reach, place, speed, angle, at = 0.0, 0.0, 0.0, 0.0, 0.0
    step = 0.01
    while at < block.duration + delay:
        wanted = gain * block.asked(at - delay)
        angle = wanted + (angle - wanted) * exp(-lag * step)
        speed += step * (GRAVITY * tan(angle) - drag * speed)
        place += step * speed
        reach = max(reach, abs(place))
        at += step
    return reach


def largest_excursion(
    plan: tuple[Block, ...], lag: float, gain: float, drag: float, delay: float
) -> float:
    """Return the largest excursion of any tilt block [m].

    The drone may be ``_SLACK`` times quicker, slower or later, and stronger.
    """
    tilts = {abs(block.amplitude): block for block in plan if block.axis in TILT_AXES}
    drones = [
        (lag * pace, gain * strength, drag / _SLACK, delay * late)
        for pace in (1.0 / _SLACK, 1.0, _SLACK)
        for strength in (1.0, 1.25)
        for late in (1.0, _SLACK)
    ]
    return max(
        (excursion(block, *drone) for block in tilts.values() for drone in drones), default=0.0
    )
