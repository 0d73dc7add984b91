"""How one person is, from the situations that hold, in a sentence."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection
from dataclasses import dataclass
from math import hypot

from housefly.geometry import Vec3
from housefly.hub.api.answers import SituationAnswer
from housefly.hub.api.state_answers import PersonAnswer, Verdict
from housefly.hub.situations.kinds import OF_PEOPLE, POSTURES, SituationKind
from housefly.hub.situations.person import ON_FLOOR
from housefly.hub.things.carrying import with_article
from housefly.hub.things.thing import ThingKind
from housefly.hub.things.words import age_words, lasting_words, seen_words
from housefly.hub.things.world_model import WorldModel

SEAT = re.compile(r"\s+(seat|mattress)\b.*$")
_CARRIES = 0.5
"""Less sure than this, nobody is said to carry a thing."""
_BESIDE = 1.0
"""Whoever stands this near to a piece of furniture is at it [m]."""


@dataclass(frozen=True, slots=True)
class RoomMoment:
    """The room at one time.

    Attributes:
        at: Unix time [s].
        world: what is where then.
        situations: what holds then.
        known: whether anything was listening then.
        confidence_in: returns the confidence in the place of a thing, 0 to 1, by its id.
        offline: ids of the devices that say themselves that they are gone; of now only.
    """

    at: float
    world: WorldModel
    situations: tuple[SituationAnswer, ...]
    known: bool = True
    confidence_in: Callable[[str], float] = lambda thing: 1.0
    offline: frozenset[str] = frozenset()


def person_answer(moment: RoomMoment, person: str, gone: bool) -> PersonAnswer:
    """Return how somebody is.

    Args:
        moment: the room.
        person: id.
        gone: whether whoever saw them last says that they left its sight.
    """
    world = moment.world
    thing, found = world.thing(person), world.where(person)
    holds = {held.kind: held for held in moment.situations if held.thing == person}
    posture = next((holds[kind] for kind in POSTURES if kind in holds), None)
    fallen = holds.get(SituationKind.PERSON_FALLEN)
    base = fallen or posture or holds.get(SituationKind.PERSON_PRESENT)
    present: Verdict = "yes" if base is not None else "no" if gone else "unknown"
    carries = tuple(
        one.id
        for one in world.things
        if world.where(one.id).inside == person and moment.confidence_in(one.id) >= _CARRIES
    )
    activity = _activity(world, posture, fallen, found.position)
    sources = base.sources if base else ()
    heard = evidence_age(world, sources, person, moment.at)
    words = _sentence(moment, person, base, activity, present, heard)
    if carries and present == "yes":
        words += f"; carries {' and '.join(world.thing(one).name for one in carries)}"
    return PersonAnswer(
        person,
        thing.name,
        words,
        present,
        POSTURES[posture.kind] if posture else "",
        activity or ("away" if present == "no" else ""),
        fallen.confidence if fallen else 0.0,
        carries,
        posture.since if posture else None,
        posture.confidence if posture else 0.0,
        found.position if found.seen_at is not None else None,
        heard if base is not None else found.age(moment.at),
        base.evidence if base else "",
        sources,
    )


def evidence_age(
    world: WorldModel, sources: Collection[str], thing: str, now: float
) -> float | None:
    """Return how long ago sources last spoke of themselves or a thing [s]; None for never."""
    known = {one.id for one in world.things}
    times = [
        seen.captured_at
        for about in (thing, *sources)
        if about in known
        for seen in world.latest_observations(about)
        if seen.source in sources
    ]
    return max(0.0, now - max(times)) if times else None


def people_of(moment: RoomMoment) -> tuple[str, ...]:
    """Return the ids of everybody: in the catalogue, or found by the detectors."""
    listed = {thing.id for thing in moment.world.of_kind(ThingKind.PERSON)}
    found = {held.thing for held in moment.situations if held.kind in OF_PEOPLE}
    known = {thing.id for thing in moment.world.things}
    return tuple(sorted(listed | (found & known)))


def is_bed(on: object) -> bool:
    """Return whether what carries somebody is a bed: neither the floor nor a seat."""
    return isinstance(on, str) and on not in ("", ON_FLOOR) and "seat" not in on.split()


def _activity(
    world: WorldModel,
    posture: SituationAnswer | None,
    fallen: SituationAnswer | None,
    position: Vec3 | None,
) -> str:
    if fallen is not None:
        return "on the floor"
    if posture is None:
        return ""
    on = posture.facts.get("on", "")
    if on:
        return (
            "in bed"
            if is_bed(on) and posture.kind == SituationKind.PERSON_LYING
            else f"on {spoken_seat(str(on))}"
        )
    beside = (
        _beside(world, position)
        if posture.kind == SituationKind.PERSON_STANDING and position
        else ""
    )
    return f"at {beside}" if beside else POSTURES[posture.kind]


def _beside(world: WorldModel, position: Vec3) -> str:
    """Return the name of the nearest furniture that somebody stands at, "" for none."""
    near = [
        (hypot(place[0] - position[0], place[1] - position[1]), thing.name)
        for thing in world.of_kind(ThingKind.FURNITURE)
        if (place := world.where(thing.id).position) is not None
    ]
    distance, name = min(near, default=(_BESIDE, ""))
    return spoken_name(name) if distance < _BESIDE else ""


_VERBS: dict[str, str] = {
    SituationKind.PERSON_LYING: "lies",
    SituationKind.PERSON_SITTING: "sits",
    SituationKind.PERSON_STANDING: "stands",
    SituationKind.PERSON_WALKING: "walks",
}


def _sentence(
    moment: RoomMoment,
    person: str,
    base: SituationAnswer | None,
    activity: str,
    present: Verdict,
    heard: float | None,
) -> str:
    who = spoken_name(moment.world.thing(person).name)
    if base is None:
        found = moment.world.where(person)
        seen = seen_words(found, moment.at)
        if present == "no":
            return f"{who} is not here, {seen}"
        return f"{who} was {seen}" if found.seen_at is None else f"{who} is not seen now, {seen}"
    if base.kind == SituationKind.PERSON_FALLEN:
        does = "may have fallen and lies on the floor"
    elif base.kind == SituationKind.PERSON_PRESENT:
        does = "is here"
    else:
        place = activity if activity.split()[0] in ("in", "on", "at") else ""
        does = f"{_VERBS[base.kind]} {place}".rstrip()
    spoken = "" if heard is None else f", {age_words(heard)}"
    sure = f"{100 * base.confidence:.0f} % sure"
    return f"{who} {does}{lasting_words(moment.at - base.since)} ({sure}; {base.evidence}{spoken})"


def spoken_seat(on: str) -> str:
    """Return what carries somebody, as people call it: "sofa seat 1" is "the sofa"."""
    furniture = SEAT.sub("", on)
    return with_article(furniture or on)


def spoken_name(name: str) -> str:
    """Return a name as it stands in a sentence: "stove" is "the stove", "Ann" and "bed-2" stay."""
    is_plain = name[:1].islower() and not any(letter.isdigit() for letter in name)
    return with_article(name) if is_plain else name
