"""Other drones as a pilot sees them: kept away from as people are, and who has the right of way."""

from __future__ import annotations

from math import nan

import pytest

from housefly.config.site import Site, changed
from housefly.geometry import Vec2, Vec3
from housefly.messages import Obstacle, ObstacleKind, Pose, Sighting
from housefly.pilot.navigator import RoomNavigator
from housefly.pilot.planning.other_drones import (
    HEED_DISTANCE,
    LOST_AFTER,
    LOST_KEPT,
    LOST_MARGIN,
    PASSING_MARGIN,
    SETTLED_TIME,
    OtherDrones,
)
from housefly.sites.loaded_site import open_site

FLEET = changed(
    Site(),
    hub__enabled=False,
    drones=(
        {"name": "anna", "body": "a"},
        {"name": "bert", "address": "127.0.0.2", "pad": (8.05, 1.25, 0.0), "hull_length": 0.4},
    ),
)
RADIUS = FLEET.all_drones[1].reach
ANNA = (5.0, 2.0)


def anna() -> OtherDrones:
    """Return what anna, who has the right of way, knows of bert."""
    return OtherDrones(FLEET.for_drone("anna"))


def bert() -> OtherDrones:
    """Return what bert, who gives way, knows of anna."""
    return OtherDrones(FLEET.for_drone("bert"))


def flown(
    others: OtherDrones,
    own: str,
    other: str,
    start: Vec2,
    velocity: Vec2 = (0.0, 0.0),
    height: float = 1.1,
    seconds: float = 1.0,
    at: float = 0.0,
) -> Obstacle:
    """Show both drones for some time, ours at ANNA; return the last that was told of the other."""
    last = None
    for n in range(round(100 * seconds)):
        now = at + 0.01 * n
        place = (start[0] + velocity[0] * 0.01 * n, start[1] + velocity[1] * 0.01 * n, height)
        told = others.step((sighting(own, (*ANNA, 1.1), now), sighting(other, place, now)), now)
        last = told[-1] if told else last
    assert last is not None
    return last


def sighting(body: str, place: Vec3, at: float) -> Sighting:
    return Sighting(body, Pose(place), at, at)


def test_who_gives_way_keeps_a_persons_distance_from_one_that_flies_at_its_velocity() -> None:
    told = flown(bert(), "bert", "a", (2.0, 2.0), (0.5, 0.1))
    assert (told.id, told.kind) == ("anna", ObstacleKind.DRONE)
    assert told.velocity == pytest.approx((0.5, 0.1), abs=0.02)
    hovering = flown(bert(), "bert", "a", (2.0, 2.0))
    assert hovering.kind is ObstacleKind.DRONE and hovering.velocity == (0.0, 0.0)


def test_to_who_has_the_right_of_way_the_other_is_a_thing_once_it_is_near_or_hovers() -> None:
    near = flown(anna(), "a", "bert", (5.0, 4.5), (0.5, 0.0))
    assert (near.id, near.kind, near.velocity) == ("bert", ObstacleKind.THING, (0.0, 0.0))
    assert near.radius == pytest.approx(RADIUS + PASSING_MARGIN)
    assert near.confidence == 1.0
    far = (ANNA[0], ANNA[1] + HEED_DISTANCE + 0.1)
    assert flown(anna(), "a", "bert", far, (0.5, 0.0)).confidence == 0.0
    assert flown(anna(), "a", "bert", far).confidence == 1.0


def test_right_of_way_is_nothing_against_one_that_flies_at_us_for_a_while() -> None:
    others = anna()
    told = flown(others, "a", "bert", (7.0, 2.0), (-0.8, 0.0))
    assert told.kind is ObstacleKind.DRONE
    assert told.velocity == pytest.approx((-0.8, 0.0), abs=0.05)
    hovers = flown(others, "a", "bert", (6.2, 2.0), at=1.0, seconds=1.5)
    assert hovers.kind is ObstacleKind.DRONE
    assert flown(others, "a", "bert", (6.2, 2.0), at=2.5, seconds=3.0).kind is ObstacleKind.THING
    assert flown(anna(), "a", "bert", (6.2, 2.0), (0.8, 0.0)).kind is ObstacleKind.THING


def test_nobody_has_the_right_of_way_over_one_that_takes_off_or_lands() -> None:
    assert flown(anna(), "a", "bert", (6.2, 2.0), height=0.5).kind is ObstacleKind.DRONE
    assert flown(anna(), "a", "bert", (6.2, 2.0), height=1.0).kind is ObstacleKind.THING


@pytest.mark.parametrize(("others", "own", "other"), [(anna, "a", "bert"), (bert, "bert", "a")])
def test_one_that_stands_is_a_low_thing_and_no_floor(others, own: str, other: str) -> None:
    told = flown(others(), own, other, (2.0, 2.0), height=0.06)
    assert told.kind is ObstacleKind.THING and told.top < 0.5
    assert told.radius < RADIUS + 0.1


