"""What people are told of events and situations: words, made from their kinds and facts."""

from __future__ import annotations

from housefly.hub.api.answers import EventAnswer
from housefly.hub.flight_facts import PILOT
from housefly.hub.situations.kinds import SituationKind
from housefly.messages import RoomEvent
from housefly.messages.words import Words, literal

_SITUATIONS: dict[str, Words] = {
    SituationKind.PERSON_PRESENT: Words("present"),
    SituationKind.PERSON_WALKING: Words("walking"),
    SituationKind.PERSON_STANDING: Words("standing"),
    SituationKind.PERSON_SITTING: Words("sitting"),
    SituationKind.PERSON_LYING: Words("lying"),
    SituationKind.PERSON_FALLEN: Words("fallen"),
}
"""What is said of a person beside the name; of a thing it is the kind itself."""


def situation_words(kind: str) -> Words:
    """Return what a situation says of its thing, beside the thing's name."""
    return _SITUATIONS.get(kind) or literal(kind)


def event_words(event: RoomEvent) -> Words:
    """Return what happened: of the pilot's events its own words, else the kind."""
    own = dict(event.facts).get("words") if event.source == PILOT else None
    return literal(own if isinstance(own, str) and own else event.kind)


def event_answer(event: RoomEvent) -> EventAnswer:
    """Return an event in the form of an answer."""
    h, facts = event, dict(event.facts)
    return EventAnswer(
        h.kind, h.thing, h.at, h.source, h.cause, h.confidence, facts, event_words(event)
    )
