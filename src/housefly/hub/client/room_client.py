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

import time
from collections.abc import Iterator
from contextlib import suppress
from types import TracebackType
from typing import Any, Self

from housefly.errors import LinkError
from housefly.hub.api.answers import News
from housefly.hub.api.json import answer_from_json, question_to_json
from housefly.hub.api.questions import Question
from housefly.hub.client.http import HttpRoom
from housefly.hub.client.hub_connection import HubConnection
from housefly.hub.client.room_queries import RoomQueries

_START_PATIENCE, _START_PAUSE = 5.0, 0.1
"""How long the first question waits for a room that has just been started [s]."""


class RoomClient(RoomQueries):
    """A client of one room, not thread-safe. Use it as a context manager, or close it.

    Args:
        address: of the console, for example http://127.0.0.1:8080.
        key: bearer token of the run.
        timeout: of one question [s].
        socket: of the hub's query server on this machine, faster than HTTP; "" asks over HTTP.
    """

    def __init__(self, address: str, key: str, timeout: float = 10.0, socket: str = "") -> None:
        self._hub = HubConnection(socket, key, timeout) if socket else None
        self._http = HttpRoom(address, key, timeout)
        self._heard = False

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
        if self._hub is not None:
            self._hub.close()

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
        return answer_from_json(question, self._asked(question))

    def _asked(self, question: Question) -> str:
        deadline = time.monotonic() + _START_PATIENCE
        while True:
            if self._hub is not None:
                with suppress(OSError):  # over HTTP the room says in words why nobody answers
                    text = self._hub.ask(question_to_json(question))
                    self._heard = True
                    return text
            try:
                return self._http.ask(question)
            except LinkError:
                # A room that was just started may still open its memory.
                if self._hub is None or self._heard or time.monotonic() > deadline:
                    raise
            time.sleep(_START_PAUSE)
