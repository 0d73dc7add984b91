"""What a rule waits for that can never come."""

from __future__ import annotations

from collections.abc import Iterator
from difflib import get_close_matches

from housefly.hub.situations.kinds import SituationKind
from housefly.hub.state_queries import STATE_WORDS
from housefly.tasks.rules.rule import (
    EventPattern,
    Hours,
    MqttPattern,
    Rule,
    SituationPattern,
    TimePattern,
)
from housefly.wires.devices import KINDS
from housefly.wires.devices.fields import plain_number

_SITUATIONS = tuple(SituationKind)
_EVENTS = (
    *_SITUATIONS,
    *(kind.ended for kind in SituationKind),
    *dict.fromkeys(event for kind in KINDS.values() for event in kind.events.values()),
)


def impossibilities(rule: Rule) -> Iterator[str]:
    """Yield what of a rule can never hold, a sentence each."""
    match rule.when:
        case MqttPattern():
            yield from _of_message(rule.when)
        case SituationPattern(situation=kind) if kind not in _SITUATIONS:
            yield f"there is no situation {kind!r}; there is: {', '.join(_SITUATIONS)}"
        case EventPattern(event=kind) if kind not in _EVENTS:
            for close in get_close_matches(kind, _EVENTS, 1, 0.8):
                yield f"no event is called {kind!r}; did you mean {close!r}?"
        case TimePattern(at=times) if times:
            if rule.quiet and all(rule.quiet.hold(at) for at in times):
                yield f"it comes only in its quiet hours, {rule.quiet}"
            between = rule.conditions.between
            if between and not any(between.hold(at) for at in times):
                yield f"it never comes in if.between, {between}"
    for condition in rule.conditions.states:
        state = " ".join(condition.state.lower().split())
        if state not in STATE_WORDS:
            close = "".join(
                f"; did you mean {word!r}?" for word in get_close_matches(state, STATE_WORDS, 1)
            )
            yield f"nothing is ever {condition.state!r}{close or _all_states()}"
    if rule.conditions.between and _is_empty(rule.conditions.between):
        yield f"if.between, {rule.conditions.between}, is no time at all"


def _of_message(pattern: MqttPattern) -> Iterator[str]:
    """Yield what no message can say."""
    above, below, value = pattern.above, pattern.below, pattern.value
    what = pattern.field or "a value"
    if above is not None and below is not None and above >= below:
        yield f"{what} is never above {above:g} and below {below:g} at once"
    if value is None or (above is None and below is None):
        return
    number = plain_number(value) if isinstance(value, str) else value
    if isinstance(number, bool) or number is None:
        yield f"{what} is never {value!r} and above or below a number at once"
    elif (above is not None and number <= above) or (below is not None and number >= below):
        yield f"value is {value!r}, which is not within above and below"


def _all_states() -> str:
    return f"; allowed: {', '.join(sorted(STATE_WORDS))}"


def _is_empty(hours: Hours) -> bool:
    return hours.begin == hours.end
