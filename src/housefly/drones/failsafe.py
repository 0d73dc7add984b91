"""What a drone is told, whatever its pilot says or does not say: the same for every drone.

Pure; drivers and lock step share it. A pilot that falls silent, or is gone, leaves a drone that
brakes, hovers and lands, also one that does not say whether it flies. An order that moves the drone
and comes late counts for nothing. A take-off counts once, on the ground only, and only when the
drone's limits are known to be ours: a drone that landed by itself would rise again. A drone that
is found in the air only hovers and lands; a driver that leaves brings down what flies.
"""

from __future__ import annotations

from enum import Enum
from math import isfinite

from housefly.config.airframe import Airframe
from housefly.drones.brake import ON_FLOOR, SINK_TIME_MAX, AttitudeSpeed
from housefly.drones.standstill import standstill_of
from housefly.messages import (
    LEVEL,
    Action,
    AnySetpoint,
    Command,
    DroneStatus,
    KnownMotion,
    Telemetry,
)
from housefly.messages.sensing import AIRBORNE_STATUSES, REPORT_AGE_MAX
from housefly.messages.steering import Instruction, flying, numbers_of

HOVER_AFTER = 0.25
"""Silence of the pilot after which a flying drone brakes and hovers [s]."""
LAND_AFTER = 2.0
"""Silence of the pilot after which a flying drone lands [s]."""
_MOVES = frozenset({Action.FLY, Action.TAKE_OFF, Action.RESET})
"""What is worth nothing when it comes late."""


class Permit(Enum):
    """What the driver lets the pilot do; cutting the motors always passes."""

    ALL = "all"
    HOVER_AND_LAND = "hover and land"
    LAND = "land"


