"""What behavior asks of whoever knows the room: where a place is, and the way there."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from housefly.geometry import Vec2
from housefly.messages.flight import Order
from housefly.messages.obstacles import Obstacle
from housefly.messages.sensing import Sighting
from housefly.messages.steering import Path, PlanAnswer
from housefly.messages.words import Words
from housefly.numeric import FloatArray
from housefly.pilot.behavior.mission import Mission, Refused
from housefly.pilot.behavior.path_profile import PathProfile
from housefly.pilot.planning.people_map import PeopleMap
from housefly.pilot.planning.space.answer import SpaceAnswer
from housefly.pilot.planning.space.passage import Passage
from housefly.pilot.planning.trajectory.kinematic_state import KinematicState
from housefly.pilot.planning.trajectory.time_scale import TimeScale


@dataclass(frozen=True, slots=True)
class PathBlock:
    """Where a path is blocked.

    Attributes:
        along: how far ahead [m].
        name: of the obstacle.
    """

    along: float
    name: str


class Navigator(Protocol):
    """Knows the room and plans in it."""

    @property
    def people(self) -> PeopleMap:
        """Everybody who is known, and how near they come."""
        ...

    @property
    def openings(self) -> int:
        """How often something that stood was taken away or moved on."""
        ...

    @property
    def sees_people(self) -> bool:
        """Whether a sensor of the site sees people."""
        ...

    @property
    def lost_drones(self) -> tuple[str, ...]:
        """Other drones that were lost sight of in the air; their last places are kept clear."""
        ...

    def update(
        self, obstacles: tuple[Obstacle, ...], sightings: tuple[Sighting, ...], now: float
    ) -> list[Words]:
        """Bring the map up to now [s]; return in words which obstacles are refused."""
        ...

    def mission(self, order: Order) -> Mission | Refused:
        """Return what an order means in this room, or why it means nothing."""
        ...

    def home(self) -> Mission:
        """Return the mission that comes home and lands."""
        ...

    def route(self, start: Vec2, goal: Vec2) -> PlanAnswer:
        """Return the way; a start in a blocked cell is left by the shortest straight line first."""
        ...

    @property
    def in_space(self) -> bool:
        """Whether trajectories in space are flown, and not corners in the plane."""
        ...

    @property
    def hull_radius(self) -> float:
        """How far the hull reaches from the drone's middle, in the plane [m]."""
        ...

    def way(self, start: KinematicState, goal: Vec2, yaw: float, lead: float = 0.0) -> SpaceAnswer:
        """Return the trajectory in space from a state, at a heading [rad], to rest at a goal.

        It begins so much later [s].
        """
        ...

    def passages(
        self, scale: TimeScale, profile: PathProfile, comfort: float, now: float
    ) -> list[Passage]:
        """Return how a trajectory in space gets past people who walk, earliest arrival first."""
        ...

    def block(self, here: Vec2, path: Path, waypoint: int) -> PathBlock | None:
        """Return what blocks the rest of a path from a place [m] on; None when it is free."""
        ...

    def closed(self, rows: FloatArray, now: float) -> Words:
        """Return what closes a short motion that begins where the drone is, in words, or ""."""
        ...

    def is_passing(self, start: Vec2, goal: Vec2) -> bool:
        """Return whether there is a way once the obstacles of now are gone."""
        ...
