"""Four rotors: what each is told, how fast it follows, and what all of them push. Pure."""

from __future__ import annotations

from math import exp

from housefly.twin.disturbance import MotorGains
from housefly.twin.drone_mechanics import Mechanics
from housefly.twin.quadrotor.motors import rotor_wrench
from housefly.twin.simulated_body import MOTORS_OFF, Wrench

_LAG = 0.02
"""A rotor follows what it is told within this [s]; assumed for propellers of 6 inches."""
_BEND = 0.65
"""Share of the square in thrust over throttle: ArduPilot, MOT_THST_EXPO."""
_STILL = 1e-3
"""A rotor that has less than this share of its throttle stands."""


class Rotors:
    """The rotors of one drone, in the order of ``quadrotor.motors``.

    Args:
        mechanics: thrust and arm.
    """

    def __init__(self, mechanics: Mechanics) -> None:
        self._mechanics = mechanics
        self._turning: MotorGains = (0.0, 0.0, 0.0, 0.0)

    def step(self, told: MotorGains, seconds: float) -> Wrench:
        """Let time pass; return what they push.

        Args:
            told: throttle of each, 0 to 1.
            seconds: how long they are told so [s].
        """
        kept = exp(-seconds / _LAG)
        front_left, front_right, rear_right, rear_left = (
            wanted + kept * (turns - wanted)
            for wanted, turns in zip(told, self._turning, strict=True)
        )
        self._turning = front_left, front_right, rear_right, rear_left
        if max(self._turning) < _STILL:
            return MOTORS_OFF
        return rotor_wrench(
            (lift(front_left), lift(front_right), lift(rear_right), lift(rear_left)),
            self._mechanics,
        )


def lift(throttle: float) -> float:
    """Return the share of its full thrust that a rotor has at a throttle, both 0 to 1."""
    return (1.0 - _BEND) * throttle + _BEND * throttle * throttle
