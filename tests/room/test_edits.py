"""Edits of places and zones: applied, or refused in words; never half."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.config.edits import Edits, NoFlyZone, PlaceEdit
from housefly.config.site import Site, changed
from housefly.errors import EditsError
from housefly.room.bsen import bsen
from housefly.room.edits import edited, edits_from_tree, room_of
from housefly.room.grid import Cell, build_grid
from housefly.room.model import Place

ROOM, SITE = bsen(), Site()
CORNER = PlaceEdit(
    name="corner", title="Reading corner", viewpoint=(6.0, 4.25), look_at=(5.0, 5.0, 1.0)
)
WET = NoFlyZone(rectangle=(5.0, 3.0, 6.0, 4.0), reason="wet floor")


def refusal(edits: Edits, site: Site = SITE) -> EditsError:
    with pytest.raises(EditsError) as caught:
        edited(ROOM, site, edits)
    return caught.value


def test_no_edits_change_nothing_bit_for_bit() -> None:
    room, site = edited(ROOM, SITE, Edits())
    assert room is ROOM and site == SITE
    before, after = build_grid(ROOM, SITE), build_grid(room, site)
    assert (
        before.cells.tobytes() == after.cells.tobytes()
        and before.clearance.tobytes() == after.clearance.tobytes()
    )


def test_a_place_is_added_one_is_changed_one_is_gone_and_the_rest_stay() -> None:
    tv = PlaceEdit(name="tv", title="Screen", viewpoint=(12.55, 1.25), look_at=(14.3, 2.2, 1.4))
    room, site = edited(ROOM, SITE, Edits(places=(CORNER, tv), removed=("bed",)))
    assert [p.name for p in room.places] == [
        *(p.name for p in ROOM.places if p.name != "bed"),
        "corner",
    ]
    assert room.place("tv") == Place("tv", (12.55, 1.25), (14.3, 2.2, 1.4), "Screen")
    assert room.place("desk") == ROOM.place("desk")
    assert room_of(site) == room, "whoever reads the site gets the same room"
    assert replace(room, places=ROOM.places) == ROOM


def test_a_zone_closes_its_cells_and_no_others() -> None:
    room, site = edited(ROOM, SITE, Edits(zones=(WET,)))
    before, after = build_grid(ROOM, SITE), build_grid(room, site)
    different = np.argwhere(before.cells != after.cells)
    assert len(different) > 0
    for i, j in different:
        x, y = after.centre_of((int(i), int(j)))
        assert 5.0 <= x <= 6.0 and 3.0 <= y <= 4.0 and after.cells[i, j] == Cell.VIRTUAL


@pytest.mark.parametrize(
    ("edits", "item", "words"),
    [
        (Edits(removed=("home",)), "removed.0", "home cannot be removed"),
        (Edits(removed=("cellar",)), "removed.0", "no place called 'cellar'"),
        (
            Edits(places=(CORNER.model_copy(update={"name": "home"}),)),
            "places.0",
            "home cannot be changed",
        ),
        (Edits(places=(CORNER, CORNER)), "places.1", "names must differ"),
        (
            Edits(places=(CORNER.model_copy(update={"title": "work DESK"}),)),
            "places.0",
            "shown as 'work DESK'",
        ),
        (
            Edits(
                places=(CORNER.model_copy(update={"name": "bed", "title": "Bed"}),),
                removed=("bed",),
            ),
            "places.0",
            "at once",
        ),
        (
            Edits(places=(CORNER.model_copy(update={"viewpoint": (99.0, 1.0)}),)),
            "places.0",
            "x from 0.00 to 15.00 m",
        ),
        (
            Edits(places=(CORNER.model_copy(update={"look_at": (5.0, 5.0, 9.0)}),)),
            "places.0",
            "z from 0 to 2.70 m",
        ),
        (
            Edits(places=(CORNER.model_copy(update={"viewpoint": (0.05, 0.05)}),)),
            "places.0",
            "the nearest free point is (",
        ),
        (
            Edits(zones=(NoFlyZone(rectangle=(10.2, 1.0, 11.0, 1.6), reason="mine"),)),
            "zones.0",
            "covers the home pad",
        ),
        (
            Edits(zones=(NoFlyZone(rectangle=(5.0, 3.0, 5.1, 4.0), reason="thin"),)),
            "zones.0",
            "sides of 0.20 m and more",
        ),
        (
            Edits(zones=(NoFlyZone(rectangle=(5.0, 3.0, 55.0, 4.0), reason="wide"),)),
            "zones.0",
            "not inside the room",
        ),
        (
            Edits(zones=(NoFlyZone(rectangle=(2.0, 3.0, 4.0, 5.0), reason="guest"),)),
            "zones.0",
            "1 of 9 places from home: Entrance",
        ),
        (
            Edits(zones=(WET, NoFlyZone(rectangle=(9.6, 0.0, 10.0, 8.0), reason="tape"))),
            "zones.1",
            "Meeting table, Bed, Kitchen",
        ),
    ],
)
def test_what_cannot_be_is_refused_in_words_with_range_and_unit(
    edits: Edits, item: str, words: str
) -> None:
    error = refusal(edits)
    assert words in str(error)
    assert error.item == item


def test_a_place_that_is_removed_need_not_be_reached() -> None:
    edited(
        ROOM,
        SITE,
        Edits(
            removed=("entrance",),
            zones=(NoFlyZone(rectangle=(2.0, 3.0, 4.0, 5.0), reason="guest"),),
        ),
    )


def test_mode_paper_knows_no_edits() -> None:
    paper = changed(SITE, mode="paper")
    assert "mode default only" in str(refusal(Edits(removed=("bed",)), paper))
    held = paper.model_copy(update={"edits": Edits(places=(CORNER,), zones=(WET,))})
    assert room_of(held) == ROOM
    assert build_grid(ROOM, held).cells.tobytes() == build_grid(ROOM, paper).cells.tobytes()


@pytest.mark.parametrize(
    ("tree", "item", "words"),
    [
        ([], "", "edits are places, removed and zones"),
        ({"place": []}, "place", "is not a known key"),
        (
            {"places": [{"name": "A b!", "viewpoint": [1, 1], "look_at": [1, 1, 1]}]},
            "places.0",
            "1 to 40 of a-z",
        ),
        (
            {"places": [{"name": "a", "viewpoint": [1, None], "look_at": [1, 1, 1]}]},
            "places.0",
            "places.0.viewpoint.1",
        ),
        ({"zones": [{"rectangle": [1, 1, 2, 2], "reason": "  "}]}, "zones.0", "say why"),
        ({"zones": [{"rectangle": [2, 1, 1, 2], "reason": "x"}]}, "zones.0", "x_min < x_max"),
        ({"removed": ["a"] * 41}, "removed", "40"),
    ],
)
def test_json_that_is_no_edits_is_refused_in_words(tree: Any, item: str, words: str) -> None:
    with pytest.raises(EditsError) as caught:
        edits_from_tree(tree)
    assert words in str(caught.value) and caught.value.item == item


JSON = st.recursive(
    st.none() | st.booleans() | st.floats() | st.text(max_size=8),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(st.sampled_from(["places", "zones", "removed", "name"]), inner)
    ),
    max_leaves=12,
)


@given(JSON)
@settings(max_examples=200)
def test_any_json_is_read_or_refused(tree: Any) -> None:
    try:
        edits = edits_from_tree(tree)
    except EditsError as error:
        assert str(error)
    else:
        assert edits_from_tree(edits.model_dump(mode="json")) == edits


near = st.floats(-1.0, 16.0)
names = st.sampled_from(["corner", "tv", "home", "bed", "a place", "desk"])
a_place = st.builds(
    PlaceEdit,
    name=names,
    title=st.text(max_size=5, alphabet="abBed"),
    viewpoint=st.tuples(near, near),
    look_at=st.tuples(near, near, near),
)


@st.composite
def a_zone(draw: st.DrawFn) -> NoFlyZone:
    x, y, w, h = draw(near), draw(near), draw(st.floats(0.01, 4.0)), draw(st.floats(0.01, 4.0))
    return NoFlyZone(rectangle=(x, y, x + w, y + h), reason="why")


@given(
    st.builds(
        Edits,
        places=st.tuples() | st.tuples(a_place),
        removed=st.tuples() | st.tuples(names),
        zones=st.lists(a_zone(), max_size=2).map(tuple),
    )
)
@settings(max_examples=150)
def test_any_edits_are_applied_or_refused_and_what_is_applied_can_be_flown(edits: Edits) -> None:
    try:
        room, site = edited(ROOM, SITE, edits)
    except EditsError as error:
        assert str(error) and (
            error.item == "" or error.item.split(".")[0] in ("places", "removed", "zones")
        )
        return
    grid = build_grid(room, site)
    assert room.place("home") == ROOM.place("home")
    assert len({place.name for place in room.places}) == len(room.places)
    assert all(grid.is_free(grid.cell_of(place.viewpoint)) for place in room.places)
    assert room_of(site) == room
