"""Who took or put a thing: the nearest person within reach at that time, unless two might have been
it.
"""

from __future__ import annotations

from dataclasses import dataclass

from housefly.hub.situations.tracks import Tracks
from housefly.messages import Facts

REACH = 1.2
"""Farthest distance over the floor from which somebody reaches a thing [m]."""
SURE = 0.65
"""Share of the sum of the two nearest distances that must lie with the other for the nearest to be
named.
"""


@dataclass(frozen=True, slots=True)
class Doer:
    """Who did it: id or "", confidence 0 to 1, and the numbers."""

    person: str
    confidence: float
    facts: Facts = ()


NOBODY = Doer("", 0.0)


def doer_near(tracks: Tracks, place: tuple[float, ...], at: float, carrier: str = "") -> Doer:
    """Return who was near a place at a time.

    Args:
        tracks: where people were.
        place: world [m].
        at: when [s, Unix time].
        carrier: who is known to carry the thing: named as soon as they are within reach.
    """
    near = sorted(row for row in tracks.distances(place, at) if row[0] <= REACH)
    if not near:
        return NOBODY
    for away, person, believed in near:
        if person == carrier:
            return Doer(person, believed, _facts(away, believed))
    away, person, believed = near[0]
    share = near[1][0] / max(away + near[1][0], 1e-9) if len(near) > 1 else 1.0
    if share < SURE:
        return Doer("", 0.0, (("candidates", ",".join(sorted(name for _, name, _ in near))),))
    return Doer(person, share * believed, _facts(away, share * believed))


def _facts(away: float, confidence: float) -> Facts:
    return (("by_distance", away), ("by_confidence", confidence))
