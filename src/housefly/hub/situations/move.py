"""A thing was taken or put: what the sources of things report to the detector of objects."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.geometry import Vec3
from housefly.messages import Facts

TAKEN, PUT = "object taken", "object put"


@dataclass(frozen=True, slots=True)
class Move:
    """One move of a thing.

    Attributes:
        kind: ``TAKEN`` or ``PUT``.
        thing: id.
        at: when [s, Unix time].
        container: id of what it was taken from or put into, "" for none.
        position: where it was taken or put [m]; None when that is the container's own place.
        confidence: 0 to 1.
        evidence: which source says so and what.
        dated: whether the time is known so well that it can be said who was near.
        facts: the numbers.
    """

    kind: str
    thing: str
    at: float
    container: str
    position: Vec3 | None
    confidence: float
    evidence: str
    dated: bool = True
    facts: Facts = ()
