"""The questions of a room as methods, for whoever can ask it."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.geometry import Vec3
from housefly.hub.api.answers import (
    EventAnswer,
    EventsAnswer,
    PictureAnswer,
    PlacedAnswer,
    PlacedThing,
    SensorAnswer,
    SensorsAnswer,
    ThingAnswer,
    ThingsAnswer,
    TrajectoryAnswer,
    WhereAnswer,
)
from housefly.hub.api.questions import (
    CatalogueQuestion,
    ContentsQuestion,
    EventsQuestion,
    NearQuestion,
    NightsQuestion,
    PeopleQuestion,
    PictureQuestion,
    Question,
    SensorsQuestion,
    StateQuestion,
    TrajectoryQuestion,
    WhereQuestion,
)
from housefly.hub.api.state_answers import (
    NightAnswer,
    NightsAnswer,
    PeopleAnswer,
    PersonAnswer,
    StateAnswer,
)


class RoomQueries(ABC):
    """Asks one room, running or remembered."""

    @abstractmethod
    def ask(self, question: Question) -> Any:
        """Return the answer to a question; raises ThingError if there is no such thing."""

    def where(self, thing: str, at: float | None = None) -> WhereAnswer:
        """Return where a thing is, by id, name or alias, now or at a time [Unix time, s]."""
        answer: WhereAnswer = self.ask(WhereQuestion(thing, at))
        return answer

    def things(self, kind: str = "") -> tuple[ThingAnswer, ...]:
        """Return the catalogue, of one kind or all of it."""
        answer: ThingsAnswer = self.ask(CatalogueQuestion(kind))
        return answer.things

    def near(self, what: str | Vec3, radius: float, kind: str = "") -> tuple[PlacedThing, ...]:
        """Return what is within a radius [m] of a thing or of a point [m], the closest first."""
        question = (
            NearQuestion(radius, thing=what, kind=kind)
            if isinstance(what, str)
            else NearQuestion(radius, "", *what, kind)
        )
        answer: PlacedAnswer = self.ask(question)
        return answer.things

    def contents(self, thing: str, at: float | None = None) -> tuple[PlacedThing, ...]:
        """Return everything inside a thing, however deep, now or at a time [Unix time, s]."""
        answer: PlacedAnswer = self.ask(ContentsQuestion(thing, at))
        return answer.things

    def trajectory(
        self, thing: str, since: float, until: float | None = None, every: float = 0.0
    ) -> NDArray[np.float64]:
        """Return where a thing was: rows of Unix time [s], x, y, z [m], shape (n, 4)."""
        answer: TrajectoryAnswer = self.ask(TrajectoryQuestion(thing, since, until, every))
        return np.array(answer.rows, dtype=float).reshape(-1, 4)

    def events(
        self,
        since: float = 0.0,
        until: float | None = None,
        thing: str = "",
        kind: str = "",
        cause: str = "",
        limit: int = 200,
    ) -> tuple[EventAnswer, ...]:
        """Return the newest ``limit`` events between two times [Unix time, s], sorted by time."""
        answer: EventsAnswer = self.ask(EventsQuestion(since, until, thing, kind, cause, limit))
        return answer.events

    def sensors(self) -> tuple[SensorAnswer, ...]:
        """Return the health of every sensor."""
        answer: SensorsAnswer = self.ask(SensorsQuestion())
        return answer.sensors

    def memory(self) -> str:
        """Return what is wrong with the room's memory, in words; "" when all is kept."""
        answer: SensorsAnswer = self.ask(SensorsQuestion())
        return answer.memory

    def picture(self, at: float | None = None) -> PictureAnswer:
        """Return everything that has a place, now or at a time [Unix time, s]."""
        answer: PictureAnswer = self.ask(PictureQuestion(at))
        return answer

    def state(self, thing: str, state: str, at: float | None = None) -> StateAnswer:
        """Return whether a thing or a person is "on", "open", "in bed" ...: yes, no or unknown."""
        answer: StateAnswer = self.ask(StateQuestion(thing, state, at))
        return answer

    def people(self, person: str = "", at: float | None = None) -> tuple[PersonAnswer, ...]:
        """Return who is there and how, one person or all, now or at a time [Unix time, s]."""
        answer: PeopleAnswer = self.ask(PeopleQuestion(person, at))
        return answer.people

    def nights(
        self,
        since: float,
        thing: str = "",
        until: float | None = None,
        from_hour: float = 22.0,
        to_hour: float = 6.0,
    ) -> tuple[NightAnswer, ...]:
        """Return how often somebody was up in each night that begins between two times [s].

        ``thing`` is a person or a bed, "" for every bed; hours are of the local day.
        """
        answer: NightsAnswer = self.ask(NightsQuestion(since, thing, until, from_hour, to_hour))
        return answer.nights


class AskedRoom(RoomQueries):
    """A room behind a function.

    Args:
        ask: returns the answer; raises ThingError, or LinkError when nobody remembers.
    """

    def __init__(self, ask: Callable[[Question], Any]) -> None:
        self._ask = ask

    def ask(self, question: Question) -> Any:
        """Return the answer to a question."""
        return self._ask(question)
