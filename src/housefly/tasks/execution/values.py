"""What a running task is told at each tick, and what it wants done: pure values."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.evidence.clip_values import StartClip, TakeSnapshot
from housefly.geometry import Vec3
from housefly.messages import DroneStatus, Event, Order, OrderAnswer, Phase, SafetyMode


@dataclass(frozen=True, slots=True)
class PersonReply:
    """What a person answered to a question of this task."""

    question: str
    choice: str
    by: str


@dataclass(frozen=True, slots=True)
class TaskInputs:
    """Everything that one tick of a running task may know.

    Attributes:
        now: the pilot's clock [s]; orders are stamped with it.
        unix: the same moment as Unix time [s].
        status: what the drone says it does; None before the first report.
        phase, safety, goal_name: of the pilot.
        position: of the drone in the world [m]; None while it is not tracked.
        yaw: [rad].
        events: what the pilot told since the last tick.
        warnings: what is wrong now, in words.
        replies: of people, since the last tick.
        battery: charge, 0 to 1; None when unknown.
        orders: what people, and not tasks, ordered the pilot since the last tick.
        pose_age: how old the position is [s].
        answers: of the pilot to orders, since the last tick.
    """

    now: float
    unix: float
    status: DroneStatus | None = None
    phase: Phase = Phase.IDLE
    safety: SafetyMode = SafetyMode.NOMINAL
    goal_name: str = ""
    position: Vec3 | None = None
    yaw: float | None = None
    events: tuple[Event, ...] = ()
    warnings: tuple[str, ...] = ()
    replies: tuple[PersonReply, ...] = ()
    battery: float | None = None
    orders: tuple[Order, ...] = ()
    pose_age: float = 0.0
    answers: tuple[OrderAnswer, ...] = ()


@dataclass(frozen=True, slots=True)
class GiveOrder:
    """Give the pilot an order; ``issued_at`` and ``sender`` are filled in."""

    order: Order


@dataclass(frozen=True, slots=True)
class StopClip:
    """End the clip."""


@dataclass(frozen=True, slots=True)
class Say:
    """Tell people something: on every screen, over MQTT and to whoever listens."""

    words: str


@dataclass(frozen=True, slots=True)
class AskPerson:
    """Ask people; the reply comes as a PersonReply with the same id."""

    id: str
    words: str
    choices: tuple[str, ...] = ("yes", "no")
    timeout: float | None = None
    otherwise: str = "no"


@dataclass(frozen=True, slots=True)
class CloseQuestion:
    """A question is over, answered or not: a later reply finds nobody who waits for it."""

    id: str


@dataclass(frozen=True, slots=True)
class PublishMqtt:
    """Publish to a device of the room."""

    topic: str
    payload: str


@dataclass(frozen=True, slots=True)
class Report:
    """Add a line to what the task found."""

    words: str


TaskAction = (
    GiveOrder
    | StartClip
    | StopClip
    | TakeSnapshot
    | Say
    | AskPerson
    | CloseQuestion
    | PublishMqtt
    | Report
)
