"""The drone's own computer: control states, commands and watchdogs.

Sources: Parrot ARDroneLib SDK 2.0.1 and docs/wires.md, section 4. It runs one control period at a
time and knows neither physics nor wires.
"""

from __future__ import annotations

from collections.abc import Callable
from math import acos, cos, radians

from housefly.config.drone import DroneConfig
from housefly.geometry import GRAVITY
from housefly.messages import AnySetpoint, Pose
from housefly.messages.stick import Stick
from housefly.twin.contracts import FlightState, OnboardLimits
from housefly.twin.quadrotor.battery import CUT_OFF_VOLTAGE, FORCED_LANDING_VOLTAGE, LOW_VOLTAGE
from housefly.twin.quadrotor.inner_loops import InnerLoops, LoopReferences
from housefly.twin.simulated_body import CONTROL_PERIOD, MOTORS_OFF, SensorReading, Wrench

WATCHDOG_AFTER = 0.05
"""Silence that raises the watchdog bit [s]."""

_TAKE_OFF_HEIGHT = 1.0
_SPIN_UP_TIME = 1.0
_TAKE_OFF_CLIMB = 0.4
_TAKE_OFF_MIN_TIME = 3.0
_TAKE_OFF_MAX_TIME = 8.0
"""Take-off: height [m], spin-up [s], climb [m/s], shortest and longest duration [s]."""

_LANDING_SINK = 0.4
_TOUCHDOWN_SINK = 0.25
_TOUCHDOWN_HEIGHT = 0.3
_TOUCHDOWN_TIME = 0.4
"""Landing: sink rate [m/s], slower below a height [m]; this long at rest [s] means ground."""
_STANDSTILL_SPEED = 0.06
_SONAR_GROUND = 0.15
_DEAF_TOUCHDOWN_TIME = 3.0
"""A sonar that sees no ground this near [m], deaf perhaps, is believed for this long [s]."""

TILT_CUTOFF = radians(65.0)
"""The drone cuts its motors when it leans further than this [rad]."""


