"""Answers an intent: words from the room's memory, or a request for a service. Flies nothing."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from housefly.config.house_mode import HouseMode
from housefly.errors import HouseflyError, LinkError, ThingError
from housefly.evidence.clip_values import ClipsQuestion
from housefly.hub.client.room_queries import RoomQueries
from housefly.hub.situations.kinds import SituationKind
from housefly.messages import OrderKind
from housefly.tasks.api.questions import BoardQuestion, SetMode
from housefly.tasks.api.values import TaskRequest
from housefly.tasks.intents.answer_past import answer_came_at, answer_what_happened
from housefly.tasks.intents.answer_people import (
    BELL,
    answer_got_up,
    answer_nights,
    answer_state,
    answer_who,
)
from housefly.tasks.intents.answer_where import answer_contents, answer_where
from housefly.tasks.intents.asking import Asking
from housefly.tasks.intents.intent import Intent, IntentName, NameKind
from housefly.tasks.intents.intent_reply import IntentReply, Notice, TaskAct
from housefly.tasks.intents.names import Names
from housefly.tasks.intents.recognizer import recognizer
from housefly.tasks.intents.speech import Speech
from housefly.tasks.intents.time_span import next_time, spans_of

_WEEK = 7 * 86400.0
SERVICES: dict[IntentName, tuple[str, str]] = {
    IntentName.LOOK: ("look", "subject"),
    IntentName.LOOK_AROUND: ("panorama", ""),
    IntentName.PATROL: ("patrol", ""),
    IntentName.COME: ("come", "person"),
    IntentName.FOLLOW: ("follow", "person"),
    IntentName.VISITOR: ("visitor", ""),
    IntentName.INVENTORY: ("inventory", "subject"),
    IntentName.NIGHT_ROUND: ("night_round", ""),
    IntentName.ALL_RIGHT: ("all_right", "person"),
}
"""The service that an intent asks for, and its parameter that the subject fills ("" for none)."""
_STATE_EVENTS: dict[str, str] = {
    "on": SituationKind.APPLIANCE_ON,
    "running": SituationKind.APPLIANCE_ON,
    "off": SituationKind.APPLIANCE_ON.ended,
    "open": SituationKind.CONTACT_OPEN,
    "closed": SituationKind.CONTACT_OPEN.ended,
    "shut": SituationKind.CONTACT_OPEN.ended,
    "occupied": SituationKind.BED_OCCUPIED,
    "free": SituationKind.BED_OCCUPIED.ended,
    "in bed": SituationKind.PERSON_LYING,
    "lying": SituationKind.PERSON_LYING,
    "up": SituationKind.PERSON_LYING.ended,
    "fallen": SituationKind.PERSON_FALLEN,
}
"""The event with which a state begins; of others nobody is told."""


def answer_intent(
    intent: Intent, names: Names, room: RoomQueries, now: float, own: Path | None = None
) -> IntentReply:
    """Return the reply to an intent, in its language.

    Args:
        intent: as recognized.
        names: of the room.
        room: remembers; it is only asked.
        now: Unix time [s].
        own: folder with a person's own sentence files, or None.
    """
    say = Speech(recognizer(intent.language, own).book, names, now)
    asking = Asking(intent, names, room, now, say)
    try:
        return _ANSWERS[intent.intent](asking)
    except LinkError:
        return IntentReply(say("nobody_remembers"))
    except ThingError as error:
        return IntentReply(say("not_known", why=error))
    except HouseflyError as error:
        return IntentReply(say("cannot_answer", why=error))


def _service(asking: Asking) -> IntentReply:
    service, parameter = SERVICES[asking.intent.intent]
    subject = asking.subject()
    if subject is None or not parameter:
        return IntentReply(asking.say(f"request {service}"), request=TaskRequest(service))
    request = TaskRequest(service, {parameter: subject.id})
    return IntentReply(asking.say(f"request {service} subject", thing=subject), request=request)


def _own_service(asking: Asking) -> IntentReply:
    subject, service = asking.subject(), asking.slots.service or ""
    parameters = {} if subject is None else {"subject": subject.id}
    return IntentReply(
        asking.say("request own", service=service), request=TaskRequest(service, {**parameters})
    )


def _act(act: TaskAct) -> Callable[[Asking], IntentReply]:
    return lambda asking: IntentReply(asking.say(f"act {act.value}"), act=act)


def _order(kind: OrderKind) -> Callable[[Asking], IntentReply]:
    return lambda asking: IntentReply(asking.say(f"order {kind.value}"), order=kind)


def _mode(asking: Asking) -> IntentReply:
    if asking.slots.mode is None:
        return IntentReply(asking.say("mode_question"), question=BoardQuestion())
    mode = asking.say.say(f"mode {asking.slots.mode}")
    return IntentReply(
        asking.say("mode_set", mode=mode), question=SetMode(HouseMode(asking.slots.mode))
    )


def _clips(asking: Asking) -> IntentReply:
    span = spans_of(asking.slots, asking.now, _WEEK)[0]
    subject = asking.subject()
    about = dict.fromkeys(NameKind, "")
    if subject is not None:
        about[subject.kind] = subject.id
    question = ClipsQuestion(
        span.since,
        span.until,
        about[NameKind.PERSON],
        about[NameKind.PLACE],
        about[NameKind.THING],
    )
    return IntentReply(asking.say("clips"), question=question)


def _call_me(asking: Asking) -> IntentReply:
    say, subject, event = asking.say, asking.subject(), asking.slots.event or "time"
    thing = "" if subject is None else subject.thing
    if event == "time":
        at = next_time(asking.slots, asking.now)
        if at is None:
            return IntentReply(say("when_shall_i"))
        return IntentReply(
            say("i_remind", clock=say.clock(at)), notice=Notice(say("it_is_time"), at=at)
        )
    if event == "state":
        kind = _STATE_EVENTS.get(asking.slots.state or "")
        if kind is None:
            return IntentReply(say("nobody_tells"))
        told = say("told state", thing=subject) if subject else say("told state any")
        return IntentReply(say("i_tell"), notice=Notice(told, (kind,), thing))
    kinds = {
        "bell": (BELL,),
        "at_door": (BELL, SituationKind.AT_ENTRANCE),
        "gets_up": (SituationKind.PERSON_LYING.ended, SituationKind.BED_OCCUPIED.ended),
        "falls": (SituationKind.PERSON_FALLEN,),
    }[event]
    return IntentReply(say("i_tell"), notice=Notice(say(f"told {event}"), kinds, thing))


def _help(asking: Asking) -> IntentReply:
    return IntentReply(asking.say("help"))


_ANSWERS: dict[IntentName, Callable[[Asking], IntentReply]] = {
    **dict.fromkeys(SERVICES, _service),
    IntentName.SERVICE: _own_service,
    IntentName.WHERE: answer_where,
    IntentName.CONTENTS: answer_contents,
    IntentName.IS: answer_state,
    IntentName.WHO: answer_who,
    IntentName.GOT_UP: answer_got_up,
    IntentName.NIGHTS: answer_nights,
    IntentName.WHAT_HAPPENED: answer_what_happened,
    IntentName.CAME_AT: answer_came_at,
    IntentName.CLIPS: _clips,
    IntentName.CALL_ME: _call_me,
    IntentName.CANCEL: _act(TaskAct.CANCEL),
    IntentName.PAUSE: _act(TaskAct.PAUSE),
    IntentName.CONTINUE: _act(TaskAct.CONTINUE),
    IntentName.STOP: _order(OrderKind.STOP),
    IntentName.LAND: _order(OrderKind.LAND),
    IntentName.HOME: _order(OrderKind.HOME),
    IntentName.MODE: _mode,
    IntentName.HELP: _help,
}
