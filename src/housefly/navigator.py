"""Joins room, map and planner into what behavior asks for; only the pilot uses it."""

from __future__ import annotations

from dataclasses import replace

from housefly.behavior.cells import CellFollower
from housefly.behavior.errand import STAY, Mission
from housefly.behavior.navigator import Follower
from housefly.behavior.tracking import PathFollower
from housefly.config import Site
from housefly.geometry import Vec2, distance
from housefly.messages import Order, OrderKind, Path, PlanAnswer
from housefly.planning.planner import plan
from housefly.room.grid import OccupancyGrid
from housefly.room.model import Room

ESCAPE_REACH = 1.0
"""A drone in a blocked cell may fly straight to a free cell that is nearer than this [m]."""


class RoomNavigator:
    """Places and ways in one room."""

    def __init__(self, site: Site, room: Room, grid: OccupancyGrid) -> None:
        self._paper = site.mode == "paper"
        self._speed = site.limits.speed
        self._room = room
        self._grid = grid

    def mission(self, order: Order) -> Mission | str:
        """Return what an order means in this room, or in words why it means nothing."""
        if order.kind is OrderKind.TAKE_OFF:
            return STAY
        if order.kind is OrderKind.HOME:
            return self.home()
        if order.place:
            return self._at_place(order)
        if order.goal is None:
            return "it names neither a place nor a goal"
        name = f"({order.goal[0]:.1f}, {order.goal[1]:.1f})"
        return Mission(order.kind, name, order.goal, order.look_at, order.look_s)

    def home(self) -> Mission:
        """Return the mission that comes home and lands with the heading of the pad."""
        return Mission(OrderKind.HOME, "home", self._room.home, yaw=self._room.home_yaw)

    def plan(self, start: Vec2, goal: Vec2) -> PlanAnswer:
        """Return the planner's answer in the way of the mode."""
        return plan(self._grid, start, goal, self._speed, every_cell=self._paper, shortcut=not self._paper)

    def route(self, start: Vec2, goal: Vec2) -> PlanAnswer:
        """Return the way; a start in a blocked cell is left by the shortest straight line first."""
        answer = self.plan(start, goal)
        if answer.path is not None or self._grid.is_free(self._grid.cell_of(start)) or answer.suggestion is None:
            return answer
        free = answer.suggestion
        if distance(start, free) > ESCAPE_REACH:
            return answer
        onward = self.plan(free, goal)
        if onward.path is None:
            return onward
        way = onward.path
        longer = Path((start, *way.waypoints), way.length + distance(start, free), way.clearance)
        return replace(onward, start=start, path=longer, duration=longer.length / self._speed)

    def follower(self, path: Path, yaw: float) -> Follower:
        """Return a follower of the mode for this path, starting at heading yaw [rad]."""
        return CellFollower(path, yaw) if self._paper else PathFollower(path, self._speed)

    def _at_place(self, order: Order) -> Mission | str:
        try:
            place = self._room.place(order.place)
        except KeyError as error:
            return str(error.args[0])
        return Mission(order.kind, place.name, place.viewpoint, order.look_at or place.look_at, order.look_s)
