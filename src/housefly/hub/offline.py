"""Answers from the store alone, while nothing runs."""

from __future__ import annotations

import time
from pathlib import Path
from types import TracebackType
from typing import Self

from housefly.config.site import Site
from housefly.hub.api.answers import Answer
from housefly.hub.api.questions import Question
from housefly.hub.memory import RoomMemory
from housefly.hub.query_handler import QueryHandler
from housefly.hub.room_status import RoomStatus
from housefly.hub.situations.device_traits import device_traits_of
from housefly.hub.store.open import open_site_store
from housefly.hub.things_of_room import catalogue_of, surfaces_of
from housefly.room.edits import room_of


class OfflineRoom:
    """The memory of a site without its hub; raises StoreError if it cannot be opened."""

    def __init__(self, site: Site, folder: Path) -> None:
        room = room_of(site, folder)
        things = catalogue_of(site, room, folder)
        self._memory = RoomMemory(things, lambda: open_site_store(site), surfaces_of(room))
        status = RoomStatus(self._memory.writer.report)
        devices = device_traits_of(site)
        self._queries = QueryHandler(self._memory, status, time.time, devices)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._memory.close()

    def ask(self, question: Question) -> Answer:
        """Return the answer; raises ThingError if there is no such thing."""
        return self._queries.answer(question)
