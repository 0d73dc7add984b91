"""Which AT commands leave next, from the command in force and the drone's newest report.

Pure; the driver and the lock-step room share it. The take-off bit is sent only on the ground and
under a take-off command, never in flight: a drone that landed by itself would rise again; and only
when its configuration is known to be ours.

The watchdog over the pilot is here as well: a pilot that falls silent, or is gone, leaves a drone
that brakes, hovers and lands, also one that does not say whether it flies. An order that moves the
drone and comes late counts for nothing.
"""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum
from math import isfinite, radians

from housefly.messages import LEVEL, Action, Command, DroneStatus, KnownMotion, Setpoint, Telemetry
from housefly.messages.sensing import AIRBORNE_STATUSES, REPORT_AGE_MAX
from housefly.wires.ardrone import at
from housefly.wires.ardrone.brake import (
    BRAKE_TIME_MAX,
    ON_FLOOR,
    SINK_TIME_MAX,
    AttitudeSpeed,
    braking_setpoint,
    sinking_setpoint,
)
from housefly.wires.ardrone.conversions import Maxima, pcmd_from_setpoint
from housefly.wires.ardrone.emergency_button import EmergencyButton

SEND_INTERVAL = 0.030
"""Time between datagrams that the drone's makers recommend [s]."""
SEND_INTERVAL_MIN = 0.027
"""A setpoint leaves at once when the last datagram is this old [s]: 3 ms early does not wait."""
REPEAT_AFTER = 0.035
"""Without a new command the one in force is repeated after this long [s].

The drone complains after 50 ms.
"""
HOVER_AFTER = 0.25
"""Silence of the pilot after which a flying drone brakes and hovers [s]."""
LAND_AFTER = 2.0
"""Silence of the pilot after which a flying drone lands [s]."""
TRIM_TIME = 0.1
"""How long flat trim is repeated before take-off [s]."""
TRIM_TILT_MAX = radians(1.5)
"""A drone that leans more than this is not trimmed [rad]: it would take the lean of its pad for
level, and take off along it.
"""
_GROUNDED = frozenset({DroneStatus.LANDED, DroneStatus.EMERGENCY})
_MOVES = frozenset({Action.FLY, Action.TAKE_OFF, Action.RESET})
"""What is worth nothing when it comes late."""

_HOVER = at.Pcmd()
_LAND = at.Ref(at.RefBits.LAND)
_TAKE_OFF = at.Ref(at.RefBits.TAKE_OFF)
_PRESS = at.Ref(at.RefBits.EMERGENCY)


class Permit(Enum):
    """What the driver lets the pilot do; cutting the motors always passes."""

    ALL = "all"
    HOVER_AND_LAND = "hover and land"
    LAND = "land"


