"""Lets people live in the simulated room in fast time, and answers what happened."""

from __future__ import annotations

import time
from pathlib import Path
from types import TracebackType
from typing import Self

from housefly.app.public.temporary_folder import TemporaryFolder
from housefly.hub.api.answers import Answer
from housefly.hub.api.questions import Question
from housefly.hub.client.room_queries import RoomQueries
from housefly.hub.memory import RoomMemory
from housefly.hub.query_handler import QueryHandler
from housefly.hub.room_status import RoomStatus
from housefly.hub.situation_service import SituationService
from housefly.hub.store.open import open_store
from housefly.hub.things.thing import Thing
from housefly.hub.things_of_room import catalogue_of, surfaces_of, things_of_scene
from housefly.sites.loaded_site import LoadedSite
from housefly.twin.people import Scene, load_scene
from housefly.twin.sensors.devices import SimulatedDevices
from housefly.wires.devices import Delivered, Placement, decode_reading

_PERIOD = 0.05
"""Time between two looks at the devices [s]."""


class PlayedScene(RoomQueries):
    """The memory of a room in which a scene was played; answers as ``connect()`` does.

    Use it as a context manager, or close it.

    Attributes:
        begin: when the scene began [Unix time, s].
        end: when it ended, which is now for every question [Unix time, s].
    """

    def __init__(self, loaded: LoadedSite, scene: Scene, things: tuple[Thing, ...]) -> None:
        self.end = time.time()
        self.begin = self.end - scene.length
        self._folder = TemporaryFolder()
        self._memory = RoomMemory(
            things,
            lambda: open_store(self._folder.path / "room.db"),
            surfaces_of(loaded.room),
        )
        status = RoomStatus(self._memory.writer.report)
        self._queries = QueryHandler(self._memory, status, lambda: self.end)
        self._play(scene, loaded, SituationService(loaded.site, loaded.room, self._memory, status))

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
        """Forget everything."""
        self._memory.close()
        self._folder.remove()

    def ask(self, question: Question) -> Answer:
        """Return the answer to a question; raises ThingError if there is no such thing."""
        return self._queries.answer(question)

    def _play(self, scene: Scene, loaded: LoadedSite, situations: SituationService) -> None:
        devices = SimulatedDevices(scene, loaded.site.name)
        tags = Placement(things={thing.tag: thing.name for thing in scene.script.things})
        for tick in range(round(scene.length / _PERIOD)):
            elapsed = _PERIOD * tick
            now = self.begin + elapsed
            for message in devices.messages(elapsed, now):
                sent = Delivered(message.address, message.channel, message.payload, now)
                reading = decode_reading(sent, tags)
                for observation in reading.observations:
                    self._memory.add(observation)
                for event in reading.events:
                    self._memory.add(event)
            situations.update(now)


def play_scene(loaded: LoadedSite, scene: str = "bsen") -> PlayedScene:
    """Play a scene from its begin to its end in fast time, and return what the room remembers.

    The devices of the scene send their payloads, the hub decodes them, detects situations and keeps
    all of it in a database of its own.

    Args:
        loaded: site and room; its catalogue gives things their names.
        scene: name of a shipped scene, or the path of a scene file.

    Raises:
        ConfigError: scene or catalogue cannot be read.
    """
    known = catalogue_of(loaded.site, loaded.room, Path())
    named = {thing.id: thing for thing in (*things_of_scene(scene), *known)}
    return PlayedScene(loaded, load_scene(scene), tuple(named.values()))
