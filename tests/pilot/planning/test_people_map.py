"""Where a landing hurts nobody and nothing."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from housefly.geometry import Vec2, distance
from housefly.messages import Obstacle, ObstacleKind
from housefly.pilot.behavior.braking import BESIDE_MAX
from housefly.pilot.navigator import RoomNavigator
from housefly.pilot.planning.people_map import SPOT_APART, UNMOVED_TIME, PeopleMap
from housefly.room.grid import Cell
from housefly.sites.loaded_site import load_site

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


SOFA_CORNER = (11.27, 1.28)
ABOVE_SOFA = 1.0
BESIDE_THINGS = [(5.0 + 0.4 * n, y) for n in range(22) for y in (0.9, 1.6, 3.6, 5.1)]


@pytest.fixture(scope="module")
def navigator() -> RoomNavigator:
    loaded = load_site("bsen", hub__enabled=False)
    return RoomNavigator(loaded.site, loaded.room, loaded.grid)


def test_over_furniture_the_nearest_clear_floor_is_straight_beside_it(
    navigator: RoomNavigator,
) -> None:
    navigator.update((), (), 0.0)
    spot = navigator.clear_floor(SOFA_CORNER, ABOVE_SOFA)
    assert spot is not None
    assert distance(spot, SOFA_CORNER) <= BESIDE_MAX
    assert not navigator.people.ground_fault(spot)


def test_over_clear_floor_a_landing_keeps_its_place(navigator: RoomNavigator) -> None:
    navigator.update((), (), 0.0)
    assert navigator.clear_floor((3.5, 4.2), ABOVE_SOFA) is None


def test_clear_floor_that_is_to_be_left_is_left_by_so_much(navigator: RoomNavigator) -> None:
    navigator.update((), (), 0.0)
    place = (3.5, 4.2)
    spot = navigator.clear_floor(place, ABOVE_SOFA, (place,))
    assert spot is not None and 0.9 <= distance(place, spot) <= BESIDE_MAX


def test_no_landing_is_steered_into_what_stands_as_high_as_the_drone(
    navigator: RoomNavigator,
) -> None:
    navigator.update((), (), 0.0)
    beside = 0
    for x, y in BESIDE_THINGS:
        for height in (0.5, 1.0, 1.4):
            layer = navigator.people._things(height)
            spot = navigator.clear_floor((x, y), height)
            if layer.kind(layer.cell_of((x, y))) is Cell.OCCUPIED or spot is None:
                continue
            beside += 1
            way = np.linspace((x, y), spot, 60).tolist()
            kinds = {layer.kind(layer.cell_of((at[0], at[1]))) for at in way}
            assert kinds <= {Cell.FREE, Cell.INFLATED}, (x, y, height)
    assert beside >= 5


def test_nobody_is_landed_on_who_stands_below_and_nobody_is_passed_too_near(
    navigator: RoomNavigator,
) -> None:
    place = (3.5, 4.2)
    below = Obstacle("below", place, 0.2, seen_at=0.0, source="laser", kind=ObstacleKind.PERSON)
    navigator.update((below,), (), 0.0)
    assert navigator.people.landing_fault(place, 0.0)
    spot = navigator.clear_floor(place, 1.4)
    if spot is not None:
        assert distance(spot, place) > navigator.people.hull + 0.2
        assert not navigator.people.landing_fault(spot, 0.0)


@pytest.mark.parametrize(
    ("kind", "speed", "is_refused"),
    [
        (ObstacleKind.DRONE, -0.6, True),
        (ObstacleKind.DRONE, 0.6, False),
        (ObstacleKind.DRONE, 0.0, False),
        (ObstacleKind.PERSON, -0.6, False),
    ],
)
def test_a_take_off_waits_for_a_drone_that_comes_past(
    around: PeopleMap, kind: ObstacleKind, speed: float, is_refused: bool
) -> None:
    place = 4.0, 3.0
    there = Obstacle("bert", (7.5, 3.0), 0.3, velocity=(speed, 0.0), seen_at=0.0, kind=kind)
    around.update((there,), lambda height: around._grid, 0.0)
    fault = around.take_off_fault(place, 0.0)
    assert ("bert comes near" in fault) == is_refused


@pytest.mark.parametrize(
    ("who", "kind", "said"),
    [
        ("track-2", ObstacleKind.PERSON, "somebody is too close"),
        ("track-depth-1-2", ObstacleKind.UNKNOWN, "something is too close"),
        ("track-2", ObstacleKind.THING, "something is too close"),
        ("Anna", ObstacleKind.PERSON, "Anna is too close"),
        ("the chair", ObstacleKind.THING, "the chair is too close"),
    ],
)
def test_who_has_no_name_is_not_called_by_a_number(
    around: PeopleMap, who: str, kind: ObstacleKind, said: str
) -> None:
    there = Obstacle(who, (4.2, 3.0), 0.3, seen_at=0.0, kind=kind)
    around.update((there,), lambda height: around._grid, 0.0)
    assert around.take_off_fault((4.0, 3.0), 0.0) == said
