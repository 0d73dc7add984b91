"""The world model: every thing, what each source last said of it, and the fused view."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from housefly.errors import ThingError
from housefly.geometry import Vec3, distance
from housefly.hub.things.containment import chain_of, contents_of
from housefly.hub.things.names import Names
from housefly.hub.things.thing import Kind, Thing
from housefly.hub.things.whereabouts import Whereabouts, whereabouts
from housefly.messages import Happening, Observation


@dataclass(frozen=True, slots=True)
class Near:
    """A thing close to a point, and how close [m]."""

    thing: str
    distance: float


class World:
    """What is where, now; told by sensors, asked by everybody. One thread at a time."""

    def __init__(self, things: Iterable[Thing] = ()) -> None:
        self._things: dict[str, Thing] = {}
        self._names = Names()
        self._last: dict[str, dict[str, Observation]] = {}
        self._valid: dict[str, dict[str, Observation]] = {}
        self._fused: dict[str, Whereabouts] = {}
        self._happenings: dict[str, dict[str, Happening]] = {}
        for thing in things:
            self.know(thing)

    @property
    def things(self) -> tuple[Thing, ...]:
        """All things, in the order in which they became known."""
        return tuple(self._things.values())

    def know(self, thing: Thing) -> None:
        """Add a thing, or replace what was known of it; raises ThingError when it would come to be
        inside itself.
        """
        before = self._things.get(thing.id)
        self._enter(thing)
        try:
            self.chain(thing.id)
        except ThingError:
            self._leave(thing) if before is None else self._enter(before)
            raise

    def told(self, sample: Observation) -> None:
        """Hear what a source says; a sample older than the source's last one changes nothing.

        A thing or container that nobody knows becomes an object that is called by its id.

        Raises:
            ThingError: the thing would come to be inside itself; the sample is not kept.
        """
        for unknown in {sample.thing, sample.inside} - self._things.keys() - {""}:
            self.know(Thing(unknown, unknown))
        inside = self._own(sample.thing).inside
        before = self._valid.get(sample.thing, {}).get(sample.source)
        if sample.valid and _is_newer(sample, before):
            self._valid.setdefault(sample.thing, {})[sample.source] = sample
            self._fused.pop(sample.thing, None)
            if self._own(sample.thing).inside != inside:
                self._refuse_ring(sample, before)
        if _is_newer(sample, self._last.get(sample.thing, {}).get(sample.source)):
            self._last.setdefault(sample.thing, {})[sample.source] = sample

    def happened(self, happening: Happening) -> None:
        """Hear of something that happened."""
        kinds = self._happenings.setdefault(happening.thing, {})
        known = kinds.get(happening.kind)
        if known is None or happening.at >= known.at:
            kinds[happening.kind] = happening

    def last_happening(self, thing: str, kind: str = "") -> Happening | None:
        """Return the newest thing that happened to a thing, of one kind or of any; None when
        nothing did.
        """
        kinds = self._happenings.get(thing, {})
        return (
            kinds.get(kind)
            if kind
            else max(kinds.values(), key=lambda happening: happening.at, default=None)
        )

    def thing(self, thing: str) -> Thing:
        """Return a thing by its id, or else by what it is called; raises ThingError, with
        suggestions, when there is none.
        """
        found = self._things.get(thing)
        return found if found is not None else self.find(thing)

    def find(self, words: str, kind: Kind | None = None) -> Thing:
        """Return the one thing that is meant by a name, an alias, an id or the beginning of one.

        Raises:
            ThingError: nothing or more than one thing is called so; names what could have been
                meant.
        """
        among = None if kind is None else frozenset(thing.id for thing in self.of_kind(kind))
        return self._things[self._names.find(words, among)]

    def of_kind(self, kind: Kind) -> tuple[Thing, ...]:
        """Return all things of a kind."""
        return tuple(thing for thing in self._things.values() if thing.kind is kind)

    def said(self, thing: str) -> tuple[Observation, ...]:
        """Return the last sample of each source, valid or not, sources in alphabetical order."""
        return tuple(
            sample for _, sample in sorted(self._last.get(self.thing(thing).id, {}).items())
        )

    def where(self, thing: str) -> Whereabouts:
        """Return the fused view of a thing; the position of its container where it has none of its
        own.
        """
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
        """Return the ids of what contains a thing, the closest first: cabinet, kitchen."""
        return chain_of(self.thing(thing).id, self._container)

    def contents(self, thing: str) -> tuple[str, ...]:
        """Return the ids of all that is in a thing, however deep."""
        return contents_of(self.thing(thing).id, self._things, self._container)

    def near(self, centre: Vec3 | str, radius: float, kind: Kind | None = None) -> tuple[Near, ...]:
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
                found.append(Near(thing.id, apart))
        return tuple(sorted(found, key=lambda near: (near.distance, near.thing)))

    def _own(self, thing: str) -> Whereabouts:
        fused = self._fused.get(thing)
        if fused is None:
            fused = whereabouts(
                self._things[thing], self._valid.get(thing, {}).values(), self._kind
            )
            self._fused[thing] = fused
        return fused

    def _container(self, thing: str) -> str:
        return self._own(thing).inside if thing in self._things else ""

    def _kind(self, thing: str) -> Kind | None:
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
    """Tell which of two samples of one source counts; among equally old ones the choice must not
    depend on their order.
    """
    if known is None:
        return True
    ours, theirs = (sample.captured_at, sample.received_at), (known.captured_at, known.received_at)
    return ours > theirs or (ours == theirs and repr(sample) > repr(known))
