"""A real memory with a scripted day in it, that is asked as the hub is: over JSON."""

from __future__ import annotations

from datetime import datetime, timedelta
from pathlib import Path
from typing import Any

from housefly.errors import HouseflyError
from housefly.hub.api.answers import SituationAnswer
from housefly.hub.api.json import (
    answer_from_json,
    answer_to_json,
    question_from_json,
    question_to_json,
    refusal_to_json,
)
from housefly.hub.api.questions import Question
from housefly.hub.client.room_queries import RoomQueries
from housefly.hub.memory import RoomMemory
from housefly.hub.query_handler import QueryHandler
from housefly.hub.room_status import RoomStatus
from housefly.hub.situations.device_traits import DeviceTraits
from housefly.hub.situations_at import MEMORY_STARTED
from housefly.hub.store.open import open_store
from housefly.hub.things.thing import Thing, ThingKind
from housefly.messages import Fact, Observation, RoomEvent
from housefly.sensors.contracts import SensorHealth

THINGS = (
    Thing("kitchen", "the kitchen", ThingKind.FURNITURE, position=(7.5, 5.5, 0.8)),
    Thing("cabinet", "the cabinet", ThingKind.FURNITURE, position=(11.5, 4.2, 0.6)),
    Thing("refrigerator", "refrigerator", ThingKind.FURNITURE, position=(6.5, 5.5, 0.8)),
    Thing("sofa", "sofa", ThingKind.FURNITURE, position=(12.5, 2.0, 0.4)),
    Thing("bed", "bed", ThingKind.FURNITURE, position=(10.0, 2.8, 0.4)),
    Thing("stove", "the stove", ThingKind.STRUCTURE, position=(9.6, 5.8, 0.9)),
    Thing("cup", "the cup", ThingKind.OBJECT, ("mug",)),
    Thing("book", "the book", ThingKind.OBJECT),
    Thing("glasses", "the glasses", ThingKind.OBJECT),
    Thing("person-1", "grandma", ThingKind.PERSON),
    Thing("visitor", "the visitor", ThingKind.PERSON),
    Thing("doorbell", "the doorbell", ThingKind.OBJECT),
    Thing("entrance", "entrance door", ThingKind.STRUCTURE),
    Thing("place-entrance", "Entrance", ThingKind.PLACE, ("entrance",), position=(1.0, 4.2, 1.2)),
)
_DEVICES = {"stove-plug": DeviceTraits("stove", "power", 50.0, 20.0, 60.0)}


def today_at(clock: str, days_ago: int = 0) -> float:
    """Return a local time of today, or of a day before it [Unix time, s]."""
    hour, minute = clock.split(":")
    day = datetime.now() - timedelta(days=days_ago)
    at = day.replace(hour=int(hour), minute=int(minute), second=0, microsecond=0)
    return at.timestamp()


class RememberedRoom(RoomQueries):
    """A memory and the time, both set by a test."""

    def __init__(self, file: Path, now: float) -> None:
        self.now = now
        self.asked: list[Question] = []
        self.memory = RoomMemory(THINGS, lambda: open_store(file))
        self.status = RoomStatus(self.memory.writer.report)
        self.status.add_health_source(lambda: (SensorHealth("x", "x", "x", True),))
        self._answers = QueryHandler(self.memory, self.status, lambda: self.now, _DEVICES)

    def ask(self, question: Question) -> Any:
        self.asked.append(question)
        asked = question_from_json(question_to_json(question))
        return answer_from_json(question, answer_to_json(self._answers.answer(asked)))

    def answer(self, text: str) -> str:
        """Answer over the bus, as the hub does."""
        try:
            return answer_to_json(self._answers.answer(question_from_json(text)))
        except HouseflyError as error:
            return refusal_to_json(error)

    def see(self, thing: str, at: float, position: Any = None, inside: str = "") -> None:
        """Have a sensor see a thing."""
        self.memory.add(Observation(thing, "vicon", at, at, position, inside=inside))

    def says(self, device: str, at: float, *facts: tuple[str, Fact]) -> None:
        """Have a device report."""
        self.memory.add(Observation(device, device, at, at, facts=facts))

    def happens(self, kind: str, thing: str, at: float, cause: str = "", **facts: Fact) -> None:
        """Have something happen."""
        source = "situations/test" if " " in kind else "hub"
        self.memory.add(RoomEvent(kind, thing, at, source, cause, facts=tuple(facts.items())))

    def holds(self, *rows: tuple[str, str, float, dict[str, Any]]) -> None:
        """Have situations hold since a time."""
        self.status.set_situations(
            SituationAnswer(kind, thing, since, 0.9, "floor-1: seen", facts, ("floor-1",))
            for kind, thing, since, facts in rows
        )


def a_day_with_grandma(file: Path) -> RememberedRoom:
    """Return a room at four in the afternoon, after an ordinary night and a visit at three."""
    now = today_at("16:00")
    room = RememberedRoom(file, now)
    room.memory.add(RoomEvent(MEMORY_STARTED, "hub", today_at("20:00", 1), "hub"))
    room.happens("appliance on", "stove", today_at("22:10", 1))
    room.happens("appliance on ended", "stove", today_at("22:20", 1))
    for begin, end in (
        (today_at("22:30", 1), today_at("01:10")),
        (today_at("01:16"), today_at("07:05")),
    ):
        room.happens("person lying", "person-1", begin, on="bed")
        room.happens("person lying ended", "person-1", end)
        room.happens("bed occupied", "bed", begin)
        room.happens("bed occupied ended", "bed", end)
    room.see("cup", now - 120.0, inside="cabinet")
    room.see("book", now - 7200.0, (12.4, 2.1, 0.5))
    room.see("person-1", now - 1.0, (12.5, 2.0, 0.0))
    room.happens("bell pressed", "doorbell", today_at("15:02"))
    room.happens("someone at the entrance", "entrance", today_at("15:02") + 3.0, "visitor")
    room.happens("someone at the entrance ended", "entrance", today_at("15:05"))
    room.happens("bell pressed", "doorbell", now - 20.0)
    room.happens("someone at the entrance", "entrance", now - 20.0)
    room.says("stove-plug", now - 5.0, ("power", 1420.0))
    room.holds(
        ("person sitting", "person-1", now - 600.0, {"on": "sofa seat 0"}),
        ("someone at the entrance", "entrance", now - 20.0, {}),
    )
    return room
