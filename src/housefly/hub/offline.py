"""Answers from the store alone, while nothing runs: what was last known."""

from __future__ import annotations

import time
from pathlib import Path
from types import TracebackType
from typing import Self

from housefly.config.site import Site
from housefly.hub.answers import Answers
from housefly.hub.api.answers import Answer
from housefly.hub.api.questions import Question
from housefly.hub.memory import RoomMemory
from housefly.hub.present import Present
from housefly.hub.process import catalogue_of, store_address
from housefly.hub.store.opening import open_store
from housefly.room.edits import room_of


class OfflineRoom:
    """The memory of a site without its hub; raises StoreError when it cannot be opened."""

    def __init__(self, site: Site, folder: Path) -> None:
        address = store_address(site)
        things = catalogue_of(site, room_of(site, folder), folder)
        self._memory = RoomMemory(things, lambda: open_store(address, keep_days=site.hub.keep_days))
        self._answers = Answers(self._memory, Present(self._memory.writer.report), time.time)

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
        """Return the answer; raises ThingError when there is no such thing."""
        return self._answers.answer(question)
