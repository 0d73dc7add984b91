"""How confidence decays with age, and how independent sources add up."""

from __future__ import annotations

from collections.abc import Iterable
from math import prod

_MISSED_BEATS = 2.0
"""Heartbeats that a source may miss before confidence in its last message decays."""
CLAIM_THRESHOLD = 0.5
"""A situation is claimed from this confidence on."""
KNOWN_THRESHOLD = 0.25
"""Below this confidence a situation is unknown."""


def freshness(age: float, heartbeat: float) -> float:
    """Return the confidence factor of a message by its age, 0 to 1.

    It is 1 for two heartbeats, then halves with each further one. After four heartbeats it is
    below ``KNOWN_THRESHOLD`` and the source counts as silent.

    Args:
        age: of the message [s].
        heartbeat: longest time between two messages of a healthy source [s].
    """
    late = max(0.0, age / heartbeat - _MISSED_BEATS)
    return float(0.5**late) if late <= 2.0 else 0.0


def noisy_or(confidences: Iterable[float]) -> float:
    """Return the confidence that at least one of several independent sources is right."""
    return 1.0 - prod(1.0 - confidence for confidence in confidences)
