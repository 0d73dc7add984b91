"""What the pilot remembers of the obstacles that it was told of: believed or refused, ageing,
forgotten.

An obstacle that nobody sees any more is believed less and less: its confidence halves every
    ``HALF_LIFE``, and below ``ENOUGH``
it frees its cells. One of full confidence therefore stands for ``FREED_AFTER``; one whose source
says 0 is gone at once.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import hypot, isfinite

import numpy as np

from housefly.geometry import Vec2
from housefly.messages.obstacles import Obstacle
from housefly.numeric import FloatArray

HALF_LIFE = 1.0
"""An obstacle that is not seen is half as believable after this [s]."""
ENOUGH = 0.25
"""Obstacles less believable than this do not count."""
FREED_AFTER = 2.0
"""An obstacle of full confidence that is not seen any more frees its cells after this [s]."""
MOST = 64
"""No more obstacles than this are kept; the most believable stay."""
LARGEST = 5.0
"""No obstacle reaches farther from its middle than this [m]."""
FASTEST = 3.0
"""No obstacle moves faster than this [m/s]."""
AHEAD_OF_TIME = 0.05
"""How far a capture time may lie in the future [s]: clocks of two processes on one machine agree
better.
"""

Extent = tuple[float, float, float, float]


def fault_of(obstacle: Obstacle, now: float, extent: Extent) -> str:
    """Return why an obstacle is not believed, in words, or "".

    Args:
        obstacle: as its source sent it.
        now: time [s].
        extent: x_min, y_min, x_max, y_max of the map [m].
    """
    shape = (
        *obstacle.position,
        obstacle.radius,
        *obstacle.size,
        obstacle.yaw,
        obstacle.bottom,
        obstacle.top,
    )
    if not all(
        isfinite(number)
        for number in (*shape, *obstacle.velocity, obstacle.confidence, obstacle.seen_at)
    ):
        return "not all its numbers are finite"
    if not 0.0 <= obstacle.confidence <= 1.0:
        return "its confidence does not lie between 0 and 1"
    if obstacle.radius < 0.0 or min(obstacle.size) < 0.0 or _reach(obstacle) > LARGEST:
        return f"its size makes no sense (at most {LARGEST:.0f} m)"
    if hypot(*obstacle.velocity) > FASTEST:
        return f"it is faster than {FASTEST:.0f} m/s"
    if obstacle.seen_at > now + AHEAD_OF_TIME:
        return "it was seen in the future"
    (x, y), (x_min, y_min, x_max, y_max) = obstacle.position, extent
    if not (x_min - LARGEST <= x <= x_max + LARGEST and y_min - LARGEST <= y <= y_max + LARGEST):
        return "it lies far outside the map"
    return ""


def belief(obstacle: Obstacle, now: float) -> float:
    """Return how far an obstacle is believed now, 0 to 1."""
    age = max(0.0, now - obstacle.seen_at)
    return float(obstacle.confidence * 0.5 ** (age / HALF_LIFE))


@dataclass(frozen=True, slots=True)
class Memory:
    """The obstacles that count, the newest word of each; in the order of source and id."""

    obstacles: tuple[Obstacle, ...] = ()

    def after(self, heard: Iterable[Obstacle], now: float) -> Memory:
        """Return the memory after new words of obstacles, without those that are forgotten."""
        known = {(obstacle.source, obstacle.id): obstacle for obstacle in self.obstacles}
        for obstacle in heard:
            name = obstacle.source, obstacle.id
            if name not in known or known[name].seen_at <= obstacle.seen_at:
                known[name] = obstacle
        counting = [name for name in sorted(known) if belief(known[name], now) >= ENOUGH]
        if len(counting) > MOST:
            counting = sorted(sorted(counting, key=lambda name: -belief(known[name], now))[:MOST])
        obstacles = tuple(known[name] for name in counting)
        return self if obstacles == self.obstacles else Memory(obstacles)


def rows_of(
    obstacles: Iterable[Obstacle], now: float, horizon: float, band: Vec2
) -> tuple[FloatArray, tuple[str, ...]]:
    """Return the ground that obstacles may cover until a time ahead, one row each, and the names
    that belong to the rows.

    A row is x, y, half length, half width, cos yaw, sin yaw, radius, and the way that it moves in x
    and y [m]: from where it was seen, because it may have stopped since, to where it will be. A
    rectangle that moves counts as the disc around it.

    Args:
        obstacles: what is known.
        now: time [s].
        horizon: how far ahead [s].
        band: heights between which an obstacle counts [m].
    """
    counting = [
        obstacle for obstacle in obstacles if obstacle.bottom <= band[1] and obstacle.top >= band[0]
    ]
    rows = np.array(
        [_row(obstacle, now, horizon) for obstacle in counting], dtype=np.float64
    ).reshape(-1, 9)
    return rows, tuple(obstacle.id for obstacle in counting)


def _row(obstacle: Obstacle, now: float, horizon: float) -> tuple[float, ...]:
    (x, y), (length, width), (vx, vy) = obstacle.position, obstacle.size, obstacle.velocity
    ahead = max(0.0, now - obstacle.seen_at) + horizon
    if vx or vy:
        return x, y, 0.0, 0.0, 1.0, 0.0, _reach(obstacle), vx * ahead, vy * ahead
    return (
        x,
        y,
        length / 2,
        width / 2,
        float(np.cos(obstacle.yaw)),
        float(np.sin(obstacle.yaw)),
        obstacle.radius,
        0.0,
        0.0,
    )


def _reach(obstacle: Obstacle) -> float:
    """Return the radius of the disc around an obstacle [m]."""
    return hypot(*obstacle.size) / 2 + obstacle.radius
