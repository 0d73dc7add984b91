"""The shortest time in which a drone can fly a way from rest to rest, whatever its pilot does.

Source: Pontryagin's principle on a straight line. With the tilt bounded, the acceleration is
``A - k v`` at most, and the braking ``A + k v``, with ``A = g tan(tilt)`` and drag ``k``; the
fastest flight accelerates fully, keeps the speed limit, and brakes fully.
"""

from __future__ import annotations

from math import log1p, tan

from housefly.geometry import GRAVITY

_HALVINGS = 60
_DRAG_MIN = 1e-6
"""Less drag counts as this [1/s]: the formulas divide by it."""


def shortest_time(length: float, speed: float, tilt: float, drag: float) -> float:
    """Return the least time from rest to rest along a straight line [s].

    A curve of the same length takes longer: what it needs to turn it cannot use to speed up.

    Args:
        length: of the way [m].
        speed: limit [m/s].
        tilt: limit [rad].
        drag: over mass [1/s].
    """
    push, drag = GRAVITY * tan(tilt), max(drag, _DRAG_MIN)
    if length <= 0.0:
        return 0.0
    low, top = 0.0, min(speed, push / drag * (1.0 - 1e-9))
    if _way(top, push, drag) > length:
        for _ in range(_HALVINGS):
            middle = 0.5 * (low + top)
            low, top = (middle, top) if _way(middle, push, drag) < length else (low, middle)
    cruise = max(0.0, length - _way(top, push, drag)) / top
    return (log1p(drag * top / push) - log1p(-drag * top / push)) / drag + cruise


def _way(top: float, push: float, drag: float) -> float:
    """Return how far a flight comes that only speeds up to a speed and brakes [m]."""
    up, down = -log1p(-drag * top / push), log1p(drag * top / push)
    return (push * up / drag - top) / drag + (top - push * down / drag) / drag
