"""The questions of a room as methods of asyncio: those of ``RoomQueries``, to be awaited."""

from __future__ import annotations

from abc import ABC, abstractmethod
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


class AsyncRoomQueries(ABC):
    """Asks one room that runs."""

    @abstractmethod
    async def ask(self, question: Question) -> Any:
        """Return the answer to a question; raises ThingError if there is no such thing."""

    async def where(self, thing: str, at: float | None = None) -> WhereAnswer:
        """Return where a thing is, by id, name or alias, now or at a time [Unix time, s]."""
        answer: WhereAnswer = await self.ask(WhereQuestion(thing, at))
        return answer

    async def things(self, kind: str = "") -> tuple[ThingAnswer, ...]:
        """Return the catalogue, of one kind or all of it."""
        answer: ThingsAnswer = await self.ask(CatalogueQuestion(kind))
        return answer.things

    async def near(
        self, what: str | Vec3, radius: float, kind: str = ""
    ) -> tuple[PlacedThing, ...]:
        """Return what is within a radius [m] of a thing or of a point [m], the closest first."""
        question = (
            NearQuestion(radius, thing=what, kind=kind)
            if isinstance(what, str)
            else NearQuestion(radius, "", *what, kind)
        )
        answer: PlacedAnswer = await self.ask(question)
        return answer.things

    async def contents(self, thing: str, at: float | None = None) -> tuple[PlacedThing, ...]:
        """Return everything inside a thing, however deep, now or at a time [Unix time, s]."""
        answer: PlacedAnswer = await self.ask(ContentsQuestion(thing, at))
        return answer.things

    async def trajectory(
        self, thing: str, since: float, until: float | None = None, every: float = 0.0
    ) -> NDArray[np.float64]:
        """Return where a thing was: rows of Unix time [s], x, y, z [m], shape (n, 4)."""
        answer: TrajectoryAnswer = await self.ask(TrajectoryQuestion(thing, since, until, every))
        return np.array(answer.rows, dtype=float).reshape(-1, 4)

    async def events(
        self,
        since: float = 0.0,
        until: float | None = None,
        thing: str = "",
        kind: str = "",
        cause: str = "",
        limit: int = 200,
    ) -> tuple[EventAnswer, ...]:
        """Return the newest ``limit`` events between two times [Unix time, s], sorted by time."""
        answer: EventsAnswer = await self.ask(
            EventsQuestion(since, until, thing, kind, cause, limit)
        )
        return answer.events

    async def sensors(self) -> tuple[SensorAnswer, ...]:
        """Return the health of every sensor."""
        answer: SensorsAnswer = await self.ask(SensorsQuestion())
        return answer.sensors

    async def memory(self) -> str:
        """Return what is wrong with the room's memory, in words; "" when all is kept."""
        answer: SensorsAnswer = await self.ask(SensorsQuestion())
        return answer.memory

    async def picture(self, at: float | None = None) -> PictureAnswer:
        """Return everything that has a place, now or at a time [Unix time, s]."""
        answer: PictureAnswer = await self.ask(PictureQuestion(at))
        return answer

    async def state(self, thing: str, state: str, at: float | None = None) -> StateAnswer:
        """Return whether a thing or a person is "on", "open", "in bed" ...: yes, no or unknown."""
        answer: StateAnswer = await self.ask(StateQuestion(thing, state, at))
        return answer

    async def people(self, person: str = "", at: float | None = None) -> tuple[PersonAnswer, ...]:
        """Return who is there and how, one person or all, now or at a time [Unix time, s]."""
        answer: PeopleAnswer = await self.ask(PeopleQuestion(person, at))
        return answer.people

    async def nights(
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
        answer: NightsAnswer = await self.ask(
            NightsQuestion(since, thing, until, from_hour, to_hour)
        )
        return answer.nights
