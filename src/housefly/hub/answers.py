"""Answers questions from the world model and the store; the same for the bus, the HTTP API and
Python.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from math import sqrt
from typing import Any

from housefly.errors import ThingError
from housefly.geometry import yaw_of
from housefly.hub.api.answers import (
    Answer,
    EventsAnswer,
    Occurrence,
    PictureAnswer,
    Placed,
    PlacedAnswer,
    Said,
    ThingAnswer,
    ThingsAnswer,
    TrajectoryAnswer,
    View,
    WhereAnswer,
)
from housefly.hub.api.questions import (
    Catalogue,
    Contents,
    Events,
    Near,
    Picture,
    Question,
    Sensors,
    Trajectory,
    Where,
)
from housefly.hub.memory import RoomMemory
from housefly.hub.present import Present
from housefly.hub.things.thing import Kind, Thing
from housefly.hub.things.whereabouts import Whereabouts
from housefly.hub.things.words import where_words
from housefly.hub.things.world import World
from housefly.messages import Happening, Observation

LONGEST = 200_000
"""Rows of a trajectory that one answer may hold."""


class Answers:
    """Answers from one memory; safe from any thread.

    Args:
        memory: what the room knows.
        present: what holds now besides: sensors, situations, obstacles.
        clock: Unix time [s].
    """

    def __init__(self, memory: RoomMemory, present: Present, clock: Callable[[], float]) -> None:
        self._memory, self._present, self._clock = memory, present, clock
        self._by: dict[type[Question], Callable[[Any], Answer]] = {
            Where: self._where,
            Catalogue: self._catalogue,
            Near: self._near,
            Contents: self._contents,
            Trajectory: self._trajectory,
            Events: self._events,
            Sensors: lambda _: self._present.sensors(),
            Picture: self._picture,
        }

    def answer(self, question: Question) -> Answer:
        """Return the answer; raises ThingError when there is no such thing."""
        return self._by[type(question)](question)

    def _where(self, question: Where) -> WhereAnswer:
        if question.at is not None:
            return where_answer(self._world_at(question.at), question.thing, question.at)
        with self._memory.lock:
            return where_answer(self._memory.world, question.thing, self._clock())

    def _catalogue(self, question: Catalogue) -> ThingsAnswer:
        kind = _kind(question.kind)
        with self._memory.lock:
            things = self._memory.world.things
        return ThingsAnswer(
            tuple(_thing(thing) for thing in things if kind is None or thing.kind is kind)
        )

    def _near(self, question: Near) -> PlacedAnswer:
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
                tuple(placed(world, world.thing(near.thing), now, near.distance) for near in found)
            )

    def _contents(self, question: Contents) -> PlacedAnswer:
        if question.at is not None:
            world, now = self._world_at(question.at), question.at
            return PlacedAnswer(_all(world, world.contents(world.thing(question.thing).id), now))
        with self._memory.lock:
            world = self._memory.world
            return PlacedAnswer(
                _all(world, world.contents(world.thing(question.thing).id), self._clock())
            )

    def _trajectory(self, question: Trajectory) -> TrajectoryAnswer:
        thing = self._named(question.thing)
        until = self._clock() if question.until is None else question.until
        self._memory.flush()
        with self._memory.past() as store:
            rows = store.trajectory(
                thing, question.since, until, source=question.source, every=question.every
            )
        return TrajectoryAnswer(
            thing, tuple((t, x, y, z) for t, x, y, z in rows[-LONGEST:].tolist())
        )

    def _events(self, question: Events) -> EventsAnswer:
        thing = self._named(question.thing) if question.thing else ""
        until = self._clock() if question.until is None else question.until
        self._memory.flush()
        with self._memory.past() as store:
            found = store.events(
                question.since, until, thing=thing, kind=question.kind, cause=question.cause
            )
        return EventsAnswer(tuple(occurrence(one) for one in found[-question.limit :]))

    def _picture(self, question: Picture) -> PictureAnswer:
        if question.at is not None:
            world = self._world_at(question.at)
            return PictureAnswer(
                question.at, _all(world, (thing.id for thing in world.things), question.at)
            )
        now = self._clock()
        with self._memory.lock:
            world = self._memory.world
            things = _all(world, (thing.id for thing in world.things), now)
        return PictureAnswer(now, things, self._present.situations(), self._present.obstacles())

    def _named(self, words: str) -> str:
        with self._memory.lock:
            return self._memory.world.thing(words).id

    def _world_at(self, at: float) -> World:
        self._memory.flush()
        with self._memory.lock:
            world = World(self._memory.world.things)
        with self._memory.past() as store:
            seen = store.seen(at)
        tell(world, seen)
        return world


def tell(world: World, samples: Iterable[Observation]) -> None:
    """Tell a world of the past what was seen; what contradicts itself is left out."""
    for sample in samples:
        try:
            world.told(sample)
        except ThingError:
            continue


def where_answer(world: World, words: str, now: float) -> WhereAnswer:
    """Return where a thing is; raises ThingError when there is no such thing."""
    thing = world.thing(words)
    found = world.where(thing.id)
    return WhereAnswer(
        thing.id,
        thing.name,
        thing.kind.value,
        where_words(world, thing.id, now),
        found.position,
        _yaw(found),
        _std(found),
        world.chain(thing.id),
        found.by_container,
        found.seen_at,
        found.age(now),
        found.sources,
        tuple(_said(sample, now) for sample in world.said(thing.id)),
    )


def occurrence(happening: Happening) -> Occurrence:
    """Return something that happened as an answer holds it."""
    h = happening
    return Occurrence(h.kind, h.thing, h.at, h.source, h.cause, h.confidence, dict(h.facts))


def placed(world: World, thing: Thing, now: float, distance: float | None = None) -> Placed:
    """Return a thing with its place, and how far it is from where was asked [m]."""
    found = world.where(thing.id)
    return Placed(
        thing.id,
        thing.name,
        thing.kind.value,
        found.position,
        _yaw(found),
        found.inside,
        found.age(now),
        distance,
    )


def _all(world: World, things: Iterable[str], now: float) -> tuple[Placed, ...]:
    return tuple(placed(world, world.thing(thing), now) for thing in things)


def _thing(thing: Thing) -> ThingAnswer:
    views = tuple(View(view.name, view.position, view.yaw, view.robot) for view in thing.viewpoints)
    return ThingAnswer(
        thing.id, thing.name, thing.kind.value, thing.aliases, thing.position, thing.inside, views
    )


def _said(sample: Observation, now: float) -> Said:
    return Said(
        sample.source,
        now - sample.captured_at,
        sample.position,
        sample.inside,
        sample.valid,
        dict(sample.facts),
    )


def _yaw(found: Whereabouts) -> float | None:
    return None if found.orientation is None else yaw_of(found.orientation)


def _std(found: Whereabouts) -> float | None:
    if found.covariance is None:
        return None
    return sqrt((found.covariance[0] + found.covariance[3] + found.covariance[5]) / 3.0)


def _kind(word: str) -> Kind | None:
    try:
        return Kind(word) if word else None
    except ValueError as error:
        raise ThingError(
            f"{word!r} is no kind of thing; there are: {', '.join(kind.value for kind in Kind)}"
        ) from error
