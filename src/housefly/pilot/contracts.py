"""What the pilot is given: its settings, and whoever knows the room and leads the mission."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from typing import Protocol

from housefly.config.airframe import Airframe
from housefly.config.drone import TWIN_ODOMETRY_ERROR
from housefly.geometry import Vec2
from housefly.messages.flight import Event, Order, OrderAnswer
from housefly.messages.obstacles import Obstacle
from housefly.messages.preflight import PreflightCheck
from housefly.messages.sensing import Estimate, Sighting
from housefly.messages.steering import PlanAnswer, Setpoint
from housefly.messages.words import Words
from housefly.pilot.behavior.braking import LAST_HEIGHT
from housefly.pilot.behavior.mission import (
    PEOPLE_SILENCE_MAX,
    MissionState,
    TrackingTask,
    VehicleStatus,
)
from housefly.pilot.behavior.path_progress import TrajectorySetpoint
from housefly.pilot.behavior.steered_landing import BlindPlan
from housefly.pilot.step import PilotParameters


@dataclass(frozen=True, slots=True)
class PilotSettings:
    """What does not change in a flight.

    Attributes:
        parameters: of the compiled step.
        airframe: of the drone.
        body: name of the drone in the tracking system.
        home: the pad [m].
        flight_height: z_ref [m].
        facing_tolerance: the heading is the wanted one when nearer than this [rad].
        drag: of the air on the drone, over its mass [1/s].
        odometry_error: share of a way by which the drone's own odometry may misjudge it.
        guarded: tracking is held against what the drone feels; without it only in negative
            controls.
        sinks_to: lowest height wanted in a steered landing [m].
        drifts_from: the aim of a steered landing allows for a drift from this height on [m]; 0 for
            none.
        people_silence: the sensors that look for people may be silent for so long [s].
    """

    parameters: PilotParameters
    airframe: Airframe
    body: str
    home: Vec2
    flight_height: float
    facing_tolerance: float
    drag: float
    odometry_error: float = TWIN_ODOMETRY_ERROR
    guarded: bool = True
    sinks_to: float = LAST_HEIGHT
    drifts_from: float = 0.0
    people_silence: float = PEOPLE_SILENCE_MAX


class Map(Protocol):
    """Knows the room as it is now."""

    def update(
        self, obstacles: tuple[Obstacle, ...], sightings: tuple[Sighting, ...], now: float
    ) -> list[Words]:
        """Bring the map up to now [s]; return in words which obstacles are refused."""
        ...

    @property
    def in_space(self) -> bool:
        """Whether trajectories in space are flown, and not corners in the plane."""
        ...

    def route(self, start: Vec2, goal: Vec2) -> PlanAnswer:
        """Return the way from a start to a goal [m]."""
        ...

    def clear_floor(self, place: Vec2, height: float, found: Collection[Vec2] = ()) -> Vec2 | None:
        """Return where to land beside a place over furniture or people [m], at a height [m].

        Away from where the sonar found something. None where the place itself is clear and nothing
        was found, or nothing better can be reached.
        """
        ...


class Missions(Protocol):
    """Decides what the drone tracks."""

    @property
    def state(self) -> MissionState:
        """How far the mission has come."""
        ...

    @property
    def task(self) -> TrackingTask:
        """What the drone tracks."""
        ...

    @property
    def answers(self) -> tuple[OrderAnswer, ...]:
        """What became of the orders of the last step that have an id."""
        ...

    @property
    def speed_factor(self) -> float:
        """Share of the cruise speed to fly at near people, 0 to 1."""
        ...

    @property
    def is_yielding(self) -> bool:
        """Whether the drone makes way for somebody: it may be far from where it flies to."""
        ...

    def found_below(self, vehicle: VehicleStatus) -> tuple[Vec2, ...]:
        """Return where the drone's own sensor found something below [m], if it shows some now."""
        ...

    @property
    def blind_landing(self) -> BlindPlan:
        """Why not to land without tracking where the drone is, and what to fly instead."""
        ...

    @property
    def origin_confirmed(self) -> bool:
        """Whether tracking has shown the drone on its pad, or was found to agree with the map."""
        ...

    @property
    def origin_revoked(self) -> bool:
        """Whether tracking was found lying, and has not shown the drone on its pad since."""
        ...

    def preflight(self, vehicle: VehicleStatus) -> tuple[PreflightCheck, ...]:
        """Return what the pre-flight checks find now."""
        ...

    def update(
        self,
        orders: tuple[Order, ...],
        vehicle: VehicleStatus,
        target: TrajectorySetpoint | None,
        facing: bool,
    ) -> list[Event]:
        """Bring the mission up to now and return what people should know."""
        ...


class Maneuver(Protocol):
    """Asked once a step while the pilot holds a place and the drone is seen."""

    def propose(self, now: float, estimate: Estimate) -> Setpoint | None:
        """Return the setpoint to fly now [s], or None to hold the place."""
        ...
