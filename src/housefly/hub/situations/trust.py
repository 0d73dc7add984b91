"""How far a word that is getting old is believed, and how independent words add up."""

from __future__ import annotations

from collections.abc import Iterable
from math import prod

MISSED_BEATS = 2.0
"""So many heartbeats of a source may be missing before its last word loses weight."""
CLAIM = 0.5
"""A situation is claimed from this confidence."""
KNOWN = 0.25
"""Below this confidence a situation is not known any more."""


def trust(age: float, heartbeat: float) -> float:
    """Return how far a word of this age is still believed, 0 to 1.

    Whole for two heartbeats, then halved with every further one: after four it is below ``KNOWN``,
        the source counts as silent.

    Args:
        age: of the word [s].
        heartbeat: longest time between two words of a source that is well [s].
    """
    late = max(0.0, age / heartbeat - MISSED_BEATS)
    return float(0.5**late) if late <= 2.0 else 0.0


def together(confidences: Iterable[float]) -> float:
    """Return the confidence that at least one of several independent words is right."""
    return 1.0 - prod(1.0 - confidence for confidence in confidences)