@pytest.mark.parametrize(("others", "own", "other"), [(anna, "a", "bert"), (bert, "bert", "a")])
def test_the_last_place_of_one_lost_in_the_air_is_kept_clear_for_a_while(
    others, own: str, other: str
) -> None:
    known = others()
    flown(known, own, other, (2.0, 2.0), (0.4, 0.0))
    assert known.lost == ()

    def told(now: float) -> tuple[Obstacle, ...]:
        return known.step((sighting(own, (*ANNA, 1.1), now),), now)

    told(1.0 + LOST_AFTER)
    (kept,) = told(1.3 + LOST_AFTER)
    assert known.lost == (kept.id,)
    assert kept.kind is ObstacleKind.THING and kept.seen_at == pytest.approx(1.3 + LOST_AFTER)
    assert kept.position == pytest.approx((2.4, 2.0), abs=0.02)
    hull = next(drone.reach for drone in FLEET.all_drones if drone.name == kept.id)
    assert kept.radius == pytest.approx(hull + LOST_MARGIN)
    assert told(LOST_KEPT)
    assert told(LOST_KEPT + 1.1) == () and known.lost == ()


def test_without_tracking_of_ourselves_nobody_else_is_lost() -> None:
    known = bert()
    flown(known, "bert", "a", (2.0, 2.0))
    assert known.step((), 5.0)
    assert known.lost == ()


def test_nonsense_is_not_believed() -> None:
    known = bert()
    assert known.step((sighting("a", (nan, 0.0, 1.0), 0.0),), 0.0) == ()
    assert known.step((sighting("a", (1.0, 0.0, 1.0), 9.0),), 0.0) == ()


def test_a_site_with_one_drone_knows_no_other() -> None:
    known = OtherDrones(Site())
    assert known.bodies == frozenset()
    assert known.step((sighting("bert", (1.0, 0.0, 1.0), 0.0),), 0.0) == ()


def test_the_pad_of_another_is_no_floor_and_its_body_is_told_once() -> None:
    loaded = open_site(FLEET.for_drone("bert"))
    navigator = RoomNavigator(loaded.site, loaded.room, loaded.grid)
    pad = (10.55, 1.25)
    assert "the pad of anna" in navigator.people.ground_fault((pad[0] + 0.4, pad[1]))
    assert not navigator.people.ground_fault(loaded.room.home)
    spot = navigator.people.landing_spot((pad[0] - 0.4, pad[1]), 0.0)
    assert spot is not None and not navigator.people.ground_fault(spot)
    navigator.update((), (sighting("a", (9.0, 1.25, 1.1), 0.0),), 0.0)
    assert navigator.people.separation((8.05, 1.25), (0.0, 0.0), 0.0, 0.0).name == "anna"
    assert len(navigator.people) == 1


def take_off_faults(navigator: RoomNavigator, ways: list[tuple[Vec3, Vec3, float]]) -> list[str]:
    """Show anna on ways that she flies one after the other: from, to, for so long [s].

    Return what forbids a take-off from the pad of bert at the end of each.
    """
    now, found = 0.0, []
    pad = (8.05, 1.25)
    for start, end, seconds in ways:
        steps = round(seconds / 0.02)
        for n in range(1, steps + 1):
            share, now = n / steps, now + 0.02
            x, y, z = (a + share * (b - a) for a, b in zip(start, end, strict=True))
            seen = (sighting("a", (x, y, z), now), sighting("bert", (*pad, 0.05), now))
            navigator.update((), seen, now)
        found.append(str(navigator.people.take_off_fault(pad, now)))
    return found


def test_a_take_off_waits_for_one_that_may_set_off_this_way_at_any_moment() -> None:
    loaded = open_site(FLEET.for_drone("bert"))
    navigator = RoomNavigator(loaded.site, loaded.room, loaded.grid)
    pad, up, away = (10.55, 1.25, 0.05), (10.55, 1.25, 1.1), (10.2, 4.0, 1.1)
    stands, rises, hovers, stays, leaves, stops, stays_there, comes = take_off_faults(
        navigator,
        [
            (pad, pad, 1.0),
            (pad, up, 2.6),
            (up, up, 2.0),
            (up, up, SETTLED_TIME + 1.0),
            (up, away, 5.6),
            (away, away, 2.0),
            (away, away, SETTLED_TIME),
            (away, up, 5.6),
        ],
    )
    assert stands == "" and "anna is near" in rises and "anna is near" in hovers
    assert stays == "", "one that hovers for long is not waited for"
    assert leaves == "", "nor one that flies elsewhere"
    assert "anna is near" in stops and stays_there == "" and comes == ""
    far = (3.0, 4.0, 1.1)
    assert take_off_faults(navigator, [(pad, far, 20.0), (far, far, 1.0)])[1] == ""
