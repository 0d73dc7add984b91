"""Who took or put a thing: the nearest person within reach, unless it might have been two."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.hub.situations.person_tracks import PersonTracks
from housefly.messages import Facts

ARM_REACH = 1.2
"""Farthest distance over the floor at which somebody reaches a thing [m]."""
_SURE_SHARE = 0.65
"""The nearest person is named if the other's share of both distances is at least this."""


@dataclass(frozen=True, slots=True)
class Actor:
    """Who did it: an id or "", the confidence from 0 to 1, and the numbers."""

    person: str
    confidence: float
    facts: Facts = ()


NO_ACTOR = Actor("", 0.0)


def actor_near(
    tracks: PersonTracks, place: tuple[float, ...], at: float, carrier: str = ""
) -> Actor:
    """Return who was near a place at a time.

    Args:
        tracks: where people were.
        place: world [m].
        at: when [s, Unix time].
        carrier: who carried the thing so far; preferred if within reach.
    """
    near = sorted(row for row in tracks.distances(place, at) if row[0] <= ARM_REACH)
    if not near:
        return NO_ACTOR
    for away, person, confidence in near:
        if person == carrier:
            return Actor(person, confidence, _facts(away, confidence))
    away, person, confidence = near[0]
    share = near[1][0] / max(away + near[1][0], 1e-9) if len(near) > 1 else 1.0
    if share < _SURE_SHARE:
        return Actor("", 0.0, (("candidates", ",".join(sorted(name for _, name, _ in near))),))
    return Actor(person, share * confidence, _facts(away, share * confidence))


def _facts(away: float, confidence: float) -> Facts:
    return (("by_distance", away), ("by_confidence", confidence))
