"""Whether a Tello flies: it does not say so. Pure.

What it says is how many whole seconds its motors have turned. While that counts, it is in the air,
or on its way up or down as it was told last; once several states in a row say the same, it is down.
States that are lost say nothing, so they never bring it down. A take-off or a landing that is
answered ``ok`` is over at once, if the height agrees.
"""

from __future__ import annotations

from math import inf

from housefly.messages import DroneStatus
from housefly.wires.tello.answers import AnswerKind, TelloAnswer
from housefly.wires.tello.lines import Line, Word
from housefly.wires.tello.state import TOF_MAX, TelloState

MOTORS_STAND_AFTER, SAME_STATES = 1.3, 13
"""Its motors stand once states that say the same seconds lie so far apart [s], and are so many: in
the air no more than ten of them come in a second.
"""
TAKE_OFF_TIME_MAX = 12.0
"""After that it flies, whether it said ``ok`` or not [s]; clients wait 20 s for that."""
_UP_HEIGHT, _DOWN_HEIGHT = 30, 20
"""It is up above, and down below [cm]."""


class FlightWatch:
    """Follows one drone by its states, its answers, and what it was told.

    Attributes:
        refusal: what it answered to the last take-off in place of taking off; "" for nothing.
    """

    def __init__(self) -> None:
        self.refusal = ""
        self._turns: bool | None = None
        self._motor_time, self._same_since, self._same = -1, inf, 0
        self._tof = 0
        self._rises_since: float | None = None
        self._sinks = self._is_cut = False
        self._down_at = -inf

    def sent(self, line: Line, now: float) -> None:
        """Note what the drone was told now [s]."""
        if line is Word.TAKE_OFF:
            self._rises_since, self._sinks, self.refusal = now, False, ""
        elif line is Word.LAND:
            self._sinks = True
        elif line is Word.EMERGENCY:
            self._is_cut = True

    def reset(self) -> None:
        """Leave the emergency."""
        self._is_cut = False

    def hear(self, answer: TelloAnswer, now: float) -> None:
        """Take in an answer that came now [s]."""
        if answer.kind is AnswerKind.DONE:
            if self._rises_since is not None and self._tof >= _UP_HEIGHT:
                self._rises_since = None
            elif self._sinks and self._tof < _DOWN_HEIGHT:
                self._sinks, self._down_at, self._turns = False, now, False
        elif answer.kind is AnswerKind.REFUSED and self._rises_since is not None:
            self.refusal = answer.text
            self._rises_since = None if self._turns else self._rises_since

    def see(self, state: TelloState, now: float) -> None:
        """Take in a state that came now [s]."""
        self._count(state.time, now)
        self._tof = state.tof if state.tof < TOF_MAX else state.h
        if self._rises_since is not None and now - self._rises_since > TAKE_OFF_TIME_MAX:
            self._rises_since = None
        if not self._turns:
            self._sinks = False

    def status(self) -> DroneStatus:
        """Return what the drone does."""
        if self._motor_time < 0:
            return DroneStatus.UNKNOWN
        if self._is_cut:
            return DroneStatus.EMERGENCY
        if not self._turns:
            return DroneStatus.UNKNOWN if self._turns is None else DroneStatus.LANDED
        if self._rises_since is not None:
            return DroneStatus.TAKING_OFF
        return DroneStatus.LANDING if self._sinks else DroneStatus.FLYING

    def _count(self, seconds: int, now: float) -> None:
        """Take in for how long its motors have turned; the last tick of a landing is none."""
        if seconds != self._motor_time:
            is_first = self._motor_time < 0
            if not is_first and now - self._down_at > MOTORS_STAND_AFTER:
                self._turns = True
            self._motor_time, self._same_since, self._same = seconds, now, 1
            return
        self._same += 1
        if self._same >= SAME_STATES and now - self._same_since > MOTORS_STAND_AFTER:
            self._turns = False
