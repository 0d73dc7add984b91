"""The steps that a task is made of, as values."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from enum import Enum


class StepKind(Enum):
    """What a step does; the value is its word in a document."""

    TAKE_OFF = "take_off"
    GO_TO = "go_to"
    LOOK_AT = "look_at"
    SWEEP = "sweep"
    FOLLOW = "follow"
    RETURN_HOME = "return_home"
    LAND = "land"
    RECORD = "record"
    SNAPSHOT = "snapshot"
    SAY = "say"
    ANNOUNCE = "announce"
    REPORT = "report"
    PUBLISH = "publish"
    ASK = "ask"
    WAIT = "wait"
    FIND = "find"
    SEARCH = "search"
    COVERAGE = "coverage"
    CONTENTS = "contents"
    CHANGES = "changes"
    CHECK_PEOPLE = "check_people"
    CALL = "call"
    SEQUENCE = "sequence"
    PARALLEL = "parallel"
    FIRST_OF = "first_of"
    RETRY = "retry"
    TIMEOUT = "timeout"
    IF = "if"
    REPEAT = "repeat"
    FOR_EACH = "for_each"
    FAIL = "fail"


class ConditionKind(Enum):
    """What a condition asks; the value is its word in a document."""

    IS = "is"
    SET = "set"
    REPLY = "reply"
    PARAMETER = "parameter"
    STALE = "stale"
    DOUBTFUL = "doubtful"
    NOT = "not"
    ALL = "all"
    ANY = "any"


@dataclass(frozen=True, slots=True)
class ParameterUse:
    """A parameter where a number, a flag or a list is wanted: ``$name``."""

    name: str


@dataclass(frozen=True, slots=True)
class TaskCondition:
    """A condition: its arguments, or the conditions it is made of."""

    kind: ConditionKind
    arguments: dict[str, ArgumentValue] = field(default_factory=dict)
    parts: tuple[TaskCondition, ...] = ()


ArgumentValue = (
    str
    | float
    | bool
    | tuple[str, ...]
    | tuple[float, ...]
    | dict[str, str | float | bool]
    | ParameterUse
    | TaskCondition
)


@dataclass(frozen=True, slots=True)
class TaskStep:
    """One step.

    Attributes:
        kind: what it does.
        arguments: by name; those that were not given are missing.
        blocks: steps inside it, by the word that they stand under.
        name: its own name, or "".
        timeout: longest time that it may take [s]; None takes the usual.
        may_fail: the task goes on when it fails.
        line: where it stands in its document; 0 when it was not read from one.
    """

    kind: StepKind
    arguments: dict[str, ArgumentValue] = field(default_factory=dict)
    blocks: dict[str, tuple[TaskStep, ...]] = field(default_factory=dict)
    name: str = ""
    timeout: float | ParameterUse | None = None
    may_fail: bool = False
    line: int = field(default=0, compare=False)

    def every_step(self) -> Iterator[TaskStep]:
        """Yield this step and all steps inside it, in order."""
        yield self
        for block in self.blocks.values():
            for step in block:
                yield from step.every_step()
