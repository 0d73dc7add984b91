"""Decides what the rules do when something happens: pure, its memory goes in and comes out."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from datetime import tzinfo

from housefly.config.house_mode import HouseMode
from housefly.messages.words import Words
from housefly.tasks.api.answers import RuleFiring, RuleStatus
from housefly.tasks.api.values import Confirm, Priority, ReasonCode, RequestSurface, TaskRequest
from housefly.tasks.rules.mode_table import launch_permit
from housefly.tasks.rules.room_facts import RoomFacts
from housefly.tasks.rules.rule import Rule, TimePattern
from housefly.tasks.rules.rule_memory import RuleMemory
from housefly.tasks.rules.rule_objection import (
    RuleObjection,
    depth_of,
    never_asks,
    taken_parameters,
    too_deep,
    too_late,
    too_often,
    too_unsure,
    wrong_mode,
    wrong_state,
    wrong_time,
)
from housefly.tasks.rules.spoken_rule import spoken_when
from housefly.tasks.rules.time_slots import last_slot, next_slot
from housefly.tasks.rules.trigger import TimeTrigger, Trigger, fits

SLOT_GRACE = 600.0
"""A time that was missed by more than this [s], because nothing ran, is skipped."""
ASKS_FIRST, ASKS_FOR_TASK = Words("somebody is asked first"), Words("its task is asked for")
"""What a rule that fires does: still true when somebody has said no."""
_HOUR = 3600.0
_CLOCK_ERROR = 26 * _HOUR
"""A time of a rule that is done and lies further ahead was done by a wrong clock [s]."""
_LONGEST_CAUSE = 100


@dataclass(frozen=True, slots=True)
class RuleDecision:
    """What a rule does, and the request that it makes; None when it makes none."""

    firing: RuleFiring
    request: TaskRequest | None = None


class RuleEngine:
    """The rules of a house.

    Args:
        rules: all of them; those that are off do nothing.
        zone: of local times; None is this machine's.
    """

    def __init__(self, rules: Iterable[Rule], zone: tzinfo | None = None) -> None:
        self.rules = tuple(rules)
        self._zone = zone
        self._enabled = tuple(rule for rule in self.rules if rule.enabled)

    def with_rules(self, rules: Iterable[Rule]) -> RuleEngine:
        """Return an engine of other rules, with the same local time."""
        return RuleEngine(rules, self._zone)

    def heard(
        self,
        trigger: Trigger,
        mode: HouseMode,
        now: float,
        memory: RuleMemory,
        room: RoomFacts,
    ) -> tuple[RuleMemory, tuple[RuleDecision, ...]]:
        """Return what the rules do about a trigger, and what they remember of it.

        Args:
            trigger: what happened.
            mode: of the house.
            now: Unix time [s].
            memory: what they remember.
            room: answers their conditions.
        """
        memory = memory.settled(now)
        waiting = [rule for rule in self._enabled if fits(rule.when, trigger, rule.name)]
        if not waiting or trigger.id in memory.seen:
            return memory, ()
        memory = memory.with_seen(trigger.id)
        decisions = []
        for rule in waiting:
            decision, depth = self._decided(rule, trigger, mode, now, memory, room)
            memory = memory.noted(decision.firing, depth)
            decisions.append(decision)
        return memory, tuple(decisions)

    def ticked(
        self, mode: HouseMode, now: float, memory: RuleMemory, room: RoomFacts
    ) -> tuple[RuleMemory, tuple[RuleDecision, ...]]:
        """Return what the rules do because it is time; call it about once a second."""
        decisions: list[RuleDecision] = []
        for rule in self._enabled:
            if not isinstance(rule.when, TimePattern):
                continue
            slot, memory = self._due(rule, rule.when, now, memory)
            if slot is None:
                continue
            trigger = TimeTrigger(rule.name, slot)
            if now - slot > SLOT_GRACE:
                words = f"nothing ran at that time; {(now - slot) / 60:.0f} min later is too late"
                decision = _not_fired(rule, trigger, now, RuleObjection(ReasonCode.DEADLINE, words))
                memory = memory.noted(decision.firing, None)
                decisions.append(decision)
                continue
            memory, made = self.heard(trigger, mode, now, memory, room)
            decisions += made
        return memory, tuple(decisions)

    def next_time(self, after: float) -> float | None:
        """Return when the next time of a rule comes [Unix time, s]."""
        slots = [
            next_slot(rule.when, after, self._zone)
            for rule in self._enabled
            if isinstance(rule.when, TimePattern)
        ]
        return min((slot for slot in slots if slot is not None), default=None)

    def statuses(self, memory: RuleMemory) -> tuple[RuleStatus, ...]:
        """Return each rule and what it did last."""
        found = []
        for rule in self.rules:
            last = memory.last.get(rule.name)
            at, words, cause = (last.at, last.words, last.cause) if last else (None, "", "")
            status = RuleStatus(
                rule.name,
                rule.about or rule.words(),
                rule.enabled,
                at,
                words,
                cause,
                spoken_when(rule),
                rule.then.service,
                Confirm(rule.confirm),
                tuple(map(HouseMode, rule.conditions.mode)),
                is_remembered=rule.when.kind not in ("mqtt", "webhook"),
            )
            found.append(status)
        return tuple(found)

    def _due(
        self, rule: Rule, pattern: TimePattern, now: float, memory: RuleMemory
    ) -> tuple[float | None, RuleMemory]:
        """Return the time of a rule that is to be dealt with now, None for none."""
        done = memory.slots.get(rule.name)
        ahead = pattern.every or _CLOCK_ERROR
        if done is None or done > now + ahead:
            return None, memory.with_slot(rule.name, now)
        slot = last_slot(pattern, now, self._zone)
        if slot is None or slot <= done:
            return None, memory
        return slot, memory.with_slot(rule.name, slot)

    def _decided(
        self,
        rule: Rule,
        trigger: Trigger,
        mode: HouseMode,
        now: float,
        memory: RuleMemory,
        room: RoomFacts,
    ) -> tuple[RuleDecision, int | None]:
        depth = 1 + depth_of(trigger, now, memory)
        confirm, priority = Confirm(rule.confirm), Priority(rule.priority)
        permit = launch_permit(
            mode,
            RequestSurface.RULE,
            confirm=confirm,
            priority=priority,
            names_mode=mode.value in rule.conditions.mode,
        )
        parameters = taken_parameters(rule, trigger)
        objection = (
            too_late(trigger, now)
            or too_deep(depth)
            or wrong_mode(rule.conditions, mode)
            or (None if permit.is_given else RuleObjection(permit.code, permit.words))
            or wrong_time(rule, now, self._zone)
            or too_unsure(rule.conditions, trigger)
            or too_often(rule, now, memory)
            or wrong_state(rule.conditions, now, room)
            or (parameters if isinstance(parameters, RuleObjection) else None)
            or never_asks(rule)
        )
        if objection is not None or isinstance(parameters, RuleObjection):
            assert objection is not None
            return _not_fired(rule, trigger, now, objection), None
        request = TaskRequest(
            rule.then.service,
            parameters,
            f"rule {rule.name}",
            RequestSurface.RULE,
            _cause(rule, trigger),
            permit.confirm,
            priority,
            now + rule.deadline if rule.deadline else None,
        )
        asks = permit.confirm is Confirm.ASK
        words = ASKS_FIRST if asks else ASKS_FOR_TASK
        firing = RuleFiring(rule.name, now, trigger.id, rule.then.service, ReasonCode.OK, words)
        return RuleDecision(firing, request), depth


def _not_fired(rule: Rule, trigger: Trigger, now: float, why: RuleObjection) -> RuleDecision:
    return RuleDecision(
        RuleFiring(rule.name, now, trigger.id, rule.then.service, why.code, why.words)
    )


def _cause(rule: Rule, trigger: Trigger) -> str:
    words = f"rule:{rule.name} {trigger.id}"
    return "".join(letter for letter in words if letter.isprintable())[:_LONGEST_CAUSE]
