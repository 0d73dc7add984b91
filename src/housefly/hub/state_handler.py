"""Answers about states now and at any kept time: from the memory, the detectors and the store."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from typing import TypeVar

from housefly.errors import ThingError
from housefly.hub.api.questions import NightsQuestion, PeopleQuestion, StateQuestion
from housefly.hub.api.state_answers import NightAnswer, NightsAnswer, PeopleAnswer, StateAnswer
from housefly.hub.memory import RoomMemory
from housefly.hub.nights import NightWindow, night_of, nothing_kept, stays_of
from housefly.hub.person_status import RoomMoment, people_of, person_answer
from housefly.hub.room_status import RoomStatus
from housefly.hub.situations.device_traits import DeviceTraits
from housefly.hub.situations.hysteresis import UNKNOWN
from housefly.hub.situations.kinds import BEGUN_BY, SituationKind
from housefly.hub.situations_at import situations_at
from housefly.hub.state_queries import device_answer, person_state_answer
from housefly.hub.things.beliefs import Beliefs
from housefly.hub.things.thing import Thing, ThingKind
from housefly.hub.things.world_model import WorldModel
from housefly.messages import RoomEvent

_LOOK_BACK = 86_400.0
"""What began longer ago than this and never ended is not looked for [s]."""
_LEFT = SituationKind.PERSON_PRESENT.ended
_Answered = TypeVar("_Answered")


class StateHandler:
    """Answers whether, who and how often.

    Args:
        memory: the world model and the store.
        status: situations now.
        clock: Unix time [s].
        devices: what is known of measuring devices, by id.
        world_at: what is where at a past time [s, Unix time].
        beliefs_at: how sure that is.
    """

    def __init__(
        self,
        memory: RoomMemory,
        status: RoomStatus,
        clock: Callable[[], float],
        devices: Mapping[str, DeviceTraits],
        world_at: Callable[[float], WorldModel],
        beliefs_at: Callable[[WorldModel, float], Beliefs],
    ) -> None:
        self._memory, self._status, self._clock = memory, status, clock
        self._devices, self._world_at, self._beliefs_at = devices, world_at, beliefs_at

    def state(self, question: StateQuestion) -> StateAnswer:
        """Answer whether a thing or person is in a state; raises ThingError, WireError."""
        now = self._now(question.at)
        switched = self._events(now, SituationKind.APPLIANCE_ON, SituationKind.APPLIANCE_ON.ended)
        left = self._events(now, _LEFT)

        def answer(moment: RoomMoment) -> StateAnswer:
            thing = _named(moment.world, question.thing)
            if thing.kind is ThingKind.PERSON or thing.id in people_of(moment):
                who = person_answer(moment, thing.id, thing.id in _gone(left))
                return person_state_answer(question, who)
            return device_answer(
                question, thing, moment, self._devices, lambda device: _was_on(switched, device)
            )

        return self._at(question.at, answer)

    def people(self, question: PeopleQuestion) -> PeopleAnswer:
        """Answer who is there, and how; raises ThingError if there is no such person."""
        left = self._events(self._now(question.at), _LEFT)

        def answer(moment: RoomMoment) -> PeopleAnswer:
            asked = question.person
            people = (_named(moment.world, asked).id,) if asked else people_of(moment)
            gone = _gone(left)
            rows = tuple(person_answer(moment, person, person in gone) for person in people)
            return PeopleAnswer(moment.at, rows)

        return self._at(question.at, answer)

    def nights(self, question: NightsQuestion) -> NightsAnswer:
        """Answer how often somebody was up at night; raises ThingError if there is no such one."""
        now, named = self._clock(), ""
        if question.thing:
            with self._memory.lock:
                named = _named(self._memory.world, question.thing).id
        until = min(now, self._now(question.until))
        events = self._stored(question.since - _LOOK_BACK, min(now, until + _LOOK_BACK))
        nights = tuple(
            NightWindow(question.from_hour, question.to_hour).nights(question.since, until)
        )
        return NightsAnswer(
            tuple(
                self._night(thing, night, events, now)
                for thing in ((named,) if named else _beds(events))
                for night in nights
            )
        )

    def _night(
        self, thing: str, night: tuple[float, float], events: tuple[RoomEvent, ...], now: float
    ) -> NightAnswer:
        # A night that has just begun has no event yet; whoever went to bed before is still there.
        still_told = night[0] <= now < night[1] and self._status.is_live
        if not still_told and not any(night[0] <= event.at <= night[1] for event in events):
            return nothing_kept(thing, night)
        found = night_of(thing, night, stays_of(thing, events, now), now)
        # A bed that nobody heard of is not an empty bed.
        heard = any(
            event.thing == thing and night[0] - _LOOK_BACK <= event.at <= night[1]
            for event in events
        )
        return found if found.in_bed > 0.0 or heard else nothing_kept(thing, night)

    def _now(self, at: float | None) -> float:
        return self._clock() if at is None else at

    def _at(self, at: float | None, answer: Callable[[RoomMoment], _Answered]) -> _Answered:
        """Return an answer about one moment; the world model of now is used under its lock."""
        if at is not None:
            world, held = self._world_at(at), situations_at(self._stored(at - _LOOK_BACK, at))
            believed = self._beliefs_at(world, at)
            return answer(RoomMoment(at, world, held, True, _confidence_by(believed, world, at)))
        known = self._status.is_live
        holds, offline = self._status.situations() if known else (), self._status.offline()
        with self._memory.lock:
            world, now = self._memory.world, self._clock()
            sure = _confidence_by(self._memory.beliefs, world, now)
            return answer(RoomMoment(now, world, holds, known, sure, offline))

    def _events(self, until: float, *kinds: str) -> tuple[RoomEvent, ...]:
        """Return what happened in the last day of some kinds, by time."""
        return in_order(
            event for kind in kinds for event in self._stored(until - _LOOK_BACK, until, kind)
        )

    def _stored(self, since: float, until: float, kind: str = "") -> tuple[RoomEvent, ...]:
        self._memory.flush()
        with self._memory.store() as store:
            return in_order(store.events(max(0.0, since), until, kind=kind))


def in_order(events: Iterable[RoomEvent]) -> tuple[RoomEvent, ...]:
    """Return events by time; of those at one time the ends first, as one posture gives another."""
    return tuple(sorted(events, key=lambda e: (e.at, e.kind not in BEGUN_BY)))


def _named(world: WorldModel, words: str) -> Thing:
    """Return a thing by its name, with or without its article; raises ThingError."""
    try:
        return world.thing(words)
    except ThingError:
        with suppress(ThingError):
            return world.thing(f"the {words}")
        raise


def _confidence_by(beliefs: Beliefs, world: WorldModel, now: float) -> Callable[[str], float]:
    return lambda thing: beliefs.of(world, thing, now).confidence


def _gone(left: Iterable[RoomEvent]) -> frozenset[str]:
    """Return who left, by what ended that they were present."""
    last = {event.thing: event for event in left}
    return frozenset(t for t, event in last.items() if UNKNOWN not in event.facts)


def _was_on(switched: Iterable[RoomEvent], thing: str) -> bool | None:
    """Return whether a thing was on when that was last decided; None when it never was."""
    last = [event for event in switched if event.thing == thing][-1:]
    if not last or UNKNOWN in last[0].facts:
        return None
    return last[0].kind == SituationKind.APPLIANCE_ON


def _beds(events: Iterable[RoomEvent]) -> tuple[str, ...]:
    return tuple(
        sorted({event.thing for event in events if event.kind == SituationKind.BED_OCCUPIED})
    )
