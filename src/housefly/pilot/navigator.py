"""Joins room, map, obstacles and planner into what behavior asks for; only the pilot uses it."""

from __future__ import annotations

from dataclasses import replace
from math import isinf

from housefly.config.site import Site
from housefly.geometry import Vec2, distance
from housefly.messages.flight import Order, OrderKind
from housefly.messages.obstacles import Obstacle
from housefly.messages.sensing import Sighting
from housefly.messages.steering import Path, PlanAnswer
from housefly.pilot.behavior.mission import STAY, Mission, Refused
from housefly.pilot.behavior.navigator import PathBlock
from housefly.pilot.planning.furniture import TrackedFurniture
from housefly.pilot.planning.live import distances_for, first_block, live_grid
from housefly.pilot.planning.obstacles import ObstacleMemory, obstacle_fault, obstacle_rows
from housefly.pilot.planning.people import may_be_person
from housefly.pilot.planning.people_map import PeopleMap
from housefly.pilot.planning.planner import plan
from housefly.pilot.planning.tracked_bodies import TrackedBodies
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
WATCH_SLACK = 0.05
"""A path in use may come this much nearer to people than a new one [m]."""


class RoomNavigator:
    """Places and ways in one room.

    Attributes:
        people: everybody who is known, and how near they come.
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
        self._furniture = TrackedFurniture(site, room)
        self._bodies = TrackedBodies(site)
        self._memory = ObstacleMemory()
        self._soon, self._names = obstacle_rows((), 0.0, 0.0, self._band)
        self._refreshed = 0.0
        self.people = PeopleMap(site, room, grid)
        self.sees_people = site.sees_people

    def update(
        self, obstacles: tuple[Obstacle, ...], sightings: tuple[Sighting, ...], now: float
    ) -> list[str]:
        """Bring the map up to now [s]; return in words which obstacles are refused."""
        tracked = (*self._furniture.step(sightings, now), *self._bodies.step(sightings, now))
        known = (*obstacles, *tracked)
        faults = [(obstacle, obstacle_fault(obstacle, now, self._extent)) for obstacle in known]
        accepted = [obstacle for obstacle, fault in faults if not fault]
        is_due = now - self._refreshed >= MAP_REFRESH_PERIOD
        if accepted or (self._memory.obstacles and is_due):
            self._refresh(accepted, now)
        return [f"{obstacle.source or 'somebody'}: {fault}" for obstacle, fault in faults if fault]

    def _refresh(self, accepted: list[Obstacle], now: float) -> None:
        self._memory, self._refreshed = self._memory.updated(accepted, now), now
        self._soon, self._names = obstacle_rows(
            self._memory.obstacles, now, WATCH_HORIZON, self._band, self._kept[1] - WATCH_SLACK
        )
        self._live = {}
        self.people.update(self._memory.obstacles, self._things, now)

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

    def _things(self) -> OccupancyGrid:
        """Return the map of now without people."""
        things = [thing for thing in self._memory.obstacles if not may_be_person(thing)]
        rows, _ = obstacle_rows(things, self._refreshed, 0.0, self._band)
        return live_grid(self._static, rows, self._distances.reach)

    def block(self, here: Vec2, path: Path, waypoint: int) -> PathBlock | None:
        """Return what blocks the rest of a path from a place [m] on; None when it is free."""
        if not len(self._soon):
            return None
        along, row = first_block(
            self._soon, (here, *path.waypoints[waypoint:]), self._distances.tight
        )
        return None if isinf(along) else PathBlock(along, self._names[row])

    def is_passing(self, start: Vec2, goal: Vec2) -> bool:
        """Return whether there is a way once the obstacles of now are gone."""
        return (
            bool(self._memory.obstacles) and self._way(self._static, start, goal).path is not None
        )

    def mission(self, order: Order) -> Mission | Refused:
        """Return what an order means in this room, or why it means nothing."""
        if order.kind is OrderKind.TAKE_OFF:
            return STAY
        if order.kind is OrderKind.HOME:
            return self.home()
        if order.place:
            return self._at_place(order)
        if order.goal is None:
            return Refused("it names neither a place nor a goal")
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
        if not len(self.people):
            return self._way(self._grid(), start, goal)
        comfortable = self._way(self._grid(self._kept[0]), start, goal)
        if comfortable.path is not None:
            return comfortable
        return self._way(self._grid(self._kept[1]), start, goal)

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
            return Refused(str(error.args[0]))
        return Mission(
            order.kind, place.name, place.viewpoint, order.look_at or place.look_at, order.look_s
        )
