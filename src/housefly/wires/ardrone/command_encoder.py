"""Which AT commands say what the drone is to do now.

Pure; the driver and lock step share it. The take-off bit is sent under no other order; flat trim
comes before it. The emergency bit is a toggle that acts on its rising edge.
"""

from __future__ import annotations

from collections.abc import Callable
from math import radians

from housefly.messages import Action, DroneStatus, Telemetry
from housefly.messages.sensing import REPORT_AGE_MAX
from housefly.messages.steering import Instruction
from housefly.messages.stick import Maxima
from housefly.wires.ardrone import at
from housefly.wires.ardrone.conversions import pcmd_from_setpoint

TRIM_TIME = 0.1
"""How long flat trim is repeated before take-off [s]."""
TRIM_TILT_MAX = radians(1.5)
"""A drone that leans more than this is not trimmed [rad]: it would take the lean of its pad for
level, and take off along it.
"""
PRESS_TIME_MAX = 1.0
"""Longest press of the emergency button [s]; later reports could make it press twice."""
_RELEASE_TIME_MIN = 0.15
"""Shortest pause between two presses [s]."""
_GROUNDED = frozenset({DroneStatus.LANDED, DroneStatus.EMERGENCY})

_HOVER = at.Pcmd()
_LAND = at.Ref(at.RefBits.LAND)
_TAKE_OFF = at.Ref(at.RefBits.TAKE_OFF)
_PRESS = at.Ref(at.RefBits.EMERGENCY)


class CommandEncoder:
    """Turns what the drone is to do into AT commands.

    Args:
        maxima: as below.

    Attributes:
        maxima: what a full stick means to the drone now.
    """

    def __init__(self, maxima: Maxima) -> None:
        self.maxima = maxima
        self._order, self._ordered_at, self._lands_all = 0, 0.0, False
        self._button = EmergencyButton()
        self._table: dict[Action, Callable[[float, Telemetry | None], tuple[at.AtCommand, ...]]] = {
            Action.IDLE: self._idle,
            Action.TAKE_OFF: self._take_off,
            Action.HOVER: lambda now, report: (_HOVER,),
            Action.LAND: lambda now, report: (_LAND, _HOVER),
            Action.CUT: self._cut,
            Action.RESET: self._reset,
        }

    def encoded(
        self, told: Instruction, now: float, report: Telemetry | None
    ) -> tuple[at.AtCommand, ...]:
        """Return what to send now [s], given the drone's newest report."""
        if told.order != self._order:
            self._button.reset(told.ordered_at)
        self._order, self._ordered_at = told.order, told.ordered_at
        self._lands_all = told.lands_all
        command = told.command
        if command.action not in (Action.CUT, Action.RESET):
            self._button.release(now)
        if command.action is Action.FLY:
            return (pcmd_from_setpoint(command.setpoint, self.maxima),)
        return self._table[command.action](now, report)

    def _idle(self, now: float, report: Telemetry | None) -> tuple[at.AtCommand, ...]:
        is_fresh = report is not None and now - report.received_at <= REPORT_AGE_MAX
        if report is not None and is_fresh and report.status in _GROUNDED:
            return (_LAND, at.ComWatchdog())
        if self._lands_all:
            return (_LAND, _HOVER, at.ComWatchdog())
        # in the air this ends a stick that a driver before us left; on the ground it is nothing
        return (_HOVER, at.ComWatchdog())

    def _take_off(self, now: float, report: Telemetry | None) -> tuple[at.AtCommand, ...]:
        if report is not None and report.status is DroneStatus.TAKING_OFF:
            return (_TAKE_OFF, _HOVER)
        if now - self._ordered_at < TRIM_TIME:
            lean = max(abs(report.phi), abs(report.theta)) if report else 0.0
            return (_LAND,) if lean > TRIM_TILT_MAX else (_LAND, at.FlatTrim())
        return (_TAKE_OFF,)

    def _cut(self, now: float, report: Telemetry | None) -> tuple[at.AtCommand, ...]:
        wanted = report is None or report.status is not DroneStatus.EMERGENCY
        return self._press(now, report, wanted=wanted)

    def _reset(self, now: float, report: Telemetry | None) -> tuple[at.AtCommand, ...]:
        wanted = report is not None and report.status is DroneStatus.EMERGENCY
        return self._press(now, report, wanted=wanted)

    def _press(
        self, now: float, report: Telemetry | None, *, wanted: bool
    ) -> tuple[at.AtCommand, ...]:
        if wanted and self._button.hold(now, report.received_at if report else None):
            return (_PRESS,)
        self._button.release(now)
        return (_LAND,)


class EmergencyButton:
    """The emergency bit: held until the drone changes, then released before the next press.

    It is a toggle that acts on its rising edge. It is therefore held until a report shows the
    wanted state, however many datagrams are lost, and then released; a second press needs a report
    newer than the release.
    """

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
