"""Answers what happened, and who came when."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from housefly.hub.api.answers import EventAnswer
from housefly.hub.situations.kinds import SituationKind
from housefly.tasks.intents.answer_people import BELL
from housefly.tasks.intents.asking import Asking
from housefly.tasks.intents.intent_reply import IntentReply
from housefly.tasks.intents.time_span import TimeSpan, spans_of

_DAY = 86400.0
_MOST_LINES = 8
_ONE_VISIT = 180.0
"""Bell and person within this time are one visit [s]."""
_MOST_EVENTS = 2000
TOLD_KINDS = (
    BELL,
    SituationKind.AT_ENTRANCE,
    SituationKind.PERSON_FALLEN,
    SituationKind.BED_OCCUPIED,
    SituationKind.BED_OCCUPIED.ended,
    SituationKind.APPLIANCE_ON,
    SituationKind.APPLIANCE_ON.ended,
    SituationKind.DOOR_OPEN_LONG,
    SituationKind.OBJECT_TAKEN,
    SituationKind.OBJECT_PUT,
    SituationKind.OBJECT_MISSING,
)
"""Events that people are told of; phrases are named after them."""


@dataclass(frozen=True, slots=True)
class _Visit:
    """Somebody at the door: when, who ("" when nobody knows), and whether they rang."""

    at: float
    who: str
    rang: bool


def answer_what_happened(asking: Asking) -> IntentReply:
    """Return what happened in a time, the newest last."""
    say, subject = asking.say, asking.subject()
    for span in spans_of(asking.slots, asking.now, _DAY):
        events = [
            one
            for one in _events(asking, span, "" if subject is None else subject.thing)
            if one.kind in TOLD_KINDS
        ]
        if events:
            lines = [_line(asking, one) for one in events[-_MOST_LINES:]]
            more = len(events) - len(lines)
            head = [say("and_more", count=more)] if more else []
            return IntentReply(say.joined(*head, *lines))
    return IntentReply(say("nothing_happened", span=_span_words(asking)))


def answer_came_at(asking: Asking) -> IntentReply:
    """Return who came at a time."""
    say = asking.say
    for span in spans_of(asking.slots, asking.now, _DAY):
        visits = _visits(
            [one for one in _events(asking, span) if one.kind in (BELL, SituationKind.AT_ENTRANCE)]
        )
        if visits:
            return IntentReply(say.joined(*(_visit(asking, one) for one in visits[-_MOST_LINES:])))
    return IntentReply(say("nobody_came", span=_span_words(asking)))


def _events(asking: Asking, span: TimeSpan, thing: str = "") -> tuple[EventAnswer, ...]:
    return asking.room.events(span.since, span.until, thing, limit=_MOST_EVENTS)


def _line(asking: Asking, event: EventAnswer) -> str:
    say = asking.say
    who = say.name(event.cause) if event.cause else None
    key = f"event {event.kind}"
    if who is not None and f"{key} by" in say.say.texts:
        words = say(f"{key} by", thing=say.name(event.thing), person=who)
    else:
        words = say(key, thing=say.name(event.thing))
    return say("line", clock=say.clock(event.at), words=words)


def _visits(events: Sequence[EventAnswer]) -> list[_Visit]:
    visits: list[_Visit] = []
    for event in events:
        rang = event.kind == BELL
        if visits and event.at - visits[-1].at < _ONE_VISIT:
            last = visits.pop()
            visits.append(_Visit(last.at, last.who or event.cause, last.rang or rang))
        else:
            visits.append(_Visit(event.at, event.cause, rang))
    return visits


def _visit(asking: Asking, visit: _Visit) -> str:
    say = asking.say
    rang = "_rang" if visit.rang else ""
    clock = say.clock(visit.at)
    if visit.who:
        return say(f"came{rang}", person=say.name(visit.who), clock=clock)
    return say(f"somebody_came{rang}", clock=clock)


def _span_words(asking: Asking) -> str:
    """Return the time that was looked through: "between 22:00 and 6:00"."""
    span = spans_of(asking.slots, asking.now, _DAY)[0]
    say = asking.say
    return say("between", since=say.clock(span.since), until=say.clock(span.until))
