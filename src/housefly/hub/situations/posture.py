"""Posture of a person from place, speed and height of the head: the first rule that fits."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from housefly.hub.situations.bed import Beds
from housefly.hub.situations.kinds import SituationKind
from housefly.hub.situations.layout import Area, Layout
from housefly.hub.situations.person_tracks import PersonTrack

WALK_SPEED = 0.35
"""A person at least this fast walks [m/s]."""
STOP_SPEED = 0.2
"""A walking person slower than this stands [m/s]."""
_SEAT_MARGIN = 0.05
"""Whoever is at most this far beside a seat or bed is on it [m]."""
_FALLEN_HEAD = 0.5
"""Somebody with a lower head, not in bed, lies on the floor [m]."""
_PILLOW_HEAD = 0.95
"""Somebody with a higher head sits on the bed instead of lying there [m]."""
_SEATED_HEAD = 1.45
"""Somebody with a higher head stands in front of the seat instead of sitting on it [m]."""
_CUSHION_HEAD = 0.8
"""Somebody with a lower head, on a seat, lies on it [m]."""
STRETCHED_EXTENT = 1.1
"""Somebody who touches the floor over at least this length lies on it [m]."""


@dataclass(frozen=True, slots=True)
class PersonFeatures:
    """Features of one person at one moment.

    Attributes:
        speed: over the floor [m/s].
        walked: whether they walked until now.
        head: height of the head above the floor [m], None if unknown.
        seat: the seat that they are on, None for none.
        bed: the bed that they are on, None for none.
        loaded: whether the bed is loaded; None if unknown, or without a bed.
        extent: over what length they touch the floor [m], None if unknown.
    """

    speed: float
    walked: bool
    head: float | None
    seat: Area | None
    bed: Area | None
    loaded: bool | None
    extent: float | None = None

    @property
    def lies_on_floor(self) -> bool:
        """Whether they lie on the floor: neither bed nor seat carries them."""
        if self.seat is not None or (self.bed is not None and self.loaded is not False):
            return False
        return is_down(self.head, self.extent)

    @property
    def moves(self) -> bool:
        """Whether they walk, with hysteresis."""
        return self.speed >= (STOP_SPEED if self.walked else WALK_SPEED)


@dataclass(frozen=True, slots=True)
class _Rule:
    """One posture; ``words`` say why."""

    kind: SituationKind
    confidence: float
    fits: Callable[[PersonFeatures], bool]
    words: str


RULES: tuple[_Rule, ...] = (
    _Rule(
        SituationKind.PERSON_LYING,
        0.8,
        lambda p: p.lies_on_floor and _below(p.head, _FALLEN_HEAD),
        "head near the floor",
    ),
    _Rule(SituationKind.PERSON_WALKING, 0.9, lambda p: p.moves, "moves over the floor"),
    _Rule(SituationKind.PERSON_LYING, 0.75, lambda p: p.lies_on_floor, "stretched over the floor"),
    _Rule(
        SituationKind.PERSON_SITTING,
        0.85,
        lambda p: p.bed is not None and _above(p.head, _PILLOW_HEAD) and p.loaded is not False,
        "head high on bed",
    ),
    _Rule(
        SituationKind.PERSON_LYING,
        0.95,
        lambda p: p.bed is not None and p.loaded is True,
        "in bed, and the bed feels it",
    ),
    _Rule(
        SituationKind.PERSON_LYING, 0.6, lambda p: p.bed is not None and p.loaded is None, "in bed"
    ),
    _Rule(
        SituationKind.PERSON_STANDING,
        0.8,
        lambda p: p.seat is not None and _above(p.head, _SEATED_HEAD),
        "head high before seat",
    ),
    _Rule(
        SituationKind.PERSON_LYING,
        0.75,
        lambda p: p.seat is not None and _below(p.head, _CUSHION_HEAD),
        "on seat, head as low as it",
    ),
    _Rule(
        SituationKind.PERSON_SITTING,
        0.9,
        lambda p: p.seat is not None and p.head is not None,
        "on seat, head low",
    ),
    _Rule(SituationKind.PERSON_SITTING, 0.8, lambda p: p.seat is not None, "on seat"),
    _Rule(SituationKind.PERSON_STANDING, 0.9, lambda p: True, "stays where they are"),
)
"""From the strongest evidence to the weakest; confidences hold for fresh positions."""


def rule_for(looks: PersonFeatures) -> _Rule:
    """Return the first rule that fits."""
    return next(rule for rule in RULES if rule.fits(looks))


def is_down(head: float | None, extent: float | None) -> bool:
    """Return whether head height [m] or extent on the floor [m] are of somebody who lies."""
    return _below(head, _FALLEN_HEAD) or _above(extent, STRETCHED_EXTENT)


def features_of(
    track: PersonTrack, speed: float, walked: bool, layout: Layout, beds: Beds, now: float
) -> PersonFeatures:
    """Return the features of a person at a time [s] by one source's track."""
    place, bed = track.last.position, bed_at(layout, track.last.position)
    return PersonFeatures(
        speed,
        walked,
        track.last.head,
        seat_at(layout, place),
        layout.beds.get(bed),
        beds.occupied(bed, now) if bed else None,
        track.last.extent,
    )


def seat_at(layout: Layout, point: tuple[float, ...]) -> Area | None:
    """Return the seat that a point is on, None for none."""
    return next((seat for seat in layout.seats if seat.distance(point) <= _SEAT_MARGIN), None)


def bed_at(layout: Layout, point: tuple[float, ...]) -> str:
    """Return the id of the bed that a point is on, "" for none."""
    return next(
        (bed for bed, area in sorted(layout.beds.items()) if area.distance(point) <= _SEAT_MARGIN),
        "",
    )


def _below(head: float | None, limit: float) -> bool:
    return head is not None and head < limit


def _above(length: float | None, limit: float) -> bool:
    return length is not None and length >= limit
