"""Furniture with markers: taken out of the room, known by where it stood, refused when absent."""

from __future__ import annotations

from math import cos, pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.furniture import FurnitureConfig
from housefly.config.site import Site, changed
from housefly.errors import ConfigError
from housefly.room.bsen import bsen
from housefly.room.grid import Cell, build_grid
from housefly.room.tracked import body_pose_of, footprint_of, stand_of, untracked
from housefly.sites.loaded_site import open_site

SHELF = FurnitureConfig(
    name="shelf", body="Shelf 1", model="smart shelf", length=0.5, width=0.35, top=1.0
)
AT = (11.5, 4.2)


def site(*pieces: FurnitureConfig) -> Site:
    return changed(Site(), furniture=pieces)


def test_a_room_whose_furniture_nobody_tracks_is_the_same_room() -> None:
    loose = FurnitureConfig(name="chair", body="Chair 1")
    assert untracked(bsen(), site(loose)) is bsen()
    assert stand_of(bsen(), loose) is None


def test_what_is_tracked_leaves_the_room_and_nothing_else_does() -> None:
    left = untracked(bsen(), site(SHELF))
    assert {solid.thing for solid in bsen().solids} - {solid.thing for solid in left.solids} == {
        "smart shelf"
    }
    before, after = (build_grid(room, Site()) for room in (bsen(), left))
    cell = before.cell_of(AT)
    assert before.kind(cell) is Cell.OCCUPIED and after.kind(cell) is Cell.FREE
    assert ((before.cells == Cell.FREE) <= (after.cells == Cell.FREE)).all()


def test_one_of_many_is_named_by_how_its_solids_are_called() -> None:
    chair = FurnitureConfig(name="chair", body="Chair 1", model="meeting chair north", top=1.0)
    gone = {solid.name for solid in bsen().solids} - {
        solid.name for solid in untracked(bsen(), site(chair)).solids
    }
    assert gone and all(name.startswith("meeting chair north ") for name in gone)


def test_where_it_stands_is_the_rectangle_around_it_as_the_site_file_turns_it() -> None:
    shelf = stand_of(bsen(), SHELF)
    turned = stand_of(bsen(), SHELF.model_copy(update={"length": 0.35, "width": 0.5}))
    assert shelf is not None and turned is not None
    assert shelf.middle == pytest.approx(AT, abs=0.02) and turned.middle == shelf.middle
    assert shelf.size == pytest.approx((0.46, 0.30), abs=0.01) and turned.size == shelf.size[::-1]
    assert abs(cos(shelf.yaw - turned.yaw)) == pytest.approx(0.0, abs=1e-9)
    assert (shelf.bottom, shelf.top) == pytest.approx((0.0, 0.89), abs=0.02)


@given(
    x=st.floats(-2.0, 2.0), y=st.floats(-2.0, 2.0), turn=st.floats(-pi, pi), yaw=st.floats(-pi, pi)
)
def test_a_body_put_where_a_footprint_wants_it_has_that_footprint(
    x: float, y: float, turn: float, yaw: float
) -> None:
    piece = FurnitureConfig(name="shelf", body="Shelf 1", x=x, y=y, yaw=turn)
    middle, found = footprint_of(piece, body_pose_of(piece, AT, yaw))
    assert middle == pytest.approx(AT) and cos(found - yaw) == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"model": "spaceship"}, "nothing that the room model has; it has: .*smart shelf"),
        ({"model": "carpet"}, "nothing that the room model has"),
        ({"width": 0.1}, "0.46 m long and 0.30 m wide in the room model"),
        ({"model": "chair"}, "as large"),
        ({"top": 0.5}, "heights of 0.00 to 0.89 m"),
        ({"bottom": 0.4}, "bottom and top must include them"),
    ],
)
def test_furniture_that_does_not_fit_the_room_is_refused_before_anything_starts(
    changes: dict[str, object], words: str
) -> None:
    with pytest.raises(ConfigError, match=words):
        open_site(site(SHELF.model_copy(update=changes)))


def test_two_things_cannot_be_the_same_one_of_the_room() -> None:
    with pytest.raises(ConfigError, match="same model"):
        site(SHELF, SHELF.model_copy(update={"name": "other", "body": "Shelf 2"}))
