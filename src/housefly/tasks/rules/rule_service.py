"""The rules of a running house: hears what happens, tells what to do, keeps what it remembers."""

from __future__ import annotations

from dataclasses import dataclass
from threading import Lock
from typing import Protocol

from housefly.config.house_mode import HouseMode
from housefly.messages import RoomEvent
from housefly.tasks.api.answers import ModeAnswer, RulesAnswer, RuleStatus
from housefly.tasks.rules.mode_event import mode_event
from housefly.tasks.rules.mode_table import MODE_TABLE
from housefly.tasks.rules.room_facts import RoomFacts
from housefly.tasks.rules.rule_engine import RuleDecision, RuleEngine
from housefly.tasks.rules.rule_memory import RuleMemory
from housefly.tasks.rules.rule_store import KeptRules
from housefly.tasks.rules.trigger import Trigger


class RulesKeeper(Protocol):
    """Keeps the mode and the memory of the rules."""

    def load(self) -> KeptRules:
        """Return what was kept."""
        ...

    def keep(self, kept: KeptRules) -> None:
        """Keep it."""
        ...


@dataclass(frozen=True, slots=True)
class ModeChange:
    """What a change of the mode answers, and the event that tells of it; None for no change."""

    answer: ModeAnswer
    event: RoomEvent | None


class RuleService:
    """Runs the rules; may be called from any thread.

    Args:
        engine: the rules.
        store: keeps mode and memory.
        room: answers their conditions.
        problem: what is wrong with one's own rules, which are left aside then; "" for nothing.
    """

    def __init__(
        self, engine: RuleEngine, store: RulesKeeper, room: RoomFacts, problem: str = ""
    ) -> None:
        self.engine, self._problem = engine, problem
        self._store, self._room, self._lock = store, room, Lock()
        kept = store.load()
        self._mode = kept.mode
        self._memory = kept.memory.of_rules(frozenset(rule.name for rule in engine.rules))

    @property
    def mode(self) -> HouseMode:
        """The mode of the house."""
        return self._mode

    def heard(self, trigger: Trigger, now: float) -> tuple[RuleDecision, ...]:
        """Return what the rules do about a trigger; raises StoreError when it cannot be kept."""
        with self._lock:
            memory, decisions = self.engine.heard(
                trigger, self._mode, now, self._memory, self._room
            )
            self._remember(memory)
            return decisions

    def ticked(self, now: float) -> tuple[RuleDecision, ...]:
        """Return what the rules do because it is time; call it about once a second."""
        with self._lock:
            memory, decisions = self.engine.ticked(self._mode, now, self._memory, self._room)
            self._remember(memory)
            return decisions

    def set_mode(self, mode: HouseMode, by: str, now: float) -> ModeChange:
        """Set the mode of the house and keep it, before anybody is told."""
        with self._lock:
            before = self._mode
            if mode is not before:
                self._store.keep(KeptRules(mode, self._memory))
                self._mode = mode
        event = mode_event(mode, before, by, now) if mode is not before else None
        return ModeChange(self.mode_answer(), event)

    def mode_answer(self) -> ModeAnswer:
        """Return the mode, and what it allows."""
        return ModeAnswer(self._mode, MODE_TABLE[self._mode].words)

    def rules_answer(self) -> RulesAnswer:
        """Return the rules and what each did last; what is wrong with one's own stands first."""
        rules = self.engine.statuses(self._memory)
        if not self._problem:
            return RulesAnswer(rules)
        words = f"left aside until the next start: {self._problem}"
        return RulesAnswer((RuleStatus("own rules", words, False), *rules))

    def _remember(self, memory: RuleMemory) -> None:
        before, self._memory = self._memory, memory
        # What only was looked at is not worth a write: an event storm must not wear the disk.
        if (before.fired, before.slots) != (memory.fired, memory.slots):
            self._store.keep(KeptRules(self._mode, memory))
