"""Turns positions of things into moves: one leaves its place, one comes to rest."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.geometry import Vec3, distance
from housefly.hub.situations.kinds import SituationKind
from housefly.hub.situations.move import Move
from housefly.hub.situations.person_tracks import PersonTracks
from housefly.hub.situations.situation import DetectorInput, Evidence
from housefly.messages import Observation

_STILL_RADIUS = 0.06
"""A thing that stays within this distance rests [m]."""
_REST_TIME = 2.0
"""How long a thing must be still before it rests [s]."""
_MOVED_DISTANCE = 0.25
"""A thing this far from where it rested was moved [m]."""
_GONE_AFTER = 0.5
"""How long a thing must be away before it was taken [s]: one wrong position is no move."""
_HAND_REACH = 0.7
"""What rests closer to a person than this may be in their hand [m]."""
LEFT_ALONE = 30.0
"""What rests for this long is in nobody's hand [s]."""
_POSITION_CONFIDENCE = 0.8
"""Confidence in a move seen by position."""


@dataclass(slots=True)
class _Thing:
    """One thing as one source sees it.

    Attributes:
        anchor: where it is still [m].
        since: since when it is still [s, Unix time].
        last: when it was last seen [s, Unix time].
        rest: where it rested last [m]; None while it is moved.
        away: when it left that place [s, Unix time], None while it is there.
        fresh: whether it is unknown how it came here.
    """

    anchor: Vec3
    since: float
    last: float
    rest: Vec3 | None = None
    away: float | None = None
    fresh: bool = True


class RestingDetector:
    """Detects moves of things seen by position; each thing by the first source that sees it.

    Args:
        tracks: where people are; fed by whoever owns it.
    """

    def __init__(self, tracks: PersonTracks) -> None:
        self._tracks = tracks
        self._things: dict[tuple[str, str], _Thing] = {}
        self._source: dict[str, str] = {}

    def add(self, item: DetectorInput) -> None:
        """Add a position of a thing that is in no container."""
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
        if distance(place, thing.anchor) > _STILL_RADIUS:
            thing.anchor, thing.since = place, at
        if thing.rest is None or distance(place, thing.rest) <= _MOVED_DISTANCE:
            thing.away = None
        elif thing.away is None:
            thing.away = at

    def moves(self, now: float) -> tuple[Move, ...]:
        """Return the things taken from their place, or put down, since the last call."""
        found = (
            self._move(name, source, thing, now)
            for (name, source), thing in sorted(self._things.items())
        )
        return tuple(move for move in found if move is not None)

    def last_seen(self, thing: str) -> float | None:
        """Return when a thing was last seen by position [s, Unix time], None for never."""
        return max(
            (row.last for (name, _), row in self._things.items() if name == thing), default=None
        )

    def is_live(self, thing: str, now: float) -> bool:
        """Return whether the source of a thing is alive, so that not seeing it means something."""
        return thing not in self._source or self._tracks.is_live(self._source[thing], now)

    def mark_moved(self, thing: str) -> None:
        """Note that another source moved a thing: where it comes to rest, it was put."""
        for (name, _), row in self._things.items():
            if name == thing:
                row.rest, row.away, row.fresh = None, None, False

    def _move(self, name: str, source: str, thing: _Thing, now: float) -> Move | None:
        if (
            thing.rest is not None
            and thing.away is not None
            and thing.last - thing.away >= _GONE_AFTER
        ):
            taken = Move(
                SituationKind.OBJECT_TAKEN,
                name,
                thing.away,
                "",
                thing.rest,
                _POSITION_CONFIDENCE,
                Evidence("left its place", source),
            )
            thing.rest, thing.away, thing.fresh = None, None, False
            return taken
        if thing.rest is None and self._is_resting(thing):
            put = Move(
                SituationKind.OBJECT_PUT,
                name,
                thing.since,
                "",
                thing.anchor,
                _POSITION_CONFIDENCE,
                Evidence("came to rest", source),
            )
            fresh, thing.fresh, thing.rest = thing.fresh, False, thing.anchor
            return None if fresh else put
        return None

    def _is_resting(self, thing: _Thing) -> bool:
        stayed = thing.last - thing.since
        nearest = min(
            (away for away, _, _ in self._tracks.distances(thing.anchor, thing.last)),
            default=float("inf"),
        )
        return stayed >= _REST_TIME and (nearest > _HAND_REACH or stayed >= LEFT_ALONE)
