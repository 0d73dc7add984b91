"""Where the sonar found something below is remembered, and forgotten when the floor shows."""

from __future__ import annotations

import pytest

from housefly.pilot.behavior.found_below import FORGOTTEN_AFTER, NEAR, STEADY_AFTER, FoundBelow

PLACE = (3.0, 2.0)


def shown(*heights: float, seconds: float = 0.1) -> FoundBelow:
    """Something that showed so long from each of these heights to a drone at rest [m, s]."""
    found, now = FoundBelow(), 0.0
    for z in heights:
        for _ in range(round(seconds / 0.1)):
            found.show((*PLACE, z), now)
            now += 0.1
    return found


def see_floor(found: FoundBelow, position: tuple[float, float, float], seconds: float) -> None:
    for n in range(round(seconds / 0.1) + 1):
        found.look(position, 100.0 + 0.1 * n)


def test_a_place_near_to_where_something_was_found_is_no_place_to_land() -> None:
    found = shown(0.9, 0.85)
    assert found.is_near(PLACE) and found.is_near((3.0 + 0.9 * NEAR, 2.0))
    assert not found.is_near((3.0 + 1.1 * NEAR, 2.0))
    assert list(found) == [PLACE]


@pytest.mark.parametrize(
    "position",
    [
        pytest.param((3.0, 2.0, 1.2), id="higher: a thin thing shows at one height only"),
        pytest.param((3.3, 2.0, 0.85), id="from beside"),
    ],
)
def test_floor_that_shows_from_elsewhere_says_nothing(position: tuple[float, float, float]) -> None:
    found = shown(0.85, seconds=2.0 * STEADY_AFTER)
    see_floor(found, position, 5.0 * FORGOTTEN_AFTER)
    assert found.is_near(PLACE)


def test_floor_that_shows_from_the_same_place_for_a_while_is_believed() -> None:
    found = shown(0.85, seconds=2.0 * STEADY_AFTER)
    see_floor(found, (3.05, 2.0, 0.85), 0.8 * FORGOTTEN_AFTER)
    assert found.is_near(PLACE)
    see_floor(found, (3.05, 2.0, 0.85), 1.2 * FORGOTTEN_AFTER)
    assert not found.is_near(PLACE)


def test_what_a_drone_saw_in_passing_may_stand_beside_it_where_it_rests() -> None:
    found = FoundBelow()
    for n in range(15):
        found.show((2.9 + 0.008 * n, 2.0, 1.3), 0.1 * n)
    see_floor(found, (3.01, 2.0, 1.3), 3.0 * FORGOTTEN_AFTER)
    assert found.is_near((3.01, 2.0))


def test_what_shows_all_the_way_up_may_be_gone_from_up_there() -> None:
    found = shown(0.8, 0.9, 1.0, 1.1, 1.2, seconds=0.4)
    see_floor(found, (*PLACE, 1.2), 1.5 * FORGOTTEN_AFTER)
    assert not found.is_near(PLACE)


def test_somebody_who_lies_is_found_in_more_than_one_place() -> None:
    found = FoundBelow()
    for n in range(12):
        found.show((3.0 + 0.1 * n, 2.0, 0.85), 0.1 * n)
    assert found.is_near((4.4, 2.0)) and found.is_near((2.5, 2.0))


def test_a_drone_that_stands_begins_anew() -> None:
    found = shown(0.9)
    found.forget()
    assert not found.is_near(PLACE) and not list(found)
