"""Which AT commands leave next, from the command in force and the drone's newest report.

Pure; the driver and the lock-step room share it. The take-off bit is sent only on the ground and
under a take-off command, never in flight: a drone that landed by itself would rise again. The
emergency bit is a toggle that acts on its rising edge. It is therefore held until a report shows
the wanted state, however many datagrams are lost, and then released; a second press needs a report
newer than the release.
"""

from __future__ import annotations

from collections.abc import Callable

from housefly.messages import Action, Command, DroneStatus, Setpoint, Telemetry
from housefly.wires.ardrone import at
from housefly.wires.ardrone.conversions import Maxima, pcmd_from_setpoint

SEND_INTERVAL = 0.030
"""Time between datagrams that the drone's makers recommend [s]."""
SEND_INTERVAL_MIN = 0.027
"""A setpoint leaves at once when the last datagram is this old [s]: 3 ms early does not wait."""
REPEAT_AFTER = 0.035
"""Without a new command the one in force is repeated after this long [s].

The drone complains after 50 ms.
"""
HOVER_AFTER = 0.25
"""Silence of the pilot after which a flying drone hovers [s]."""
LAND_AFTER = 2.0
"""Silence of the pilot after which a flying drone lands [s]."""
REPORT_AGE_MAX = 0.5
"""An older report says nothing about the present [s]."""
TRIM_TIME = 0.1
"""How long flat trim is repeated before take-off [s]."""
PRESS_TIME_MAX = 1.0
"""Longest press of the emergency button [s]; later reports could make it press twice."""
_RELEASE_TIME_MIN = 0.15
"""Shortest pause between two presses [s]."""

_AIRBORNE = frozenset({DroneStatus.TAKING_OFF, DroneStatus.FLYING, DroneStatus.LANDING})
_GROUNDED = frozenset({DroneStatus.LANDED, DroneStatus.EMERGENCY})

_HOVER = at.Pcmd()
_LAND = at.Ref(at.RefBits.LAND)
_TAKE_OFF = at.Ref(at.RefBits.TAKE_OFF)
_PRESS = at.Ref(at.RefBits.EMERGENCY)


class _EmergencyButton:
    """The toggle: held until the drone changes, then released before the next press."""

    def __init__(self) -> None:
        self._pressed_at: float | None = None
        self._released_at: float | None = None

    def release(self, now: float) -> None:
        """Let go; does nothing when the button is not held."""
        if self._pressed_at is not None:
            self._pressed_at, self._released_at = None, now

    def hold(self, now: float, report_at: float | None) -> bool:
        """Return whether the bit is set now.

        Args:
            now: [s].
            report_at: arrival of the newest report that asks for a press [s].
        """
        if self._pressed_at is not None:
            if now - self._pressed_at < PRESS_TIME_MAX:
                return True
            self.release(now)
        elif self._released_at is None or (
            report_at is not None and report_at - self._released_at > _RELEASE_TIME_MIN
        ):
            self._pressed_at = now
            return True
        return False

    def reset(self, now: float) -> None:
        """Let the next press not wait for a report, unless the button was held just now."""
        self.release(now)
        if self._released_at is not None and now - self._released_at > _RELEASE_TIME_MIN:
            self._released_at = None


class CommandSequencer:
    """Turns the command in force into AT commands, with a watchdog over the pilot.

    Attributes:
        maxima: what a full stick means to the drone now.
    """

    def __init__(self, maxima: Maxima, now: float) -> None:
        self.maxima = maxima
        self._action = Action.IDLE
        self._setpoint = Setpoint()
        self._commanded_at = now
        self._action_since = now
        self._has_taken_off = False
        self._must_land = False
        self._button = _EmergencyButton()
        self._table: dict[Action, Callable[[float, Telemetry | None], tuple[at.AtCommand, ...]]] = {
            Action.IDLE: self._idle,
            Action.TAKE_OFF: self._take_off,
            Action.FLY: lambda now, report: (pcmd_from_setpoint(self._setpoint, self.maxima),),
            Action.HOVER: lambda now, report: (_HOVER,),
            Action.LAND: lambda now, report: (_LAND, _HOVER),
            Action.CUT: self._cut,
            Action.RESET: self._reset,
        }

    def update(self, command: Command, now: float) -> bool:
        """Put a command in force; return whether its action differs from the one before."""
        self._commanded_at = now
        self._setpoint = command.setpoint
        changed = command.action is not self._action
        if changed:
            self._action = command.action
            self._action_since = now
            self._has_taken_off = False
            self._button.reset(now)
        return changed

    def next_commands(self, now: float, report: Telemetry | None) -> tuple[at.AtCommand, ...]:
        """Return what to send now [s], given the drone's newest report."""
        action = self._action_in_force(now, report)
        if action not in (Action.CUT, Action.RESET):
            self._button.release(now)
        return self._table[action](now, report)

    def _action_in_force(self, now: float, report: Telemetry | None) -> Action:
        """Return the pilot's action, or what the watchdog puts in its place."""
        airborne = report is not None and report.status in _AIRBORNE
        silence = now - self._commanded_at
        self._must_land = airborne and (self._must_land or silence > LAND_AFTER)
        if self._action in (Action.CUT, Action.RESET):
            return self._action
        if self._must_land:
            # a take-off command from before the silence must not count again after it
            self._has_taken_off = True
            return Action.LAND
        if silence > HOVER_AFTER and self._action is not Action.LAND:
            return Action.HOVER if airborne else Action.IDLE
        return self._action

    def _idle(self, now: float, report: Telemetry | None) -> tuple[at.AtCommand, ...]:
        if report is None or now - report.received_at > REPORT_AGE_MAX:
            return (at.ComWatchdog(),)
        return (_LAND if report.status in _GROUNDED else _HOVER, at.ComWatchdog())

    def _take_off(self, now: float, report: Telemetry | None) -> tuple[at.AtCommand, ...]:
        if report is not None and report.status in _AIRBORNE:
            self._has_taken_off |= report.status is not DroneStatus.LANDING
            return (_TAKE_OFF, _HOVER) if report.status is DroneStatus.TAKING_OFF else (_HOVER,)
        if (
            report is None
            or now - report.received_at > REPORT_AGE_MAX
            or report.status is not DroneStatus.LANDED
            or self._has_taken_off
        ):
            return self._idle(now, report)
        if now - self._action_since < TRIM_TIME:
            return (_LAND, at.FlatTrim())
        return (_TAKE_OFF,)

    def _cut(self, now: float, report: Telemetry | None) -> tuple[at.AtCommand, ...]:
        wanted = report is None or report.status is not DroneStatus.EMERGENCY
        return self._press(now, report, wanted=wanted)

    def _reset(self, now: float, report: Telemetry | None) -> tuple[at.AtCommand, ...]:
        if report is not None and report.status in _AIRBORNE:
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
