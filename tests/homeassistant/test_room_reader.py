"""Hub and tasks are asked about what has changed, and no more than they can bear."""

from __future__ import annotations

from collections import Counter
from typing import Any

import pytest
from home_screen import site_at
from stand_in_tasks import StandInTasks

from housefly.bus.local import LocalBus
from housefly.bus.topics import HUB_QUERY
from housefly.clock import SteppedClock
from housefly.errors import LinkError, ThingError
from housefly.homeassistant.home_view import HomeView
from housefly.homeassistant.room_reader import RoomReader
from housefly.hub.api.answers import (
    PictureAnswer,
    SensorAnswer,
    SensorsAnswer,
    SituationAnswer,
    SourceAnswer,
    WhereAnswer,
)
from housefly.hub.api.json import answer_to_json, question_from_json, refusal_to_json
from housefly.hub.api.questions import PictureQuestion, SensorsQuestion, WhereQuestion
from housefly.room.files import load_room


class Hub:
    """Answers what is asked about doors, and counts it."""

    def __init__(self, bus: LocalBus, doors: int) -> None:
        self.asked: Counter[str] = Counter()
        self.is_open = True
        self.doors = tuple(f"door-{number}" for number in range(doors))
        self.answering = bus.answer(HUB_QUERY, self.answer)

    def answer(self, text: str) -> str:
        question: Any = question_from_json(text)
        self.asked[question.ask] += 1
        match question:
            case SensorsQuestion():
                told = [
                    SensorAnswer(one, "door", one, True, 1.0, 0.1, "", {}) for one in self.doors
                ]
                return answer_to_json(SensorsAnswer((*told,), ""))
            case PictureQuestion():
                held = SituationAnswer("appliance on", "stove", 3.0, 0.9, "it draws 1420 W")
                return answer_to_json(PictureAnswer(1.0, (), (held,)))
            case WhereQuestion(thing) if thing == "door-1":
                return refusal_to_json(ThingError("there is no such thing"))
            case WhereQuestion(thing):
                said = SourceAnswer(thing, 0.1, None, "", True, {"open": self.is_open})
                return answer_to_json(
                    WhereAnswer(
                        *(thing, thing, "device", "", None, None, None, (), "", 1.0, 0.1),
                        *((thing,), (said,)),
                    )
                )
        raise AssertionError(question)


class House:
    """A reader with its hub and tasks."""

    def __init__(self, doors: int = 3, *, has_tasks: bool = True) -> None:
        bus, self.clock = LocalBus(), SteppedClock()
        site = site_at(1883)
        self.hub, self.tasks = Hub(bus, doors), StandInTasks(bus)
        self.view = HomeView(site, load_room(site.room.model), self.clock)
        self.reader = RoomReader(bus, self.view, self.clock, has_tasks=has_tasks)

    def state(self, key: str) -> bytes:
        return self.view.states()[self.view.topics.state(key)]


def test_everything_is_known_after_the_first_look() -> None:
    house = House()
    house.reader.read()
    assert house.state("device-door-0-open") == b"ON"
    assert house.state("device-door-1-open") == b"None", "it has reported nothing yet"
    assert house.state("situation-appliance-on") == b"ON"
    assert house.state("room-mode") == b"home"


def test_what_has_reported_is_asked_about_soon_and_at_most_twice_a_second() -> None:
    house = House()
    house.reader.read()
    house.hub.is_open = False
    for _ in range(100):
        house.clock.advance(0.05)
        house.reader.touch(["door-0", "cup"])
        house.reader.read()
    assert house.state("device-door-0-open") == b"OFF"
    assert house.state("device-door-2-open") == b"ON", "its own turn comes later"
    assert 10 <= house.hub.asked["where"] <= 3 + 11
    house.clock.advance(10.0)
    house.reader.read()
    assert house.state("device-door-2-open") == b"OFF"


def test_a_house_full_of_devices_is_asked_about_bit_by_bit() -> None:
    house = House(doors=100)
    for turn in range(1, 6):
        house.reader.read()
        assert house.hub.asked["where"] == 20 * turn
    house.clock.advance(0.1)
    house.reader.read()
    assert house.hub.asked["where"] == 100


def test_silent_tasks_hide_no_room_and_a_silent_hub_is_said() -> None:
    house = House()
    house.tasks.close()
    house.reader.read()
    assert house.state("device-door-0-open") == b"ON" and house.state("room-mode") == b"None"
    house.hub.answering.close()
    house.clock.advance(2.0)
    with pytest.raises(LinkError):
        house.reader.read()


def test_where_there_are_no_tasks_nobody_asks_them() -> None:
    house = House(has_tasks=False)
    house.reader.read()
    assert house.tasks.asked == [] and house.state("room-mode") == b"None"
