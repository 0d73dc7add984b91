"""Ask a running room from Python.

import housefly

room = housefly.connect()
print(room.where("cup").words)
for event in room.events(thing="entrance-door"):
    print(event.kind, event.at)
for news in room.watch():
    print(news.events)
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from types import TracebackType
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from housefly.geometry import Vec3
from housefly.hub.api.answers import (
    EventAnswer,
    EventsAnswer,
    News,
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
from housefly.hub.api.json import answer_from_json, question_to_json
from housefly.hub.api.questions import (
    CatalogueQuestion,
    ContentsQuestion,
    EventsQuestion,
    NearQuestion,
    PictureQuestion,
    Question,
    SensorsQuestion,
    TrajectoryQuestion,
    WhereQuestion,
)
from housefly.hub.client.http import HttpRoom
from housefly.hub.client.loopback import LoopbackConnection


class RoomClient:
    """A client of one room, not thread-safe. Use it as a context manager, or close it.

    Args:
        address: of the console, for example http://127.0.0.1:8080.
        key: bearer token of the run.
        timeout: of one question [s].
        port: of the hub's query server on this machine, faster than HTTP; 0 asks over HTTP.
    """

    def __init__(self, address: str, key: str, timeout: float = 10.0, port: int = 0) -> None:
        self._loopback = LoopbackConnection(port, key, timeout) if port else None
        self._http = HttpRoom(address, key, timeout)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def close(self) -> None:
        """Close the connections."""
        self._http.close()
        if self._loopback is not None:
            self._loopback.close()

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
        """Return the state of the room's memory in words."""
        answer: SensorsAnswer = self.ask(SensorsQuestion())
        return answer.memory

    def picture(self, at: float | None = None) -> PictureAnswer:
        """Return everything that has a place, now or at a time [Unix time, s]."""
        answer: PictureAnswer = self.ask(PictureQuestion(at))
        return answer

    def watch(self) -> Iterator[News]:
        """Yield changes as they happen; raises LinkError if the room goes away."""
        return self._http.watch()

    def ask(self, question: Question) -> Any:
        """Return the answer to a question.

        Raises:
            ThingError: there is no such thing.
            WireError: a value of the question is not allowed.
            LinkError: nobody answers.
        """
        if self._loopback is not None:
            with suppress(OSError):  # over HTTP the room says in words why nobody answers
                return answer_from_json(question, self._loopback.ask(question_to_json(question)))
        return answer_from_json(question, self._http.ask(question))
