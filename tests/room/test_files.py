"""Room files: what is written is read back, and bad values are named."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import ConfigError, RoomError
from housefly.room.bsen import bsen
from housefly.room.files import load_room, room_from_toml, room_to_toml, save_room
from housefly.room.model import Place, Room, Shape, Solid

SMALL = Room(
    "small",
    (0.0, 0.0, 3.0, 2.0),
    2.5,
    (Solid("box 1", "box", Shape.BOX, (1.0, 1.0, 0.5), (0.2, 0.3, 1.0)),),
    (Place("home", (0.5, 0.5), (1.0, 0.5, 1.0), "Home"),),
    (),
    (0.5, 0.5),
)


@pytest.mark.parametrize("room", [bsen(), SMALL])
def test_a_room_survives_being_written_and_read(room: Room) -> None:
    assert room_from_toml(room_to_toml(room)) == room


@given(st.text(min_size=1, max_size=60))
def test_any_name_survives_being_written_and_read(name: str) -> None:
    from dataclasses import replace

    assert room_from_toml(room_to_toml(replace(SMALL, name=name))).name == name


def test_a_saved_room_is_loaded_relative_to_the_site_file(tmp_path: Path) -> None:
    save_room(SMALL, tmp_path / "rooms" / "mine")
    assert load_room("rooms/mine", tmp_path) == SMALL


def test_the_built_in_room_is_known_by_name() -> None:
    assert load_room("bsen") == bsen()


@pytest.mark.parametrize(
    ("change", "key", "words"),
    [
        ("height = 2.5", "height = 0.2", "height"),
        ("height = 2.5", 'height = "high"', "height"),
        ("height = 2.5", "hight = 2.5", "hight"),
        ("bounds = [0.0, 0.0, 3.0, 2.0]", "bounds = [3.0, 0.0, 0.0, 2.0]", "x_min < x_max"),
        ("home = [0.5, 0.5]", "home = [9.5, 0.5]", "within bounds"),
        ("size = [0.2, 0.3, 1.0]", "size = [0.2, -0.3, 1.0]", "solids.0.size.1"),
        ("size = [0.2, 0.3, 1.0]", "size = [0.2, nan, 1.0]", "solids.0.size.1"),
        ('shape = "box"', 'shape = "ball"', "solids.0.shape"),
        ('name = "home"', 'name = "away"', '"home"'),
        ("home = [0.5, 0.5]", "home = [0.5", "TOML"),
    ],
)
def test_a_bad_value_is_named_with_what_is_allowed(change: str, key: str, words: str) -> None:
    text = room_to_toml(SMALL)
    assert change in text
    with pytest.raises(ConfigError, match=r".") as caught:
        room_from_toml(text.replace(change, key), "room.toml")
    assert words in str(caught.value)


def test_an_unknown_room_is_refused_with_the_known_ones(tmp_path: Path) -> None:
    with pytest.raises(RoomError, match="bsen"):
        load_room("nowhere", tmp_path)
