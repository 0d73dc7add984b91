"""The rules of a running house: hears what happens, tells what to do, keeps what it remembers."""

from __future__ import annotations

from dataclasses import dataclass, replace
from threading import Lock
from typing import Protocol

from housefly.config.house_mode import HouseMode
from housefly.messages import RoomEvent
from housefly.tasks.api.answers import ModeAnswer, RulesAnswer, RuleStatus
from housefly.tasks.rules.change_store import ChangeStore
from housefly.tasks.rules.mode_event import mode_event
from housefly.tasks.rules.mode_table import MODE_TABLE
from housefly.tasks.rules.room_facts import RoomFacts
from housefly.tasks.rules.rule_change import RuleChange, asking_first, with_changes
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
        changes: keeps what people changed on the page; None keeps nothing.

    Attributes:
        written: the rules as their files say.
        engine: the rules as they are now.
        problems: what of the changes is left aside, in words.
    """

    def __init__(
        self,
        engine: RuleEngine,
        store: RulesKeeper,
        room: RoomFacts,
        problem: str = "",
        changes: ChangeStore | None = None,
    ) -> None:
        self.written, self._problem = engine.rules, problem
        self._store, self._room, self._lock = store, room, Lock()
        self._change_store = changes
        self._changes = changes.load() if changes else {}
        rules, self.problems = with_changes(self.written, self._changes)
        if changes and changes.problem:
            rules, self.problems = asking_first(rules), (changes.problem,)
        self.engine = engine.with_rules(rules)
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

    def change(self, name: str, change: RuleChange | None) -> None:
        """Change a rule and keep that; None makes it again as its file says.

        Raises:
            TaskError: it cannot be so.
            StoreError: it cannot be kept; nothing is changed then.
        """
        with self._lock:
            changes = {one: kept for one, kept in self._changes.items() if one != name}
            if change is not None:
                changes[name] = self._changes.get(name, RuleChange()).and_then(change)
            rules, _ = with_changes(self.written, changes)
            if self._change_store is not None:
                self._change_store.keep(changes)
            self._changes = changes
            self.engine = self.engine.with_rules(rules)

    def mode_answer(self) -> ModeAnswer:
        """Return the mode, and what it allows."""
        return ModeAnswer(self._mode, MODE_TABLE[self._mode].words)

    def rules_answer(self) -> RulesAnswer:
        """Return the rules and what each did last; what is wrong with one's own stands first."""
        by = {name: change.by for name, change in self._changes.items()}
        rules = tuple(
            replace(one, changed_by=by.get(one.name, ""))
            for one in self.engine.statuses(self._memory)
        )
        if not self._problem:
            return RulesAnswer(rules)
        words = f"left aside until the next start: {self._problem}"
        return RulesAnswer((RuleStatus("own rules", words, False), *rules))

    def _remember(self, memory: RuleMemory) -> None:
        before, self._memory = self._memory, memory
        # What only was looked at is not worth a write: an event storm must not wear the disk.
        if (before.fired, before.slots) != (memory.fired, memory.slots):
            self._store.keep(KeptRules(self._mode, memory))
