"""A stranger's firmware as the computer of a simulated drone: it flies, we only look.

It has its own sensors, states and watchdogs, and hears its own wire: sticks, setpoints and poses of
the simulated drone's servers do not reach it. Between two control periods it is stepped once more,
as often as physics is.
"""

from __future__ import annotations

from collections.abc import Callable
from math import exp
from typing import Protocol

from housefly.config.drone import DroneConfig
from housefly.twin.contracts import FlightState
from housefly.twin.disturbance import MotorGains
from housefly.twin.drone_mechanics import Mechanics, mechanics_of
from housefly.twin.quadrotor.battery import CUT_OFF_VOLTAGE
from housefly.twin.quadrotor.firmware import Firmware
from housefly.twin.quadrotor.motors import rotor_wrench
from housefly.twin.simulated_body import (
    MOTORS_OFF,
    PHYSICS_PERIOD,
    BodyState,
    SensorReading,
    Wrench,
)

_OFF_GROUND = 0.05
"""A drone this high above where it stands flies [m]."""
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


class Board(Protocol):
    """What answers a state of the body with what the four motors are told."""

    def exchange(self, at: float, body: BodyState) -> MotorGains:
        """Return throttles, 0 to 1, for the step that begins now [s]; order as everywhere."""
        ...


class BoardedFirmware(Firmware):
    """One such firmware.

    Args:
        drone: whose motors it drives.
        board: the program.
        body: returns the true state.
    """

    def __init__(self, drone: DroneConfig, board: Board, body: Callable[[], BodyState]) -> None:
        super().__init__(drone)
        self._board, self._body = board, body
        mechanics = mechanics_of(drone.airframe)
        self._rotors, self._standing = Rotors(mechanics), mechanics.standing_height
        self._steps = 0

    def step(self, measured: SensorReading, voltage: float, silence: float) -> Wrench:
        """Run the first physics step of a control period; silence is the program's own affair."""
        self.powered = voltage > CUT_OFF_VOLTAGE
        return self.step_again()

    def step_again(self) -> Wrench:
        """Run one physics step."""
        body = self._body()
        told = self._board.exchange(self._steps * PHYSICS_PERIOD, body)
        self._steps += 1
        pushed = self._rotors.step(told, PHYSICS_PERIOD)
        is_up = body.position[2] > self._standing + _OFF_GROUND and pushed.thrust > 0.0
        self.flight = FlightState.FLYING if is_up else FlightState.LANDED
        return pushed