class Failsafe:
    """Stands between one pilot and one drone.

    Args:
        now: of the first command [s].
        tilt_max: as below.
        airframe: of the drone; one that does not hover by itself sinks level in silence.
        watched: False repeats the last command for ever; for negative controls only.

    Attributes:
        tilt_max: the largest tilt to brake with [rad].
        permit: what the pilot may do; None while nobody knows what the drone does.
    """

    def __init__(
        self, now: float, tilt_max: float, airframe: Airframe, *, watched: bool = True
    ) -> None:
        self.tilt_max = tilt_max
        self.permit: Permit | None = None
        self._hovers, self._watched = airframe.capabilities.hovers, watched
        self._lands_itself = airframe.lands_itself
        self._command = Command(Action.IDLE)
        self._commanded_at = now
        self._order, self._ordered_at = 0, now
        self._has_taken_off = False
        self._must_land = False
        self._is_gone = self._is_leaving = False
        self._refused_at: float | None = None
        self._braking_since: float | None = None
        self._sinking_since: float | None = None
        self._speed = AttitudeSpeed(airframe)
        self._has_sonar = airframe.sonar is not None
        self._forms = airframe.capabilities.forms
        self._standstill = standstill_of(airframe.capabilities.form, self._speed)

    def update(
        self,
        command: Command,
        now: float,
        issued_at: float | None = None,
        motion: KnownMotion | None = None,
    ) -> bool:
        """Put a command in force; return whether its action differs from the one before.

        A command older than the one in force is ignored, and so is one that moves the drone and
        comes later than ``HOVER_AFTER``, and a setpoint that is not numbers or of a form that the
        drone does not take: to the watchdog a pilot that sends nothing else is silent.

        Args:
            command: of the pilot.
            now: [s].
            issued_at: when the pilot gave it [s]; now when None.
            motion: what it knew of the drone's motion; None says nothing new.
        """
        at_time = now if issued_at is None else min(issued_at, now)
        is_late = now - at_time > HOVER_AFTER and command.action in _MOVES
        if at_time < self._commanded_at or is_late or not self._can_be_flown(command):
            return False
        self._commanded_at = at_time
        self._is_gone = False
        if command.action is Action.FLY:
            self._standstill.ask(command.asked)
        self._speed.ask(command.setpoint if command.action is Action.FLY else LEVEL)
        if motion is not None:
            self._speed.know(motion, at_time)
        changed = command.action is not self._command.action
        self._command = command
        if changed:
            self._order, self._ordered_at = self._order + 1, now
            self._has_taken_off = False
        return changed

    def _can_be_flown(self, command: Command) -> bool:
        """Return whether a command can be flown; only to fly needs a setpoint."""
        if command.action is not Action.FLY:
            return True
        return command.form in self._forms and all(map(isfinite, numbers_of(command.asked)))

    def abandon(self) -> None:
        """Note that the pilot is gone: its silence need not be waited for."""
        self._is_gone = True

    def land_for_good(self) -> None:
        """Land from now on, and let nothing pass but cutting the motors."""
        self._is_leaving = True

    def decide(self, now: float, report: Telemetry | None) -> Instruction:
        """Return what the drone is told now [s], given its newest report."""
        self.permit = self._judged(report)
        if report is not None:
            self._speed.update(report)
        command = self._in_words_of_drone(self._in_force(now, report), now, report)
        return Instruction(command, self._order, self._ordered_at, self._is_over(now))

    def _judged(self, report: Telemetry | None) -> Permit | None:
        if self._is_leaving:
            return Permit.LAND
        if report is None or report.status is DroneStatus.UNKNOWN:
            return self.permit
        if report.status not in AIRBORNE_STATUSES:
            return Permit.ALL
        return self.permit or Permit.HOVER_AND_LAND

    def _in_words_of_drone(self, action: Action, now: float, report: Telemetry | None) -> Command:
        """Return an action as the drone can follow it: a silent pilot's hover begins with a brake.

        A drone that hovers by a speed that is not believed, or not at all, sinks in its place, and
        lands by itself where its own loops keep it level and at rest.
        """
        is_left = self._is_silent(now) and action in (Action.HOVER, Action.LAND)
        is_flying = report is not None and report.status is DroneStatus.FLYING
        if not (is_left and is_flying):
            self._sinking_since = self._braking_since = None
        elif not (self._hovers and self._speed.motion.hovers):
            is_own = self._lands_itself and action is Action.LAND
            return Command(Action.LAND) if is_own else self._sink(now, report)
        elif action is Action.HOVER and report is not None:
            return self._brake(now, report)
        if action is Action.TAKE_OFF:
            action = self._take_off(now, report)
        elif action is Action.RESET and report is not None and report.status in AIRBORNE_STATUSES:
            action = Action.IDLE
        return self._command if action is Action.FLY else Command(action)

    def _sink(self, now: float, report: Telemetry | None) -> Command:
        """Brake and sink level: the drone's own hover would fly by a speed that is wrong."""
        if self._sinking_since is None:
            self._sinking_since = now
        is_low = self._has_sonar and report is not None and report.height < ON_FLOOR
        is_long = now - self._sinking_since > SINK_TIME_MAX
        if is_long or (is_low and now - self._sinking_since > 1.0):
            return Command(Action.LAND)
        setpoint = self._standstill.sinking(now, now - self._sinking_since, report, self.tilt_max)
        return Command(Action.LAND) if setpoint is None else self._flown(setpoint)

    def _brake(self, now: float, report: Telemetry) -> Command:
        """Lean against the drone's own speed; once at rest, leave the rest of the silence to it."""
        if self._braking_since is None:
            self._braking_since = now
        setpoint = None
        if now - self._braking_since <= self._speed.brake.time_max:
            setpoint = self._standstill.braking(now, report, self.tilt_max)
        if setpoint is None:
            self._braking_since = float("-inf")
            return Command(Action.HOVER)
        return self._flown(setpoint)

    def _flown(self, setpoint: AnySetpoint) -> Command:
        command = flying(setpoint)
        self._speed.ask(command.setpoint)
        return command

    def _is_silent(self, now: float) -> bool:
        return self._watched and (self._is_gone or now - self._commanded_at > HOVER_AFTER)

    def _in_force(self, now: float, report: Telemetry | None) -> Action:
        """Return the pilot's action, or what the watchdog puts in its place."""
        airborne = report is not None and report.status in AIRBORNE_STATUSES
        if self._command.action in (Action.CUT, Action.RESET):
            self._must_land &= airborne
            return self._command.action
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
        action = self._command.action
        if self.permit in (None, Permit.ALL) or action not in _MOVES:
            self._refused_at = None
            return action
        self._refused_at = now if self._refused_at is None else self._refused_at
        return Action.HOVER if self.permit is Permit.HOVER_AND_LAND else Action.IDLE

    def _take_off(self, now: float, report: Telemetry | None) -> Action:
        """Return a take-off while it may begin or is under way, what follows it, or IDLE."""
        if report is not None and report.status in AIRBORNE_STATUSES:
            self._has_taken_off |= report.status is not DroneStatus.LANDING
            return Action.TAKE_OFF if report.status is DroneStatus.TAKING_OFF else Action.HOVER
        may_begin = (
            report is not None
            and now - report.received_at <= REPORT_AGE_MAX
            and report.status is DroneStatus.LANDED
            and report.configured
            and not self._has_taken_off
        )
        return Action.TAKE_OFF if may_begin else Action.IDLE
