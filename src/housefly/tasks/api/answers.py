"""What the tasks answer: one frozen value a kind of answer. Times are Unix time [s]."""

from __future__ import annotations

from dataclasses import dataclass, field

from housefly.config.house_mode import HouseMode
from housefly.evidence.clip_values import ClipsAnswer, ClipsQuestion, DeleteClip, KeepClip
from housefly.messages.words import UNSAID, Words
from housefly.tasks.api.questions import (
    BoardQuestion,
    CancelTask,
    ChangeRule,
    ContinueTask,
    DryRunQuestion,
    PauseTask,
    RehearseTask,
    ReplyToTask,
    RequestTask,
    RulesQuestion,
    Sentence,
    ServicesQuestion,
    SetMode,
    TakePhoto,
    TaskHistoryQuestion,
    TaskQuestion,
    Webhook,
)
from housefly.tasks.api.values import (
    Confirm,
    ParameterInfo,
    ParameterValue,
    ReasonCode,
    RehearsalReport,
    ServiceInfo,
    TaskRequest,
    TaskStatus,
)


@dataclass(frozen=True, slots=True)
class TasksAnswer:
    """Tasks; after an order, those that it concerns."""

    tasks: tuple[TaskStatus, ...]


@dataclass(frozen=True, slots=True)
class TaskBoard:
    """Everything that a screen of the tasks shows.

    Attributes:
        at: when.
        mode: of the house.
        drone: what the drone does, in words.
        records: whether the camera records now.
        tasks: the open ones, in the order in which they fly.
        ended: the newest ended ones, newest first.
        notices: what people should know, in words: no space for clips, a clock that leapt.
    """

    at: float
    mode: HouseMode
    drone: Words
    records: bool
    tasks: tuple[TaskStatus, ...]
    ended: tuple[TaskStatus, ...]
    notices: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class ServicesAnswer:
    """What can be asked for."""

    services: tuple[ServiceInfo, ...]


@dataclass(frozen=True, slots=True)
class RehearsalAnswer:
    """What a rehearsal found."""

    rehearsal: RehearsalReport


@dataclass(frozen=True, slots=True)
class SentenceAnswer:
    """What became of a sentence.

    Attributes:
        understood: whether it means something here.
        intent: its name (docs/tasks.md), or "".
        slots: its values.
        words: the answer, or why there is none.
        task: the task that it started, or None.
        suggestions: what may have been meant.
        offer: what a yes would ask for, as a new request; nothing is asked for yet.
        code: why it was not done, OK when it was.
    """

    understood: bool
    intent: str
    words: Words
    slots: dict[str, ParameterValue] = field(default_factory=dict)
    task: TaskStatus | None = None
    suggestions: tuple[str, ...] = ()
    offer: TaskRequest | None = None
    code: ReasonCode = ReasonCode.OK


@dataclass(frozen=True, slots=True)
class ModeAnswer:
    """The mode of the house, and what it allows, in words."""

    mode: HouseMode
    words: str


@dataclass(frozen=True, slots=True)
class RuleStatus:
    """One rule.

    Attributes:
        name: of the rule.
        words: what it says.
        enabled: whether it is on.
        last_at, last_words, last_cause: what it last did, and because of what.
        when: what it waits for, as people say it; UNSAID of what is no rule.
        title: of the service that it asks for.
        confirm: whether it asks first.
        modes: of the house, in which it counts; () is any.
        parameters: what a person may set, each with its value as default.
        is_remembered: whether what it waits for is kept, so that the past tells when it came.
        changed_by: who changed it on the page; "" while it is as its file says.
    """

    name: str
    words: str
    enabled: bool
    last_at: float | None = None
    last_words: str = ""
    last_cause: str = ""
    when: Words = UNSAID
    title: str = ""
    confirm: Confirm = Confirm.ASK
    modes: tuple[HouseMode, ...] = ()
    parameters: tuple[ParameterInfo, ...] = ()
    is_remembered: bool = True
    changed_by: str = ""


@dataclass(frozen=True, slots=True)
class RulesAnswer:
    """The rules."""

    rules: tuple[RuleStatus, ...]


@dataclass(frozen=True, slots=True)
class RuleFiring:
    """What a rule did, or would have done, and why; ``code`` OK starts its task."""

    rule: str
    at: float
    cause: str
    service: str
    code: ReasonCode
    words: str


@dataclass(frozen=True, slots=True)
class FiringsAnswer:
    """What the rules did, or would have done, by time."""

    firings: tuple[RuleFiring, ...]


TaskAnswer = (
    TasksAnswer
    | TaskBoard
    | ServicesAnswer
    | RehearsalAnswer
    | SentenceAnswer
    | ModeAnswer
    | RulesAnswer
    | FiringsAnswer
    | ClipsAnswer
)
TASK_ANSWER_TYPES: dict[type[TaskQuestion], type[TaskAnswer]] = {
    RequestTask: TasksAnswer,
    RehearseTask: RehearsalAnswer,
    ReplyToTask: TasksAnswer,
    CancelTask: TasksAnswer,
    PauseTask: TasksAnswer,
    ContinueTask: TasksAnswer,
    BoardQuestion: TaskBoard,
    ServicesQuestion: ServicesAnswer,
    TaskHistoryQuestion: TasksAnswer,
    Sentence: SentenceAnswer,
    SetMode: ModeAnswer,
    RulesQuestion: RulesAnswer,
    ChangeRule: RulesAnswer,
    DryRunQuestion: FiringsAnswer,
    ClipsQuestion: ClipsAnswer,
    Webhook: FiringsAnswer,
    KeepClip: ClipsAnswer,
    DeleteClip: ClipsAnswer,
    TakePhoto: ClipsAnswer,
}
"""What each question is answered with."""
