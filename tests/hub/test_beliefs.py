"""Answers carry their doubt: carried things, people out of sight, what was taken unseen."""

from __future__ import annotations

from typing import Any

import pytest

from housefly.hub.api.questions import WhereQuestion
from housefly.hub.memory import RoomMemory
from housefly.hub.store.open import open_store
from housefly.hub.things.surfaces import Surface
from housefly.hub.things.thing import Thing, ThingKind
from housefly.messages import Observation, RoomEvent

_TABLE = Surface("sofa-table", "sofa table", (3.0, 1.0), (0.5, 0.3), 0.43)
_THINGS = (
    Thing("cup", "the cup"),
    Thing("resident", "the resident", ThingKind.PERSON),
    Thing("cabinet", "the cabinet", ThingKind.FURNITURE, position=(0.0, 0.0, 0.6)),
    Thing("bed", "the bed", ThingKind.FURNITURE, position=(9.0, 9.0, 0.3)),
)


@pytest.fixture
def room(house: Any) -> Any:
    """A house with a table, a person and a cabinet."""
    house.memory.close()
    reopen(house)
    return house


def reopen(house: Any) -> None:
    house.open(_THINGS)
    house.memory.close()
    house.memory = RoomMemory(_THINGS, lambda: open_store(house.file), (_TABLE,))
    house.answers._memory = house.memory


def walk_past_the_table(house: Any, stop: float = 2.0) -> None:
    """The resident takes the cup, walks to the table, stands there and walks on, until now."""
    begin = house.now - 20.0
    seen = Observation("cup", "situations/objects", begin, begin, inside="resident")
    house.memory.add(seen)
    x = 0.0
    for tick in range(200):
        at = begin + 0.1 * (tick + 1)
        x += 0.0 if 3.0 <= x < 3.05 and stop > 0.0 else 0.08
        stop -= 0.1 if 3.0 <= x < 3.05 else 0.0
        facts = (("kind", "person"),)
        house.memory.add(Observation("resident", "floor", at, at, (x, 0.2, 0.0), facts=facts))


def test_a_carried_thing_is_with_its_carrier_or_left_where_they_stopped(room: Any) -> None:
    walk_past_the_table(room)
    answer = room.ask(WhereQuestion("cup"))
    assert answer.inside == ("resident",)
    assert 0.4 < answer.confidence < 0.7
    (other,) = answer.alternatives
    assert (other.words, other.thing) == ("left on the sofa table", "sofa-table")
    assert other.position == pytest.approx((3.0, 0.7, 0.43), abs=0.1)
    assert "the cup: with the resident" in answer.words
    assert "or left on the sofa table at (3.0" in answer.words
    assert f"({round(100 * other.confidence)} %)" in answer.words


def test_the_doubt_outlives_a_restart_and_is_the_same_when_asked_later_of_then(room: Any) -> None:
    walk_past_the_table(room)
    told = room.ask(WhereQuestion("cup"))
    then = room.now
    room.memory.close()
    reopen(room)
    again = room.ask(WhereQuestion("cup"))
    assert [one.words for one in again.alternatives] == [one.words for one in told.alternatives]
    assert again.confidence == pytest.approx(told.confidence, abs=0.05)
    room.now += 100.0
    room.see("cup", 1.0, inside="cabinet", source="cabinet")
    assert room.ask(WhereQuestion("cup")).alternatives == ()
    past = room.ask(WhereQuestion("cup", at=then))
    assert past.confidence == pytest.approx(told.confidence, abs=0.05)
    assert [one.thing for one in past.alternatives] == ["sofa-table"]


def test_what_is_seen_again_is_doubted_no_more(room: Any) -> None:
    walk_past_the_table(room)
    room.see("cup", 0.0, (3.0, 1.0, 0.45))
    assert room.ask(WhereQuestion("cup")).alternatives == ()


def test_the_furniture_of_a_container_that_tells_its_contents_is_no_place_to_leave_a_thing(
    house: Any,
) -> None:
    inside = Surface("shelf", "shelf", (0.0, 0.0), (0.3, 0.3), 0.9)
    house.memory.close()
    house.memory = RoomMemory(_THINGS, lambda: open_store(house.file), (inside,))
    house.answers._memory = house.memory
    begin = house.now - 10.0
    told = (("contents", "book"),)
    house.memory.add(Observation("cabinet", "cabinet", begin, begin, facts=told))
    house.memory.add(Observation("cup", "situations/objects", begin, begin, inside="resident"))
    for tick in range(100):
        at = begin + 0.1 * tick
        house.memory.add(Observation("resident", "floor", at, at, (0.4, 0.0, 0.0)))
    assert house.ask(WhereQuestion("cup")).alternatives == ()
    assert house.ask(WhereQuestion("cup", at=house.now - 0.1)).alternatives == ()


def test_what_its_cabinet_no_longer_lists_is_hardly_there(room: Any) -> None:
    room.see("cup", 60.0, inside="cabinet", source="cabinet")
    for ago, contents in ((60.0, "cup"), (5.0, "")):
        at = room.now - ago
        told = Observation("cabinet", "cabinet", at, at, facts=(("contents", contents),))
        room.memory.add(told)
        assert bool(room.ask(WhereQuestion("cup")).alternatives) == (contents == "")
    answer = room.ask(WhereQuestion("cup"))
    assert answer.confidence < 0.1 and "or taken by somebody since (95 %)" in answer.words


def test_who_is_seen_is_there_and_who_is_not_may_be_elsewhere(room: Any) -> None:
    room.see("resident", 0.2, (1.0, 2.0, 0.0), source="floor")
    assert room.ask(WhereQuestion("resident")).alternatives == ()
    room.now += 10.0
    answer = room.ask(WhereQuestion("resident"))
    assert answer.confidence < 0.2
    assert [one.words for one in answer.alternatives] == ["elsewhere"]


def test_a_source_that_goes_on_without_somebody_makes_them_missed_at_once(room: Any) -> None:
    room.see("resident", 0.9, (1.0, 2.0, 0.0), source="floor")
    assert room.ask(WhereQuestion("resident")).alternatives == ()
    room.see("floor", 0.1, source="floor")
    assert room.ask(WhereQuestion("resident")).alternatives != ()


def test_who_lay_down_is_probably_in_bed_until_they_get_up(room: Any) -> None:
    room.see("resident", 60.0, (9.0, 8.0, 0.0), source="floor")
    facts = (("on", "bed"),)
    source = "situations/people"
    at = room.now - 55.0
    room.memory.add(RoomEvent("person lying", "resident", at, source, "", 0.8, facts))
    answer = room.ask(WhereQuestion("resident"))
    assert answer.alternatives[0].thing == "bed"
    assert "or in the bed at (9.00, 9.00, 0.30) m (72 %)" in answer.words
    room.memory.add(RoomEvent("person lying ended", "resident", room.now, source))
    assert "bed" not in room.ask(WhereQuestion("resident")).words


def test_furniture_that_nobody_sees_is_where_it_was(room: Any) -> None:
    room.see("cabinet", 5000.0, (1.0, 2.0, 0.0))
    assert room.ask(WhereQuestion("cabinet")).confidence == 1.0


def test_somebody_whom_a_floor_numbers_is_a_person_without_a_catalogue(room: Any) -> None:
    at = room.now
    facts = (("kind", "person"),)
    room.memory.add(Observation("person-7", "floor", at, at, (1.0, 2.0, 0.0), facts=facts))
    room.memory.add(Observation("cup", "situations/objects", at, at, inside="person-7"))
    assert "with person-7" in room.ask(WhereQuestion("cup")).words
