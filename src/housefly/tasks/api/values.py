"""The values of the tasks that cross borders: states, reasons, requests, what the board shows.

Times are Unix time [s].
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum

from housefly.geometry import Vec2
from housefly.messages.words import Words

ParameterValue = str | float | bool


class TaskStage(Enum):
    """How far a task has come."""

    WAITING = "waiting for a yes"
    QUEUED = "queued"
    RUNNING = "running"
    PAUSED = "paused"
    SUSPENDED = "suspended"
    DONE = "done"
    FAILED = "failed"
    CANCELLED = "cancelled"
    REFUSED = "refused"
    EXPIRED = "expired"


ENDED = frozenset(
    {
        TaskStage.DONE,
        TaskStage.FAILED,
        TaskStage.CANCELLED,
        TaskStage.REFUSED,
        TaskStage.EXPIRED,
    }
)
"""States that a task never leaves."""


class Priority(Enum):
    """Who goes first; a higher one pre-empts a lower one at a safe point."""

    ALARM = "alarm"
    PERSON = "person"
    RULE = "rule"
    BACKGROUND = "background"


class Confirm(Enum):
    """Whether a person is asked before a task may fly."""

    AUTO = "auto"
    ASK = "ask"
    NEVER = "never"


class OnPreempt(Enum):
    """What becomes of a task that a more urgent one takes the drone from."""

    RESUME = "resume"
    RESTART = "restart"
    END = "end"


class RequestSurface(Enum):
    """Where a request came from."""

    CONSOLE = "console"
    COMMAND_LINE = "command line"
    HTTP = "http"
    MQTT = "mqtt"
    ROS = "ros 2"
    WEBHOOK = "webhook"
    ASSISTANT = "assistant"
    RULE = "rule"


ATTENDED = frozenset({RequestSurface.CONSOLE, RequestSurface.COMMAND_LINE, RequestSurface.HTTP})
"""Where a person asks; everywhere else nobody may be looking."""


class ReasonCode(Enum):
    """Why something was refused, or how a task ended; the words beside it are for people."""

    OK = "ok"
    UNKNOWN_SERVICE = "unknown_service"
    BAD_PARAMETER = "bad_parameter"
    UNKNOWN_PLACE = "unknown_place"
    UNKNOWN_THING = "unknown_thing"
    UNKNOWN_TASK = "unknown_task"
    NOT_UNDERSTOOD = "not_understood"
    NO_WAY = "no_way"
    NO_VIEW = "no_view"
    BATTERY = "battery"
    TOO_LONG = "too_long"
    PREFLIGHT = "preflight"
    MODE = "mode"
    QUIET_HOURS = "quiet_hours"
    COOLDOWN = "cooldown"
    RATE_LIMIT = "rate_limit"
    QUEUE_FULL = "queue_full"
    NOT_ALLOWED = "not_allowed"
    DECLINED = "declined"
    NO_ANSWER = "no_answer"
    DEADLINE = "deadline"
    CANCELLED = "cancelled"
    PERSON_TOOK_OVER = "person_took_over"
    STEP_FAILED = "step_failed"
    TIMEOUT = "timeout"
    SAFETY = "safety"
    RESTARTED = "restarted"
    NOT_READY = "not_ready"
    NO_DRONE = "no_drone"
    NO_CAMERA = "no_camera"
    CONDITION = "condition"
    PREEMPTED = "preempted"


class TaskStepState(Enum):
    """How far one step of a task has come."""

    WAITING = "waiting"
    RUNNING = "running"
    DONE = "done"
    FAILED = "failed"
    SKIPPED = "skipped"


@dataclass(frozen=True, slots=True)
class TaskRequest:
    """A request for a service.

    Attributes:
        service: name of a task document.
        parameters: for its parameters; what is missing takes its default.
        asked_by: who asks, in words.
        surface: where the request came from.
        cause: id of the event or rule behind it, or "".
        confirm: whether a person must say yes first.
        priority: who goes first.
        deadline: not begun by then [Unix time, s], it expires; None waits for ever.
        owner: id of who asks, filled in by whoever knows them; a name may be anybody's.
        drone: name of the drone that is to fly; "" for whichever is free, ready and nearest.
        sentence: in which somebody asked, or "".
    """

    service: str
    parameters: dict[str, ParameterValue] = field(default_factory=dict)
    asked_by: str = ""
    surface: RequestSurface = RequestSurface.CONSOLE
    cause: str = ""
    confirm: Confirm = Confirm.AUTO
    priority: Priority = Priority.PERSON
    deadline: float | None = None
    owner: str = ""
    drone: str = ""
    sentence: str = ""


@dataclass(frozen=True, slots=True)
class RehearsalReport:
    """What a rehearsal in lock step found, before anything flies.

    Attributes:
        may_fly: whether the task may fly.
        code, words: why not, or what to expect, in one sentence.
        way: where the drone flies, world xy [m].
        duration: of the whole task, at most [s]; None when it was not flown to its end.
        charge: share of a full battery that it takes at most, 0 to 1.
        clearance: smallest distance of the hull to anything [m].
        first_look: until the first look at the subject [s].
        took: time that the rehearsal itself took [s].
        shortest: of the whole task when every question is answered at once [s].
    """

    may_fly: bool
    code: ReasonCode
    words: Words
    way: tuple[Vec2, ...] = ()
    duration: float | None = None
    charge: float | None = None
    clearance: float | None = None
    first_look: float | None = None
    took: float = 0.0
    shortest: float | None = None


@dataclass(frozen=True, slots=True)
class TaskStepStatus:
    """One step of a task: its name in the document, what it does in words, how far it is."""

    name: str
    words: str
    state: TaskStepState


@dataclass(frozen=True, slots=True)
class TaskLook:
    """What a task shows people now: what it looks at, and until when.

    Attributes:
        words: what the drone does, as in "Looking at the entrance".
        until: when it goes on by itself [Unix time, s]; None where nobody can say.
    """

    words: Words
    until: float | None = None


@dataclass(frozen=True, slots=True)
class PersonQuestion:
    """A question that waits for a person.

    Attributes:
        id: of the question, unique within its task.
        words: what is asked.
        choices: what may be answered; the first is what a person would usually say.
        until: the end of waiting [Unix time, s].
        otherwise: the choice that counts when nobody answers.
    """

    id: str
    words: Words
    choices: tuple[str, ...] = ("yes", "no")
    until: float | None = None
    otherwise: str = "no"


@dataclass(frozen=True, slots=True)
class TaskStatus:
    """One task, waiting, flying or ended.

    Attributes:
        id: a number that never comes again at this site.
        service, title, parameters: what it does.
        state, code, words: how far it is and why, in one sentence.
        asked_by, surface, cause, priority: who wanted it.
        asked_at, started_at, ended_at, deadline: [Unix time, s].
        steps: its steps, in order.
        question: what waits for a person, or None.
        rehearsal: what the rehearsal found, or None.
        clips: ids of its clips and snapshots.
        report: what it found, one line each, for people.
        took_off_at: when its flight began [Unix time, s]; None when it did not fly.
        flown: how long it was in the air [s]; None where nobody knows whether it flew.
        recording: folder of the recording of the whole run, for `housefly replay`, or "".
        drone: that flies it, or is wanted for it; "" while that may be any.
        look: what it shows people now; None while it flies somewhere, or shows nothing.
    """

    id: int
    service: str
    title: str
    parameters: dict[str, ParameterValue]
    state: TaskStage
    code: ReasonCode
    words: Words
    asked_by: str
    surface: RequestSurface
    cause: str
    priority: Priority
    asked_at: float
    started_at: float | None = None
    ended_at: float | None = None
    deadline: float | None = None
    steps: tuple[TaskStepStatus, ...] = ()
    question: PersonQuestion | None = None
    rehearsal: RehearsalReport | None = None
    clips: tuple[str, ...] = ()
    report: tuple[str, ...] = ()
    took_off_at: float | None = None
    flown: float | None = None
    recording: str = ""
    drone: str = ""
    look: TaskLook | None = None


@dataclass(frozen=True, slots=True)
class ParameterInfo:
    """One parameter of a service: its type, unit, default and what it is for."""

    name: str
    type: str
    about: str
    unit: str = ""
    default: ParameterValue | None = None
    required: bool = False


@dataclass(frozen=True, slots=True)
class ServiceInfo:
    """One service that can be asked for, or why it cannot: file, line and reason of its document.

    Attributes:
        name: in requests.
        title, about: for people.
        parameters: what may be given.
        flies: whether it moves the drone.
        problem: what is wrong with its document, in words; "" when it can be asked for.
    """

    name: str
    title: str
    about: str
    parameters: tuple[ParameterInfo, ...] = ()
    flies: bool = True
    problem: str = ""
