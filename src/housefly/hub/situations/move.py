"""A thing was taken or put, as reported to the detector of objects."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.geometry import Vec3
from housefly.hub.situations.kinds import SituationKind
from housefly.hub.situations.situation import Evidence
from housefly.messages import Facts


@dataclass(frozen=True, slots=True)
class Move:
    """One move of a thing.

    Attributes:
        kind: ``SituationKind.OBJECT_TAKEN`` or ``SituationKind.OBJECT_PUT``.
        thing: id.
        at: when [s, Unix time].
        container: id of what it was taken from or put into, "" for none.
        position: where it was taken or put [m]; None at the container's own position.
        confidence: 0 to 1.
        evidence: which source reports what.
        dated: whether the time is exact enough to say who was near.
        facts: the numbers.
    """

    kind: SituationKind
    thing: str
    at: float
    container: str
    position: Vec3 | None
    confidence: float
    evidence: Evidence
    dated: bool = True
    facts: Facts = ()
