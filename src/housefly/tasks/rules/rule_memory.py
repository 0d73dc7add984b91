"""What the rules remember between two triggers: a value, kept as JSON over a restart."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from pydantic import TypeAdapter, ValidationError

from housefly.errors import WireError
from housefly.tasks.api.answers import RuleFiring

DAY = 86400.0
SEEN_MAX = 512
"""So many triggers are remembered, to know one that comes twice."""


@dataclass(frozen=True, slots=True)
class RuleMemory:
    """What the rules remember.

    Attributes:
        fired: by rule, when it fired within the last day [Unix time, s], by time.
        slots: by rule, the last time of its times that was dealt with [Unix time, s].
        depths: by rule, how many rules stand behind its last firing.
        last: by rule, what it did last.
        seen: ids of the last triggers, the newest last.
    """

    fired: Mapping[str, tuple[float, ...]] = field(default_factory=dict)
    slots: Mapping[str, float] = field(default_factory=dict)
    depths: Mapping[str, int] = field(default_factory=dict)
    last: Mapping[str, RuleFiring] = field(default_factory=dict)
    seen: tuple[str, ...] = ()

    def firings(self, rule: str, now: float) -> tuple[float, ...]:
        """Return when a rule fired within the last day [Unix time, s]."""
        return tuple(at for at in self.fired.get(rule, ()) if at > now - DAY)

    def settled(self, now: float) -> RuleMemory:
        """Return the memory with no firing ahead of now [Unix time, s].

        A clock that was set back must not keep a rule silent until it is there again.
        """
        if all(at <= now for times in self.fired.values() for at in times):
            return self
        fired = {name: tuple(min(at, now) for at in times) for name, times in self.fired.items()}
        return replace(self, fired=fired)

    def noted(self, firing: RuleFiring, depth: int | None) -> RuleMemory:
        """Return the memory after a rule did something; ``depth`` None says it asked for nothing.

        Of what a rule did not do, the reason is kept, not each time.
        """
        name, last = firing.rule, {**self.last, firing.rule: firing}
        if depth is None:
            return replace(self, last=last)
        fired = (*self.firings(name, firing.at), firing.at)
        return replace(
            self,
            last=last,
            fired={**self.fired, name: fired},
            depths={**self.depths, name: depth},
        )

    def with_seen(self, trigger: str) -> RuleMemory:
        """Return the memory with one more trigger."""
        return replace(self, seen=(*self.seen, trigger)[-SEEN_MAX:])

    def with_slot(self, rule: str, slot: float) -> RuleMemory:
        """Return the memory with a time of a rule that was dealt with."""
        return replace(self, slots={**self.slots, rule: slot})

    def of_rules(self, names: frozenset[str]) -> RuleMemory:
        """Return the memory without rules that are no longer there."""
        return RuleMemory(
            {name: at for name, at in self.fired.items() if name in names},
            {name: at for name, at in self.slots.items() if name in names},
            {name: depth for name, depth in self.depths.items() if name in names},
            {name: last for name, last in self.last.items() if name in names},
            self.seen,
        )


_MEMORY: TypeAdapter[RuleMemory] = TypeAdapter(RuleMemory)


def memory_to_json(memory: RuleMemory) -> str:
    """Return the memory as JSON."""
    return _MEMORY.dump_json(memory).decode()


def memory_from_json(text: str) -> RuleMemory:
    """Return the memory; raises WireError when the text is none."""
    try:
        return _MEMORY.validate_json(text)
    except ValidationError as error:
        raise WireError(f"no memory of rules: {error.errors()[0]['msg']}") from error
