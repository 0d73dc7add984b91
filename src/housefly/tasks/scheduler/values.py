"""What the scheduler holds, hears and decides: frozen values. Times are Unix time [s]."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.config.drone import DRONE_NAME
from housefly.geometry import Vec2
from housefly.messages.words import UNSAID, Words
from housefly.tasks.api.values import (
    ATTENDED,
    Confirm,
    OnPreempt,
    PersonQuestion,
    ReasonCode,
    RehearsalReport,
    TaskRequest,
    TaskStage,
)
from housefly.tasks.scheduler.transitions import STAGES, QueueState

_KEEPS_DRONE = frozenset({QueueState.SUSPENDED, QueueState.HELD_SUSPENDED})
CONFIRM = "confirm"
"""Id of the question whether a task may begin."""


@dataclass(frozen=True, slots=True)
class TaskTraits:
    """What the scheduler must know of a task's document.

    Attributes:
        title: for people.
        flies: whether it needs the drone; others run beside.
        confirm: whether a person must say yes; the stricter of this and the request's counts.
        on_preempt: what becomes of it when a more urgent task takes the drone.
    """

    title: str
    flies: bool = True
    confirm: Confirm = Confirm.AUTO
    on_preempt: OnPreempt = OnPreempt.RESUME


@dataclass(frozen=True, slots=True)
class SchedulerLimits:
    """Bounds of the queue.

    Attributes:
        queue: tasks that may wait.
        beside: tasks without a flight that may run at once.
        confirm_time: how long a yes is waited for [s].
        fresh_time: a flight that would begin later than this after the last yes asks again [s].
        per_source: tasks that may wait of one source that is no person, and questions for a yes
            that one person may bring about.
        alarms: alarms that may wait beyond a queue that people have filled.
    """

    queue: int = 20
    beside: int = 4
    confirm_time: float = 120.0
    fresh_time: float = 600.0
    per_source: int = 5
    alarms: int = 4


@dataclass(frozen=True, slots=True)
class ScheduledTask:
    """One task in the queue, or as it ended.

    Attributes:
        id: a number that never comes again.
        request: what was asked for; a second request for the same may raise its priority.
        traits: of its document.
        state: where it is.
        asked_at, started_at, ended_at: [Unix time, s].
        turn: among equals the smallest goes first.
        fresh_at: when somebody last wanted it to fly [Unix time, s].
        code, words: why it is where it is, in one sentence; "" says nothing beyond the state.
        question: what a person is asked, or None.
        rehearsal: the newest, or None.
        drone: that flies it, or flew it last; "" while that may be any.
    """

    id: int
    request: TaskRequest
    traits: TaskTraits
    state: QueueState
    asked_at: float
    turn: int
    fresh_at: float
    code: ReasonCode = ReasonCode.OK
    words: Words = UNSAID
    question: PersonQuestion | None = None
    rehearsal: RehearsalReport | None = None
    started_at: float | None = None
    ended_at: float | None = None
    drone: str = ""

    @property
    def stage(self) -> TaskStage:
        """The stage that people see."""
        return STAGES[self.state]

    @property
    def asker(self) -> str:
        """Who asked, for people; a name proves nothing."""
        return self.request.asked_by or self.request.surface.value

    @property
    def lane(self) -> str:
        """Whose turn it is when it is this task's turn."""
        return self.request.owner or self.asker

    @property
    def wanted_drone(self) -> str:
        """The only drone that may fly it; a run that was set aside stays with its own."""
        return self.drone if self.state in _KEEPS_DRONE else self.request.drone

    @property
    def is_attended(self) -> bool:
        """Whether a person asked for it."""
        return self.request.surface in ATTENDED

    @property
    def source(self) -> str:
        """With whose tasks it is counted: a person's, or all that come over one surface."""
        return self.lane if self.is_attended else self.request.surface.value


@dataclass(frozen=True, slots=True)
class RunReport:
    """How far a run is: its stage, why, and whether it may be pre-empted now.

    Of the stages only the ends count here; the rest the scheduler has decided itself. A run that
    still waits for its rehearsal is at a safe point.
    """

    id: int
    stage: TaskStage = TaskStage.RUNNING
    code: ReasonCode = ReasonCode.OK
    words: Words = UNSAID
    is_safe_point: bool = False


@dataclass(frozen=True, slots=True)
class DroneAvailability:
    """Whether tasks may order a drone now; else why not, as in "the drone charges (43 %)".

    Attributes:
        is_ready, words: that.
        name: of the drone.
        place: where it is, world xy [m]; None where that is not known.
    """

    is_ready: bool
    words: Words = UNSAID
    name: str = DRONE_NAME
    place: Vec2 | None = None


@dataclass(frozen=True, slots=True)
class TaskAdmitted:
    """A request became a task, which waits or is queued."""

    task: ScheduledTask


@dataclass(frozen=True, slots=True)
class TaskMerged:
    """A request for what waits already became part of that task."""

    task: ScheduledTask


@dataclass(frozen=True, slots=True)
class TaskEnded:
    """A task ended: drop its run, if there is one, without another step."""

    task: ScheduledTask


@dataclass(frozen=True, slots=True)
class StartTask:
    """Begin a new run of a task."""

    id: int


@dataclass(frozen=True, slots=True)
class PreemptTask:
    """Take the drone from a run; keep it as it is for ResumeTask, or drop it."""

    id: int
    is_kept: bool


@dataclass(frozen=True, slots=True)
class ResumeTask:
    """Give a kept run the drone again; begin one where it was pre-empted before it had any."""

    id: int


@dataclass(frozen=True, slots=True)
class CancelRun:
    """Let a run end as its document says; it is stepped until it reports its end."""

    id: int
    words: Words


@dataclass(frozen=True, slots=True)
class PauseRun:
    """Let a run hover."""

    id: int


@dataclass(frozen=True, slots=True)
class ContinueRun:
    """Let a paused run go on."""

    id: int


Decision = (
    TaskAdmitted
    | TaskMerged
    | TaskEnded
    | StartTask
    | PreemptTask
    | ResumeTask
    | CancelRun
    | PauseRun
    | ContinueRun
)
