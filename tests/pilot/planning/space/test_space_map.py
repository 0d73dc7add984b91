"""Trajectories of B-sen's map of this moment: asked for as the pilot asks."""

from __future__ import annotations

import re
from functools import cache
from math import nan, tan
from pathlib import Path

import numpy as np
import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st

import housefly
from housefly.config.site import Site, changed, site_from_file
from housefly.geometry import Vec3
from housefly.messages.obstacles import Obstacle, ObstacleKind
from housefly.numeric import FloatArray
from housefly.pilot.behavior.braking import REFERENCE_BRAKING
from housefly.pilot.planning.people import people_at, speed_share
from housefly.pilot.planning.space.clearance import HullCylinder, hull_clearances
from housefly.pilot.planning.space.escape import escape_mask
from housefly.pilot.planning.space.solid_rows import filled_rows, room_rows
from housefly.pilot.planning.space.space_map import BRAKING, SpaceMap, motion_limits
from housefly.pilot.planning.trajectory.time_scale import (
    TRAJECTORY_START,
    motion_at,
    scale_advanced,
)
from housefly.pilot.planning.trajectory.timing import TICK, KinematicState
from housefly.pilot.planning.trajectory.trajectory import Trajectory, at_rest
from housefly.room.bsen import bsen
from housefly.room.grid import build_grid
from housefly.room.model import Room, Shape, Solid

HOME, KITCHEN, ENTRANCE = (10.55, 1.25, 1.1), (9.05, 4.25, 1.1), (3.05, 4.25, 1.1)
MORE = settings(max_examples=12, deadline=None, phases=[Phase.explicit, Phase.generate])


@cache
def bsen_site() -> Site:
    """Return the site of B-sen with the planner in space at 1 m/s."""
    file = Path(housefly.__file__).parent / "sites" / "bsen.toml"
    return changed(site_from_file(file), map__planner="space", limits__speed=1.0)


@cache
def made(site: Site) -> SpaceMap:
    """Return the map of B-sen for a site."""
    return SpaceMap(site, bsen(), build_grid(bsen(), site))


def fresh(*obstacles: Obstacle) -> SpaceMap:
    """Return B-sen's map with obstacles in it at time 0."""
    space = made(bsen_site())
    space.update(obstacles, 0.0)
    return space


def somebody(x: float, y: float, vx: float = 0.0, vy: float = 0.0) -> Obstacle:
    """Return a person."""
    return Obstacle("somebody", (x, y), 0.25, velocity=(vx, vy), kind=ObstacleKind.PERSON)


def bsen_room_bounds() -> tuple[float, float, float, float]:
    """Return x_min, y_min, x_max, y_max [m]."""
    return bsen().bounds


def flown(space: SpaceMap, start: Vec3, goal: Vec3, comfort: float = 0.5) -> Trajectory:
    """Return the trajectory between two places at rest."""
    answer = space.answer(at_rest(np.array(start)), goal, 0.0, comfort)
    assert answer.trajectory is not None, answer.reason
    return answer.trajectory


@cache
def places() -> FloatArray:
    """Return middles of free voxels, shape (n, 3)."""
    voxels = made(bsen_site())._static
    steps = np.argwhere(voxels.free()).astype(np.float64) + 0.5
    middles: FloatArray = steps * voxels.resolution + np.array(voxels.origin)
    return middles


