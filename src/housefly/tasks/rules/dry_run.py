"""What the rules would have done: what happened, and the times, again through the same engine."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from typing import Any

from housefly.config.house_mode import HouseMode
from housefly.hub.api.answers import EventAnswer
from housefly.hub.api.questions import EventsQuestion, Question
from housefly.messages import RoomEvent
from housefly.tasks.api.answers import FiringsAnswer, RuleFiring
from housefly.tasks.api.values import ReasonCode
from housefly.tasks.rules.mode_event import MODE_CHANGED, mode_after, mode_before
from housefly.tasks.rules.room_facts import RoomFacts
from housefly.tasks.rules.rule_engine import RuleEngine
from housefly.tasks.rules.rule_memory import RuleMemory
from housefly.tasks.rules.trigger import EventTrigger

_PAGE = 1000
"""Events that are asked for at once."""
MAX_FIRINGS = 1000
"""So many are answered, the newest."""


def event_of(answer: EventAnswer) -> RoomEvent:
    """Return an event as the room's memory told it."""
    return RoomEvent(
        answer.kind,
        answer.thing,
        answer.at,
        answer.source,
        answer.cause,
        answer.confidence,
        tuple(answer.facts.items()),
    )


def stored_events(
    ask: Callable[[Question], Any], since: float, until: float
) -> tuple[RoomEvent, ...]:
    """Return everything that a room remembers between two times [Unix time, s], by time."""
    found: dict[str, RoomEvent] = {}
    end = until
    while page := ask(EventsQuestion(since, end, limit=_PAGE)).events:
        events = [event_of(answer) for answer in page]
        found |= {EventTrigger(event).id: event for event in events}
        if len(page) < _PAGE or page[0].at >= end:
            break
        end = page[0].at
    return tuple(sorted(found.values(), key=lambda event: event.at))


def dry_run(
    engine: RuleEngine,
    events: Iterable[RoomEvent],
    since: float,
    until: float,
    mode: HouseMode,
    room: RoomFacts,
) -> FiringsAnswer:
    """Return what the rules would have done between two times; nothing flies.

    Args:
        engine: the rules.
        events: what happened, by time; the modes of the house are among it.
        since: begin [Unix time, s].
        until: end [Unix time, s].
        mode: of the house where the events do not say.
        room: answers the conditions as of then.
    """
    happened = [event for event in events if since <= event.at <= until]
    mode = next((mode_before(event) or mode for event in happened if _is_mode(event)), mode)
    memory, _ = engine.ticked(mode, since, RuleMemory(), room)
    firings: list[RuleFiring] = []
    for at, event in _in_order(engine, happened, since, until):
        if event is None:
            memory, decisions = engine.ticked(mode, at, memory, room)
        else:
            mode = mode_after(event) or mode
            memory, decisions = engine.heard(EventTrigger(event), mode, at, memory, room)
        firings += [decision.firing for decision in decisions]
    return FiringsAnswer(tuple(_joined(firings))[-MAX_FIRINGS:])


def _in_order(
    engine: RuleEngine, events: Iterable[RoomEvent], since: float, until: float
) -> Iterator[tuple[float, RoomEvent | None]]:
    """Yield events and the times of rules (with None), by time."""
    slot = engine.next_time(since)
    for event in events:
        while slot is not None and slot <= event.at:
            yield slot, None
            slot = engine.next_time(slot)
        yield event.at, event
    while slot is not None and slot <= until:
        yield slot, None
        slot = engine.next_time(slot)


def _is_mode(event: RoomEvent) -> bool:
    return event.kind == MODE_CHANGED


def _joined(firings: Iterable[RuleFiring]) -> Iterator[RuleFiring]:
    """Yield firings; refusals of one rule for one reason that follow each other are one."""
    last: RuleFiring | None = None
    times = 0
    for firing in firings:
        if last is not None and _is_again(last, firing):
            times += 1
            continue
        if last is not None:
            yield _counted(last, times)
        last, times = firing, 1
    if last is not None:
        yield _counted(last, times)


def _is_again(last: RuleFiring, firing: RuleFiring) -> bool:
    same = (last.rule, last.code) == (firing.rule, firing.code)
    return same and firing.code is not ReasonCode.OK


def _counted(firing: RuleFiring, times: int) -> RuleFiring:
    if times == 1:
        return firing
    return replace(firing, words=f"{firing.words} (and {times - 1} times more)")
