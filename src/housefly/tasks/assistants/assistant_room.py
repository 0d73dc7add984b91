"""The running room as an assistant reaches it: memory, tasks, map and pictures; found anew for
each question, because runs end and begin while an assistant stays.
"""

from __future__ import annotations

from http.client import HTTPConnection, HTTPException, HTTPSConnection
from typing import Any, Protocol
from urllib.parse import quote, urlsplit

from housefly.bus.topics import DroneTopics
from housefly.errors import LinkError
from housefly.hub.api.endpoints import API_PREFIX
from housefly.hub.api.json import checked_question
from housefly.hub.api.pilot_queries import RoomView
from housefly.hub.api.pilot_queries_json import from_json
from housefly.hub.api.questions import Question
from housefly.hub.client.discovery import RoomAddress, find
from housefly.hub.client.room_client import RoomClient
from housefly.tasks.api.questions import TaskQuestion
from housefly.tasks.client.tasks_client import TasksClient

_TIMEOUT = 30.0
"""Of one question; a rehearsal takes seconds [s]."""
MAX_CLIP = 64 * 2**20
"""Largest clip or snapshot that is fetched [bytes]."""


class AssistantRoom(Protocol):
    """What the tools of an assistant ask; raises HouseflyError in words."""

    def ask(self, question: Question) -> Any:
        """Return the memory's answer."""
        ...

    def ask_tasks(self, question: TaskQuestion) -> Any:
        """Return the answer of the tasks."""
        ...

    def view(self) -> RoomView:
        """Return the room and its map."""
        ...

    def clip(self, clip: str) -> bytes:
        """Return the file of a clip or snapshot."""
        ...


class FoundRoom:
    """The room that runs on this machine.

    Args:
        site: its name; "" for the one that was started last.
    """

    def __init__(self, site: str = "") -> None:
        self._site = site

    def ask(self, question: Question) -> Any:
        """Return the memory's answer; raises ThingError, WireError or LinkError."""
        place = find(self._site)
        with RoomClient(place.address, place.key, _TIMEOUT, place.socket) as room:
            return room.ask(checked_question(question))

    def ask_tasks(self, question: TaskQuestion) -> Any:
        """Return the answer of the tasks; raises TaskError or LinkError."""
        with TasksClient(find(self._site), timeout=_TIMEOUT) as tasks:
            return tasks.ask_tasks(question)

    def view(self) -> RoomView:
        """Return the room and its map; raises LinkError."""
        from housefly.bus.zenoh_bus import ZenohBus

        place = find(self._site)
        if not place.bus:
            raise LinkError(f"the run of {place.site} does not say where its bus is")
        with ZenohBus(connect=place.bus) as bus:
            return from_json(RoomView, bus.ask(DroneTopics(place.drones[0]).room, ""))

    def clip(self, clip: str) -> bytes:
        """Return the file of a clip or snapshot; raises LinkError."""
        return _fetched(find(self._site), f"{API_PREFIX}/clips/{quote(clip, safe='')}")


def _fetched(place: RoomAddress, path: str) -> bytes:
    """Return a file of the console's server; who watched is written down there."""
    parts = urlsplit(place.address)
    kind = HTTPSConnection if parts.scheme == "https" else HTTPConnection
    connection = kind(parts.hostname or "127.0.0.1", parts.port, timeout=_TIMEOUT)
    try:
        connection.request("GET", path, headers={"Authorization": f"Bearer {place.key}"})
        answer = connection.getresponse()
        content = answer.read(MAX_CLIP + 1)
    except (OSError, HTTPException) as error:
        raise LinkError(f"the console does not answer: {error}") from error
    finally:
        connection.close()
    if answer.status != 200 or len(content) > MAX_CLIP:
        raise LinkError(f"the console does not give this clip: status {answer.status}")
    return content
