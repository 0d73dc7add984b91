"""Which lines a Tello is due: what the failsafe decided, and what keeps the link. Pure.

Sticks leave at each turn, also before anybody knows whether the drone flies: the last ones hold for
15 s, and a driver that was killed has left some. Nothing else is said while it takes off or lands,
but to land, again and again: a Tello ignores that until its take-off is over.
"""

from __future__ import annotations

from math import inf

from housefly.messages import Action, DroneStatus
from housefly.messages.steering import Instruction
from housefly.wires.tello.answers import AnswerKind, TelloAnswer
from housefly.wires.tello.conversions import FullSticks, sticks_of
from housefly.wires.tello.lines import Line, Question, Sticks, Word

STATE_AGE_MAX = 1.0
"""A drone whose state is older is greeted again [s]: it may have been switched off and on."""
_PAUSES: dict[Line, float] = {
    Word.COMMAND: 0.5,
    Word.TAKE_OFF: 3.0,
    Word.LAND: 0.5,
    Word.EMERGENCY: 0.09,
    Word.STREAM_ON: 2.0,
    Question.SDK: 2.0,
}
"""What is asked for is said again after so long [s]."""
_UP_IN_THE_AIR = frozenset({DroneStatus.FLYING, DroneStatus.UNKNOWN})
_ON_ITS_WAY = frozenset({DroneStatus.TAKING_OFF, DroneStatus.LANDING})
_QUESTIONS_MAX = 3
"""SDK 1.3 answers no question about itself."""


class Talk:
    """The lines of one driver.

    Args:
        full: what full sticks mean.

    Attributes:
        sdk: version of its SDK as it answered, or "".
        is_open: whether it is in SDK mode: it answered, and sends its state.
    """

    def __init__(self, full: FullSticks) -> None:
        self.sdk, self.is_open = "", False
        self._full = full
        self._said: dict[Line, float] = {}
        self._questions = 0

    def hear(self, answer: TelloAnswer) -> None:
        """Take in an answer."""
        if answer.kind is AnswerKind.VALUE and self._questions and not self.sdk:
            self.sdk = answer.text

    def lines(
        self,
        told: Instruction,
        status: DroneStatus,
        now: float,
        *,
        state_age: float,
        wants_pictures: bool,
    ) -> tuple[Line, ...]:
        """Return what leaves now, in order.

        Args:
            told: by the failsafe.
            status: of the drone.
            now: [s].
            state_age: time since it last sent its state [s].
            wants_pictures: whether pictures should come, and do not.
        """
        self.is_open = state_age < STATE_AGE_MAX
        due: list[Line] = [] if self.is_open else self._due(Word.COMMAND, now)
        due += self._ordered(told, status, now)
        if self.is_open and status not in _ON_ITS_WAY:
            if wants_pictures:
                due += self._due(Word.STREAM_ON, now)
            if not self.sdk and self._questions < _QUESTIONS_MAX:
                asked = self._due(Question.SDK, now)
                self._questions += len(asked)
                due += asked
        return tuple(due)

    def _ordered(self, told: Instruction, status: DroneStatus, now: float) -> list[Line]:
        action = told.command.action
        if action is Action.CUT:
            return self._due(Word.EMERGENCY, now)
        if status is not DroneStatus.LANDED and (action is Action.LAND or told.lands_all):
            return self._due(Word.LAND, now)
        if action is Action.TAKE_OFF and status is DroneStatus.LANDED:
            return self._due(Word.TAKE_OFF, now)
        if status not in _UP_IN_THE_AIR:
            return []
        velocity = told.command.velocity if action is Action.FLY else None
        return [Sticks() if velocity is None else sticks_of(velocity, self._full)]

    def _due(self, line: Line, now: float) -> list[Line]:
        """Return a line unless it was just said."""
        if now - self._said.get(line, -inf) < _PAUSES[line]:
            return []
        self._said[line] = now
        return [line]