@MORE
@given(st.integers(0, 2**31), st.sampled_from([0.5, 1.0]))
def test_a_trajectory_begins_as_it_must_ends_at_rest_and_keeps_off_everything(
    seed: int, comfort: float
) -> None:
    random = np.random.default_rng(seed)
    chair = Obstacle("chair", (float(random.uniform(5, 13)), 4.2), 0.2, kind=ObstacleKind.THING)
    space = fresh(chair, somebody(float(random.uniform(5, 13)), 1.2))
    start, goal = places()[random.integers(len(places()), size=2)]
    state = at_rest(start)
    for _ in range(2):
        answer = space.answer(state, (goal[0], goal[1], goal[2]), 0.0, comfort)
        flight = answer.trajectory
        if flight is None:
            assert answer.reason
            return
        assert np.allclose(flight.rows[0, :3], state.place, atol=1e-3)
        assert np.allclose(flight.rows[0, 3:6], state.velocity, atol=0.02)
        assert np.linalg.norm(flight.rows[-1, :3] - goal) < 0.088
        assert np.linalg.norm(flight.rows[-1, 3:6]) < 1e-3
        moment = space._moment(comfort)
        places_flown = np.ascontiguousarray(flight.rows[:, :3])
        near = hull_clearances(moment.rows, places_flown, space.hull, 1.0)
        if moment.clearance(state.place) >= space.keep and not flight.stops:
            assert near.min() >= space.keep - 0.025
        # And once more, from the middle of the flight, as it moves there.
        row = flight.rows[int(random.integers(len(flight.rows)))]
        state = KinematicState(row[:3].copy(), row[3:6].copy(), row[6:9].copy())


def test_who_is_where_it_wants_to_be_stays() -> None:
    flight = flown(fresh(), HOME, HOME)
    assert flight.rows.shape == (2, 9)
    assert (flight.rows[:, 3:] == 0.0).all()


def test_a_start_at_a_crawl_is_answered_and_not_for_days() -> None:
    crawl = KinematicState(np.array(HOME), np.array([1e-4, 0.0, 0.0]), np.array([0.3, 1.2, 0.0]))
    flight = fresh().trajectory(crawl, KITCHEN, 0.0, 0.5)
    assert flight is None or flight.duration < 600.0


@pytest.mark.parametrize(
    ("start", "goal", "words"),
    [
        (HOME, (5.7, 1.5, 1.1), r"the goal \(5.70, 1.50, 1.10\) m lies in a no-fly area"),
        (HOME, (3.05, 4.25, 2.5), "the goal .* lies in a no-fly area"),
        (HOME, (30.0, 0.0, 1.0), "the goal .* lies outside the map"),
        (HOME, (7.0, 5.4, 1.1), "the goal .* too close to an obstacle: .* which keeps 0.15 m"),
        ((30.0, 0.0, 1.0), HOME, "the start .* lies outside the map"),
    ],
)
def test_why_there_is_no_way_is_said_in_words(start: Vec3, goal: Vec3, words: str) -> None:
    space = fresh()
    answer = space.answer(at_rest(np.array(start)), goal, 0.0, 0.5)
    assert answer.trajectory is None
    assert re.search(words, answer.reason), answer.reason
    assert answer.suggestion is not None
    assert space._moment(0.5).is_free(np.array(answer.suggestion))


def test_a_closed_corridor_is_said_to_be_and_where_one_could_go() -> None:
    wall = Obstacle("wall", (5.0, 4.2), size=(0.2, 1.8), kind=ObstacleKind.THING)
    space = fresh(wall)
    answer = space.answer(at_rest(np.array(HOME)), ENTRANCE, 0.0, 0.5)
    assert "there is no free way from" in answer.reason
    assert answer.suggestion is not None and answer.suggestion[0] > 5.0


@pytest.mark.parametrize("person", [somebody(8.05, 3.5), somebody(8.05, 3.9)])
def test_a_drone_too_close_to_somebody_leaves_and_comes_no_closer(person: Obstacle) -> None:
    flight = flown(fresh(person), (8.05, 4.3, 1.1), ENTRANCE)
    apart = np.linalg.norm(flight.rows[:, :2] - np.array(person.position), axis=1)
    assert apart.min() >= apart[0] - 0.03
    is_close = apart < 0.25 + 0.343 + 0.5
    travelled = np.linalg.norm(flight.rows[:, :3] - flight.rows[0, :3], axis=1)
    assert travelled[is_close].max() < 1.0
    assert not is_close[is_close.argmin() :].any()


