"""Orders, what the pilot makes of them, and one whole step of the pilot."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum
from math import inf

from housefly.geometry import Vec2, Vec3
from housefly.messages.event_code import EventCode
from housefly.messages.obstacles import Obstacle
from housefly.messages.sensing import Estimate, Sighting, Telemetry
from housefly.messages.steering import Behavior, Clearing, Command, Path, Reference, SafetyMode
from housefly.messages.words import UNSAID, Words


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
    NUDGE = "nudge"


class OrderSource(Enum):
    """What gave an order: only a person sees the room, and may insist."""

    PERSON = "person"
    TASK = "task"
    RULE = "rule"
    ASSISTANT = "assistant"
    PROGRAM = "program"


@dataclass(frozen=True, slots=True)
class Order:
    """One order of a person or a task.

    GO flies to ``place`` or ``goal`` and hovers there. SERVICE is the paper's service: take off,
    fly there, look for ``look_s``, come home, land. HOME flies home and lands. STOP hovers and
    latches until RESUME; LAND and CUT always pass. NUDGE moves a drone that holds its place by
    hand: it counts for 0.3 s, so whoever holds a key gives it again and again.

    Attributes:
        kind: what to do.
        place: name of a place, or "".
        goal: world xy [m], when there is no place.
        look_at: world point [m] to face on arrival; None keeps the place's own view, or the
            heading.
        look_s: how long to look before coming home [s].
        issued_at: when it was given [s]; orders older than 0.5 s that move the drone are refused.
        sender: the name of who asked, for people to read.
        velocity: wanted by NUDGE, along the axes of the world [m/s].
        id: by which its answer is found; "" where nobody waits for one.
        source: what gave it.
    """

    kind: OrderKind
    place: str = ""
    goal: Vec2 | None = None
    look_at: Vec3 | None = None
    look_s: float = 5.0
    issued_at: float = 0.0
    sender: str = ""
    velocity: Vec3 | None = None
    id: str = ""
    source: OrderSource = OrderSource.PERSON


class OrderOutcome(Enum):
    """What became of an order."""

    TAKEN = "taken"
    WRONG_VALUE = "wrong value"
    EXPIRED = "expired"
    WRONG_PHASE = "wrong phase"
    NO_EMERGENCY = "no emergency"
    STOPPED = "stopped"
    SAFETY = "safety"
    DRONE_SILENT = "drone silent"
    DRONE_NOT_READY = "drone not ready"
    DRONE_FAULT = "drone fault"
    UNTRACKED = "untracked"
    BATTERY = "battery"
    PREFLIGHT = "preflight"
    UNKNOWN_PLACE = "unknown place"
    NO_WAY = "no way"
    UNAVAILABLE = "unavailable"
    WAITING = "waiting"
    DISK = "disk"
    RESTARTING = "restarting"
    TOO_MANY = "too many"
    SUPERSEDED = "superseded"


@dataclass(frozen=True, slots=True)
class OrderAnswer:
    """What the pilot made of an order.

    Attributes:
        order_id: of the order.
        outcome: whether it was taken, or why not.
        reason: why not, in words with the values; "" when it was taken.
    """

    order_id: str
    outcome: OrderOutcome = OrderOutcome.TAKEN
    reason: Words = UNSAID

    @property
    def is_taken(self) -> bool:
        """Whether the pilot does it."""
        return self.outcome is OrderOutcome.TAKEN


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
    code: EventCode
    text: Words


class Phase(Enum):
    """How far a mission has come."""

    IDLE = "idle"
    TAKING_OFF = "taking off"
    OUTBOUND = "flying to goal"
    LOOKING = "looking"
    HOLDING = "holding"
    RETURNING = "returning"
    LANDING = "landing"


@dataclass(frozen=True, slots=True)
class Inputs:
    """Everything that a step of the pilot may know, besides the time.

    Attributes:
        sightings: since the last step.
        telemetry: the newest.
        orders: since the last step.
        obstacles: reported since the last step; the pilot keeps earlier ones for a while.
        late: how much later than planned this step runs [s].
        origin_known: tracking and map were found to agree before this pilot began.
        people_seen_at: until when each sensor that looks for people was believed [s]: of each the
            newest scan or image, of those the oldest. -inf before the first of one of them; inf
            where there is none, or where nobody said.
    """

    sightings: tuple[Sighting, ...] = ()
    telemetry: Telemetry | None = None
    orders: tuple[Order, ...] = ()
    obstacles: tuple[Obstacle, ...] = ()
    late: float = 0.0
    origin_known: bool = False
    people_seen_at: float = inf


@dataclass(frozen=True, slots=True)
class Outputs:
    """Everything that a step of the pilot decides.

    Attributes:
        command: for the drone driver.
        estimate: None until the first sighting.
        reference: None while nothing is tracked.
        behavior, phase, safety: states of the acceptor, the mission and the safety gate.
        goal_name: where the mission goes, in words ("" when none).
        path: the path in use.
        waypoint: index into ``path.waypoints`` of the next waypoint.
        reason: why safety or the pilot holds back, in words ("" when nothing does).
        events: what happened in this step.
        warnings: everything that is wrong now, in words, worst first.
        clears: what ends what the safety gate does; while safety is nominal it does nothing.
        answers: to the orders of this step that have an id.
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
    reason: Words = UNSAID
    events: tuple[Event, ...] = ()
    warnings: tuple[Words, ...] = ()
    clears: Clearing = Clearing.ITSELF
    answers: tuple[OrderAnswer, ...] = ()


@dataclass(frozen=True, slots=True)
class PilotStep:
    """One step of the pilot with all that is needed to replay it bit for bit."""

    sequence: int
    now: float
    inputs: Inputs
    outputs: Outputs


@dataclass(frozen=True, slots=True)
class LinkStatus:
    """Health of the pilot's wires and loop, published about twice a second.

    Attributes:
        at: time [s].
        tracking_connected, drone_connected, video_connected: wire states.
        tracking_rate_hz: sightings of our drone per second over the last second.
        telemetry_rate_hz, video_rate_hz: likewise.
        loop_p50_s, loop_p99_s, loop_max_s: lateness of the pilot loop's ticks over the last ten
            seconds [s].
        missed_ticks: ticks skipped since start.
        notes: anything a person should read, in words.
        tracking_latency_s: from capture to the pilot, by the stamps [s]; the following are 0 where
            nothing is known.
        command_delay_s, command_delay_std_s: from command to first reaction, and its one-sigma
            error [s].
        nis, height_nis: normalized innovation squared in the plane and of the height; 1 where the
            filter is as good as it thinks.
        push, load: steady push in the plane [m/s^2], and down as a share of the weight.
        height_std: one-sigma uncertainty of the height at the last sighting [m].
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
    notes: tuple[Words, ...] = field(default=())
    tracking_latency_s: float = 0.0
    command_delay_s: float = 0.0
    command_delay_std_s: float = 0.0
    nis: float = 0.0
    height_nis: float = 0.0
    push: float = 0.0
    load: float = 0.0
    height_std: float = 0.0
