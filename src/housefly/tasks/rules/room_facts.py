"""What the conditions of rules ask of the room: what nobody knows does not hold."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from housefly.errors import HouseflyError
from housefly.hub.api.questions import PeopleQuestion, Question, StateQuestion
from housefly.hub.api.state_answers import Verdict

ANYBODY = "anybody"
"""In ``present`` and ``absent``: any person at all."""


class RoomFacts(Protocol):
    """Answers the conditions of a rule at a time [Unix time, s]."""

    def state(self, thing: str, state: str, at: float) -> Verdict:
        """Return whether a thing is in a state."""
        ...

    def presence(self, person: str, at: float) -> Verdict:
        """Return whether a person, or anybody, is there."""
        ...


class AskedRoomFacts:
    """Asks a room, running or remembered.

    Args:
        ask: returns the answer to a question; its errors mean that nobody knows.
        live: whether to ask how it is now; else how it was then.
    """

    def __init__(self, ask: Callable[[Question], Any], live: bool = True) -> None:
        self._ask, self._live = ask, live

    def state(self, thing: str, state: str, at: float) -> Verdict:
        """Return whether a thing is in a state."""
        try:
            answer = self._ask(StateQuestion(thing, state, self._at(at)))
        except HouseflyError:
            return "unknown"
        verdict: Verdict = answer.answer
        return verdict

    def presence(self, person: str, at: float) -> Verdict:
        """Return whether a person, or anybody, is there."""
        try:
            name = "" if person == ANYBODY else person
            people = self._ask(PeopleQuestion(name, self._at(at))).people
        except HouseflyError:
            return "unknown"
        verdicts = {who.present for who in people}
        if "yes" in verdicts:
            return "yes"
        return "no" if verdicts == {"no"} else "unknown"

    def _at(self, at: float) -> float | None:
        return None if self._live else at
