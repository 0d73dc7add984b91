"""What behavior asks of whoever knows the room: where a place is, and the way there."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from housefly.geometry import Vec2
from housefly.messages import Order, Path, PlanAnswer
from housefly.pilot.behavior.errand import Mission
from housefly.pilot.behavior.tracking import Track


class Follower(Protocol):
    """A path and how far the drone was sent on it; mode default and mode paper have one each."""

    def step(self, position: Vec2, moving: bool, dt: float) -> Track:
        """Go on by dt [s] with the drone at a position [m] and return what to track."""
        ...

    @property
    def goal(self) -> Vec2:
        """The end of the path [m]."""
        ...


@dataclass(frozen=True, slots=True)
class Block:
    """Where a path is blocked.

    Attributes:
        along: how far ahead [m].
        name: of the obstacle.
    """

    along: float
    name: str


class Navigator(Protocol):
    """Knows the room and plans in it."""

    def mission(self, order: Order) -> Mission | str:
        """Return what an order means in this room, or in words why it means nothing."""
        ...

    def home(self) -> Mission:
        """Return the mission that comes home and lands."""
        ...

    def route(self, start: Vec2, goal: Vec2) -> PlanAnswer:
        """Return the way; a start in a blocked cell is left by the shortest straight line first."""
        ...

    def block(self, here: Vec2, path: Path, waypoint: int) -> Block | None:
        """Return what blocks the rest of a path, from a place [m] by the next waypoint to its end;
        None when it is free.
        """
        ...

    def is_passing(self, start: Vec2, goal: Vec2) -> bool:
        """Tell whether there is a way when the obstacles of now are gone."""
        ...

    def follower(self, path: Path, yaw: float) -> Follower:
        """Return a follower of the mode for this path, starting at heading yaw [rad]."""
        ...
