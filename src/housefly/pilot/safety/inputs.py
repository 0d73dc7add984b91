"""What the safety gate is told in one step, and the box that the drone has to stay in."""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite, nan

from housefly.config.airframe import BrakingConstants
from housefly.geometry import Vec2, Vec3
from housefly.messages.flight import Phase
from housefly.messages.sensing import AIRBORNE_STATUSES, DroneFault, DroneStatus, Telemetry
from housefly.messages.steering import AnySetpoint, Reference
from housefly.messages.words import UNSAID, Words
from housefly.pilot.behavior.mission import NO_SILENCE, PeopleSilence
from housefly.pilot.estimation.consistency import NOTHING_KNOWN, TrackingConsistency

CRUISE_PHASES = (Phase.OUTBOUND, Phase.LOOKING, Phase.HOLDING, Phase.RETURNING)
"""Phases in which we say where the drone should be."""


@dataclass(frozen=True, slots=True)
class GateInputs:
    """What is known at one step.

    Attributes:
        now: time [s].
        status: the drone's last word about itself.
        battery: charge, 0 to 1; NaN counts as empty.
        pose_age, telemetry_age: [s]; infinite before the first.
        position: estimated place [m], None before the first sighting.
        stopped: STOP is latched.
        cutting: the motors are to be cut.
        phase: of the mission.
        velocity: estimated, world [m/s].
        yaw: heading [rad]; nan before the first sighting.
        reference: of the last step, None where no trajectory is followed or a maneuver flies.
        flight_height: z_ref [m]; nan while none is wanted.
        height_follows: it moves with a trajectory in space, which the drone can follow.
        flown: the setpoint that flew the drone in the last step; None where it flew itself.
        telemetry: the drone's newest report, None before the first.
        consistency: tracking held against that report.
        late: how much later than planned this step runs [s].
        home_time: how long the way home takes from here [s].
        has_way_home: the planner has a way home from here.
        silence: of the sensors that look for people.
        landing_blocker: why a drone that can hold its place without tracking is not to land there,
            in words; UNSAID to land.
        missing_lean: by how much more a drone whose attitude stands still has to be asked to lean,
            theta and phi [rad]; None where it tells how it leans.
        steers: our setpoint may hold the drone and land it; mode paper leaves that to the drone.
    """

    now: float
    status: DroneStatus
    battery: float
    pose_age: float
    telemetry_age: float
    position: Vec3 | None
    stopped: bool
    cutting: bool
    phase: Phase = Phase.HOLDING
    velocity: Vec3 | None = None
    yaw: float = nan
    reference: Reference | None = None
    flight_height: float = nan
    height_follows: bool = False
    flown: AnySetpoint | None = None
    telemetry: Telemetry | None = None
    consistency: TrackingConsistency = NOTHING_KNOWN
    late: float = 0.0
    home_time: float = 0.0
    has_way_home: bool = True
    silence: PeopleSilence = NO_SILENCE
    landing_blocker: Words = UNSAID
    missing_lean: Vec2 | None = None
    steers: bool = True

    @property
    def airborne(self) -> bool:
        """Whether the propellers carry the drone, by its last word."""
        return self.status in AIRBORNE_STATUSES

    @property
    def cruising(self) -> bool:
        """Whether it flies, by its own word and by ours."""
        return self.status is DroneStatus.FLYING and self.phase in CRUISE_PHASES

    @property
    def faults(self) -> tuple[DroneFault, ...]:
        """The drone's complaints."""
        return self.telemetry.faults if self.telemetry else ()


@dataclass(frozen=True, slots=True)
class Geofence:
    """The box to stay in: x_min, y_min, x_max, y_max, and the ceiling above the floor [m]."""

    bounds: tuple[float, float, float, float]
    ceiling: float

    def outside(self, position: Vec3) -> float:
        """Return how far a point lies outside in the plane [m]; infinite when it is no number."""
        return self._beyond((position[0], position[1]))

    def overshoot(self, position: Vec3, velocity: Vec3, braking: BrakingConstants) -> float:
        """Return how much farther outside the drone will be where it can come to rest [m]."""
        (x, y, z), (vx, vy, vz) = position, velocity
        here, rest = (
            (x, y),
            (x + _stopping_distance(vx, braking), y + _stopping_distance(vy, braking)),
        )
        sideways = self._beyond(rest) - self._beyond(here)
        top = z + _stopping_distance(max(vz, 0.0), braking) - max(self.ceiling, z)
        farther = max(sideways, top)
        return farther if isfinite(farther) else 0.0

    def _beyond(self, point: Vec2) -> float:
        x, y = point
        x_min, y_min, x_max, y_max = self.bounds
        gaps = (x_min - x, x - x_max, y_min - y, y - y_max)
        return max(0.0, *gaps) if x == x and y == y else float("inf")


def _stopping_distance(speed: float, braking: BrakingConstants) -> float:
    way = braking.way_to_rest(abs(speed))
    return way if speed > 0.0 else -way
