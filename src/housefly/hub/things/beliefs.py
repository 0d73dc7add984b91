"""How sure the memory is of where each thing is, by what could have happened unseen."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from housefly.geometry import Vec3
from housefly.hub.situations.kinds import SituationKind
from housefly.hub.things.carrying import Carrying, with_article
from housefly.hub.things.fused_pose import FusedPose
from housefly.hub.things.hypothesis import SURE, Belief, Hypothesis, belief_in
from housefly.hub.things.surfaces import Surface
from housefly.hub.things.thing import ThingKind
from housefly.hub.things.world_model import WorldModel
from housefly.messages import Fact, Observation, RoomEvent

CARRIERS = (ThingKind.PERSON, ThingKind.ROBOT)
"""They move by themselves; what they carry is with them, not in them."""
"""Events by which a person who is out of sight lies in a bed, until they get up."""
_UNSEEN_AFTER, _UNSEEN_TIME = 1.0, 3.0
"""A person unseen for longer is perhaps elsewhere; half of them are after so much more [s]."""
_MISSED_AFTER = 0.3
"""The same when their source has been heard since and did not see them [s]."""
_IN_BED = 0.9
"""Share of those whom a bed feels and nobody sees that lie in it."""
_TAKEN = 0.95
"""Share of what a container no longer lists that is really gone."""


@dataclass(frozen=True, slots=True)
class _Lying:
    """Somebody lies on a thing, by its id."""

    on: str
    confidence: float


class Beliefs:
    """Follows carried things and people in bed; not thread-safe.

    Args:
        surfaces: where things may be left.
    """

    def __init__(self, surfaces: Sequence[Surface] = ()) -> None:
        self._surfaces = tuple(surfaces)
        self._carried: dict[str, Carrying] = {}
        self._lying: dict[str, _Lying] = {}
        self._heard: dict[str, float] = {}
        self._lists: dict[str, tuple[float, frozenset[str]]] = {}

    def observe(self, world: WorldModel, sample: Observation) -> None:
        """Follow what a source has just told the world model."""
        self._heard[sample.source] = max(
            sample.captured_at, self._heard.get(sample.source, sample.captured_at)
        )
        contents = dict(sample.facts).get("contents")
        if sample.thing == sample.source and isinstance(contents, str):
            self._lists[sample.thing] = sample.captured_at, frozenset(contents.split(","))
        if sample.inside or sample.thing in self._carried:
            self._follow(world, sample.thing)
        if sample.valid and sample.position is not None:
            for carrying in self._carried.values():
                if carrying.carrier == sample.thing:
                    carrying.add(sample.captured_at, sample.position)

    def note(self, event: RoomEvent) -> None:
        """Note who lies down and gets up."""
        if event.kind == SituationKind.PERSON_LYING:
            on = str(dict[str, Fact](event.facts).get("on", ""))
            self._lying[event.thing] = _Lying(on, event.confidence)
        elif event.kind == SituationKind.PERSON_LYING.ended:
            self._lying.pop(event.thing, None)

    def carried(self) -> Mapping[str, Carrying]:
        """Return what is carried, by id."""
        return self._carried

    def retrace(self, world: WorldModel, thing: str, way: Iterable[tuple[float, Vec3]]) -> None:
        """Follow a carried thing anew along times [s, Unix time] and places [m] of its carrier."""
        old = self._carried[thing]
        new = self._carried[thing] = Carrying(old.carrier, old.since, self._free_surfaces(world))
        for at, position in way:
            new.add(at, position)

    def of(self, world: WorldModel, thing: str, now: float) -> Belief:
        """Return how sure the world model's answer is at a time [s, Unix time]."""
        known = world.thing(thing)
        found = world.where(known.id)
        if known.id in self._carried:
            return self._carried[known.id].belief(now)
        if found.inside in self._lists and found.seen_at is not None:
            return self._listed(known.id, found.inside, found.seen_at)
        if known.kind is ThingKind.PERSON and found.seen_at is not None:
            return self._unseen(world, known.id, self._unseen_for(found, now))
        return SURE

    def _follow(self, world: WorldModel, thing: str) -> None:
        found = world.where(thing)
        by = found.inside
        seen_itself = found.position is not None and not found.by_container
        carried = by and world.thing(by).kind in CARRIERS and not seen_itself
        if not carried or found.seen_at is None:
            self._carried.pop(thing, None)
            return
        known = self._carried.get(thing)
        if known is None or known.carrier != by or known.since != found.seen_at:
            self._carried[thing] = Carrying(by, found.seen_at, self._free_surfaces(world))

    def _free_surfaces(self, world: WorldModel) -> tuple[Surface, ...]:
        """Return the surfaces without those of containers that tell what is put into them."""
        told = [world.where(box).position for box in self._lists]
        return tuple(
            surface
            for surface in self._surfaces
            if not any(place and surface.distance(place[:2]) == 0.0 for place in told)
        )

    def _listed(self, thing: str, box: str, seen_at: float) -> Belief:
        at, names = self._lists[box]
        if thing in names or at <= seen_at:
            return SURE
        return belief_in(1.0 - _TAKEN, (Hypothesis("taken by somebody since", "", None, _TAKEN),))

    def _unseen_for(self, found: FusedPose, now: float) -> float:
        """Return for how long somebody has surely been out of sight [s], 0 while they are seen."""
        seen_at = now if found.seen_at is None else found.seen_at
        missed = all(self._heard.get(by, 0.0) > seen_at + _MISSED_AFTER for by in found.sources)
        return max(0.0, now - seen_at - (_MISSED_AFTER if missed else _UNSEEN_AFTER))

    def _unseen(self, world: WorldModel, thing: str, unseen: float) -> Belief:
        if unseen == 0.0:
            return SURE
        lying = self._lying.get(thing)
        in_bed = _IN_BED * lying.confidence if lying is not None else 0.0
        there = (1.0 - in_bed) * 0.5 ** (unseen / _UNSEEN_TIME)
        others = []
        if lying is not None:
            bed = next((one for one in world.things if one.id == lying.on), None)
            name, place = ("bed", None) if bed is None else (with_article(bed.name), bed.position)
            others.append(Hypothesis(f"in {name}", lying.on, place, in_bed))
        return belief_in(there, others)