def test_nothing_is_flown_under_that_stands_and_nobody_is_flown_over() -> None:
    """The hull is 0.13 m high: it would fit under a desk and between the boards of a shelf."""
    space = fresh()
    voxels = space._static
    for x, y, z in ((11.8, 5.75, 0.45), (11.5, 4.2, 0.75), (7.5, 0.65, 0.75), (9.0, 5.8, 1.2)):
        assert not voxels.free()[voxels.voxel_of((x, y, z))]
    standing = fresh(somebody(9.05, 4.25))._moment(0.5)
    column = standing.voxels.voxel_of(KITCHEN)[:2]
    assert not standing.free[column].any()
    table = Obstacle("table", (8.0, 4.25), 0.3, top=0.7, kind=ObstacleKind.THING)
    over = fresh(table)._moment(0.5)
    heights = over.free[over.voxels.voxel_of((8.0, 4.25, 1.1))[:2]]
    assert heights.any() and not heights[: over.voxels.voxel_of((0, 0, 0.75))[2]].any()


def test_the_air_under_a_table_is_closed_and_under_a_lamp_and_a_lintel_it_is_not() -> None:
    def hung(thing: str, bottom: float, top: float) -> tuple[float, float]:
        size = (2.0, 2.0, top - bottom)
        solid = Solid(thing, thing, Shape.BOX, (2.0, 2.0, (bottom + top) / 2), size)
        room = Room("one", (0.0, 0.0, 4.0, 4.0), 2.7, (solid,), (), (), (0.5, 0.5))
        below, hull = np.array([[2.0, 2.0, 0.5]]), HullCylinder(0.343, 0.065)
        exact, full = (
            float(hull_clearances(rows, below, hull, 1.0)[0])
            for rows in (room_rows(room), filled_rows(room, 1.1))
        )
        return exact, full

    assert hung("table", 0.9, 0.95) == (pytest.approx(0.335), 0.0)
    for thing, bottom in (("lamp", 1.2), ("wall", 0.9)):
        exact, full = hung(thing, bottom, 2.0)
        assert exact == full > 0.3


def test_the_way_out_never_leads_nearer_to_somebody() -> None:
    space, here = fresh(somebody(8.05, 3.5)), np.array((8.05, 4.3, 1.1))
    moment = space._moment(0.5)
    opened = escape_mask(space._static, moment.free, space._open_air, here, moment.standing)
    new = np.argwhere(opened & ~moment.free)
    middles = np.array(moment.voxels.origin) + (new + 0.5) * moment.voxels.resolution
    apart = np.hypot(middles[:, 0] - 8.05, middles[:, 1] - 3.5)
    assert len(new) > 50
    assert apart.min() >= 0.8 - 0.08


def test_ways_go_round_the_air_over_furniture_where_that_costs_little() -> None:
    """A drone that loses its link lands by itself where it is."""
    site = changed(bsen_site(), map__virtual_obstacles=())
    space = made(site)
    space.update((), 0.0)
    flight = flown(space, (8.2, 2.5, 1.1), (10.5, 4.2, 1.1))
    bed = (np.abs(flight.rows[:, 0] - 10.35) < 0.97) & (np.abs(flight.rows[:, 1] - 2.7) < 0.41)
    assert not bed.any()
    over, beside = (space._static.voxel_of(place) for place in ((10.35, 2.7, 1.1), KITCHEN))
    assert space._dear[over] >= space._dear[beside] + 0.9


def test_volumes_of_the_site_close_and_slow_the_air() -> None:
    square = [[6.0, 3.4], [8.0, 3.4], [8.0, 5.0], [6.0, 5.0]]
    low = {"kind": "keep_out", "polygon": square, "top": 1.3}
    slow = {"kind": "slow", "polygon": square, "speed": 0.3}
    for volume, check in ((low, "over"), (slow, "slow")):
        space = made(changed(bsen_site(), volumes=(volume,)))
        space.update((), 0.0)
        rows = flown(space, (9.05, 4.25, 1.1), (5.3, 4.25, 1.1)).rows
        inside = (rows[:, 0] > 6.0) & (rows[:, 0] < 8.0) & (rows[:, 1] > 3.4) & (rows[:, 1] < 5.0)
        speeds = np.linalg.norm(rows[:, 3:6], axis=1)
        if check == "over":
            assert (rows[inside, 2] >= 1.3 - 0.01).all()
        else:
            assert inside.any() and speeds[inside].max() <= 0.32 and speeds.max() > 0.6


