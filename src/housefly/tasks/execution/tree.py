"""Makes the behavior tree of a task out of its steps."""

from __future__ import annotations

from collections.abc import Callable

from py_trees.behaviour import Behaviour
from py_trees.common import ParallelPolicy
from py_trees.composites import Parallel, Selector, Sequence
from py_trees.decorators import FailureIsSuccess, Retry

from housefly.tasks.document.step_forms import default_of
from housefly.tasks.document.steps import StepKind, TaskCondition, TaskStep
from housefly.tasks.document.templates import plain_text
from housefly.tasks.execution.composition import (
    Branch,
    ForEach,
    Otherwise,
    Recording,
    Rounds,
    TimeLimit,
)
from housefly.tasks.execution.descents import Land, ReturnHome
from housefly.tasks.execution.flight_steps import GoTo, LookAt, TakeOff
from housefly.tasks.execution.memory_steps import Changes, CheckPeople, Contents, Coverage, Find
from housefly.tasks.execution.room_steps import (
    Announce,
    Ask,
    Fail,
    Publish,
    RecordClip,
    ReportLine,
    SaySomething,
    Snapshot,
    WaitFor,
)
from housefly.tasks.execution.run_context import RunContext
from housefly.tasks.execution.search_step import Search
from housefly.tasks.execution.step_behavior import StepBehavior
from housefly.tasks.execution.watching_steps import Follow, Sweep

STEPS: dict[StepKind, type[StepBehavior]] = {
    StepKind.TAKE_OFF: TakeOff,
    StepKind.GO_TO: GoTo,
    StepKind.LOOK_AT: LookAt,
    StepKind.SWEEP: Sweep,
    StepKind.FOLLOW: Follow,
    StepKind.RETURN_HOME: ReturnHome,
    StepKind.LAND: Land,
    StepKind.RECORD: RecordClip,
    StepKind.SNAPSHOT: Snapshot,
    StepKind.SAY: SaySomething,
    StepKind.ANNOUNCE: Announce,
    StepKind.REPORT: ReportLine,
    StepKind.PUBLISH: Publish,
    StepKind.ASK: Ask,
    StepKind.WAIT: WaitFor,
    StepKind.FIND: Find,
    StepKind.SEARCH: Search,
    StepKind.COVERAGE: Coverage,
    StepKind.CONTENTS: Contents,
    StepKind.CHANGES: Changes,
    StepKind.CHECK_PEOPLE: CheckPeople,
    StepKind.FAIL: Fail,
}
"""What each step is when it runs; the other kinds are made of steps."""

_WORDS: dict[StepKind, str] = {
    StepKind.TAKE_OFF: "take off",
    StepKind.GO_TO: "fly to {subject}",
    StepKind.LOOK_AT: "look at {subject}",
    StepKind.SWEEP: "take {views} pictures all around",
    StepKind.FOLLOW: "follow {person} for {time} s",
    StepKind.RETURN_HOME: "come home and land",
    StepKind.LAND: "land here",
    StepKind.RECORD: "record {time} s",
    StepKind.SNAPSHOT: "take a picture",
    StepKind.SAY: "say: {words}",
    StepKind.ANNOUNCE: "announce: {words}",
    StepKind.REPORT: "report: {words}",
    StepKind.PUBLISH: "publish to {topic}",
    StepKind.ASK: "ask: {question}",
    StepKind.WAIT: "wait up to {time} s",
    StepKind.FIND: "ask the memory where {subject} is",
    StepKind.SEARCH: "look for {subject}",
    StepKind.COVERAGE: "say how much of the floor was seen",
    StepKind.CONTENTS: "see what is in {thing}",
    StepKind.CHANGES: "see what changed",
    StepKind.CHECK_PEOPLE: "see how everybody is",
    StepKind.FAIL: "give up: {words}",
}


def tree_of(steps: tuple[TaskStep, ...], context: RunContext) -> Behaviour:
    """Return the tree of some steps, one after the other; its steps are noted in the context."""
    return _sequence("task", steps, context)


def _sequence(name: str, steps: tuple[TaskStep, ...], context: RunContext) -> Behaviour:
    children = [_behavior(step, context) for step in steps]
    return children[0] if len(children) == 1 else Sequence(name, True, children)


