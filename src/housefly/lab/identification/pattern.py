"""What is flown to learn a drone's constants: the same few steps, again and again, each ending near
where it began.
"""

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


TILTS = (Axis.PITCH, Axis.ROLL)


THERE_AND_BACK = (1.0, -1.0, -1.0, 1.0)
"""Signs of the parts of a block that ends where it began, and at rest."""
UP_AND_DOWN = (1.0, -1.0)
"""An AR.Drone sinks up to twice as fast as it climbs for the same stick, so the longer way would
lead to the floor.
"""


@dataclass(frozen=True, slots=True)
class Block:
    """A few parts of equal length, then nothing for ``tail``.

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
    signs: tuple[float, ...] = THERE_AND_BACK
    tail: float = 0.3

    @property
    def duration(self) -> float:
        """Of the whole block [s]."""
        return len(self.signs) * self.part + self.tail

    def asked(self, elapsed: float) -> float:
        """Return what is asked ``elapsed`` seconds after the block began."""
        index = floor(elapsed / self.part)
        return self.amplitude * self.signs[index] if 0 <= index < len(self.signs) else 0.0

    def setpoint(self, elapsed: float) -> Setpoint:
        """Return the setpoint at that time; everything but the block's own axis is level and still."""
        value = self.asked(elapsed)
        return {
            Axis.PITCH: Setpoint(theta=value),
            Axis.ROLL: Setpoint(phi=value),
            Axis.CLIMB: Setpoint(vz=value),
            Axis.TURN: Setpoint(yaw_rate=value),
        }[self.axis]

    def reversed(self) -> Block:
        """Return the block that begins the other way."""
        return replace(self, amplitude=-self.amplitude)


TILT_SHARE = 0.4
"""Share of the largest tilt that is commanded, as in the paper's Fig. 11."""
TILT_PART, CLIMB_PART, TURN_PART = 0.6, 1.0, 0.5
"""Lengths of the parts [s]."""
CLIMB_SPEED, TURN_RATE = 0.25, 0.8
"""Amplitudes [m/s, rad/s]."""
SLACK = 2.0
"""Excursions are predicted for drones this many times as quick or as slow as believed."""


def blocks(repeats: int, tilt_max: float) -> tuple[Block, ...]:
    """Return all blocks of a flight in order: each axis ``repeats`` times, beginning the one way
    and the other in turn.
    """
    tilt = TILT_SHARE * tilt_max
    kinds = (
        Block(Axis.PITCH, tilt, TILT_PART),
        Block(Axis.ROLL, tilt, TILT_PART),
        Block(Axis.TURN, TURN_RATE, TURN_PART),
        Block(Axis.CLIMB, CLIMB_SPEED, CLIMB_PART, UP_AND_DOWN, tail=0.0),
    )
    return tuple(
        kind if turn % 2 == 0 else kind.reversed() for turn in range(repeats) for kind in kinds
    )


def excursion(block: Block, lag: float, gain: float, drag: float, delay: float) -> float:
    """Return how far a tilt block takes a drone from where it began [m], at most, its delay and
    level tail included.
    """
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
    """Return the largest excursion of any tilt block [m] for a drone up to ``SLACK`` quicker,
    slower, later or stronger.
    """
    tilts = {abs(block.amplitude): block for block in plan if block.axis in TILTS}
    drones = [
        (lag * pace, gain * strength, drag / SLACK, delay * late)
        for pace in (1.0 / SLACK, 1.0, SLACK)
        for strength in (1.0, 1.25)
        for late in (1.0, SLACK)
    ]
    return max(
        (excursion(block, *drone) for block in tilts.values() for drone in drones), default=0.0
    )
