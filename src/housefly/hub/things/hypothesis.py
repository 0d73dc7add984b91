"""Where else a thing may be, and how sure the first answer is."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from housefly.geometry import Vec3


@dataclass(frozen=True, slots=True)
class Hypothesis:
    """One more place where a thing may be.

    Attributes:
        words: what would have happened: "left on the sofa table".
        thing: id of the thing on or in which it would be, "" for none.
        position: world [m]; None when nobody can say.
        confidence: 0 to 1.
    """

    words: str
    thing: str
    position: Vec3 | None
    confidence: float


@dataclass(frozen=True, slots=True)
class Belief:
    """How sure an answer is: its confidence, 0 to 1, and what else may be, the likeliest first."""

    confidence: float
    alternatives: tuple[Hypothesis, ...] = ()


SURE = Belief(1.0)
_NAMED_FROM = 0.05
"""Less likely alternatives are not named; they still cost confidence."""
_MAX_NAMED = 3
"""So many places are named; what is left over is "elsewhere"."""


def belief_in(first: float, others: Iterable[Hypothesis] = ()) -> Belief:
    """Return the belief in a first answer and in other places; what is left is elsewhere."""
    likely = [one for one in others if one.confidence >= _NAMED_FROM]
    named = sorted(likely, key=lambda one: (-one.confidence, one.words))[:_MAX_NAMED]
    rest = 1.0 - first - sum(one.confidence for one in named)
    elsewhere = (Hypothesis("elsewhere", "", None, rest),) if rest >= _NAMED_FROM else ()
    return Belief(first, (*named, *elsewhere))
