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

from housefly.hub.api.answers import News
from housefly.hub.api.json import answer_from_json, question_to_json
from housefly.hub.api.questions import Question
from housefly.hub.client.http import HttpRoom
from housefly.hub.client.loopback import LoopbackConnection
from housefly.hub.client.room_queries import RoomQueries


class RoomClient(RoomQueries):
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