def _behavior(step: TaskStep, context: RunContext) -> Behaviour:
    composed = _COMPOSED.get(step.kind)
    if composed is None or (step.kind is StepKind.RECORD and not step.blocks):
        found = _single(step, context)
    else:
        found = composed(step, context)
        if isinstance(step.timeout, float):
            found = TimeLimit(found.name, found, step.timeout, context)
    return FailureIsSuccess(found.name, found) if step.may_fail else found


def _single(step: TaskStep, context: RunContext) -> Behaviour:
    behavior = STEPS[step.kind](step, context)
    behavior.template = _step_words(step)
    behavior.note.words = _open_words(behavior.template)
    context.notes.append(behavior.note)
    return behavior


def _block(step: TaskStep, word: str, context: RunContext) -> Behaviour:
    return _sequence(step.name or step.kind.value, step.blocks[word], context)


def _number(step: TaskStep, name: str) -> float:
    value = step.arguments.get(name, default_of(step.kind, name))
    return value if isinstance(value, (int, float)) else 0.0


def _each(step: TaskStep, context: RunContext) -> list[Behaviour]:
    return [_behavior(each, context) for each in step.blocks[""]]


def _parallel(step: TaskStep, context: RunContext) -> Behaviour:
    policy = ParallelPolicy.SuccessOnAll(synchronise=True)
    return Parallel(step.name or "parallel", policy, _each(step, context))


def _timeout(step: TaskStep, context: RunContext) -> Behaviour:
    name = step.name or "timeout"
    limited = TimeLimit(name, _block(step, "do", context), _number(step, "after"), context)
    if "otherwise" not in step.blocks:
        return limited
    return Otherwise(name, limited, _block(step, "otherwise", context))


def _if(step: TaskStep, context: RunContext) -> Behaviour:
    words = [word for word in ("then", "else") if word in step.blocks]
    condition = step.arguments["condition"]
    assert isinstance(condition, TaskCondition)
    children = [_block(step, word, context) for word in words]
    return Branch(step.name or "if", condition, children, context)


def _repeat(step: TaskStep, context: RunContext) -> Behaviour:
    until = step.arguments.get("until")
    return Rounds(
        step.name or "repeat",
        _block(step, "do", context),
        int(_number(step, "times")),
        until if isinstance(until, TaskCondition) else None,
        context,
    )


def _retry(step: TaskStep, context: RunContext) -> Behaviour:
    return Retry(step.name or "retry", _block(step, "do", context), int(_number(step, "times")))


def _record(step: TaskStep, context: RunContext) -> Behaviour:
    return Recording(
        step.name or "record",
        _block(step, "do", context),
        _number(step, "before"),
        str(step.arguments.get("subject", "")),
        context,
    )


_COMPOSED: dict[StepKind, Callable[[TaskStep, RunContext], Behaviour]] = {
    StepKind.SEQUENCE: lambda step, context: _sequence(
        step.name or "sequence", step.blocks[""], context
    ),
    StepKind.PARALLEL: _parallel,
    StepKind.FIRST_OF: lambda step, context: Selector(
        step.name or "first_of", True, _each(step, context)
    ),
    StepKind.RETRY: _retry,
    StepKind.TIMEOUT: _timeout,
    StepKind.IF: _if,
    StepKind.REPEAT: _repeat,
    StepKind.RECORD: _record,
    StepKind.FOR_EACH: lambda step, context: ForEach(
        step.name or "for_each", _block(step, "do", context), str(step.arguments["of"]), context
    ),
}


def _step_words(step: TaskStep) -> str:
    """Return what a step does; what other steps find stays open, as $name."""
    words = _WORDS[step.kind]
    for name in _names(words):
        value = step.arguments.get(name, default_of(step.kind, name))
        shown = f"{value:g}" if isinstance(value, float) else _shown(value)
        words = words.replace("{" + name + "}", shown)
    return words


def _open_words(words: str) -> str:
    """Return what a step does while nobody knows yet what other steps find: (visitor)."""
    return plain_text(words, lambda name: f"({name})")


def _names(words: str) -> list[str]:
    return [part.partition("}")[0] for part in words.split("{")[1:]]


def _shown(value: object) -> str:
    return value if isinstance(value, str) else "a point"
