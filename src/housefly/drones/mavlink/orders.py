"""What a vehicle is told, and in which order: mode, arming, take-off, setpoints, landing. Pure.

Who flies it by another mode than ours, a person with a remote control or the autopilot's own
failsafe, keeps it: nothing but cutting the motors is told until it is down.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from housefly.drones.mavlink.vehicle import Vehicle
from housefly.messages import Action, AnySetpoint, DroneStatus, VelocitySetpoint
from housefly.messages.sensing import AIRBORNE_STATUSES
from housefly.messages.steering import Instruction
from housefly.wires.mavlink.autopilots import FlightMode

_REPEAT_AFTER = 0.5
"""An order whose effect does not show is repeated after this [s]."""
_STREAM_TIME = 0.6
"""Setpoints must have come for so long before a mode that wants them is asked for [s]."""


class Deed(Enum):
    """What is told once, until its effect shows."""

    ARM = "arm"
    DISARM = "disarm"
    CUT = "cut the motors"
    TAKE_OFF = "take off"


Order = Deed | FlightMode | AnySetpoint


@dataclass(slots=True)
class _Flight:
    """What holds until it stands again."""

    asked: set[int]
    is_engaged: bool = False


class Orders:
    """Turns an instruction into what is sent now.

    Args:
        vehicle: what it tells of itself.
    """

    def __init__(self, vehicle: Vehicle) -> None:
        self._vehicle, self._autopilot = vehicle, vehicle.autopilot
        self._sent_at: dict[Deed | FlightMode, float] = {}
        self._streaming_since: float | None = None
        self._streamed_at = float("-inf")
        self._flight = _Flight(set())
        self._armed_by_us = False
        self._action = Action.IDLE

    def is_taken(self, now: float) -> bool:
        """Return whether somebody else flies it, or it does so by itself."""
        vehicle, autopilot = self._vehicle, self._autopilot
        if vehicle.status(now) not in AIRBORNE_STATUSES:
            return False
        ours = {autopilot.steered.number, *self._flight.asked}
        ours |= frozenset() if self._flight.is_engaged else autopilot.passing
        return vehicle.mode not in ours

    def due(self, told: Instruction, now: float) -> tuple[Order, ...]:
        """Return what is sent now [s], in order."""
        command = told.command
        if command.action is not self._action:
            self._action = command.action
            self._sent_at.clear()
        self._follow(now)
        if command.action is Action.RESET:
            self._vehicle.is_cut = False
        if command.action is Action.CUT:
            self._vehicle.is_cut = True
            is_off = self._vehicle.is_heard(now) and not self._vehicle.armed
            return () if is_off else self._once(Deed.CUT, now)
        if self.is_taken(now):
            self._streaming_since = None
            return ()
        match command.action:
            case Action.FLY:
                return self._steered(command.asked, now)
            case Action.HOVER:
                return self._steered(VelocitySetpoint(), now)
            case Action.TAKE_OFF:
                return self._rising(now)
            case Action.LAND | Action.IDLE:
                return self._down(now, told.lands_all)
        return ()

    def _follow(self, now: float) -> None:
        """Note what the newest heartbeat says of this flight."""
        vehicle = self._vehicle
        if vehicle.status(now) not in AIRBORNE_STATUSES:
            self._flight = _Flight(set())
        elif vehicle.mode == self._autopilot.steered.number:
            self._flight.is_engaged = True
        self._armed_by_us &= vehicle.armed or Deed.ARM in self._sent_at

    def _steered(self, asked: AnySetpoint, now: float) -> tuple[Order, ...]:
        """Return a setpoint, and the mode that heeds it once that may be asked for."""
        return (*self._streamed(asked, now), *self._mode(self._autopilot.steered, now))

    def _streamed(self, asked: AnySetpoint, now: float) -> tuple[AnySetpoint, ...]:
        if self._streaming_since is None or now - self._streamed_at > _REPEAT_AFTER:
            self._streaming_since = now
        self._streamed_at = now
        return (asked,)

    def _mode(self, mode: FlightMode, now: float) -> tuple[Order, ...]:
        if self._vehicle.mode == mode.number and self._vehicle.is_heard(now):
            return ()
        is_fresh = self._streaming_since is None or now - self._streaming_since < _STREAM_TIME
        if mode is self._autopilot.steered and self._autopilot.stream_first and is_fresh:
            return ()
        self._flight.asked.add(mode.number)
        return self._once(mode, now)

    def _rising(self, now: float) -> tuple[Order, ...]:
        vehicle, autopilot = self._vehicle, self._autopilot
        # a setpoint would end ArduCopter's take-off, and PX4 wants them before its mode
        level = self._streamed(VelocitySetpoint(), now) if autopilot.stream_first else ()
        is_ready = vehicle.mode == autopilot.ready.number
        climbs = vehicle.armed and vehicle.mode in autopilot.passing and not is_ready
        if vehicle.status(now) is not DroneStatus.LANDED or climbs:
            return level
        if not is_ready:
            return (*level, *self._mode(autopilot.ready, now))
        if not vehicle.armed:
            self._armed_by_us = True
            return (*level, *self._once(Deed.ARM, now))
        return (*level, *self._once(Deed.TAKE_OFF, now))

    def _down(self, now: float, lands_all: bool) -> tuple[Order, ...]:
        self._streaming_since = None
        status = self._vehicle.status(now)
        must_be_told = lands_all or self._action is Action.LAND
        if status in AIRBORNE_STATUSES or (status is DroneStatus.UNKNOWN and must_be_told):
            return self._mode(self._autopilot.landing, now)
        stands = status is DroneStatus.LANDED and self._action is Action.IDLE
        if stands and self._vehicle.armed and self._armed_by_us:
            return self._once(Deed.DISARM, now)
        return ()

    def _once(self, order: Deed | FlightMode, now: float) -> tuple[Order, ...]:
        if now - self._sent_at.get(order, float("-inf")) < _REPEAT_AFTER:
            return ()
        self._sent_at[order] = now
        return (order,)