def test_people_who_walk_are_passed_in_time_where_that_is_earlier() -> None:
    crossing = somebody(7.5, 5.0, 0.0, -1.0)
    space = fresh(crossing)
    start = at_rest(np.array((9.5, 4.25, 1.1)))
    assert space.trajectory(start, ENTRANCE, 0.0, 0.5) is None
    people = people_at((crossing,), 0.0)
    way = space.in_time(start, ENTRANCE, 0.0, 0.5, nan, people)
    trajectory, passage = way.trajectory, way.passage
    assert trajectory is not None and passage is not None
    assert way.arrival == passage.arrival < 12.0 and way.comfort == 0.5
    scale, now, nearest, config = TRAJECTORY_START, 0.0, 9.0, bsen_site().people
    while scale.time < trajectory.duration and now < 20.0:
        here = motion_at(scale, trajectory.rows, TICK)
        apart = np.hypot(here.x - 7.5, here.y - (5.0 - now)) - 0.25 - 0.343
        nearest = min(nearest, apart) if now < 3.5 else nearest
        share = speed_share(apart, config.slow_distance, config.comfort_distance)
        wanted = 0.0 if now < passage.wait else min(passage.rate, share)
        scale, now = scale_advanced(scale, trajectory.rows, TICK, wanted, 1.0, TICK), now + TICK
    assert nearest >= 0.5 - 0.01
    assert now == pytest.approx(way.arrival, abs=1.5)


def test_the_layer_at_a_height_is_open_over_the_table_and_closed_at_its_height() -> None:
    thing = Obstacle("box", (6.0, 4.2), 0.2, top=1.0, kind=ObstacleKind.THING)
    space = fresh(thing, somebody(8.0, 4.2))
    high, low = space.layer(1.6), space.layer(1.0)
    for grid, is_open in ((high, True), (low, False)):
        assert (grid.clearance_at((6.0, 4.2)) > space.hull.radius + 0.2) == is_open
        assert grid.clearance_at((8.0, 4.2)) > space.hull.radius + 0.2  # without people
    assert high.is_free(high.cell_of((6.0, 4.2))) and not low.is_free(low.cell_of((6.0, 4.2)))
    assert space.layer(0.05).cells.any() and space.layer(9.0).shape == high.shape


def test_what_people_close_now_is_flown_when_they_are_gone_and_a_wall_never() -> None:
    space = fresh(somebody(*ENTRANCE[:2]))
    assert space.is_flown(ENTRANCE) and not space.is_flown((-3.0, 1.0, 1.1))
    x, y, _, _ = bsen_room_bounds()
    assert not space.is_flown((x + 0.1, y + 0.1, 1.1))


def test_people_who_walk_want_more_room_before_than_behind_them() -> None:
    space = fresh(somebody(8.0, 4.2, 0.5, 0.0))
    moment = space._moment(1.0)
    before = moment.clearance(np.array((10.6, 4.2, 1.1)))
    behind = moment.clearance(np.array((8.0 - 1.25, 4.2, 1.1)))
    assert behind == pytest.approx(1.25 - 0.25 - 0.343 - 0.6, abs=0.01)
    assert before == pytest.approx(2.6 - 0.75 - 0.25 - 0.343 - 1.0, abs=0.01)


def test_no_exact_solid_is_lost_in_the_map_of_full_furniture() -> None:
    space = fresh()
    some = places()[::500]
    exact = hull_clearances(room_rows(bsen()), some, space.hull, 1.0)
    assert (hull_clearances(space._solids, some, space.hull, 1.0) <= exact + 1e-9).all()


def test_a_trajectory_takes_no_more_tilt_than_the_drone_is_given() -> None:
    assert motion_limits(Site()).acceleration == 1.6
    gentle = motion_limits(changed(Site(), limits__tilt_max=0.1))
    assert gentle.acceleration == pytest.approx(9.80665 * tan(0.1))


def test_ways_past_people_count_on_the_braking_that_is_flown() -> None:
    assert BRAKING == REFERENCE_BRAKING  # planning may not know behavior
