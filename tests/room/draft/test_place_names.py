"""Places that are chosen for a room have names that a person would give."""

from __future__ import annotations

from dataclasses import replace
from math import hypot

from housefly.room.draft.missing import DraftStep, missing
from housefly.room.draft.model import DraftBox, SiteDraft, with_size
from housefly.room.draft.shapes import room_of_draft
from housefly.room.draft.site_of_draft import site_of_draft, suggested_places
from housefly.room.draft.suggestions import suggested_pad
from housefly.room.edits import reached_from
from housefly.room.grid import build_grid

TABLE = DraftBox("table", 5.0, 3.4, 1.2, 0.8, 0.75)
SHELF = DraftBox("shelf", 0.3, 2.0, 0.4, 1.0, 1.8)
DOOR = DraftBox("room door", 3.0, 0.05, 0.9, 0.1, 2.0, thing="room door")


def furnished(*boxes: DraftBox) -> SiteDraft:
    draft = replace(with_size(SiteDraft("den"), 6.0, 4.5), furniture=boxes)
    return replace(draft, pad=suggested_pad(draft))


def test_a_place_is_called_by_the_furniture_that_is_near_and_looks_at_it() -> None:
    found = {one.name: one for one in suggested_places(furnished(TABLE, SHELF))}
    assert {"table", "shelf"} <= set(found)
    assert found["table"].title == "Table" and found["table"].look_at == (5.0, 3.4, 0.75)
    assert all(one.title not in ("North", "Far") for one in found.values())


def test_without_furniture_the_sides_are_named_as_people_name_them() -> None:
    titles = {one.title for one in suggested_places(furnished())}
    assert titles and titles <= {"Far end", "North side", "South side", "East side", "West side"}


def test_a_room_with_a_door_has_an_entrance_and_a_visitor_before_it() -> None:
    draft = furnished(TABLE, DOOR)
    draft = replace(draft, places=suggested_places(draft))
    (entrance,) = (one for one in draft.places if one.name == "entrance")
    assert entrance.look_at is not None and entrance.look_at[:2] == (DOOR.x, DOOR.y)
    room = room_of_draft(draft)
    grid = build_grid(room, site_of_draft(draft))
    assert reached_from(grid, room.home)[grid.cell_of((entrance.x, entrance.y))]
    assert room.visitor is not None
    x, y = room.visitor
    assert 0.3 < x < 5.7 and 0.3 < y < 4.2
    assert 0.5 < hypot(x - entrance.x, y - entrance.y) < 2.0
    assert not [one for one in missing(draft) if one.hinders]


def test_a_room_without_a_door_has_no_entrance_and_nobody_rings_in_it() -> None:
    draft = furnished(TABLE)
    draft = replace(draft, places=suggested_places(draft))
    assert "entrance" not in {one.name for one in draft.places}
    assert room_of_draft(draft).visitor is None


def test_a_part_of_the_room_that_cannot_be_reached_is_told() -> None:
    wall = DraftBox("long shelf", 4.0, 2.25, 0.3, 4.4, 2.2)
    draft = furnished(wall)
    told = [one for one in missing(draft) if one.step is DraftStep.OBJECTS]
    assert len(told) == 1 and not told[0].hinders
    assert "of the free floor cannot be reached from the pad" in told[0].words
    assert not [one for one in missing(furnished(TABLE)) if one.step is DraftStep.OBJECTS]
