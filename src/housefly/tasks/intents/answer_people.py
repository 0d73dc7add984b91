"""Answers about people: who is there, how somebody is, who is up, how the nights were."""

from __future__ import annotations

from housefly.hub.api.state_answers import NightAnswer, PersonAnswer
from housefly.hub.situations.kinds import SituationKind
from housefly.tasks.api.values import TaskRequest
from housefly.tasks.intents.asking import Asking
from housefly.tasks.intents.intent_reply import IntentReply, offering
from housefly.tasks.intents.time_span import spans_of

BELL = "bell pressed"
"""The event of a doorbell."""
_DAY = 86400.0
_NIGHTS_TOLD = 3
_MOST_TIMES_UP = 5


def answer_state(asking: Asking) -> IntentReply:
    """Return whether a thing or a person is in a state."""
    subject, say, state = asking.subject(), asking.say, asking.slots.state or ""
    assert subject is not None, "the intent needs a subject"
    found = asking.room.state(subject.thing, state)
    if say.language == "en":
        return IntentReply(f"{found.words}.")
    shown = say.say(f"state {state}") if f"state {state}" in say.say.texts else state
    if found.answer == "unknown":
        return IntentReply(say("state_unknown", thing=subject, state=shown))
    if found.age is None:
        return IntentReply(say(f"state_{found.answer}", thing=subject, state=shown))
    ago = say.ago(found.age)
    return IntentReply(say(f"state_{found.answer}_ago", thing=subject, state=shown, ago=ago))


def answer_who(asking: Asking) -> IntentReply:
    """Return who is there, or who is at the door."""
    if asking.slots.event == "at_door":
        return _at_door(asking)
    subject, say = asking.subject(), asking.say
    people = asking.room.people(subject.thing if subject else "")
    if subject is not None and people:
        return IntentReply(say.joined(*(_how(asking, one) for one in people)))
    there = [one for one in people if one.present == "yes"]
    if there:
        return IntentReply(say.joined(*(_how(asking, one) for one in there)))
    unknown = [one.person for one in people if one.present == "unknown"]
    if unknown:
        words = say("nobody_seen", people=say.listed(unknown))
        return offering(say, words, TaskRequest("panorama"))
    return IntentReply(say("nobody_there"))


def _at_door(asking: Asking) -> IntentReply:
    say, visitor = asking.say, TaskRequest("visitor")
    held = [
        one for one in asking.room.picture().situations if one.kind == SituationKind.AT_ENTRANCE
    ]
    rang = asking.room.events(since=max(0.0, asking.now - _DAY), kind=BELL, limit=1)
    if held:
        since = asking.now - held[0].since
        began = asking.room.events(
            since=max(0.0, held[0].since - 1.0), kind=SituationKind.AT_ENTRANCE
        )
        who = next((one.cause for one in reversed(began) if one.cause), "")
        seen = (
            say("known_at_door", person=say.name(who), ago=say.ago(since))
            if who
            else say("somebody_at_door", ago=say.ago(since))
        )
        return offering(say, seen, visitor)
    last = say("rang_last", clock=say.clock(rang[-1].at)) if rang else ""
    return IntentReply(say.joined(say("nobody_at_door"), last))


def answer_got_up(asking: Asking) -> IntentReply:
    """Return who is up, and since when."""
    people = [one for who in asking.people() for one in asking.room.people(who)]
    told = [one for one in people if one.present != "no"] or people
    known = [one for one in told if one.posture] or told
    if not known:
        return IntentReply(asking.say("nobody_known"))
    return IntentReply(asking.say.joined(*(_up_words(asking, one) for one in known)))


def _up_words(asking: Asking, who: PersonAnswer) -> str:
    say, person = asking.say, asking.say.name(who.person)
    if not who.posture:
        return say("up_unknown", person=person)
    if who.posture == "lying":
        return say("not_up", person=person)
    rose = _rose(asking, who.person)
    if rose is None:
        return say("is_up", person=person)
    return say("is_up_since", person=person, clock=say.clock(rose))


def _rose(asking: Asking, person: str) -> float | None:
    nights = asking.room.nights(max(0.0, asking.now - 1.5 * _DAY), person, None, 20.0, 12.0)
    risen = [night.rose for night in nights if night.rose is not None]
    return risen[-1] if risen else None


def answer_nights(asking: Asking) -> IntentReply:
    """Return how often somebody was up in the last nights."""
    say, subject = asking.say, asking.subject()
    span = spans_of(asking.slots, asking.now, 1.5 * _DAY)[0]
    since = min(span.since, asking.now - 1.5 * _DAY) if asking.slots.period else span.since
    nights = asking.room.nights(max(0.0, since), subject.thing if subject else "")
    kept = [one for one in nights if one.unknown < one.end - one.begin and one.in_bed > 0.0]
    if not kept:
        return IntentReply(say("no_nights"))
    return IntentReply(say.joined(*(_night(asking, one) for one in kept[-_NIGHTS_TOLD:])))


def _night(asking: Asking, night: NightAnswer) -> str:
    say, person = asking.say, asking.say.name(night.thing)
    if not night.times_up:
        return say("slept_through", person=person, since=say.clock(night.begin))
    times = [say.clock(one.left) for one in night.times_up[:_MOST_TIMES_UP]]
    count = len(night.times_up)
    key = "up_once" if count == 1 else "up_often"
    return say(
        key, person=person, count=count, times=say.say.listed(times), since=say.clock(night.begin)
    )


def _how(asking: Asking, who: PersonAnswer) -> str:
    say, person = asking.say, asking.say.name(who.person)
    if who.present == "no":
        return say("is_away", person=person)
    if who.present == "unknown":
        return say("how_unknown", person=person)
    if who.fallen > 0.0:
        return say("may_have_fallen", person=person)
    if not who.posture:
        return say("is_there", person=person)
    if who.activity in ("in bed", "on the floor"):
        return say(f"{who.posture}_{who.activity.replace(' ', '_')}", person=person)
    return say(who.posture, person=person)
