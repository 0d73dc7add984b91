"""Where things rest that a source sees by position, made into moves: one that leaves its place, one
that comes to rest.
"""

from __future__ import annotations

from dataclasses import dataclass

from housefly.geometry import Vec3, distance
from housefly.hub.situations.move import PUT, TAKEN, Move
from housefly.hub.situations.situation import Item
from housefly.hub.situations.tracks import Tracks
from housefly.messages import Observation

STILL = 0.06
"""A thing that stays within this distance rests [m]."""
REST = 2.0
"""So long must it stay before it rests [s]."""
MOVED = 0.25
"""A thing this far from where it rested was moved [m]."""
GONE = 0.5
"""So long must it be away before it was taken [s]: one wrong position is no move."""
HAND = 0.7
"""What rests closer to a person than this may be in their hand [m]."""
LEFT_ALONE = 30.0
"""Unless it rests for this long [s]."""
BELIEF = 0.8
"""Confidence in a move seen by position."""


@dataclass(slots=True)
class _Thing:
    """One thing as one source sees it.

    Attributes:
        anchor: where it is still [m].
        since: since when [s, Unix time].
        last: when it was last seen [s, Unix time].
        rest: where it rested last [m]; None while it is moved.
        away: when it left that place [s, Unix time], None while it is there.
        fresh: whether nothing is known of how it came here.
    """

    anchor: Vec3
    since: float
    last: float
    rest: Vec3 | None = None
    away: float | None = None
    fresh: bool = True


class Rests:
    """Watches things that are seen by position, one source a thing: the first that sees it.

    Args:
        tracks: where people are; fed by whoever owns it.
    """

    def __init__(self, tracks: Tracks) -> None:
        self._tracks = tracks
        self._things: dict[tuple[str, str], _Thing] = {}
        self._source: dict[str, str] = {}

    def take(self, item: Item) -> None:
        """Take a position of a thing that is in no container."""
        if (
            not isinstance(item, Observation)
            or not item.valid
            or item.position is None
            or item.inside
        ):
            return
        if (
            self._tracks.is_person(item)
            or self._source.setdefault(item.thing, item.source) != item.source
        ):
            return
        key, at, place = (item.thing, item.source), item.captured_at, item.position
        thing = self._things.setdefault(key, _Thing(place, at, at))
        thing.last = at
        if distance(place, thing.anchor) > STILL:
            thing.anchor, thing.since = place, at
        if thing.rest is None or distance(place, thing.rest) <= MOVED:
            thing.away = None
        elif thing.away is None:
            thing.away = at

    def moves(self, now: float) -> tuple[Move, ...]:
        """Return which things were taken from their place, or put down, since the last call."""
        found = (
            self._move(name, source, thing, now)
            for (name, source), thing in sorted(self._things.items())
        )
        return tuple(move for move in found if move is not None)

    def seen(self, thing: str) -> float | None:
        """Return when a thing was last seen by position [s, Unix time], None for never."""
        return max(
            (row.last for (name, _), row in self._things.items() if name == thing), default=None
        )

    def known(self, thing: str, now: float) -> bool:
        """Tell whether the source that saw a thing still speaks, so that its not being seen says
        something.
        """
        return thing not in self._source or self._tracks.speaks(self._source[thing], now)

    def lifted(self, thing: str) -> None:
        """Note that a thing was moved, as another source knows: where it comes to rest it was put."""
        for (name, _), row in self._things.items():
            if name == thing:
                row.rest, row.away, row.fresh = None, None, False

    def _move(self, name: str, source: str, thing: _Thing, now: float) -> Move | None:
        if thing.rest is not None and thing.away is not None and thing.last - thing.away >= GONE:
            taken = Move(
                TAKEN, name, thing.away, "", thing.rest, BELIEF, f"{source}: left its place"
            )
            thing.rest, thing.away, thing.fresh = None, None, False
            return taken
        if thing.rest is None and self._rests(thing):
            put = Move(PUT, name, thing.since, "", thing.anchor, BELIEF, f"{source}: came to rest")
            fresh, thing.fresh, thing.rest = thing.fresh, False, thing.anchor
            return None if fresh else put
        return None

    def _rests(self, thing: _Thing) -> bool:
        stayed = thing.last - thing.since
        nearest = min(
            (away for away, _, _ in self._tracks.distances(thing.anchor, thing.last)),
            default=float("inf"),
        )
        return stayed >= REST and (nearest > HAND or stayed >= LEFT_ALONE)
