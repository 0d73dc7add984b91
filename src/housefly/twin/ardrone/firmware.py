"""The drone's own computer: which state it is in, what it listens to, when it cuts its motors.

States and watchdogs: Parrot ARDroneLib SDK 2.0.1 and docs/wires.md, section 4. The class is driven
    one control period at a
time and knows neither physics nor wires.
"""

from __future__ import annotations

from collections.abc import Callable
from math import acos, cos, radians

from housefly.config.site import DroneConfig
from housefly.geometry import GRAVITY
from housefly.twin.ardrone.battery import CUT_OFF_VOLTAGE, FORCED_LANDING_VOLTAGE, LOW_VOLTAGE
from housefly.twin.ardrone.body import MASS
from housefly.twin.ardrone.onboard_loops import REST, OnboardLoops, References, Wrench
from housefly.twin.ardrone.onboard_sensors import PERIOD, Measured
from housefly.twin.contracts import Flight, OnboardLimits, Stick

WATCHDOG_FLAG = 0.05
COM_LOST = 2.0
"""Silence [s] that raises the watchdog bit, and that makes the drone brake and land by itself."""

TAKE_OFF_HEIGHT = 1.0
SPIN_UP = 1.0
TAKE_OFF_CLIMB = 0.4
TAKE_OFF_MIN = 3.0
TAKE_OFF_MAX = 8.0
"""Take-off: height [m], motors turning before lift [s], climb [m/s], shortest and longest duration
[s].
"""

LANDING_SINK = 0.4
TOUCHDOWN_SINK = 0.25
TOUCHDOWN_HEIGHT = 0.3
TOUCHDOWN_REST = 0.4
"""Landing: sink [m/s] down to a height [m], then slower; standing still this long [s] while sinking
means ground.
"""
STILL = 0.06

TILT_MAX = radians(65.0)
"""Leaning further than this, the drone gives up and cuts its motors."""

AIRBORNE = frozenset({Flight.TAKING_OFF, Flight.FLYING, Flight.HOVERING, Flight.LANDING})


class Firmware:
    """Major control states and their loops; call ``step`` once every ``PERIOD``.

    A take-off needs a land request (REF bit 9 clear) since the last one: after a landing that
    nobody asked for, a client that still repeats its take-off bit does not start the drone again.
    """

    def __init__(self, drone: DroneConfig) -> None:
        self.flight = Flight.LANDED
        self.limits = OnboardLimits()
        self.com_lost = False
        self.tilted = False
        self.powered = True
        self._loops = OnboardLoops(drone)
        self._stick = Stick()
        self._may_take_off = True
        self._voltage = CUT_OFF_VOLTAGE + 3.0
        self._in_state = 0.0
        self._resting = 0.0
        self._states: dict[Flight, Callable[[Measured], References | None]] = {
            Flight.LANDED: self._rest,
            Flight.EMERGENCY: self._rest,
            Flight.TAKING_OFF: self._take_off,
            Flight.FLYING: self._fly,
            Flight.HOVERING: self._fly,
            Flight.LANDING: self._land,
        }

    @property
    def low_battery(self) -> bool:
        """Whether the drone complains about its battery."""
        return self._voltage < LOW_VOLTAGE

    def stick(self, stick: Stick) -> None:
        """Take the newest movement command."""
        self._stick = stick

    def request_take_off(self) -> None:
        """REF bit 9 set: counts on the ground, upright, and with some charge."""
        if (
            self.flight is Flight.LANDED
            and self._may_take_off
            and not self.tilted
            and not self.low_battery
        ):
            self._may_take_off = False
            self._enter(Flight.TAKING_OFF)

    def request_land(self) -> None:
        """REF bit 9 clear."""
        self._may_take_off = True
        if self.flight in AIRBORNE and self.flight is not Flight.LANDING:
            self._enter(Flight.LANDING)

    def toggle_emergency(self) -> None:
        """REF bit 8: cut the motors, or leave the emergency when the drone stands upright and has
        power.
        """
        if self.flight is not Flight.EMERGENCY:
            self._enter(Flight.EMERGENCY)
        elif not self.tilted and self.powered:
            self._enter(Flight.LANDED)

    def step(self, measured: Measured, voltage: float, silence: float) -> Wrench:
        """Run one control period.

        Args:
            measured: the sensors' newest reading.
            voltage: of the battery [V].
            silence: time since the last command of any kind [s].
        """
        self._voltage = voltage
        self._in_state += PERIOD
        self._watch(measured, silence)
        references = self._states[self.flight](measured)
        if references is None:
            return REST
        if self.flight is Flight.TAKING_OFF and self._in_state < SPIN_UP:
            return Wrench(0.5 * MASS * GRAVITY * self._in_state / SPIN_UP, 0.0, 0.0, 0.0)
        return self._loops.wrench(references, measured)

    def _watch(self, measured: Measured, silence: float) -> None:
        """Apply what overrides every command: tilt, empty battery, lost client."""
        self.tilted = acos(max(-1.0, min(1.0, cos(measured.phi) * cos(measured.theta)))) > TILT_MAX
        self.com_lost = silence > COM_LOST
        self.powered = self._voltage > CUT_OFF_VOLTAGE
        if self.flight not in AIRBORNE:
            return
        if self.tilted or not self.powered:
            self._enter(Flight.EMERGENCY)
        elif (
            self.com_lost or self._voltage < FORCED_LANDING_VOLTAGE
        ) and self.flight is not Flight.LANDING:
            self._enter(Flight.LANDING)

    def _enter(self, flight: Flight) -> None:
        self.flight = flight
        self._in_state = 0.0
        self._resting = 0.0

    def _rest(self, measured: Measured) -> References | None:
        return None

    def _take_off(self, measured: Measured) -> References:
        climb = min(TAKE_OFF_CLIMB, 0.8 * (TAKE_OFF_HEIGHT - measured.height))
        arrived = measured.height > 0.9 * TAKE_OFF_HEIGHT and self._in_state > TAKE_OFF_MIN
        if arrived or self._in_state > TAKE_OFF_MAX:
            self._loops.hold_height(TAKE_OFF_HEIGHT if arrived else None)
            self._stick = Stick()
            self._enter(Flight.HOVERING)
        return self._loops.hover(self.limits, measured, climb)

    def _fly(self, measured: Measured) -> References:
        self.flight = Flight.HOVERING if self._stick.hover else Flight.FLYING
        if self._stick.hover:
            return self._loops.hover(self.limits, measured)
        return self._loops.fly(self._stick, self.limits, measured)

    def _land(self, measured: Measured) -> References:
        sink = TOUCHDOWN_SINK if measured.height < TOUCHDOWN_HEIGHT else LANDING_SINK
        settled = self._in_state > 1.0 and abs(measured.climb) < STILL
        self._resting = self._resting + PERIOD if settled else 0.0
        if self._resting > TOUCHDOWN_REST:
            self._enter(Flight.LANDED)
        return self._loops.hover(self.limits, measured, -sink)
