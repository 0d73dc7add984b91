"""Joins room, map, obstacles and planner into what behavior asks for; only the pilot uses it."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from math import isinf

import numpy as np

from housefly.config.site import Site
from housefly.geometry import Vec2, distance
from housefly.messages.flight import Order, OrderKind, OrderOutcome
from housefly.messages.obstacles import Obstacle, called, thing_called
from housefly.messages.sensing import Sighting
from housefly.messages.steering import Path, PlanAnswer
from housefly.messages.words import UNSAID, Words
from housefly.numeric import FloatArray
from housefly.pilot.behavior.braking import BESIDE_MAX, BESIDE_SPEED
from housefly.pilot.behavior.mission import STAY, Mission, Refused
from housefly.pilot.behavior.navigator import PathBlock
from housefly.pilot.behavior.path_profile import PathProfile
from housefly.pilot.behavior.trajectory_profile import SpacePath, trajectory_path
from housefly.pilot.planning.furniture import TrackedFurniture
from housefly.pilot.planning.live import distances_for, first_block, live_grid
from housefly.pilot.planning.obstacles import (
    ObstacleMemory,
    is_in_band,
    obstacle_fault,
    obstacle_rows,
)
from housefly.pilot.planning.other_drones import OtherDrones
from housefly.pilot.planning.people import is_walking, may_be_person
from housefly.pilot.planning.people_map import PeopleMap
from housefly.pilot.planning.planner import plan
from housefly.pilot.planning.separation import STEP
from housefly.pilot.planning.space.answer import SpaceAnswer
from housefly.pilot.planning.space.passage import Passage
from housefly.pilot.planning.space.path_look import first_block_in_space, passes_near
from housefly.pilot.planning.space.solid_rows import live_rows
from housefly.pilot.planning.space.space_map import SpaceMap
from housefly.pilot.planning.tracked_bodies import TrackedBodies
from housefly.pilot.planning.trajectory.kinematic_state import TICK, KinematicState
from housefly.pilot.planning.trajectory.time_scale import TimeScale
from housefly.pilot.planning.trajectory.trajectory import at_rest
from housefly.room.grid import OccupancyGrid, extent_of, inflation
from housefly.room.model import Room
from housefly.room.tracked import untracked_grid

ESCAPE_REACH = 1.0
"""A drone in a blocked cell may fly straight to a free cell that is nearer than this [m]."""
PLAN_HORIZON = 1.5
"""New paths keep out of where a moving obstacle may be within this time [s] ..."""
WATCH_HORIZON = 1.0
"""... and a path in use is blocked where one may be within this time [s]."""
MAP_REFRESH_PERIOD = 0.1
"""How often the map of moving and ageing obstacles is made anew when nothing is heard of them [s].
"""
OPENING = 0.2
"""What stood opens a way when it has moved farther than this [m] ..."""
OPENING_TIME = 1.0
"""... and has not been back for so long [s]."""
LOOKED_EVERY = round(STEP / TICK)
"""A motion by hand is looked at at every so many rows."""
WALKERS_AHEAD = 21
"""For so many looks ahead who walks is kept away from."""
NEARER = 0.01
"""Who comes nearer by less than this comes no nearer than to a drone that stays [m]."""
WATCH_SLACK = 0.05
"""A path in use may come this much nearer to people than a new one [m]."""


class RoomNavigator:
    """Places and ways in one room.

    Attributes:
        people: everybody who is known, and how near they come.
        openings: how often something that stood was taken away or moved on.
        sees_people: a sensor of the site sees people.
    """

    def __init__(self, site: Site, room: Room, grid: OccupancyGrid) -> None:
        self._paper = site.mode == "paper"
        self._speed = site.limits.speed
        self._room = room
        self._static = untracked_grid(room, site, grid)
        # Until the first word of tracked furniture it stands where the room model has it.
        self._live: dict[float, OccupancyGrid] = {0.0: grid}
        self._extent = extent_of(grid)
        self._distances = distances_for(inflation(site), site.map.tracking_bound, grid.resolution)
        self._band = (
            site.map.flight_height - site.map.half_band,
            site.map.flight_height + site.map.half_band,
        )
        self._kept = (site.people.comfort_distance, site.people.min_distance)
        self._watched = site.people.min_distance - WATCH_SLACK
        self._furniture = TrackedFurniture(site, room)
        self._bodies = TrackedBodies(site)
        self._drones = OtherDrones(site)
        self._memory = ObstacleMemory()
        self._is_crowded = False
        self._standing: tuple[Obstacle, ...] = ()
        self._corners: tuple[SpacePath, FloatArray] | None = None
        self._refreshed = 0.0
        self._stood: dict[tuple[str, str], tuple[Vec2, float]] = {}
        self.openings = 0
        self._space = SpaceMap(site, room, grid) if site.flies_in_space else None
        self._height = site.map.flight_height
        self.people = PeopleMap(site, room, grid)
        self.sees_people = site.sees_people

    @property
    def in_space(self) -> bool:
        """Whether trajectories in space are flown, and not corners in the plane."""
        return self._space is not None

    @property
    def lost_drones(self) -> tuple[str, ...]:
        """Other drones that were lost sight of in the air; their last places are kept clear."""
        return self._drones.lost

    @property
    def hull_radius(self) -> float:
        """How far the hull reaches from the drone's middle, in the plane [m]; 0 on a grid."""
        return self._space.hull.radius if self._space else 0.0

    def update(
        self, obstacles: tuple[Obstacle, ...], sightings: tuple[Sighting, ...], now: float
    ) -> list[Words]:
        """Bring the map up to now [s]; return in words which obstacles are refused."""
        tracked = (
            *self._furniture.step(sightings, now),
            *self._bodies.step(sightings, now),
            *self._drones.step(sightings, now),
        )
        known = (*obstacles, *tracked)
        faults = [(obstacle, obstacle_fault(obstacle, now, self._extent)) for obstacle in known]
        accepted = [obstacle for obstacle, fault in faults if not fault]
        is_due = now - self._refreshed >= MAP_REFRESH_PERIOD
        if accepted or (self._memory.obstacles and is_due):
            self._refresh(accepted, now)
        return [
            Words("{who}: {why}", who=obstacle.source or Words("somebody"), why=fault)
            for obstacle, fault in faults
            if fault
        ]

    def _refresh(self, accepted: list[Obstacle], now: float) -> None:
        self._memory, self._refreshed = self._memory.updated(accepted, now), now
        known = self._memory.obstacles
        self._is_crowded = any(is_in_band(one, self._band) for one in known)
        # Who walks is judged in time (``passages``).
        self._standing = tuple(one for one in known if not is_walking(one))
        self._live = {}
        if self._space is not None:
            self._space.update(known, now)
            self._note_openings(now)
        self.people.update(known, self._things, now, self._drones.restless)

    def _note_openings(self, now: float) -> None:
        """Count what stood and is gone, or has stood elsewhere for a while."""
        stands = {(one.source, one.id): one.position for one in self._standing}
        stood, self._stood = self._stood, {}
        for name, place in stands.items():
            before, seen_there = stood.get(name, (place, now))
            if distance(before, place) <= OPENING:
                self._stood[name] = before, now
            elif now - seen_there < OPENING_TIME:
                self._stood[name] = before, seen_there
            else:
                self._stood[name] = place, now
                self.openings += 1
        self.openings += len(stood.keys() - stands.keys())

    def _grid(self, comfort: float = 0.0) -> OccupancyGrid:
        """Return the map of now, people grown by a distance [m].

        Made when somebody plans, because most steps of the pilot do not.
        """
        if comfort not in self._live:
            later, _ = obstacle_rows(
                self._memory.obstacles, self._refreshed, PLAN_HORIZON, self._band, comfort
            )
            self._live[comfort] = live_grid(self._static, later, self._distances.reach)
        return self._live[comfort]

    def _things(self, height: float | None) -> OccupancyGrid:
        """Return the map of now without people, at a height [m]; None stands for the usual one."""
        if self._space is not None and height is not None:
            return self._space.layer(height)
        things = [thing for thing in self._memory.obstacles if not may_be_person(thing)]
        rows, _ = obstacle_rows(things, self._refreshed, 0.0, self._band)
        return live_grid(self._static, rows, self._distances.reach)

    def block(self, here: Vec2, path: Path, waypoint: int) -> PathBlock | None:
        """Return what blocks the rest of a path from a place [m] on; None when it is free."""
        if not self._is_crowded:
            return None
        if self._space is not None and isinstance(path, SpacePath):
            return self._block_in_space(self._space, here, path, waypoint)
        soon, names = obstacle_rows(
            self._memory.obstacles, self._refreshed, WATCH_HORIZON, self._band, self._watched
        )
        along, row = first_block(soon, (here, *path.waypoints[waypoint:]), self._distances.tight)
        return None if isinf(along) else PathBlock(along, names[row])

    def _block_in_space(
        self, space: SpaceMap, here: Vec2, path: SpacePath, waypoint: int
    ) -> PathBlock | None:
        known, now = self._standing, self._refreshed
        soon = live_rows(known, now, WATCH_HORIZON, self._watched)
        height = path.heights[max(waypoint - 1, 0)]
        points = np.concatenate((((*here, height),), self._corners_of(path)[waypoint:]))
        tight = self._distances.tight - space.hull.radius
        if not passes_near(soon, points, space.hull, tight):
            return None
        along, row = first_block_in_space(
            soon, live_rows(known, now, 0.0), points, space.hull, tight
        )
        return None if isinf(along) else PathBlock(along, known[row].id)

    def _corners_of(self, path: SpacePath) -> FloatArray:
        """Return the corners of a path in space [m], shape (n, 3); it is looked at again soon."""
        if self._corners is None or self._corners[0] is not path:
            ways = zip(path.waypoints, path.heights, strict=True)
            self._corners = path, np.array([(*place, z) for place, z in ways])
        return self._corners[1]

    def closed(self, rows: FloatArray, now: float) -> Words:
        """Return what closes a short motion that begins where the drone is, in words, or UNSAID.

        The room, what is known to stand in it, and people with their comfort distance; who walks
        counts where the drone would come nearer to them than by staying.

        Args:
            rows: place, velocity and acceleration every ``TICK``, to rest, shape (n, 9).
            now: time [s].
        """
        assert self._space is not None
        looked = np.vstack((rows[:-1:LOOKED_EVERY], rows[-1:]))
        places, speeds = looked[:, :3], np.linalg.norm(looked[:, 3:6], axis=1)
        return self._space.closed_along(places, speeds) or self._closed_by_live(places, now)

    def _closed_by_live(self, places: FloatArray, now: float) -> Words:
        assert self._space is not None
        known, space, hanging = self._standing, self._space, self._height
        soon = live_rows(known, now, WATCH_HORIZON, self._kept[0], hanging)
        standing = live_rows(known, now, 0.0, 0.0, hanging)
        _, row = first_block_in_space(soon, standing, places, space.hull, space.keep)
        if row >= 0:
            return Words("{thing} is near", thing=thing_called(known[row].id))
        ends = np.repeat(places[-1:], max(0, WALKERS_AHEAD - len(places)), axis=0)
        ways = np.concatenate((places, ends))[:, :2]
        met = self.people.separation_along(ways, now)
        if met.closest >= self._kept[0]:
            return UNSAID
        stays = self.people.separation_along(np.repeat(ways[:1], len(ways), axis=0), now)
        is_nearer = met.closest < stays.closest - NEARER
        return Words("{who} comes near", who=called(met.name)) if is_nearer else UNSAID

    def is_passing(self, start: Vec2, goal: Vec2) -> bool:
        """Return whether there is a way once the obstacles of now are gone."""
        if not self._memory.obstacles:
            return False
        if self._space is not None:
            return self._space.is_flown((*goal, self._height))
        return self._way(self._static, start, goal).path is not None

    def mission(self, order: Order) -> Mission | Refused:
        """Return what an order means in this room, or why it means nothing."""
        if order.kind is OrderKind.TAKE_OFF:
            return STAY
        if order.kind is OrderKind.HOME:
            return self.home()
        if order.place:
            return self._at_place(order)
        if order.goal is None:
            return Refused(OrderOutcome.WRONG_VALUE, Words("it names neither a place nor a goal"))
        name = f"({order.goal[0]:.1f}, {order.goal[1]:.1f})"
        return Mission(order.kind, name, order.goal, order.look_at, order.look_s)

    def home(self) -> Mission:
        """Return the mission that comes home and lands with the heading of the pad."""
        return Mission(OrderKind.HOME, "home", self._room.home, yaw=self._room.home_yaw)

    def plan(self, start: Vec2, goal: Vec2) -> PlanAnswer:
        """Return the planner's answer in the way of the mode."""
        return self._plan(self._grid(), start, goal)

    def route(self, start: Vec2, goal: Vec2) -> PlanAnswer:
        """Return the way; a start in a blocked cell is left by the shortest straight line first.

        Where there is room it keeps the comfort distance from people, else the smallest.
        """
        if self._space is not None:
            return self._route_in_space(start, goal)
        if not len(self.people):
            return self._way(self._grid(), start, goal)
        comfortable = self._way(self._grid(self._kept[0]), start, goal)
        if comfortable.path is not None:
            return comfortable
        return self._way(self._grid(self._kept[1]), start, goal)

    def clear_floor(self, place: Vec2, height: float, found: Collection[Vec2] = ()) -> Vec2 | None:
        """Return where to land beside a place over furniture or people [m], at a height [m].

        Away from where the sonar found something. None where the place itself is clear and nothing
        was found, or nothing better can be reached.
        """
        people = self.people
        return people.clear_floor(place, height, self._refreshed, BESIDE_MAX, BESIDE_SPEED, found)

    def way(self, start: KinematicState, goal: Vec2, yaw: float, lead: float = 0.0) -> SpaceAnswer:
        """Return the trajectory in space from a state, at a heading [rad], to rest at a goal.

        It begins so much later [s]. Where there is room it keeps the comfort distance from people,
        else the smallest; who walks is passed in time or flown around, as it arrives first.
        """
        assert self._space is not None
        there, now = (*goal, self._height), self._refreshed
        people = self.people.walking(now + lead)
        if not len(self.people):
            return self._space.in_time(start, there, now, 0.0, yaw, people)
        comfortable = self._space.in_time(start, there, now, self._kept[0], yaw, people)
        if comfortable.trajectory is not None:
            return comfortable
        return self._space.in_time(start, there, now, self._kept[1], yaw, people)

    def passages(
        self, scale: TimeScale, profile: PathProfile, comfort: float, now: float
    ) -> list[Passage]:
        """Return how a trajectory in space gets past people who walk, earliest arrival first.

        Args:
            scale: how far it has been flown.
            profile: of the trajectory.
            comfort: what it keeps from people [m]; 0 where there was nobody when it was planned.
            now: time [s].
        """
        assert self._space is not None
        kept = comfort or self._kept[0]
        return self._space.passages(self.people.walking(now), scale, profile.motion, kept)

    def _route_in_space(self, start: Vec2, goal: Vec2) -> PlanAnswer:
        answer = self.way(at_rest(np.array((*start, self._height))), goal, 0.0)
        if answer.trajectory is None:
            where = answer.suggestion[:2] if answer.suggestion else None
            return PlanAnswer(start, goal, None, answer.reason, where)
        clearance = answer.trajectory.clearance + self.hull_radius
        path = trajectory_path(answer.trajectory.rows, clearance)
        return PlanAnswer(start, goal, path, duration=answer.trajectory.duration)

    def _plan(self, grid: OccupancyGrid, start: Vec2, goal: Vec2) -> PlanAnswer:
        return plan(
            grid, start, goal, self._speed, every_cell=self._paper, shortcut=not self._paper
        )

    def _way(self, grid: OccupancyGrid, start: Vec2, goal: Vec2) -> PlanAnswer:
        answer = self._plan(grid, start, goal)
        if (
            answer.path is not None
            or grid.is_free(grid.cell_of(start))
            or answer.suggestion is None
        ):
            return answer
        free = answer.suggestion
        if distance(start, free) > ESCAPE_REACH:
            return answer
        onward = self._plan(grid, free, goal)
        if onward.path is None:
            return onward
        way = onward.path
        longer = Path((start, *way.waypoints), way.length + distance(start, free), way.clearance)
        return replace(onward, start=start, path=longer, duration=longer.length / self._speed)

    def _at_place(self, order: Order) -> Mission | Refused:
        try:
            place = self._room.place(order.place)
        except KeyError as error:
            return Refused(OrderOutcome.UNKNOWN_PLACE, error.args[0])
        return Mission(
            order.kind, place.name, place.viewpoint, order.look_at or place.look_at, order.look_s
        )
