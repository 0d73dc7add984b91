"""A door of 0.8 m: too narrow for the disc around the hull, wide enough for the hull itself."""

from __future__ import annotations

from dataclasses import replace
from math import cos, nan, sin

import numpy as np
import pytest
from space_room import LIMITS

from housefly.config.site import Site, changed
from housefly.geometry import Vec2, Vec3
from housefly.messages.obstacles import Obstacle, ObstacleKind
from housefly.pilot.planning.space import doors
from housefly.pilot.planning.space.any_angle import in_metres, in_voxel_edges, taut
from housefly.pilot.planning.space.clearance import HullCylinder
from housefly.pilot.planning.space.costs import height_wish, narrowness
from housefly.pilot.planning.space.oriented_hull import OrientedHull, oriented_clearances
from housefly.pilot.planning.space.search import CellSearch
from housefly.pilot.planning.space.solid_rows import room_rows
from housefly.pilot.planning.space.space_map import SpaceMap
from housefly.pilot.planning.space.voxels import voxel_map
from housefly.pilot.planning.trajectory.heading import headings
from housefly.pilot.planning.trajectory.timing import TICK
from housefly.pilot.planning.trajectory.trajectory import at_rest, trajectory_along
from housefly.room.grid import build_grid
from housefly.room.model import Room, Shape, Solid

HULL = OrientedHull(0.517 / 2, 0.451 / 2, 0.065)
DOOR = 0.8
TURN_RATE = 0.9


def two_rooms(door: float) -> Room:
    """Return two rooms with a door between them, its middle at this y [m]."""
    spans = ((0.0, door - DOOR / 2), (door + DOOR / 2, 4.0))
    walls = [
        Solid(f"wall {a}", "wall", Shape.BOX, (4.0, (a + b) / 2, 1.35), (0.1, b - a, 2.7))
        for a, b in spans
    ]
    lintel = Solid("lintel", "wall", Shape.BOX, (4.0, door, 2.4), (0.1, DOOR, 0.6))
    return Room("two rooms", (0.0, 0.0, 8.0, 4.0), 2.7, (*walls, lintel), (), (), (1.5, 2.0))


@pytest.mark.parametrize("seed", range(5))
def test_the_hull_goes_through_a_door_with_its_narrow_side(seed: int) -> None:
    random = np.random.default_rng(seed)
    room = two_rooms(float(random.uniform(1.2, 2.8)))
    start = np.array([random.uniform(0.8, 2.5), random.uniform(0.8, 3.2), 1.1])
    goal = np.array([random.uniform(5.5, 7.2), random.uniform(0.8, 3.2), 1.1])
    rows = room_rows(room)
    disc = voxel_map(room, 0.1, HullCylinder(0.343, HULL.half_height), 0.145)
    here, there = (disc.voxel_of((x, y, z)) for x, y, z in (start.tolist(), goal.tolist()))
    assert not CellSearch(disc.free()).path(here, there).cells
    voxels = voxel_map(room, 0.05, HullCylinder(HULL.half_width, HULL.half_height), 0.145)
    free, weights = voxels.free(), narrowness(voxels, 0.35, 4.0) + height_wish(voxels, 1.1, 0.3)
    here, there = (voxels.voxel_of((x, y, z)) for x, y, z in (start.tolist(), goal.tolist()))
    cells = np.array(CellSearch(free, weights).path(here, there).cells) + 0.5
    ends = in_voxel_edges(voxels, np.stack((start, goal)))
    way = taut(free, np.vstack((ends[:1], cells[1:-1], ends[1:])), weights)
    corners = np.array(in_metres(voxels, way))
    slow = LIMITS._replace(narrow_speed=0.4)
    flown = trajectory_along(voxels, free, rows, corners, at_rest(start), slow)
    assert flown is not None and not flown.stops
    ahead = float(np.arctan2(goal[1] - start[1], goal[0] - start[0]))
    yaws = headings(flown.rows, TICK, ahead, nan, TURN_RATE)
    poses = np.hstack((flown.rows[:, :3], yaws[:, None]))
    assert oriented_clearances(rows, poses, HULL, 1.0).min() >= 0.1


@pytest.mark.parametrize("turn", [0.0, 0.3])
def test_the_map_of_this_moment_leads_through_a_door_with_the_headings_that_fit(
    turn: float,
) -> None:
    room = turned(two_rooms(2.0), turn)
    site = changed(Site(), map__planner="space")
    space = SpaceMap(site, room, build_grid(room, site))
    start, goal = at_rest(np.array((*spun((2.0, 2.6), turn), 1.1))), (*spun((6.0, 1.4), turn), 1.1)
    assert space.trajectory(start, goal, 0.0, 0.5) is None
    flight = space.trajectory(start, goal, 0.0, 0.5, yaw=turn + 1.5)
    assert flight is not None and flight.yaws is not None
    assert flight.yaws[0] == pytest.approx(turn + 1.5)
    assert np.abs(np.diff(flight.yaws)).max() <= TURN_RATE * TICK + 1e-9
    poses = np.hstack((flight.rows[:, :3], flight.yaws[:, None]))
    near = oriented_clearances(room_rows(room), poses, HULL, 1.0)
    assert near.min() >= site.map.tracking_bound
    assert np.hypot(*flight.rows[near < 0.16, 3:5].T).max() < 0.475


def test_from_within_somebody_no_door_is_searched_for(monkeypatch: pytest.MonkeyPatch) -> None:
    room = two_rooms(2.0)
    space = SpaceMap(changed(Site(), map__planner="space"), room, build_grid(room, Site()))
    person = Obstacle("visitor", (2.0, 2.6), 0.25, top=1.8, kind=ObstacleKind.PERSON)
    space.update([person], 0.0)
    searches: list[object] = []
    search = doors.CellSearch
    monkeypatch.setattr(doors, "CellSearch", lambda *a: searches.append(a) or search(*a))
    goal = (6.0, 1.4, 1.1)
    assert space.trajectory(at_rest(np.array((2.0, 2.6, 1.1))), goal, 0.0, 0.5, 1.5) is None
    assert not searches
    assert space.trajectory(at_rest(np.array((2.0, 0.9, 1.1))), goal, 0.0, 0.2, 1.5) is not None
    assert searches


def spun(place: Vec2, turn: float) -> Vec2:
    """Return a place turned about the middle of the two rooms [m]."""
    x, y = place[0] - 4.0, place[1] - 2.0
    return 4.0 + x * cos(turn) - y * sin(turn), 2.0 + x * sin(turn) + y * cos(turn)


def turned(room: Room, turn: float) -> Room:
    """Return the two rooms with the wall between them turned."""
    solids = tuple(
        replace(solid, position=(*spun(solid.position[:2], turn), solid.position[2]), yaw=turn)
        for solid in room.solids
    )
    longer = tuple(
        replace(one, size=(one.size[0], one.size[1] + 1.0, one.size[2]), position=_outwards(one))
        if one.name != "lintel"
        else one
        for one in solids
    )
    return replace(room, solids=longer, home=spun(room.home, turn))


def _outwards(wall: Solid) -> Vec3:
    """Return the middle of a wall that has grown by a metre away from the door [m]."""
    side = 1.0 if wall.position[1] > 2.0 else -1.0
    x, y, z = wall.position
    return x - 0.5 * side * sin(wall.yaw), y + 0.5 * side * cos(wall.yaw), z
