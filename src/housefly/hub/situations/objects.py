"""Things: taken, put and missing; from where, to where, and by whom."""

from __future__ import annotations

from collections.abc import Mapping

from housefly.geometry import Vec3
from housefly.hub.situations.contents import Contents
from housefly.hub.situations.latch import Latch
from housefly.hub.situations.layout import Layout
from housefly.hub.situations.move import PUT, TAKEN, Move
from housefly.hub.situations.rests import Rests
from housefly.hub.situations.situation import OURS, Finding, Item, Situation
from housefly.hub.situations.tracks import Tracks
from housefly.hub.situations.who import NOBODY, Doer, doer_near
from housefly.messages import Facts, Happening

MISSING = "object missing"
SOURCE = OURS + "objects"
MISSING_AFTER = 300.0
"""A thing that nothing has seen for this long since it was taken is missing [s]."""
BELIEF = 0.8
"""Confidence that it is."""
DWELL = {MISSING: 0.0, "": 0.0}


class Objects:
    """Watches all things that have a tag or are seen by position.

    Args:
        tracks: where people are; fed by whoever owns it.
        layout: where the containers stand.
    """

    def __init__(self, tracks: Tracks, layout: Layout) -> None:
        self._tracks, self._places = tracks, layout.containers
        self._contents, self._rests = Contents(layout.containers), Rests(tracks)
        self._carrier: dict[str, str] = {}
        self._taken: dict[str, Move] = {}
        self._latches: dict[str, Latch] = {}

    def take(self, item: Item) -> None:
        """Take what containers and sources of positions say of things."""
        self._contents.take(item)
        if not self._contents.where(item.thing):
            self._rests.take(item)

    def after(self, now: float) -> tuple[Happening, ...]:
        """Return what was taken and put, and what came to be missing, up to a time [s]."""
        told = [self._told(move) for move in self._contents.moves(now)]
        told += [self._told(move) for move in self._rests.moves(now)]
        for thing, latch in sorted(self._latches.items()):
            told += latch.step(now, self._missing(thing, now))
        return tuple(told)

    def holds(self) -> tuple[Situation, ...]:
        """Return what is missing."""
        return tuple(
            latch.situation
            for _, latch in sorted(self._latches.items())
            if latch.situation is not None
        )

    def _told(self, move: Move) -> Happening:
        doer = self._doer(move)
        if move.container:
            self._rests.lifted(move.thing)
        self._note(move, doer)
        facts = (*_where(move, self._places), *move.facts, *doer.facts, ("evidence", move.evidence))
        return Happening(
            move.kind, move.thing, move.at, SOURCE, doer.person, move.confidence, facts
        )

    def _doer(self, move: Move) -> Doer:
        place = move.position or self._places.get(move.container)
        if place is None or not move.dated:
            return NOBODY
        return doer_near(
            self._tracks,
            place,
            move.at,
            self._carrier.get(move.thing, "") if move.kind == PUT else "",
        )

    def _note(self, move: Move, doer: Doer) -> None:
        if move.kind == TAKEN:
            self._carrier[move.thing], self._taken[move.thing] = doer.person, move
            self._latches.setdefault(move.thing, Latch(move.thing, SOURCE, DWELL))
        else:
            self._carrier.pop(move.thing, None)
            self._taken.pop(move.thing, None)

    def _missing(self, thing: str, now: float) -> Finding | None:
        taken = None if self._contents.where(thing) else self._taken.get(thing)
        seen = max(taken.at if taken else now, self._rests.seen(thing) or 0.0)
        if taken is None or now - seen < MISSING_AFTER:
            return Finding(
                "",
                BELIEF,
                None,
                ("it is where it was put",) if taken is None else ("not for long",),
            )
        if not self._contents.known(now) or not self._rests.known(thing, now):
            return None
        words = (f"{taken.evidence}, and no source has it since",)
        by: Facts = (("taken_by", self._carrier[thing]),) if self._carrier[thing] else ()
        facts = (("last_seen", seen), *_where(taken, self._places), *by)
        return Finding(
            MISSING,
            BELIEF * taken.confidence,
            seen + MISSING_AFTER,
            words,
            facts,
            self._carrier[thing],
        )


def _where(move: Move, places: Mapping[str, Vec3]) -> Facts:
    place = move.position or places.get(move.container)
    named: Facts = (
        ((("from" if move.kind == TAKEN else "into"), move.container),) if move.container else ()
    )
    return named if place is None else (*named, ("x", place[0]), ("y", place[1]), ("z", place[2]))
