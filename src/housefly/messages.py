"""The vocabulary: every value that crosses a border between two folders.

All values are frozen. SI units. World frame: x along the long wall, y left, z up. Body frame: forward, left, up.
Times are seconds of the monotonic clock. Pitch is theta, roll is phi, yaw is psi; signs follow REP-103:
positive theta is nose down (accelerates forward), positive phi is right side down (accelerates right),
positive psi is counter-clockwise seen from above.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum

from housefly.geometry import IDENTITY, Quaternion, Vec2, Vec3, yaw_of


@dataclass(frozen=True, slots=True)
class Pose:
    """Position [m] and orientation (w, x, y, z) of a body in the world."""

    position: Vec3
    orientation: Quaternion = IDENTITY

    @property
    def yaw(self) -> float:
        """Heading psi [rad] in (-pi, pi]."""
        return yaw_of(self.orientation)


# --- room & tracking -> estimation ------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Sighting:
    """One body seen once by the tracking system.

    Attributes:
        body: name of the tracked body.
        pose: where it was.
        captured_at: when the cameras saw it [s, our monotonic clock].
        received_at: when we heard of it [s].
    """

    body: str
    pose: Pose
    captured_at: float
    received_at: float


class DroneStatus(Enum):
    """What the drone says it is doing."""

    UNKNOWN = "unknown"
    LANDED = "landed"
    TAKING_OFF = "taking off"
    FLYING = "flying"
    LANDING = "landing"
    EMERGENCY = "emergency"


@dataclass(frozen=True, slots=True)
class Telemetry:
    """What the drone last said of itself.

    Attributes:
        received_at: when we heard it [s].
        status: the drone's own state.
        battery: charge, 0 to 1.
        phi, theta, psi: attitude [rad], REP-103 signs; psi is relative to the drone's own start, not to the world.
        height: height above the floor by the drone's own sensor [m].
        velocity: body velocity forward, left, up by the drone's own estimate [m/s].
        faults: the drone's complaints, in words.
    """

    received_at: float
    status: DroneStatus
    battery: float
    phi: float = 0.0
    theta: float = 0.0
    psi: float = 0.0
    height: float = 0.0
    velocity: Vec3 = (0.0, 0.0, 0.0)
    faults: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Estimate:
    """Where the drone is, by the Kalman filter (paper V-D).

    Attributes:
        at: time the estimate is for [s].
        position: world [m]; z comes from tracking.
        velocity: world [m/s].
        yaw: heading psi [rad].
        pose_age: time since the last accepted sighting was captured [s].
        position_std: one-sigma uncertainty in x and y [m].
    """

    at: float
    position: Vec3
    velocity: Vec3
    yaw: float
    pose_age: float
    position_std: float


# --- planning ---------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Path:
    """A planned way through the map.

    Attributes:
        waypoints: world xy [m], start cell centre first, goal last.
        length: sum of the legs [m].
        clearance: smallest distance [m] from the path to an obstacle in the map, before inflation.
    """

    waypoints: tuple[Vec2, ...]
    length: float
    clearance: float


@dataclass(frozen=True, slots=True)
class PlanAnswer:
    """The answer to "how do I get from start to goal?"; ``path`` is None when there is no way.

    Attributes:
        start, goal: as asked [m].
        path: the way, or None.
        reason: in words, why there is no path ("" when there is one).
        suggestion: nearest free cell centre to a blocked or outside start or goal [m], when there is one.
        duration: expected flight time [s].
    """

    start: Vec2
    goal: Vec2
    path: Path | None
    reason: str = ""
    suggestion: Vec2 | None = None
    duration: float = 0.0


# --- behavior, control, safety ----------------------------------------------------------------------


class Behavior(Enum):
    """States of the finite state acceptor (paper Fig. 10)."""

    HOVER = "hover"
    ALTITUDE_CONTROL = "altitudeControl"
    YAW_CONTROL = "yawControl"
    PATH_TRACKING = "pathTracking"


@dataclass(frozen=True, slots=True)
class Reference:
    """Where the drone should be now: position [m], velocity [m/s] and yaw [rad] in the world."""

    position: Vec3
    velocity: Vec3
    yaw: float


@dataclass(frozen=True, slots=True)
class Setpoint:
    """What control asks of the drone's inner loops.

    Attributes:
        theta: wanted pitch [rad], positive accelerates forward.
        phi: wanted roll [rad], positive accelerates right.
        vz: wanted climb rate [m/s].
        yaw_rate: wanted yaw rate [rad/s], positive counter-clockwise.
    """

    theta: float = 0.0
    phi: float = 0.0
    vz: float = 0.0
    yaw_rate: float = 0.0


LEVEL = Setpoint()


class Action(Enum):
    """What kind of command goes to the drone."""

    IDLE = "idle"
    TAKE_OFF = "take off"
    FLY = "fly"
    HOVER = "hover"
    LAND = "land"
    CUT = "cut motors"
    RESET = "reset emergency"


@dataclass(frozen=True, slots=True)
class Command:
    """One order to the drone driver; ``setpoint`` counts only for ``Action.FLY``.

    HOVER asks for the drone's own hover (AR.Drone: hover bit); FLY with LEVEL means level attitude, which drifts.
    """

    action: Action
    setpoint: Setpoint = LEVEL


class SafetyMode(Enum):
    """What the last gate decided; the worst wins, in this order."""

    NOMINAL = "nominal"
    LEVEL = "level"
    STOPPED = "stopped"
    LAND = "land"
    CUT = "cut"


# --- orders, events, status -------------------------------------------------------------------------


class OrderKind(Enum):
    """What people and tasks may ask of the pilot."""

    TAKE_OFF = "take_off"
    LAND = "land"
    HOVER = "hover"
    GO = "go"
    SERVICE = "service"
    HOME = "home"
    STOP = "stop"
    RESUME = "resume"
    CUT = "cut"
    RESET = "reset"


@dataclass(frozen=True, slots=True)
class Order:
    """One order of a person or a task.

    GO flies to ``place`` or ``goal`` and hovers there. SERVICE is the paper's service: take off, fly there, look for
    ``look_s``, come home, land. HOME flies home and lands. STOP hovers and latches until RESUME; LAND and CUT always pass.

    Attributes:
        kind: what to do.
        place: name of a place, or "".
        goal: world xy [m], when there is no place.
        look_at: world point [m] to face on arrival; None keeps the place's own view, or the heading.
        look_s: how long to look before coming home [s].
        issued_at: when it was given [s]; orders older than 0.5 s that move the drone are refused.
        sender: who asked.
    """

    kind: OrderKind
    place: str = ""
    goal: Vec2 | None = None
    look_at: Vec3 | None = None
    look_s: float = 5.0
    issued_at: float = 0.0
    sender: str = ""


class Severity(Enum):
    """How much an event matters to a person."""

    INFO = "info"
    WARNING = "warning"
    FAULT = "fault"


@dataclass(frozen=True, slots=True)
class Event:
    """Something happened that a person may want to know."""

    at: float
    severity: Severity
    code: str
    text: str


class Phase(Enum):
    """How far an errand has come."""

    IDLE = "idle"
    TAKING_OFF = "taking off"
    OUTBOUND = "flying to goal"
    LOOKING = "looking"
    HOLDING = "holding"
    RETURNING = "returning"
    LANDING = "landing"


@dataclass(frozen=True, slots=True)
class Inputs:
    """All that a pilot step may know, besides the time."""

    sightings: tuple[Sighting, ...] = ()
    telemetry: Telemetry | None = None
    orders: tuple[Order, ...] = ()


@dataclass(frozen=True, slots=True)
class Outputs:
    """All that a pilot step decides.

    Attributes:
        command: for the drone driver.
        estimate: None until the first sighting.
        reference: None while nothing is tracked.
        behavior, phase, safety: states of the acceptor, the errand and the last gate.
        goal_name: where the errand goes, in words ("" when none).
        path: the path in use.
        waypoint: index into ``path.waypoints`` of the next waypoint.
        reason: why safety or the pilot holds back, in words ("" when nothing does).
        events: what happened in this step.
    """

    command: Command
    estimate: Estimate | None = None
    reference: Reference | None = None
    behavior: Behavior = Behavior.HOVER
    phase: Phase = Phase.IDLE
    safety: SafetyMode = SafetyMode.NOMINAL
    goal_name: str = ""
    path: Path | None = None
    waypoint: int = 0
    reason: str = ""
    events: tuple[Event, ...] = ()


@dataclass(frozen=True, slots=True)
class PilotStep:
    """One whole step, as the bus carries it and the recorder keeps it: enough to replay the pilot bit for bit."""

    sequence: int
    now: float
    inputs: Inputs
    outputs: Outputs


@dataclass(frozen=True, slots=True)
class VideoFrame:
    """One encoded picture of the drone's camera.

    Attributes:
        data: H.264 Annex B access unit; key frames start with SPS and PPS.
        keyframe: can be decoded without earlier frames.
        width, height: shown size [px].
        sequence: the drone's frame number.
        received_at: when its last byte arrived [s].
        drone_time: the drone's own clock [s].
    """

    data: bytes
    keyframe: bool
    width: int
    height: int
    sequence: int
    received_at: float
    drone_time: float = 0.0


@dataclass(frozen=True, slots=True)
class LinkStatus:
    """Health of the pilot's wires and loop, published about twice a second.

    Attributes:
        at: time [s].
        tracking_connected, drone_connected, video_connected: wire states.
        tracking_rate_hz: sightings of our drone per second over the last second.
        telemetry_rate_hz, video_rate_hz: likewise.
        loop_p50_s, loop_p99_s, loop_max_s: lateness of the pilot loop's ticks over the last ten seconds [s].
        missed_ticks: ticks skipped since start.
        notes: anything a person should read, in words.
    """

    at: float
    tracking_connected: bool = False
    drone_connected: bool = False
    video_connected: bool = False
    tracking_rate_hz: float = 0.0
    telemetry_rate_hz: float = 0.0
    video_rate_hz: float = 0.0
    loop_p50_s: float = 0.0
    loop_p99_s: float = 0.0
    loop_max_s: float = 0.0
    missed_ticks: int = 0
    notes: tuple[str, ...] = field(default=())