class CommandSequencer:
    """Turns the command in force into AT commands, with a watchdog over the pilot.

    Args:
        maxima: as below.
        now: of the first command [s].
        watched: False repeats the last command for ever; for negative controls only.

    Attributes:
        maxima: what a full stick means to the drone now.
        permit: what the pilot may do.
    """

    def __init__(self, maxima: Maxima, now: float, *, watched: bool = True) -> None:
        self.maxima = maxima
        self._watched = watched
        self.permit = Permit.ALL
        self._action = Action.IDLE
        self._setpoint = Setpoint()
        self._commanded_at = now
        self._action_since = now
        self._has_taken_off = False
        self._must_land = False
        self._is_gone = False
        self._refused_at: float | None = None
        self._braking_since: float | None = None
        self._sinking_since: float | None = None
        self._speed = AttitudeSpeed()
        self._button = EmergencyButton()
        self._table: dict[Action, Callable[[float, Telemetry | None], tuple[at.AtCommand, ...]]] = {
            Action.IDLE: self._idle,
            Action.TAKE_OFF: self._take_off,
            Action.FLY: lambda now, report: (pcmd_from_setpoint(self._setpoint, self.maxima),),
            Action.HOVER: lambda now, report: (_HOVER,),
            Action.LAND: lambda now, report: (_LAND, _HOVER),
            Action.CUT: self._cut,
            Action.RESET: self._reset,
        }

    def update(
        self,
        command: Command,
        now: float,
        issued_at: float | None = None,
        motion: KnownMotion | None = None,
    ) -> bool:
        """Put a command in force; return whether its action differs from the one before.

        A command older than the one in force is ignored, and so is one that moves the drone and
        comes later than ``HOVER_AFTER``, and a setpoint that is not numbers: to the watchdog a
        pilot that sends nothing else is silent.

        Args:
            command: of the pilot.
            now: [s].
            issued_at: when the pilot gave it [s]; now when None.
            motion: what it knew of the drone's motion; None says nothing new.
        """
        at_time = now if issued_at is None else min(issued_at, now)
        is_late = now - at_time > HOVER_AFTER and command.action in _MOVES
        if at_time < self._commanded_at or is_late or not _is_in_numbers(command):
            return False
        self._commanded_at = at_time
        self._is_gone = False
        self._setpoint = command.setpoint
        self._speed.ask(command.setpoint if command.action is Action.FLY else LEVEL)
        if motion is not None:
            self._speed.know(motion, at_time)
        changed = command.action is not self._action
        if changed:
            self._action = command.action
            self._action_since = now
            self._has_taken_off = False
            self._button.reset(now)
        return changed

    def abandon(self) -> None:
        """Note that the pilot is gone: its silence need not be waited for."""
        self._is_gone = True

    def next_commands(self, now: float, report: Telemetry | None) -> tuple[at.AtCommand, ...]:
        """Return what to send now [s], given the drone's newest report."""
        if report is not None:
            self._speed.update(report)
        action = self._action_in_force(now, report)
        if action not in (Action.CUT, Action.RESET):
            self._button.release(now)
        is_left = self._is_silent(now) and action in (Action.HOVER, Action.LAND)
        is_flying = report is not None and report.status is DroneStatus.FLYING
        if not (is_left and is_flying):
            self._sinking_since = self._braking_since = None
        elif not self._speed.motion.hovers:
            return self._sink(now, report)
        elif action is Action.HOVER and report is not None:
            return self._brake(now, report)
        return self._table[action](now, report)

    def _sink(self, now: float, report: Telemetry | None) -> tuple[at.AtCommand, ...]:
        """Brake and sink level: the drone's own hover would fly by a speed that is wrong."""
        if self._sinking_since is None:
            self._sinking_since = now
        is_low = report is not None and report.height < ON_FLOOR
        is_long = now - self._sinking_since > SINK_TIME_MAX
        if is_long or (is_low and now - self._sinking_since > 1.0):
            return (_LAND, _HOVER)
        setpoint = sinking_setpoint(now, report, self._speed, self.maxima.tilt)
        self._speed.ask(setpoint)
        return (pcmd_from_setpoint(setpoint, self.maxima),)

    def _is_silent(self, now: float) -> bool:
        return self._watched and (self._is_gone or now - self._commanded_at > HOVER_AFTER)

    def _action_in_force(self, now: float, report: Telemetry | None) -> Action:
        """Return the pilot's action, or what the watchdog puts in its place."""
        airborne = report is not None and report.status in AIRBORNE_STATUSES
        if self._action in (Action.CUT, Action.RESET):
            self._must_land &= airborne
            return self._action
        action = self._permitted(now)
        is_refused = self._refused_at is not None and now - self._refused_at > LAND_AFTER
        is_over = self._is_over(now) or is_refused
        self._must_land = airborne and (self._must_land or is_over)
        if self._must_land:
            # a take-off command from before the silence must not count again after it
            self._has_taken_off = True
            return Action.LAND
        if self._is_silent(now) and action is not Action.LAND:
            return Action.HOVER if airborne else Action.IDLE
        return action

    def _is_over(self, now: float) -> bool:
        """Return whether whatever is in the air has to land."""
        is_late = self._watched and now - self._commanded_at > LAND_AFTER
        return is_late or self.permit is Permit.LAND

    def _permitted(self, now: float) -> Action:
        """Return the pilot's action, or the strongest one that it may have in its place."""
        if self.permit is Permit.ALL or self._action not in _MOVES:
            self._refused_at = None
            return self._action
        self._refused_at = now if self._refused_at is None else self._refused_at
        return Action.HOVER if self.permit is Permit.HOVER_AND_LAND else Action.IDLE

    def _brake(self, now: float, report: Telemetry) -> tuple[at.AtCommand, ...]:
        """Lean against the drone's own speed; once at rest, leave the rest of the silence to it."""
        if self._braking_since is None:
            self._braking_since = now
        setpoint = None
        if now - self._braking_since <= BRAKE_TIME_MAX:
            setpoint = braking_setpoint(now, report, self._speed, self.maxima.tilt)
        if setpoint is None:
            self._braking_since = float("-inf")
            return (_HOVER,)
        self._speed.ask(setpoint)
        return (pcmd_from_setpoint(setpoint, self.maxima),)

    def _idle(self, now: float, report: Telemetry | None) -> tuple[at.AtCommand, ...]:
        is_fresh = report is not None and now - report.received_at <= REPORT_AGE_MAX
        if report is not None and is_fresh and report.status in _GROUNDED:
            return (_LAND, at.ComWatchdog())
        if self._is_over(now):
            return (_LAND, _HOVER, at.ComWatchdog())
        # in the air this ends a stick that a driver before us left; on the ground it is nothing
        return (_HOVER, at.ComWatchdog())

    def _take_off(self, now: float, report: Telemetry | None) -> tuple[at.AtCommand, ...]:
        if report is not None and report.status in AIRBORNE_STATUSES:
            self._has_taken_off |= report.status is not DroneStatus.LANDING
            return (_TAKE_OFF, _HOVER) if report.status is DroneStatus.TAKING_OFF else (_HOVER,)
        if (
            report is None
            or now - report.received_at > REPORT_AGE_MAX
            or report.status is not DroneStatus.LANDED
            or not report.configured
            or self._has_taken_off
        ):
            return self._idle(now, report)
        if now - self._action_since < TRIM_TIME:
            is_leaning = max(abs(report.phi), abs(report.theta)) > TRIM_TILT_MAX
            return (_LAND,) if is_leaning else (_LAND, at.FlatTrim())
        return (_TAKE_OFF,)

    def _cut(self, now: float, report: Telemetry | None) -> tuple[at.AtCommand, ...]:
        wanted = report is None or report.status is not DroneStatus.EMERGENCY
        return self._press(now, report, wanted=wanted)

    def _reset(self, now: float, report: Telemetry | None) -> tuple[at.AtCommand, ...]:
        if report is not None and report.status in AIRBORNE_STATUSES:
            self._button.release(now)
            return self._idle(now, report)
        wanted = report is not None and report.status is DroneStatus.EMERGENCY
        return self._press(now, report, wanted=wanted)

    def _press(
        self, now: float, report: Telemetry | None, *, wanted: bool
    ) -> tuple[at.AtCommand, ...]:
        if wanted and self._button.hold(now, report.received_at if report else None):
            return (_PRESS,)
        self._button.release(now)
        return (_LAND,)


def _is_in_numbers(command: Command) -> bool:
    """Return whether a command can be flown; only to fly needs a setpoint."""
    asked = command.setpoint
    return command.action is not Action.FLY or (
        isfinite(asked.theta)
        and isfinite(asked.phi)
        and isfinite(asked.vz)
        and isfinite(asked.yaw_rate)
    )
