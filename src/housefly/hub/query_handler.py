"""Answers questions from the world model and the store, for bus, HTTP and Python alike."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from math import sqrt
from typing import Any

from housefly.errors import ThingError
from housefly.geometry import yaw_of
from housefly.hub.api.answers import (
    AlternativePlace,
    Answer,
    EventsAnswer,
    PictureAnswer,
    PlacedAnswer,
    PlacedThing,
    SourceAnswer,
    ThingAnswer,
    ThingsAnswer,
    TrajectoryAnswer,
    ViewpointAnswer,
    WhereAnswer,
)
from housefly.hub.api.questions import (
    CatalogueQuestion,
    ContentsQuestion,
    EventsQuestion,
    FeedQuestion,
    NearQuestion,
    NightsQuestion,
    PeopleQuestion,
    PictureQuestion,
    Question,
    SensorsQuestion,
    StateQuestion,
    TrajectoryQuestion,
    WhereQuestion,
)
from housefly.hub.feed.feed_reader import FeedReader
from housefly.hub.memory import RoomMemory
from housefly.hub.recall import recall
from housefly.hub.room_status import RoomStatus
from housefly.hub.said import event_answer
from housefly.hub.situations.device_traits import DeviceTraits
from housefly.hub.state_handler import StateHandler
from housefly.hub.things.beliefs import Beliefs
from housefly.hub.things.fused_pose import FusedPose
from housefly.hub.things.thing import Thing, ThingKind
from housefly.hub.things.words import where_words
from housefly.hub.things.world_model import WorldModel
from housefly.messages import Observation

_MAX_ROWS = 200_000
"""Most rows of a trajectory in one answer."""


class QueryHandler:
    """Answers questions from one memory; thread-safe.

    Args:
        memory: the world model and the store.
        status: sensors, situations and obstacles now.
        clock: Unix time [s].
        devices: what is known of measuring devices, by id.
    """

    def __init__(
        self,
        memory: RoomMemory,
        status: RoomStatus,
        clock: Callable[[], float],
        devices: Mapping[str, DeviceTraits] | None = None,
    ) -> None:
        self._memory, self._status, self._clock = memory, status, clock
        states = StateHandler(
            memory, status, clock, devices or {}, self._world_at, self._beliefs_at
        )
        self._by: dict[type[Question], Callable[[Any], Answer]] = {
            WhereQuestion: self._where,
            CatalogueQuestion: self._catalogue,
            NearQuestion: self._near,
            ContentsQuestion: self._contents,
            TrajectoryQuestion: self._trajectory,
            EventsQuestion: self._events,
            FeedQuestion: FeedReader(memory, clock).answer,
            SensorsQuestion: lambda _: self._status.sensors(),
            PictureQuestion: self._picture,
            StateQuestion: states.state,
            PeopleQuestion: states.people,
            NightsQuestion: states.nights,
        }

    def answer(self, question: Question) -> Answer:
        """Return the answer; raises ThingError if there is no such thing."""
        return self._by[type(question)](question)

    def _where(self, question: WhereQuestion) -> WhereAnswer:
        if question.at is not None:
            world = self._world_at(question.at)
            beliefs = self._beliefs_at(world, question.at)
            return _where_answer(world, beliefs, question.thing, question.at)
        with self._memory.lock:
            memory = self._memory
            return _where_answer(memory.world, memory.beliefs, question.thing, self._clock())

    def _catalogue(self, question: CatalogueQuestion) -> ThingsAnswer:
        kind = _kind(question.kind)
        with self._memory.lock:
            things = self._memory.world.things
        return ThingsAnswer(
            tuple(_thing(thing) for thing in things if kind is None or thing.kind is kind)
        )

    def _near(self, question: NearQuestion) -> PlacedAnswer:
        with self._memory.lock:
            world = self._memory.world
            centre = (
                world.thing(question.thing).id
                if question.thing
                else (question.x, question.y, question.z)
            )
            found = world.near(centre, question.radius, _kind(question.kind))
            now = self._clock()
            return PlacedAnswer(
                tuple(
                    placed_thing(world, world.thing(near.thing), now, near.distance)
                    for near in found
                )
            )

    def _contents(self, question: ContentsQuestion) -> PlacedAnswer:
        if question.at is not None:
            world, now = self._world_at(question.at), question.at
            return PlacedAnswer(_all(world, world.contents(world.thing(question.thing).id), now))
        with self._memory.lock:
            world = self._memory.world
            return PlacedAnswer(
                _all(world, world.contents(world.thing(question.thing).id), self._clock())
            )

    def _trajectory(self, question: TrajectoryQuestion) -> TrajectoryAnswer:
        thing = self._named(question.thing)
        until = self._clock() if question.until is None else question.until
        self._memory.flush()
        with self._memory.store() as store:
            rows = store.trajectory(
                thing, question.since, until, source=question.source, every=question.every
            )
        return TrajectoryAnswer(
            thing, tuple((t, x, y, z) for t, x, y, z in rows[-_MAX_ROWS:].tolist())
        )

    def _events(self, question: EventsQuestion) -> EventsAnswer:
        thing = self._named(question.thing) if question.thing else ""
        until = self._clock() if question.until is None else question.until
        self._memory.flush()
        with self._memory.store() as store:
            found = store.events(
                question.since, until, thing=thing, kind=question.kind, cause=question.cause
            )
        return EventsAnswer(tuple(event_answer(one) for one in found[-question.limit :]))

    def _picture(self, question: PictureQuestion) -> PictureAnswer:
        if question.at is not None:
            world = self._world_at(question.at)
            return PictureAnswer(
                question.at, _all(world, (thing.id for thing in world.things), question.at)
            )
        now = self._clock()
        with self._memory.lock:
            world = self._memory.world
            things = _all(world, (thing.id for thing in world.things), now)
        return PictureAnswer(now, things, self._status.situations(), self._status.obstacles())

    def _named(self, words: str) -> str:
        with self._memory.lock:
            return self._memory.world.thing(words).id

    def _world_at(self, at: float) -> WorldModel:
        self._memory.flush()
        with self._memory.lock:
            world = WorldModel(self._memory.world.things)
        with self._memory.store() as store:
            seen = store.latest_at(at)
        _observe_all(world, seen)
        return world

    def _beliefs_at(self, world: WorldModel, at: float) -> Beliefs:
        beliefs = Beliefs(self._memory.surfaces)
        for thing in world.things:
            for sample in world.latest_observations(thing.id):
                beliefs.observe(world, sample)
        with self._memory.store() as store:
            recall(beliefs, world, store, at)
        return beliefs


def _observe_all(world: WorldModel, samples: Iterable[Observation]) -> None:
    """Add observations to a world model of the past; contradictions are left out."""
    for sample in samples:
        try:
            world.observe(sample)
        except ThingError:
            continue


def _where_answer(world: WorldModel, beliefs: Beliefs, words: str, now: float) -> WhereAnswer:
    """Return where a thing is; raises ThingError if there is no such thing."""
    thing = world.thing(words)
    found = world.where(thing.id)
    belief = beliefs.of(world, thing.id, now)
    return WhereAnswer(
        thing.id,
        thing.name,
        thing.kind.value,
        where_words(world, thing.id, now, belief),
        found.position,
        _yaw(found),
        _std(found),
        world.chain(thing.id),
        found.by_container,
        found.seen_at,
        found.age(now),
        found.sources,
        tuple(_source_answer(sample, now) for sample in world.latest_observations(thing.id)),
        belief.confidence,
        tuple(
            AlternativePlace(one.words, one.thing, one.position, one.confidence)
            for one in belief.alternatives
        ),
    )


def placed_thing(
    world: WorldModel, thing: Thing, now: float, distance: float | None = None
) -> PlacedThing:
    """Return a thing with its place, and its distance from the point asked for [m]."""
    found = world.where(thing.id)
    return PlacedThing(
        thing.id,
        thing.name,
        thing.kind.value,
        found.position,
        _yaw(found),
        found.inside,
        found.age(now),
        distance,
    )


def _all(world: WorldModel, things: Iterable[str], now: float) -> tuple[PlacedThing, ...]:
    return tuple(placed_thing(world, world.thing(thing), now) for thing in things)


def _thing(thing: Thing) -> ThingAnswer:
    views = tuple(
        ViewpointAnswer(view.name, view.position, view.yaw, view.robot) for view in thing.viewpoints
    )
    return ThingAnswer(
        thing.id, thing.name, thing.kind.value, thing.aliases, thing.position, thing.inside, views
    )


def _source_answer(sample: Observation, now: float) -> SourceAnswer:
    return SourceAnswer(
        sample.source,
        now - sample.captured_at,
        sample.position,
        sample.inside,
        sample.valid,
        dict(sample.facts),
    )


def _yaw(found: FusedPose) -> float | None:
    return None if found.orientation is None else yaw_of(found.orientation)


def _std(found: FusedPose) -> float | None:
    if found.covariance is None:
        return None
    return sqrt((found.covariance[0] + found.covariance[3] + found.covariance[5]) / 3.0)


def _kind(word: str) -> ThingKind | None:
    try:
        return ThingKind(word) if word else None
    except ValueError as error:
        raise ThingError(
            f"{word!r} is no kind of thing; there are: {', '.join(ThingKind)}"
        ) from error
