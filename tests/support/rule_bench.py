"""What the tests of the rules share: a rule of any kind, a bell, a room that knows little."""

from __future__ import annotations

from housefly.hub.api.state_answers import Verdict
from housefly.messages import RoomEvent
from housefly.tasks.rules.rule import Rule
from housefly.tasks.rules.rule_file import parse_rules
from housefly.tasks.rules.trigger import EventTrigger

NOON = 1_763_812_800.0
"""22 November 2025, 12:00 UTC, a Saturday."""


class KnownRoom:
    """Answers from two tables; what is not in them nobody knows."""

    def __init__(self) -> None:
        self.states: dict[tuple[str, str], Verdict] = {}
        self.people: dict[str, Verdict] = {}
        self.asked = 0

    def state(self, thing: str, state: str, at: float) -> Verdict:
        """Return what the table says."""
        self.asked += 1
        return self.states.get((thing, state), "unknown")

    def presence(self, person: str, at: float) -> Verdict:
        """Return what the table says."""
        self.asked += 1
        return self.people.get(person, "unknown")


def make_rule(
    when: str = "{event: bell pressed}",
    then: str = "{service: look}",
    conditions: str = "{}",
    name: str = "bell",
    **more: str,
) -> Rule:
    """Return a rule; each value is YAML."""
    text = (
        f"rules:\n  - name: {name}\n    when: {when}\n    then: {then}\n    if: {conditions}\n"
        + "".join(f"    {key}: {value}\n" for key, value in more.items())
    )
    return parse_rules(text)[0]


def bell(at: float, **more: object) -> EventTrigger:
    """Return that the bell rang at a time [Unix time, s]."""
    return EventTrigger(RoomEvent("bell pressed", "doorbell", at, "doorbell", **more))  # type: ignore[arg-type]
