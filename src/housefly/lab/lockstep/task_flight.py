"""A task flown in lock step, as a value: what people did, what the task did, what was true."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import inf

from housefly.geometry import Vec2
from housefly.messages import Order
from housefly.record.truth import HOME_RADIUS, ContactRecord
from housefly.tasks.api.values import ReasonCode, TaskStage, TaskStepStatus
from housefly.tasks.execution.values import TaskAction


@dataclass(frozen=True, slots=True)
class TaskScript:
    """What people do while the task flies; times since it began [s].

    Attributes:
        replies: choice by question; other questions are answered with their first choice.
        silent: nobody answers other questions.
        reply_time: a person thinks so long before they answer [s].
        late: they answer at the last moment instead.
        cancel_at, pause_at, resume_at: when somebody does that; infinity for never.
        cancel_again_at: when somebody cancels it a second time.
        orders: when a person orders the pilot something, past the task, and what.
    """

    replies: Mapping[str, str] = field(default_factory=dict)
    silent: bool = False
    reply_time: float = 1.0
    cancel_at: float = inf
    pause_at: float = inf
    resume_at: float = inf
    cancel_again_at: float = inf
    late: bool = False
    orders: tuple[tuple[float, Order], ...] = ()


NO_SCRIPT = TaskScript()
"""Nobody interferes; questions get their first choice."""


@dataclass(frozen=True, slots=True)
class TimedAction:
    """What a task wanted done, when [s], and where the drone truly was then [m].

    ``picture`` is the share that each thing and person took of the front camera's picture.
    """

    at: float
    action: TaskAction
    place: Vec2
    picture: Mapping[str, float]


@dataclass(frozen=True, slots=True)
class FlightSample:
    """The truth at one time in the air [s].

    Attributes:
        at: since the task began [s].
        place: of the drone, world xy [m].
        height: of the drone [m].
        solid, person: from the hull to the next solid and person [m].
        picture: share of the front camera's picture by thing and person, 0 to 1.
    """

    at: float
    place: Vec2
    height: float
    solid: float
    person: float
    picture: Mapping[str, float]


@dataclass(frozen=True, slots=True)
class TaskFlight:
    """One task as it was really flown; times since it began [s].

    Attributes:
        stage, code, words: how the task ended.
        ended_at: when.
        actions: what it wanted done, in order.
        began: when each step first ran, and its name; in order.
        steps: how far each step came.
        samples: the truth every half second in the air.
        contacts: what the drone touched.
        off_pad: where it is in the end, from the pad [m].
        stands: whether it stands in the end, and nothing is under way.
        airborne_at, landed_at: of the first and last time in the air; None when it never flew.
        skipped: time of hovering that was not flown but added [s].
        charge: that it took, 0 to 1.
        moved_after: how far it moved while it was watched after the end [m].
    """

    stage: TaskStage
    code: ReasonCode
    words: str
    ended_at: float
    actions: tuple[TimedAction, ...]
    began: tuple[tuple[float, str], ...]
    steps: tuple[TaskStepStatus, ...]
    samples: tuple[FlightSample, ...]
    contacts: tuple[ContactRecord, ...]
    off_pad: float
    stands: bool
    airborne_at: float | None
    landed_at: float | None
    skipped: float
    charge: float
    moved_after: float = 0.0

    @property
    def is_on_pad(self) -> bool:
        """Whether it stands on its pad in the end."""
        return self.stands and self.off_pad < HOME_RADIUS

    @property
    def clearance(self) -> float:
        """Smallest distance of the hull in the air to a solid or a person [m]."""
        return min((min(one.solid, one.person) for one in self.samples), default=inf)

    def actions_of(self, *kinds: type[TaskAction]) -> tuple[TimedAction, ...]:
        """Return the actions of some kinds."""
        return tuple(one for one in self.actions if isinstance(one.action, kinds))
