"""Who has not moved for long may be landed beside, as a thing is."""

from __future__ import annotations

from dataclasses import replace

import pytest

from housefly.app.loaded_site import load_site
from housefly.geometry import Vec2, distance
from housefly.messages import Obstacle, ObstacleKind
from housefly.pilot.planning.people_map import SPOT_APART, UNMOVED_TIME, PeopleMap

PLACE = (3.5, 2.5)


@pytest.fixture(scope="module")
def around() -> PeopleMap:
    loaded = load_site("bsen", hub__enabled=False)
    return PeopleMap(loaded.site, loaded.room, loaded.grid)


def seen(around: PeopleMap, x: float, now: float, *, name: str = "somebody") -> None:
    person = Obstacle(
        name, (x, PLACE[1]), 0.2, seen_at=now, source="laser", kind=ObstacleKind.PERSON
    )
    around.update((person,), lambda: around._grid, now)


def test_who_has_not_moved_for_long_is_landed_beside_but_not_onto(around: PeopleMap) -> None:
    seen(around, PLACE[0] + 0.9, 0.0, name="beside")
    assert around.landing_fault(PLACE, 0.1)
    seen(around, PLACE[0] + 0.92, UNMOVED_TIME, name="beside")
    assert not around.landing_fault(PLACE, UNMOVED_TIME)
    assert around.landing_fault((PLACE[0] + 0.2, PLACE[1]), UNMOVED_TIME)


@pytest.mark.parametrize(("name", "moved"), [("before", 0.2), ("somebody else", 0.0)])
def test_who_moved_or_is_new_keeps_the_drone_away(
    around: PeopleMap, name: str, moved: float
) -> None:
    seen(around, PLACE[0] + 0.8, 0.0, name="before")
    seen(around, PLACE[0] + 0.8 + moved, 20.0, name=name)
    assert around.landing_fault((PLACE[0] + 0.05, PLACE[1]), UNMOVED_TIME + 1.0)


def test_furniture_is_no_floor_to_land_on_but_the_pad_is_wherever_it_lies() -> None:
    loaded = load_site("bsen", hub__enabled=False)
    around = PeopleMap(loaded.site, loaded.room, loaded.grid)
    sofa = next(solid for solid in loaded.room.solids if solid.name.startswith("sofa"))
    beside = (sofa.position[0], sofa.position[1])
    assert "furniture" in around.ground_fault(beside)
    assert not around.ground_fault(PLACE)
    on_sofa = replace(loaded.room, home=beside)
    assert not PeopleMap(loaded.site, on_sofa, loaded.grid).ground_fault(beside)
    paper = load_site("bsen", hub__enabled=False, mode="paper")
    assert not PeopleMap(paper.site, paper.room, paper.grid).ground_fault(beside)


def test_places_to_land_beside_one_that_cannot_be_reached_are_left_out(around: PeopleMap) -> None:
    around.update((), lambda height: around._grid, 0.0)
    spots: list[Vec2] = []
    while (spot := around.landing_spot(PLACE, 0.0, unreachable=spots)) is not None:
        assert all(distance(spot, other) >= SPOT_APART for other in spots)
        assert not around.ground_fault(spot)
        spots.append(spot)
    assert len(spots) >= 4
    distances = [round(distance(PLACE, spot), 6) for spot in spots]
    assert distances == sorted(distances)
