"""Answers where a thing is and what is in it, from memory, with how old that is."""

from __future__ import annotations

from housefly.hub.api.answers import AlternativePlace, WhereAnswer
from housefly.hub.things.thing import ThingKind
from housefly.tasks.api.values import TaskRequest
from housefly.tasks.intents.asking import Asking
from housefly.tasks.intents.intent_reply import IntentReply, offering
from housefly.tasks.intents.names import NamedSubject

STALE_AFTER = 300.0
"""What was not seen for this long may be elsewhere; a look is offered [s]."""
_UNSURE = 0.5
"""Less sure than this, a look is offered too."""
_CERTAIN = 0.95
"""From here on nobody is told how sure it is."""
_BESIDE = 1.5
"""A thing this near to furniture is said to be there [m]."""
_MOST_ALTERNATIVES = 2
_MOST_CONTENTS = 12
_WORTH_TELLING = 0.1
"""Less likely places are not told."""


def answer_where(asking: Asking) -> IntentReply:
    """Return where a thing is; with ``go``, or a yes when it is stale, the drone goes and looks.

    What may well be elsewhere is searched for; all else is looked at where it is.
    """
    subject = _subject(asking)
    found = asking.room.where(subject.thing)
    request = TaskRequest("where", {"thing": subject.id, "look": "always"})
    if is_lost(found):
        request = TaskRequest("find", {"thing": subject.id})
    joined = asking.say.joined
    words = joined(_place_words(asking, subject, found), *_doubts(asking, found))
    if asking.slots.go:
        return IntentReply(joined(words, asking.say("i_go_and_look")), request=request)
    if is_stale(found) and found.kind not in (ThingKind.PLACE.value, ThingKind.STRUCTURE.value):
        return offering(asking.say, words, request)
    return IntentReply(words)


def is_stale(found: WhereAnswer) -> bool:
    """Return whether a thing may well be elsewhere by now."""
    if found.seen_at is None:
        return found.kind in (ThingKind.OBJECT.value, ThingKind.PERSON.value)
    return (found.age or 0.0) > STALE_AFTER or found.confidence < _UNSURE


def is_lost(found: WhereAnswer) -> bool:
    """Return whether a thing is one that gets lost, and may be elsewhere."""
    is_doubted = is_stale(found) or bool(found.alternatives)
    return found.kind == ThingKind.OBJECT.value and is_doubted


def answer_contents(asking: Asking) -> IntentReply:
    """Return what is in a thing, or whether it is empty."""
    subject, say = _subject(asking), asking.say
    inside = [one.thing for one in asking.room.contents(subject.thing)]
    offer = TaskRequest("inventory", {"subject": subject.id})
    if not inside:
        listed_ago = _listed_ago(asking, subject)
        if listed_ago is None:
            return offering(say, say("nobody_lists", thing=subject), offer)
        key = "is_empty" if asking.slots.empty else "nothing_inside"
        return IntentReply(say(key, thing=subject, ago=say.ago(listed_ago)))
    listed = say.listed(inside[:_MOST_CONTENTS])
    key = "not_empty" if asking.slots.empty else "inside"
    return IntentReply(say(key, thing=subject, contents=listed))


def _listed_ago(asking: Asking, subject: NamedSubject) -> float | None:
    """Return how long ago a thing told its contents itself [s], None when it never did."""
    told = (one.age for one in asking.room.where(subject.thing).said if "contents" in one.facts)
    return min(told, default=None)


def _subject(asking: Asking) -> NamedSubject:
    subject = asking.subject()
    assert subject is not None, "the intent needs a subject"
    return subject


def _place_words(asking: Asking, subject: NamedSubject, found: WhereAnswer) -> str:
    say = asking.say
    if found.position is None and not found.inside:
        return say("never_seen", thing=subject)
    where = _where(asking, found)
    if found.confidence < _CERTAIN:
        where = f"{where} ({say.percent(found.confidence)})"
    if found.age is None:
        return say("belongs", thing=subject, where=where)
    return say("is_where", thing=subject, where=where, ago=say.ago(found.age))


def _where(asking: Asking, found: WhereAnswer) -> str:
    say = asking.say
    if found.inside:
        holder = say.name(found.inside[0])
        kind = "with" if holder.kind.value == "person" else "in"
        return say(kind, place=holder)
    assert found.position is not None
    x, y, _ = found.position
    near = asking.room.near(found.position, _BESIDE, ThingKind.FURNITURE.value)
    beside = next((one.thing for one in near if one.thing != found.thing), None)
    if beside is not None:
        return say("beside", place=say.name(beside))
    return say("at_point", x=f"{x:.1f}", y=f"{y:.1f}")


def _doubts(asking: Asking, found: WhereAnswer) -> tuple[str, ...]:
    """Return where else it may be, as a sentence or none."""
    likely = [one for one in found.alternatives if one.thing and one.confidence >= _WORTH_TELLING]
    if not likely:
        return ()
    places = [_alternative(asking, one) for one in likely[:_MOST_ALTERNATIVES]]
    return (asking.say("or_perhaps", places=asking.say.say.listed(places, "or")),)


def _alternative(asking: Asking, one: AlternativePlace) -> str:
    place = asking.say.name(one.thing)
    key = "with" if place.kind.value == "person" else "on"
    return f"{asking.say(key, place=place)} ({asking.say.percent(one.confidence)})"
