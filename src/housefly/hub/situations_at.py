"""What held at a time, by the events that began and ended it."""

from __future__ import annotations

from collections.abc import Iterable

from housefly.hub.api.answers import SituationAnswer
from housefly.hub.said import situation_words
from housefly.hub.situations.kinds import BEGUN_BY
from housefly.hub.situations.situation import SOURCE_PREFIX
from housefly.messages import Facts, RoomEvent

MEMORY_STARTED = "memory started"
"""The event before which nobody knows what happened to what held."""
_PASSING = frozenset(
    {"x", "y", "sigma", "speed", "load", "power", "open_for", "evidence", "sources", "noticed_at"}
)
"""Facts that change while a situation holds, and those that are told elsewhere."""


def situations_at(events: Iterable[RoomEvent]) -> tuple[SituationAnswer, ...]:
    """Return what held after events in order of time; a start of the memory ends what it held."""
    holds: dict[tuple[str, str], SituationAnswer] = {}
    for event in events:
        if event.kind == MEMORY_STARTED:
            holds.clear()
        elif not event.source.startswith(SOURCE_PREFIX):
            continue
        elif (over := BEGUN_BY.get(event.kind)) is not None:
            holds.pop((event.thing, over), None)
        else:
            facts = dict(event.facts)
            sources = str(facts.get("sources", ""))
            holds[event.thing, event.kind] = SituationAnswer(
                event.kind, event.thing, event.at, event.confidence, str(facts.get("evidence", "")),
                lasting_facts(event.facts), tuple(filter(None, sources.split(","))),
                situation_words(event.kind),
            )  # fmt: skip
    return tuple(holds.values())


def lasting_facts(facts: Facts) -> dict[str, str | float | bool]:
    """Return the facts that last as long as a situation does."""
    return {name: value for name, value in facts if name not in _PASSING}