class Firmware:
    """Major control states and their loops; call ``step`` once every ``CONTROL_PERIOD``.

    A take-off needs a land request (REF bit 9 clear) since the last one: after a landing on its
    own, the drone ignores a client that still repeats its take-off bit.
    """

    def __init__(self, drone: DroneConfig) -> None:
        self.flight = FlightState.LANDED
        self.limits = OnboardLimits()
        self.com_lost = False
        self.tilted = False
        self.powered = True
        self._loops, self._mass = InnerLoops(drone), drone.airframe.body.mass
        self._stick = Stick()
        self._may_take_off = True
        self._voltage = CUT_OFF_VOLTAGE + 3.0
        self._in_state = 0.0
        self._resting = 0.0
        self._states: dict[FlightState, Callable[[SensorReading], LoopReferences | None]] = {
            FlightState.LANDED: self._rest,
            FlightState.EMERGENCY: self._rest,
            FlightState.TAKING_OFF: self._take_off,
            FlightState.FLYING: self._fly,
            FlightState.HOVERING: self._fly,
            FlightState.LANDING: self._land,
        }

    @property
    def low_battery(self) -> bool:
        """Whether the low battery flag is up."""
        return self._voltage < LOW_VOLTAGE

    def set_stick(self, stick: Stick) -> None:
        """Set the newest movement command."""
        self._stick = stick

    def steer(self, asked: AnySetpoint) -> None:
        """Ignore it: this one takes sticks."""

    def tell_pose(self, pose: Pose, age: float) -> None:
        """Ignore it: this one wants no pose."""

    def request_take_off(self) -> None:
        """REF bit 9 set: counts on the ground, upright, and with some charge."""
        if (
            self.flight is FlightState.LANDED
            and self._may_take_off
            and not self.tilted
            and not self.low_battery
        ):
            self._may_take_off = False
            self._enter(FlightState.TAKING_OFF)

    def begin_hovering(self, height: float) -> None:
        """Hover from now on, at a height [m]: for a flight that begins in the air."""
        self._may_take_off = False
        self._loops.hold_height(height)
        self._enter(FlightState.HOVERING)

    def request_land(self) -> None:
        """REF bit 9 clear."""
        self._may_take_off = True
        if self.flight.airborne and self.flight is not FlightState.LANDING:
            self._enter(FlightState.LANDING)

    def toggle_emergency(self) -> None:
        """REF bit 8: cut the motors, or leave the emergency if upright and powered."""
        if self.flight is not FlightState.EMERGENCY:
            self._enter(FlightState.EMERGENCY)
        elif not self.tilted and self.powered:
            self._enter(FlightState.LANDED)

    def step(self, measured: SensorReading, voltage: float, silence: float) -> Wrench:
        """Run one control period.

        Args:
            measured: the sensors' newest reading.
            voltage: of the battery [V].
            silence: time since the last command of any kind [s].
        """
        self._voltage = voltage
        self._in_state += CONTROL_PERIOD
        self._check_failsafes(measured, silence)
        references = self._states[self.flight](measured)
        if references is None:
            return MOTORS_OFF
        if self.flight is FlightState.TAKING_OFF and self._in_state < _SPIN_UP_TIME:
            return Wrench(
                0.5 * self._mass * GRAVITY * self._in_state / _SPIN_UP_TIME, 0.0, 0.0, 0.0
            )
        return self._loops.wrench(references, measured)

    def _check_failsafes(self, measured: SensorReading, silence: float) -> None:
        """Apply what overrides every command: tilt, empty battery, lost client."""
        self.tilted = (
            acos(max(-1.0, min(1.0, cos(measured.phi) * cos(measured.theta)))) > TILT_CUTOFF
        )
        self.com_lost = silence > self.limits.silence
        self.powered = self._voltage > CUT_OFF_VOLTAGE
        if not self.flight.airborne:
            return
        if self.tilted or not self.powered:
            self._enter(FlightState.EMERGENCY)
        elif (
            self.com_lost or self._voltage < FORCED_LANDING_VOLTAGE
        ) and self.flight is not FlightState.LANDING:
            self._enter(FlightState.LANDING)

    def _enter(self, flight: FlightState) -> None:
        self.flight = flight
        self._in_state = 0.0
        self._resting = 0.0

    def _rest(self, measured: SensorReading) -> LoopReferences | None:
        return None

    def _take_off(self, measured: SensorReading) -> LoopReferences:
        climb = min(_TAKE_OFF_CLIMB, 0.8 * (_TAKE_OFF_HEIGHT - measured.height))
        arrived = measured.height > 0.9 * _TAKE_OFF_HEIGHT and self._in_state > _TAKE_OFF_MIN_TIME
        if arrived or self._in_state > _TAKE_OFF_MAX_TIME:
            self._loops.hold_height(_TAKE_OFF_HEIGHT if arrived else None)
            self._stick = Stick()
            self._enter(FlightState.HOVERING)
        return self._loops.hover(self.limits, measured, climb)

    def _fly(self, measured: SensorReading) -> LoopReferences:
        self.flight = FlightState.HOVERING if self._stick.hover else FlightState.FLYING
        if self._stick.hover:
            return self._loops.hover(self.limits, measured)
        return self._loops.fly(self._stick, self.limits, measured)

    def _land(self, measured: SensorReading) -> LoopReferences:
        sink = _TOUCHDOWN_SINK if measured.height < _TOUCHDOWN_HEIGHT else _LANDING_SINK
        settled = self._in_state > 1.0 and abs(measured.climb) < _STANDSTILL_SPEED
        self._resting = self._resting + CONTROL_PERIOD if settled else 0.0
        sees_ground = measured.height < _SONAR_GROUND
        if self._resting > (_TOUCHDOWN_TIME if sees_ground else _DEAF_TOUCHDOWN_TIME):
            self._enter(FlightState.LANDED)
        return self._loops.hover(self.limits, measured, -sink)
