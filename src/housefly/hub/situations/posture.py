"""How somebody is, from where they are, how fast they move and how high their head is: the first
rule that fits.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from housefly.hub.situations.layout import Area, Layout

WALKING, STANDING, SITTING, LYING = (
    "person walking",
    "person standing",
    "person sitting",
    "person lying",
)

WALK = 0.35
"""From this speed on a person walks [m/s]."""
STOP = 0.2
"""Below this speed who walked stands [m/s]."""
SEAT_MARGIN = 0.05
"""Who is at most this far beside a seat or bed is on it [m]."""
FALLEN_HEAD = 0.5
"""Whose head is lower and who is not in bed lies on the floor [m]."""
PILLOW_HEAD = 0.95
"""Whose head is higher sits on the bed instead of lying there [m]."""
SEATED_HEAD = 1.45
"""Whose head is higher stands before the seat instead of sitting on it [m]."""


@dataclass(frozen=True, slots=True)
class Looks:
    """What is known of one person at one moment.

    Attributes:
        speed: over the floor [m/s].
        walked: whether they walked until now.
        head: height of the head above the floor [m], None when unknown.
        seat: the seat that they are on, None for none.
        bed: likewise.
        loaded: whether the bed feels somebody; None when it does not say, or there is no bed.
    """

    speed: float
    walked: bool
    head: float | None
    seat: Area | None
    bed: Area | None
    loaded: bool | None

    @property
    def moves(self) -> bool:
        """Whether they walk, with hysteresis."""
        return self.speed >= (STOP if self.walked else WALK)


@dataclass(frozen=True, slots=True)
class Rule:
    """One way to be; the words say why."""

    kind: str
    confidence: float
    fits: Callable[[Looks], bool]
    words: str


RULES: tuple[Rule, ...] = (
    Rule(
        LYING, 0.8, lambda p: p.bed is None and _below(p.head, FALLEN_HEAD), "head near the floor"
    ),
    Rule(WALKING, 0.9, lambda p: p.moves, "moves over the floor"),
    Rule(
        SITTING,
        0.85,
        lambda p: p.bed is not None and _above(p.head, PILLOW_HEAD) and p.loaded is not False,
        "head high on bed",
    ),
    Rule(
        LYING,
        0.95,
        lambda p: p.bed is not None and p.loaded is True,
        "in bed, and the bed feels it",
    ),
    Rule(LYING, 0.6, lambda p: p.bed is not None and p.loaded is None, "in bed"),
    Rule(
        STANDING,
        0.8,
        lambda p: p.seat is not None and _above(p.head, SEATED_HEAD),
        "head high before seat",
    ),
    Rule(SITTING, 0.9, lambda p: p.seat is not None and p.head is not None, "on seat, head low"),
    Rule(SITTING, 0.8, lambda p: p.seat is not None, "on seat"),
    Rule(STANDING, 0.9, lambda p: True, "stays where they are"),
)
"""From the surest sign to the weakest; confidences are for positions that are fresh."""


def rule_for(looks: Looks) -> Rule:
    """Return the rule that fits."""
    return next(rule for rule in RULES if rule.fits(looks))


def seat_at(layout: Layout, point: tuple[float, ...]) -> Area | None:
    """Return the seat that a point is on, None for none."""
    return next((seat for seat in layout.seats if seat.distance(point) <= SEAT_MARGIN), None)


def bed_at(layout: Layout, point: tuple[float, ...]) -> str:
    """Return the id of the bed that a point is on, "" for none."""
    return next(
        (bed for bed, area in sorted(layout.beds.items()) if area.distance(point) <= SEAT_MARGIN),
        "",
    )


def _below(head: float | None, limit: float) -> bool:
    return head is not None and head < limit


def _above(head: float | None, limit: float) -> bool:
    return head is not None and head >= limit
