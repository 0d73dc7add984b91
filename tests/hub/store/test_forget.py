"""Somebody who is forgotten is in no row, no fact and no byte of the memory."""

from __future__ import annotations

from pathlib import Path

import pytest

from housefly.hub.store.forget import Forgotten, mention_of
from housefly.hub.store.open import open_store
from housefly.messages import Observation, RoomEvent

NAMES = ("the resident", "resident", "Ann")


def written(address: str) -> None:
    store = open_store(address)
    seen = [
        Observation(thing, "floor-1", at, at, (1.0, 2.0, 0.0))
        for thing in ("person-1", "person-10")
        for at in (10.0, 11.0)
    ]
    carried = Observation("cup", "situations", 12.0, 12.0, inside="person-1")
    events = [
        RoomEvent("person sitting", "person-1", 20.0, "x"),
        RoomEvent("object taken", "cup", 21.0, "x", "person-1"),
        RoomEvent("object missing", "cup", 22.0, "x", facts=(("taken_by", "person-1"),)),
        RoomEvent("said", "house", 23.0, "tasks", facts=(("words", "Ann fell; Anna did not"),)),
        RoomEvent("person sitting", "person-10", 24.0, "x"),
    ]
    store.write([*seen, carried], events)
    store.close()


def test_everything_of_a_person_goes_and_everybody_else_stays(address: str) -> None:
    written(address)
    store = open_store(address)
    assert store.forget("person-1", NAMES) == Forgotten(samples=2, events=2, struck=2)
    left = store.events(0.0, 100.0)
    assert [one.thing for one in left] == ["cup", "house", "person-10"]
    assert dict(left[0].facts) == {"taken_by": "somebody"}
    assert dict(left[1].facts) == {"words": "somebody fell; Anna did not"}
    assert {one.thing for one in store.latest()} == {"person-10"}
    assert store.forget("person-1", NAMES) == Forgotten(0, 0, 0)
    store.close()


def test_no_byte_of_a_forgotten_name_is_left_in_the_file(tmp_path: Path) -> None:
    file = tmp_path / "room.db"
    written(str(file))
    assert b"Ann fell" in b"".join(path.read_bytes() for path in tmp_path.iterdir())
    store = open_store(file)
    store.forget("person-1", NAMES)
    store.close()
    left = b"".join(path.read_bytes() for path in tmp_path.iterdir())
    assert b"Ann fell" not in left and b"person-10" in left


@pytest.mark.parametrize(
    ("words", "found"),
    [
        ("person-1", True),
        ("person-10", False),
        ("a person-1.", True),
        ("ANN", True),
        ("Anna", False),
    ],
)
def test_a_name_is_found_as_a_whole_word(words: str, found: bool) -> None:
    assert bool(mention_of(("person-1", *NAMES)).search(words)) is found
