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

import json
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import asdict
from http.client import HTTPConnection, HTTPException, HTTPSConnection
from types import TracebackType
from typing import Any, Self
from urllib.parse import quote, urlencode, urlsplit

import numpy as np
from numpy.typing import NDArray
from pydantic import TypeAdapter, ValidationError
from websockets.exceptions import WebSocketException
from websockets.sync.client import connect as connect_socket

from housefly.errors import LinkError, WireError
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
from housefly.hub.client.loopback import LoopbackConnection

PATHS: dict[type[Question], str] = {
    WhereQuestion: "/where/{thing}",
    CatalogueQuestion: "/things",
    NearQuestion: "/near",
    ContentsQuestion: "/contents/{thing}",
    TrajectoryQuestion: "/trajectory/{thing}",
    EventsQuestion: "/events",
    SensorsQuestion: "/sensors",
    PictureQuestion: "/picture",
}
PREFIX = "/api/v1"
_NEWS: TypeAdapter[News] = TypeAdapter(News)


class RoomClient:
    """A client of one room, not thread-safe. Use it as a context manager, or close it.

    Args:
        address: of the console, for example http://127.0.0.1:8080.
        key: bearer token of the run.
        timeout: of one question [s].
        port: of the hub's query server on this machine, faster than HTTP; 0 asks over HTTP.
    """

    def __init__(self, address: str, key: str, timeout: float = 10.0, port: int = 0) -> None:
        self._direct = LoopbackConnection(port, key, timeout) if port else None
        parts = urlsplit(address)
        kind = HTTPSConnection if parts.scheme == "https" else HTTPConnection
        self._line = kind(parts.hostname or "127.0.0.1", parts.port, timeout=timeout)
        self._socket = (
            f"{'wss' if parts.scheme == 'https' else 'ws'}://{parts.netloc}{PREFIX}/watch"
        )
        self._headers = {"Authorization": f"Bearer {key}"}

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
        self._line.close()
        if self._direct is not None:
            self._direct.close()

    def where(self, thing: str, at: float | None = None) -> WhereAnswer:
        """Return where a thing is, by id, name or alias, now or at a time [Unix time, s]."""
        answer = self.ask(WhereQuestion(thing, at))
        assert isinstance(answer, WhereAnswer)
        return answer

    def things(self, kind: str = "") -> tuple[ThingAnswer, ...]:
        """Return the catalogue, of one kind or all of it."""
        answer = self.ask(CatalogueQuestion(kind))
        assert isinstance(answer, ThingsAnswer)
        return answer.things

    def near(self, what: str | Vec3, radius: float, kind: str = "") -> tuple[PlacedThing, ...]:
        """Return what is within a radius [m] of a thing or of a point [m], the closest first."""
        question = (
            NearQuestion(radius, thing=what, kind=kind)
            if isinstance(what, str)
            else NearQuestion(radius, "", *what, kind)
        )
        answer = self.ask(question)
        assert isinstance(answer, PlacedAnswer)
        return answer.things

    def contents(self, thing: str, at: float | None = None) -> tuple[PlacedThing, ...]:
        """Return everything inside a thing, however deep, now or at a time [Unix time, s]."""
        answer = self.ask(ContentsQuestion(thing, at))
        assert isinstance(answer, PlacedAnswer)
        return answer.things

    def trajectory(
        self, thing: str, since: float, until: float | None = None, every: float = 0.0
    ) -> NDArray[np.float64]:
        """Return where a thing was: rows of Unix time [s], x, y, z [m], shape (n, 4)."""
        answer = self.ask(TrajectoryQuestion(thing, since, until, every))
        assert isinstance(answer, TrajectoryAnswer)
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
        answer = self.ask(EventsQuestion(since, until, thing, kind, cause, limit))
        assert isinstance(answer, EventsAnswer)
        return answer.events

    def sensors(self) -> tuple[SensorAnswer, ...]:
        """Return the health of every sensor."""
        answer = self.ask(SensorsQuestion())
        assert isinstance(answer, SensorsAnswer)
        return answer.sensors

    def memory(self) -> str:
        """Return the state of the room's memory in words."""
        answer = self.ask(SensorsQuestion())
        assert isinstance(answer, SensorsAnswer)
        return answer.memory

    def picture(self, at: float | None = None) -> PictureAnswer:
        """Return everything that has a place, now or at a time [Unix time, s]."""
        answer = self.ask(PictureQuestion(at))
        assert isinstance(answer, PictureAnswer)
        return answer

    def watch(self) -> Iterator[News]:
        """Yield changes as they happen; raises LinkError if the room goes away."""
        try:
            with connect_socket(self._socket, additional_headers=self._headers) as line:
                for text in line:
                    yield _NEWS.validate_json(text)
        except (OSError, WebSocketException) as error:
            raise LinkError(f"the room went away: {error}") from error
        except ValidationError as error:
            raise WireError(f"these are no news: {error.errors()[0]['msg']}") from error

    def ask(self, question: Question) -> Any:
        """Return the answer to a question.

        Raises:
            ThingError: there is no such thing.
            WireError: a value of the question is not allowed.
            LinkError: nobody answers.
        """
        if self._direct is not None:
            with suppress(OSError):  # over HTTP the room says in words why nobody answers
                return answer_from_json(question, self._direct.ask(question_to_json(question)))
        given = {
            name: value
            for name, value in asdict(question).items()
            if name != "ask" and value not in (None, "")
        }
        path = PATHS[type(question)]
        if "{thing}" in path:
            path = path.replace("{thing}", quote(str(given.pop("thing")), safe=""))
        status, text = self._get(f"{PREFIX}{path}?{urlencode(given)}")
        if status in (401, 503):
            raise LinkError(str(json.loads(text)["error"]))
        if status == 404:
            text = json.dumps(json.loads(text) | {"unknown": True})
        return answer_from_json(question, text)

    def _get(self, path: str) -> tuple[int, str]:
        for last_try in (False, True):
            try:
                self._line.request("GET", path, headers=self._headers)
                answer = self._line.getresponse()
                return answer.status, answer.read().decode()
            except (OSError, HTTPException) as error:
                # An idle connection may have been cut: try once more on a new one.
                self._line.close()
                if last_try:
                    raise LinkError(f"the room does not answer: {error}") from error
        raise AssertionError
