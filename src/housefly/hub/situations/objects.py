"""Detects objects taken, put and missing: from where, to where, and by whom."""

from __future__ import annotations

from collections.abc import Mapping

from housefly.geometry import Vec3
from housefly.hub.situations.actor import NO_ACTOR, Actor, actor_near
from housefly.hub.situations.contents import ContentsDetector
from housefly.hub.situations.hysteresis import Hysteresis, claimed_by
from housefly.hub.situations.kinds import SituationKind
from housefly.hub.situations.layout import Layout
from housefly.hub.situations.move import Move
from housefly.hub.situations.person_tracks import PersonTracks
from housefly.hub.situations.resting import RestingDetector
from housefly.hub.situations.situation import (
    SOURCE_PREFIX,
    Assessment,
    DetectorInput,
    Evidence,
    Situation,
    evidence_facts,
)
from housefly.messages import Facts, RoomEvent

_SOURCE = SOURCE_PREFIX + "objects"
MISSING_AFTER = 300.0
"""A taken thing that nothing has seen for this long is missing [s]."""
_MISSING_CONFIDENCE = 0.8
"""Confidence that it is missing."""
_DWELL = {SituationKind.OBJECT_MISSING: 0.0, None: 0.0}


class Objects:
    """Detects moves of all things that have a tag or are seen by position.

    Args:
        tracks: where people are; fed by whoever owns it.
        layout: where the containers stand.
    """

    def __init__(self, tracks: PersonTracks, layout: Layout) -> None:
        self._tracks, self._places, self._robots = tracks, layout.containers, layout.robots
        self._contents, self._resting = ContentsDetector(layout.containers), RestingDetector(tracks)
        self._carrier: dict[str, str] = {}
        self._taken: dict[str, Move] = {}
        self._states: dict[str, Hysteresis] = {}

    def add(self, item: DetectorInput) -> None:
        """Add what containers and position sensors report about things."""
        self._contents.add(item)
        if item.thing not in self._robots and not self._contents.container_of(item.thing):
            self._resting.add(item)

    def update(self, now: float) -> tuple[RoomEvent, ...]:
        """Return what was taken, put, or became missing up to a time [s]."""
        events = [self._event(move) for move in self._contents.moves(now)]
        events += [self._event(move) for move in self._resting.moves(now)]
        for thing, hysteresis in sorted(self._states.items()):
            events += hysteresis.update(now, self._missing(thing, now))
        return tuple(events)

    def active(self) -> tuple[Situation, ...]:
        """Return what is missing."""
        return claimed_by(hysteresis for _, hysteresis in sorted(self._states.items()))

    def _event(self, move: Move) -> RoomEvent:
        actor = self._actor(move)
        if move.container:
            self._resting.mark_moved(move.thing)
        self._note(move, actor)
        facts = (
            *_where(move, self._places),
            *move.facts,
            *actor.facts,
            *evidence_facts((move.evidence,)),
        )
        return RoomEvent(
            move.kind, move.thing, move.at, _SOURCE, actor.person, move.confidence, facts
        )

    def _actor(self, move: Move) -> Actor:
        place = move.position or self._places.get(move.container)
        if place is None or not move.dated:
            return NO_ACTOR
        return actor_near(
            self._tracks,
            place,
            move.at,
            self._carrier.get(move.thing, "") if move.kind == SituationKind.OBJECT_PUT else "",
        )

    def _note(self, move: Move, actor: Actor) -> None:
        if move.kind == SituationKind.OBJECT_TAKEN:
            self._carrier[move.thing], self._taken[move.thing] = actor.person, move
            self._states.setdefault(move.thing, Hysteresis(move.thing, _SOURCE, _DWELL))
        else:
            self._carrier.pop(move.thing, None)
            self._taken.pop(move.thing, None)

    def _missing(self, thing: str, now: float) -> Assessment | None:
        taken = None if self._contents.container_of(thing) else self._taken.get(thing)
        seen = max(taken.at if taken else now, self._resting.last_seen(thing) or 0.0)
        if taken is None or now - seen < MISSING_AFTER:
            return Assessment(
                None,
                _MISSING_CONFIDENCE,
                None,
                (Evidence("it is where it was put" if taken is None else "not for long"),),
            )
        if not self._contents.all_live(now) or not self._resting.is_live(thing, now):
            return None
        told = taken.evidence
        evidence = (Evidence(f"{told.report}, and no source has it since", told.source),)
        by: Facts = (("taken_by", self._carrier[thing]),) if self._carrier[thing] else ()
        facts = (("last_seen", seen), *_where(taken, self._places), *by)
        return Assessment(
            SituationKind.OBJECT_MISSING,
            _MISSING_CONFIDENCE * taken.confidence,
            seen + MISSING_AFTER,
            evidence,
            facts,
            self._carrier[thing],
        )


def _where(move: Move, places: Mapping[str, Vec3]) -> Facts:
    place = move.position or places.get(move.container)
    named: Facts = (
        ((("from" if move.kind == SituationKind.OBJECT_TAKEN else "into"), move.container),)
        if move.container
        else ()
    )
    return named if place is None else (*named, ("x", place[0]), ("y", place[1]), ("z", place[2]))
