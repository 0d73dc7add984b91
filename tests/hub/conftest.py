"""A memory with a clock that stands, and what answers from it."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

from housefly.hub.api.json import (
    answer_from_json,
    answer_to_json,
    question_from_json,
    question_to_json,
)
from housefly.hub.api.questions import Question
from housefly.hub.memory import RoomMemory
from housefly.hub.query_handler import QueryHandler
from housefly.hub.room_status import RoomStatus
from housefly.hub.store.open import open_store
from housefly.hub.things.thing import Thing, ThingKind
from housefly.messages import Observation

NOON = float(round(time.time()))
"""Of today, because the store throws away what is older than two weeks."""
THINGS = (
    Thing("kitchen", "the kitchen", ThingKind.SPACE, position=(6.0, 5.0, 0.0)),
    Thing(
        "cabinet", "the cabinet", ThingKind.FURNITURE, position=(11.5, 4.2, 0.6), inside="kitchen"
    ),
    Thing("cup", "the red cup", ThingKind.OBJECT, ("mug",), inside="cabinet"),
    Thing("drone", "the drone", ThingKind.ROBOT, position=(1.0, 1.0, 0.0)),
)


@dataclass
class House:
    """A memory, who answers from it, and the time."""

    file: Path
    now: float = NOON
    memory: RoomMemory = field(init=False)
    status: RoomStatus = field(init=False)
    answers: QueryHandler = field(init=False)

    def __post_init__(self) -> None:
        self.open()

    def open(self, things: tuple[Thing, ...] = THINGS) -> None:
        self.memory = RoomMemory(things, lambda: open_store(self.file))
        self.status = RoomStatus(self.memory.writer.report)
        self.answers = QueryHandler(self.memory, self.status, lambda: self.now)

    def see(
        self, thing: str, ago: float, position: Any = None, inside: str = "", source: str = "vicon"
    ) -> None:
        at = self.now - ago
        self.memory.add(Observation(thing, source, at, at, position, inside=inside))

    def ask(self, question: Question) -> Any:
        """Ask over JSON, as the bus does."""
        return answer_from_json(
            question,
            answer_to_json(self.answers.answer(question_from_json(question_to_json(question)))),
        )


@pytest.fixture
def house(tmp_path: Path) -> Iterator[House]:
    made = House(tmp_path / "room.db")
    yield made
    made.memory.close()


@pytest.fixture
def noon() -> float:
    return NOON
