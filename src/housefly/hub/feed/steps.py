"""What one event adds to an entry of the feed, in a few words; nothing when it adds nothing."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from housefly.hub.api.answers import EventAnswer
from housefly.hub.person_status import SEAT
from housefly.hub.situations.kinds import OF_PEOPLE, SituationKind
from housefly.messages.words import UNSAID, Words, figure, joined, literal

IS_OF_PERSON = OF_PEOPLE | {SituationKind(kind).ended for kind in OF_PEOPLE}
"""Kinds of events whose thing is a person."""
ALARMS: frozenset[str] = frozenset(
    {SituationKind.PERSON_FALLEN, SituationKind.OBJECT_MISSING, SituationKind.DOOR_OPEN_LONG}
)
"""Kinds at which somebody should look."""
_PERSON: dict[str, Words] = {
    SituationKind.PERSON_FALLEN: Words("may have fallen"),
    SituationKind.PERSON_FALLEN.ended: Words("up again"),
    SituationKind.PERSON_PRESENT.ended: Words("out of sight"),
}
_SITS = (SituationKind.PERSON_SITTING, SituationKind.PERSON_LYING)
_STANDS = (SituationKind.PERSON_STANDING, SituationKind.PERSON_PRESENT)
_THING: dict[str, Words] = {
    SituationKind.APPLIANCE_ON: Words("on"),
    SituationKind.APPLIANCE_ON.ended: Words("off"),
    SituationKind.CONTACT_OPEN: Words("open"),
    SituationKind.CONTACT_OPEN.ended: Words("closed"),
    "door opened": Words("open"),
    "door closed": Words("closed"),
    SituationKind.DOOR_OPEN_LONG: Words("open for too long"),
    SituationKind.DOOR_OPEN_LONG.ended: Words("closed"),
    SituationKind.BED_OCCUPIED: Words("somebody is in it"),
    SituationKind.BED_OCCUPIED.ended: Words("empty"),
    "bed left": Words("empty"),
    SituationKind.OBJECT_MISSING: Words("missing"),
    SituationKind.OBJECT_MISSING.ended: Words("back"),
    SituationKind.AT_ENTRANCE: Words("somebody is there"),
    SituationKind.AT_ENTRANCE.ended: Words("nobody is there"),
    "bell pressed": Words("rang"),
    "motion seen": Words("saw motion"),
}
_NOT_TOLD = frozenset({"memory started"})
_ARTICLE = re.compile(r"^the ", re.IGNORECASE)


def then(steps: Sequence[Words]) -> Words:
    """Return steps one after the other: "kitchen, then sofa"; UNSAID for none."""
    words = steps[0] if steps else UNSAID
    for step in steps[1:]:
        words = Words("{first}, then {next}", first=words, next=step)
    return words


def flown(seconds: float) -> Words:
    """Return how long a flight was."""
    return Words("{n} s in the air", n=figure(seconds, ".0f"))


def person_step(event: EventAnswer, spot: Callable[[float, float], str]) -> Words:
    """Return where somebody is now; UNSAID where an event does not say."""
    if event.kind in _PERSON:
        return _PERSON[event.kind]
    facts = event.facts
    if event.kind in _SITS and facts.get("on"):
        on = str(facts["on"])
        return literal(SEAT.sub("", on) or on)
    x, y = facts.get("x"), facts.get("y")
    if event.kind in _STANDS and isinstance(x, float) and isinstance(y, float):
        return literal(bare(spot(x, y)))
    return UNSAID


def thing_step(event: EventAnswer, name: Callable[[str], str]) -> Words:
    """Return where a thing is now, or what happened to it; UNSAID for what only the log tells."""
    if event.kind in _NOT_TOLD:
        return UNSAID
    if event.kind == SituationKind.OBJECT_TAKEN:
        return Words("with {who}", who=name(event.cause)) if event.cause else Words("taken")
    if event.kind == SituationKind.OBJECT_PUT:
        place = str(event.facts.get("into", ""))
        return literal(bare(name(place))) if place else Words("put down")
    return _THING.get(event.kind) or event.words


def task_step(event: EventAnswer) -> Words:
    """Return what became of a task."""
    words = literal(str(event.facts.get("words", "")))
    if event.kind == "task asked":
        return Words("asked for by {who}", who=str(event.facts.get("by", "")))
    if event.kind == "person answered":
        return joined(": ", (str(event.facts.get("by") or "?"), words))
    return words


def bare(name: str) -> str:
    """Return a name as it stands in a list of places: "the Kitchen" is "kitchen", "TV" stays."""
    name = _ARTICLE.sub("", name)
    return name[:1].lower() + name[1:] if name[1:2].islower() else name
