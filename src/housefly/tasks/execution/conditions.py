"""Whether a condition holds now."""

from __future__ import annotations

from collections.abc import Callable

from housefly.errors import HouseflyError
from housefly.hub.api.questions import StateQuestion, WhereQuestion
from housefly.tasks.document.step_forms import CONDITION_FORMS
from housefly.tasks.document.steps import ConditionKind, TaskCondition
from housefly.tasks.execution.last_seen import ANYBODY, age_of
from housefly.tasks.execution.run_context import RunContext

SURE = 0.7
"""A place that the memory is less sure of counts as stale."""


def holds(condition: TaskCondition, context: RunContext) -> bool:
    """Return whether a condition holds now; what nobody knows does not hold."""
    return _CHECKS[condition.kind](condition, context)


def _text(condition: TaskCondition, name: str, context: RunContext) -> str:
    form = next(each for each in CONDITION_FORMS[condition.kind] if each.name == name)
    value = condition.arguments.get(name, form.default)
    return context.text(value) if isinstance(value, str) else ""


def _is(condition: TaskCondition, context: RunContext) -> bool:
    """A room that cannot be asked knows nothing: its answer is "unknown"."""
    thing, state = _text(condition, "thing", context), _text(condition, "state", context)
    try:
        answer = str(context.room.ask(StateQuestion(thing, state)).answer)
    except HouseflyError:
        answer = "unknown"
    return answer == _text(condition, "answer", context)


def _set(condition: TaskCondition, context: RunContext) -> bool:
    return bool(context.results.get(_text(condition, "name", context)))


def _reply(condition: TaskCondition, context: RunContext) -> bool:
    given = context.results.get(_text(condition, "to", context))
    return given is not None and given == _text(condition, "equals", context)


def _stale(condition: TaskCondition, context: RunContext) -> bool:
    """What was never seen is stale; what the catalogue has standing for good is not."""
    older, thing = condition.arguments.get("older"), _text(condition, "thing", context)
    limit = older if isinstance(older, float) else 300.0
    age = age_of(thing, context)
    if thing == ANYBODY or (age is not None and age > limit):
        return age is None or age > limit
    try:
        answer = context.room.ask(WhereQuestion(thing))
    except HouseflyError:
        return age is None
    if answer.age is None:
        return age is None and answer.position is None
    is_of_memory = age is None or age >= answer.age
    return bool(is_of_memory and answer.confidence < SURE)


def _doubtful(condition: TaskCondition, context: RunContext) -> bool:
    """Where memory names other places, the thing may be there."""
    try:
        answer = context.room.ask(WhereQuestion(_text(condition, "thing", context)))
    except HouseflyError:
        return False
    return bool(answer.alternatives)


_CHECKS: dict[ConditionKind, Callable[[TaskCondition, RunContext], bool]] = {
    ConditionKind.IS: _is,
    ConditionKind.SET: _set,
    ConditionKind.REPLY: _reply,
    ConditionKind.STALE: _stale,
    ConditionKind.DOUBTFUL: _doubtful,
    ConditionKind.NOT: lambda condition, context: not holds(condition.parts[0], context),
    ConditionKind.ALL: lambda condition, context: all(holds(p, context) for p in condition.parts),
    ConditionKind.ANY: lambda condition, context: any(holds(p, context) for p in condition.parts),
}
