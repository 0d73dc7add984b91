"""The world model: every thing, the last observation of each source, and the fused pose."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from housefly.errors import ThingError
from housefly.geometry import Vec3, distance
from housefly.hub.things.containment import chain_of, contents_of
from housefly.hub.things.fused_pose import FusedPose, fused_pose
from housefly.hub.things.name_index import NameIndex
from housefly.hub.things.thing import Thing, ThingKind
from housefly.messages import Observation


@dataclass(frozen=True, slots=True)
class NearbyThing:
    """A thing near a point, and its distance [m]."""

    thing: str
    distance: float


class WorldModel:
    """What is where, now, from the observations of all sensors. Not thread-safe."""

    def __init__(self, things: Iterable[Thing] = ()) -> None:
        self._things: dict[str, Thing] = {}
        self._names = NameIndex()
        self._last: dict[str, dict[str, Observation]] = {}
        self._valid: dict[str, dict[str, Observation]] = {}
        self._fused: dict[str, FusedPose] = {}
        for thing in things:
            self.add_thing(thing)

    @property
    def things(self) -> tuple[Thing, ...]:
        """All things, in the order in which they were added."""
        return tuple(self._things.values())

    def add_thing(self, thing: Thing) -> None:
        """Add or replace a thing; raises ThingError if it would be inside itself."""
        before = self._things.get(thing.id)
        self._enter(thing)
        try:
            self.chain(thing.id)
        except ThingError:
            self._leave(thing) if before is None else self._enter(before)
            raise

    def observe(self, sample: Observation) -> None:
        """Add what a source reports; a sample older than the source's last one changes nothing.

        An unknown thing or container becomes an object named by its id, or a person when the source
        says so.

        Raises:
            ThingError: the thing would be inside itself; the sample is not kept.
        """
        for unknown in {sample.thing, sample.inside} - self._things.keys() - {""}:
            says = dict(sample.facts).get("kind") if unknown == sample.thing else None
            kind = ThingKind.PERSON if says == ThingKind.PERSON else ThingKind.OBJECT
            self.add_thing(Thing(unknown, unknown, kind))
        inside = self._own(sample.thing).inside
        before = self._valid.get(sample.thing, {}).get(sample.source)
        if sample.valid and _is_newer(sample, before):
            self._valid.setdefault(sample.thing, {})[sample.source] = sample
            self._fused.pop(sample.thing, None)
            if self._own(sample.thing).inside != inside:
                self._refuse_ring(sample, before)
        if _is_newer(sample, self._last.get(sample.thing, {}).get(sample.source)):
            self._last.setdefault(sample.thing, {})[sample.source] = sample

    def thing(self, thing: str) -> Thing:
        """Return a thing by its id or a name; raises ThingError, with suggestions, if unknown."""
        found = self._things.get(thing)
        return found if found is not None else self.find(thing)

    def find(self, words: str, kind: ThingKind | None = None) -> Thing:
        """Return the thing for a name, an alias, an id or the unique beginning of one.

        Raises:
            ThingError: no thing or more than one matches; suggests what could have been meant.
        """
        among = None if kind is None else frozenset(thing.id for thing in self.of_kind(kind))
        return self._things[self._names.find(words, among)]

    def of_kind(self, kind: ThingKind) -> tuple[Thing, ...]:
        """Return all things of a kind."""
        return tuple(thing for thing in self._things.values() if thing.kind is kind)

    def latest_observations(self, thing: str) -> tuple[Observation, ...]:
        """Return the last sample of each source, valid or not, sorted by source."""
        return tuple(
            sample for _, sample in sorted(self._last.get(self.thing(thing).id, {}).items())
        )

    def where(self, thing: str) -> FusedPose:
        """Return the fused pose of a thing, or its container's position if it has none."""
        own = self._own(self.thing(thing).id)
        if own.position is not None or not own.inside:
            return own
        for container in self.chain(own.thing):
            held = self._own(container)
            if held.position is not None:
                return replace(
                    own, position=held.position, covariance=held.covariance, by_container=container
                )
        return own

    def chain(self, thing: str) -> tuple[str, ...]:
        """Return the ids of the containers of a thing, the closest first: cabinet, kitchen."""
        return chain_of(self.thing(thing).id, self._container)

    def contents(self, thing: str) -> tuple[str, ...]:
        """Return the ids of everything inside a thing, nested contents included."""
        return contents_of(self.thing(thing).id, self._things, self._container)

    def near(
        self, centre: Vec3 | str, radius: float, kind: ThingKind | None = None
    ) -> tuple[NearbyThing, ...]:
        """Return what is within a radius [m] of a point or of a thing, the closest first."""
        point = self.where(centre).position if isinstance(centre, str) else centre
        if point is None:
            raise ThingError(
                f"nobody knows where {centre} is, so nothing can be said to be near it"
            )
        found = []
        for thing in self._things.values():
            if thing.id == centre or (kind is not None and thing.kind is not kind):
                continue
            position = self.where(thing.id).position
            if position is not None and (apart := distance(position, point)) <= radius:
                found.append(NearbyThing(thing.id, apart))
        return tuple(sorted(found, key=lambda near: (near.distance, near.thing)))

    def _own(self, thing: str) -> FusedPose:
        fused = self._fused.get(thing)
        if fused is None:
            fused = fused_pose(self._things[thing], self._valid.get(thing, {}).values(), self._kind)
            self._fused[thing] = fused
        return fused

    def _container(self, thing: str) -> str:
        return self._own(thing).inside if thing in self._things else ""

    def _kind(self, thing: str) -> ThingKind | None:
        known = self._things.get(thing)
        return known.kind if known else None

    def _refuse_ring(self, sample: Observation, before: Observation | None) -> None:
        try:
            self.chain(sample.thing)
        except ThingError as error:
            if before is None:
                del self._valid[sample.thing][sample.source]
            else:
                self._valid[sample.thing][sample.source] = before
            self._fused.pop(sample.thing, None)
            raise ThingError(f"{sample.source} says that {error}") from error

    def _enter(self, thing: Thing) -> None:
        if thing.id in self._things:
            self._leave(self._things[thing.id], forget=False)
        self._things[thing.id] = thing
        self._names.add(thing.id, _names_of(thing))
        self._fused.clear()  # what is in it may be where it is now

    def _leave(self, thing: Thing, *, forget: bool = True) -> None:
        self._names.remove(thing.id, _names_of(thing))
        self._fused.pop(thing.id, None)
        if forget:
            del self._things[thing.id]


def _names_of(thing: Thing) -> tuple[str, ...]:
    return thing.id, thing.name, *thing.aliases


def _is_newer(sample: Observation, known: Observation | None) -> bool:
    """Return which sample of one source counts; the choice among equally old ones is fixed."""
    if known is None:
        return True
    ours, theirs = (sample.captured_at, sample.received_at), (known.captured_at, known.received_at)
    return ours > theirs or (ours == theirs and repr(sample) > repr(known))
