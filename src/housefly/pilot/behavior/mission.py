"""The values of a mission: what was asked, how far it has come, what is tracked."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import inf, isfinite, nan

from housefly.geometry import Vec2, Vec3, heading_to
from housefly.messages.flight import OrderKind, OrderOutcome, Phase
from housefly.messages.sensing import DroneStatus, Estimate, Telemetry
from housefly.messages.steering import Path
from housefly.messages.words import UNSAID, Words, figure
from housefly.pilot.behavior.drone_faults import GROUNDING_FAULTS, fault_list
from housefly.pilot.behavior.path_profile import PathProfile
from housefly.pilot.behavior.path_progress import TrajectorySetpoint
from housefly.pilot.estimation.consistency import NOTHING_KNOWN, TrackingConsistency
from housefly.pilot.estimation.dead_reckoning import ReckonedPose
from housefly.pilot.planning.trajectory.time_scale import TimeScale

PEOPLE_SILENCE_MAX = 1.0
"""One of the sensors that look for people may be silent for so long [s] ..."""
_PERIODS_MAX = 2.5
"""... or, where one is slower than that, for so many of its periods."""


@dataclass(frozen=True, slots=True)
class Refused:
    """The answer when something cannot be done: which kind of reason, and the reason in words."""

    outcome: OrderOutcome
    reason: Words


@dataclass(frozen=True, slots=True)
class Mission:
    """What to do in the air.

    Attributes:
        kind: TAKE_OFF (stay), GO, SERVICE or HOME.
        name: the goal in words.
        goal: world xy [m], None to stay.
        look_at: world point [m] to face on arrival, or None.
        look_s: how long to look [s].
        yaw: heading on arrival when there is nothing to look at [rad]; None keeps the heading.
    """

    kind: OrderKind = OrderKind.TAKE_OFF
    name: str = ""
    goal: Vec2 | None = None
    look_at: Vec3 | None = None
    look_s: float = 0.0
    yaw: float | None = None

    @property
    def flying_phase(self) -> Phase:
        """The phase in which it is flown."""
        return Phase.RETURNING if self.kind is OrderKind.HOME else Phase.OUTBOUND

    def arrival_yaw(self, position: Vec2) -> float | None:
        """Return the heading [rad] to take at the goal, seen from a position [m]; None keeps it."""
        return self.yaw if self.look_at is None else heading_to(position, self.look_at[:2])


STAY = Mission()
"""Hover where the drone is."""
LANDING_PLACE = "a clear place to land"
"""Name of the mission that lands elsewhere than at home."""


@dataclass(frozen=True, slots=True)
class MissionState:
    """How far the drone has come with its mission.

    Attributes:
        phase: what the drone is doing.
        since: when the phase began [s].
        mission: what is done, or will be once in the air.
        stopped: STOP is latched.
        cutting: the motors are to be cut; asked until the drone says so.
        resetting: the emergency state is to be left; asked until the drone says so.
        pressed_at: when cut or reset was ordered [s].
        was_cut: a motor cut was ordered, and no flight since.
    """

    phase: Phase = Phase.IDLE
    since: float = 0.0
    mission: Mission = STAY
    stopped: bool = False
    cutting: bool = False
    resetting: bool = False
    pressed_at: float = 0.0
    was_cut: bool = False

    def entering(self, phase: Phase, now: float, mission: Mission | None = None) -> MissionState:
        """Return the state in a phase that begins now."""
        return replace(
            self, phase=phase, since=now, mission=self.mission if mission is None else mission
        )

    def stopping(self, now: float, grounded: bool) -> MissionState:
        """Return the state with STOP latched: a mission is given up, a landing goes on."""
        stopped = replace(self, stopped=True, mission=STAY)
        if self.phase is Phase.TAKING_OFF and grounded:
            return stopped.entering(Phase.IDLE, now)
        if self.phase in (Phase.OUTBOUND, Phase.LOOKING, Phase.RETURNING):
            return stopped.entering(Phase.HOLDING, now)
        return stopped

    def pressing(self, now: float, *, cut: bool) -> MissionState:
        """Return the state with the motors to be cut, or the emergency to be left."""
        was_cut = cut or self.was_cut
        return replace(self, cutting=cut, resetting=not cut, pressed_at=now, was_cut=was_cut)

    def released(self) -> MissionState:
        """Return the state with neither cut nor reset wanted."""
        if not (self.cutting or self.resetting):
            return self
        return replace(self, cutting=False, resetting=False)


@dataclass(frozen=True, slots=True, eq=False)
class TrackingTask:
    """A path to follow or a place to hold; a new object is a new task.

    Attributes:
        profile: of the path in use, None while holding a place.
        path: the path in use or in prospect, for people.
        duration: expected flight time on it [s].
        hold: place to stay at [m], None to stay where the drone is.
        hold_yaw: heading to keep there [rad].
        waiting: why it waits for the way to become free, in words; "" when it does not.
        since: since when it waits [s].
        height: to fly at [m], None for the usual one.
        halted: a trajectory in space is braked to a stop on its own curve, and kept there.
        comfort: what a trajectory in space keeps from people [m]; 0 where there was nobody.
        arrival: when it was to arrive, from its beginning on [s]; infinite when people might keep
            it from that.
    """

    profile: PathProfile | None = None
    path: Path | None = None
    duration: float = 0.0
    hold: Vec2 | None = None
    hold_yaw: float = 0.0
    waiting: Words = UNSAID
    since: float = 0.0
    height: float | None = None
    halted: bool = False
    comfort: float = 0.0
    arrival: float = inf

    @property
    def is_following(self) -> bool:
        """Whether the drone is to move along a path."""
        return self.profile is not None and not self.halted


@dataclass(frozen=True, slots=True)
class TrajectoryReference:
    """The moving reference on a trajectory in space.

    Attributes:
        target: where the drone should be.
        yaw: heading to ask for [rad].
        scale: how far the trajectory has been flown.
    """

    target: TrajectorySetpoint
    yaw: float
    scale: TimeScale


@dataclass(frozen=True, slots=True)
class PeopleSilence:
    """How long that sensor has been silent, of those that look for people, which was longest.

    Attributes:
        age: since its last scan or image that was believed [s]; infinite before the first, 0 or
            less where there is no sensor.
        limit: longest that is all right [s].
    """

    age: float = 0.0
    limit: float = PEOPLE_SILENCE_MAX

    @property
    def is_too_long(self) -> bool:
        """Whether people may be unseen."""
        return not self.age <= self.limit

    @property
    def words(self) -> Words:
        """How long, in words."""
        if isfinite(self.age):
            return Words("nothing usable for {n} s", n=figure(self.age, ".0f"))
        return Words("not heard yet")

    @property
    def consequence(self) -> Words:
        """What follows from it, and how long it lasts, in words."""
        if isfinite(self.age):
            return Words(
                "people may be unseen: a sensor that looks for them gave nothing usable for {n} s",
                n=figure(self.age, ".0f"),
            )
        return Words("people may be unseen: a sensor that looks for them is not heard yet")


NO_SILENCE = PeopleSilence()
"""Nothing that looks for people is silent."""


def longest_silence(slowest_rate: float) -> float:
    """Return for how long sensors may be silent [s], given the rate of the slowest [Hz]."""
    return max(PEOPLE_SILENCE_MAX, round(_PERIODS_MAX / slowest_rate, 1))


@dataclass(frozen=True, slots=True)
class VehicleStatus:
    """What the drone says, where it is, and whether the gate lands it.

    Attributes:
        now: time [s].
        status: last reported by the drone.
        battery: charge, 0 to 1.
        telemetry_age: [s].
        estimate: where it is, None before the first sighting.
        landing_forced: the safety gate is landing the drone.
        return_wanted: the safety gate wants the drone to come home.
        telemetry: the drone's newest report, None before the first.
        consistency: tracking held against the drone's own report.
        standing_height: tracked height of the drone when it stood [m].
        maneuvering: a maneuver flies the drone.
        held: the safety gate leaves the drone to its own hover.
        reference: where the trajectory that is flown has come to; None where none is.
        tracking_disproved: in flight the drone's own motion shows that tracking is wrong.
        origin_known: tracking and map were found to agree before this pilot began.
        silence: of the sensors that look for people.
        gauge_stuck: the charge stood still in the flight before, and has not changed since.
        reckoned: where it is by its own motion, while the gate holds or lands it; None where it
            does not tell how it moves.
        landing_waits: the landing of the gate waits for the floor below to be clear.
    """

    now: float
    status: DroneStatus
    battery: float
    telemetry_age: float
    estimate: Estimate | None
    landing_forced: bool
    return_wanted: bool = False
    telemetry: Telemetry | None = None
    consistency: TrackingConsistency = NOTHING_KNOWN
    standing_height: float = 0.0
    maneuvering: bool = False
    held: bool = False
    reference: TrajectoryReference | None = None
    tracking_disproved: bool = False
    origin_known: bool = False
    silence: PeopleSilence = NO_SILENCE
    gauge_stuck: bool = False
    reckoned: ReckonedPose | None = None
    landing_waits: bool = False

    @property
    def position(self) -> Vec3 | None:
        """Place and height [m]; by its own motion while the gate holds or lands it."""
        if self.reckoned is not None:
            return self.reckoned.position
        return self.estimate.position if self.estimate else None

    @property
    def place(self) -> Vec2 | None:
        """Position in the plane [m]."""
        return self.estimate.position[:2] if self.estimate else None

    @property
    def pose_age(self) -> float:
        """Age of the pose [s]; infinite before the first."""
        return self.estimate.pose_age if self.estimate else float("inf")

    @property
    def grounding_faults(self) -> Words:
        """The drone's complaints that forbid a take-off, in words, or ""."""
        told = self.telemetry.faults if self.telemetry else ()
        return fault_list(fault for fault in told if fault in GROUNDING_FAULTS)

    @property
    def configured(self) -> bool | None:
        """Whether the drone has confirmed its limits; None before its first word."""
        return self.telemetry.configured if self.telemetry else None

    @property
    def height_error(self) -> float:
        """How far tracking has a standing drone from its height [m]; 0 where unknown."""
        error = self.consistency.height_error
        return error if isfinite(error) else 0.0


UNHEARD = VehicleStatus(
    now=0.0,
    status=DroneStatus.UNKNOWN,
    battery=nan,
    telemetry_age=inf,
    estimate=None,
    landing_forced=False,
)
"""A drone before its first word."""
