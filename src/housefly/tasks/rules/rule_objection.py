"""Why a rule does not fire: mode, time, how sure, how often, what holds in the room."""

from __future__ import annotations

import re
from dataclasses import dataclass
from datetime import tzinfo

from housefly.config.house_mode import HouseMode
from housefly.tasks.api.values import ParameterValue, ReasonCode
from housefly.tasks.rules.room_facts import RoomFacts
from housefly.tasks.rules.rule import REFERENCE, Conditions, Rule
from housefly.tasks.rules.rule_memory import RuleMemory
from housefly.tasks.rules.time_slots import local_time
from housefly.tasks.rules.trigger import EventTrigger, TimeTrigger, Trigger, is_own, value_of

MAX_AGE = 60.0
"""Who flies for something that is heard later than this [s] comes too late."""
MAX_DEPTH = 3
"""So many rules may stand behind a flight, each set off by the flight before it."""
_HOUR = 3600.0
_CAUSE = re.compile(r"rule:([a-z0-9][a-z0-9_-]*)")


@dataclass(frozen=True, slots=True)
class RuleObjection:
    """Why a rule does not fire."""

    code: ReasonCode
    words: str


def depth_of(trigger: Trigger, now: float, memory: RuleMemory) -> int:
    """Return how many rules stand behind a trigger; where it does not say, the worst case."""
    if not isinstance(trigger, EventTrigger) or not is_own(trigger):
        return 0
    event = trigger.event
    because = _CAUSE.match(str(dict(event.facts).get("because", "")) or event.cause)
    if because:
        return memory.depths.get(because[1], 1)
    recent = (name for name, times in memory.fired.items() if times and times[-1] > now - _HOUR)
    return max((memory.depths.get(name, 1) for name in recent), default=0)


def too_late(trigger: Trigger, now: float) -> RuleObjection | None:
    """Return that a trigger was heard too late to fly for."""
    age = now - trigger.at
    if isinstance(trigger, TimeTrigger) or age <= MAX_AGE:
        return None
    return RuleObjection(ReasonCode.DEADLINE, f"heard {age:.0f} s late: too late to fly for")


def too_deep(depth: int) -> RuleObjection | None:
    """Return that too many rules stand behind a trigger."""
    if depth <= MAX_DEPTH:
        return None
    return RuleObjection(ReasonCode.RATE_LIMIT, f"{MAX_DEPTH} rules stand behind it already")


def wrong_mode(conditions: Conditions, mode: HouseMode) -> RuleObjection | None:
    """Return that the rule is made for other modes of the house."""
    if not conditions.mode or mode.value in conditions.mode:
        return None
    words = f"the house is in mode {mode.value}, not {' or '.join(conditions.mode)}"
    return RuleObjection(ReasonCode.MODE, words)


def too_unsure(conditions: Conditions, trigger: Trigger) -> RuleObjection | None:
    """Return that an event is less sure than the rule wants."""
    if not isinstance(trigger, EventTrigger):
        return None
    confidence = trigger.event.confidence
    if confidence >= conditions.confidence:
        return None
    words = f"{100 * confidence:.0f} % sure, less than {100 * conditions.confidence:.0f} %"
    return RuleObjection(ReasonCode.CONDITION, words)


def too_often(rule: Rule, now: float, memory: RuleMemory) -> RuleObjection | None:
    """Return that the rule rests, or fired as often as it may."""
    fired = memory.firings(rule.name, now)
    left = rule.cooldown - (now - fired[-1]) if fired else 0.0
    if left > 0.0:
        words = f"it fired {now - fired[-1]:.0f} s ago and rests for {left:.0f} s more"
        return RuleObjection(ReasonCode.COOLDOWN, words)
    if sum(at > now - _HOUR for at in fired) >= rule.per_hour:
        return RuleObjection(ReasonCode.RATE_LIMIT, f"it fired {rule.per_hour} times in an hour")
    if len(fired) >= rule.per_day:
        return RuleObjection(ReasonCode.RATE_LIMIT, f"it fired {rule.per_day} times in a day")
    return None


def wrong_state(conditions: Conditions, now: float, room: RoomFacts) -> RuleObjection | None:
    """Return that a state or somebody's presence does not hold, or that nobody knows."""
    for item in conditions.states:
        found = room.state(item.thing, item.state, now)
        if found != item.answer:
            words = f"{item.thing} {item.state}: {found}, not {item.answer}"
            return RuleObjection(ReasonCode.CONDITION, words)
    for person, wanted in ((conditions.present, "yes"), (conditions.absent, "no")):
        seen = room.presence(person, now) if person else wanted
        if seen != wanted:
            return RuleObjection(ReasonCode.CONDITION, f"{person} is there: {seen}, not {wanted}")
    return None


def never_asks(rule: Rule) -> RuleObjection | None:
    """Return that the rule only tells."""
    if rule.confirm != "never":
        return None
    return RuleObjection(ReasonCode.NOT_ALLOWED, "the rule never asks for a flight; it only tells")


def wrong_time(rule: Rule, now: float, zone: tzinfo | None) -> RuleObjection | None:
    """Return that the local time is outside the rule's hours, or in its quiet ones."""
    at, between = local_time(now, zone), rule.conditions.between
    if between is not None and not between.hold(at):
        return RuleObjection(ReasonCode.CONDITION, f"it is {at:%H:%M}, not {between}")
    if rule.quiet is not None and rule.quiet.hold(at):
        return RuleObjection(ReasonCode.QUIET_HOURS, f"quiet hours, {rule.quiet}")
    return None


def taken_parameters(rule: Rule, trigger: Trigger) -> dict[str, ParameterValue] | RuleObjection:
    """Return the parameters with what they take from the trigger: whole values, never text."""
    found: dict[str, ParameterValue] = {}
    for name, value in rule.then.parameters.items():
        match = REFERENCE.fullmatch(value) if isinstance(value, str) else None
        taken = value_of(trigger, match[2], rule.when) if match else value
        if taken is None:
            return RuleObjection(ReasonCode.BAD_PARAMETER, f"{name}: {value} says nothing here")
        found[name] = taken
    return found
