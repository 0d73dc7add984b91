"""What the pilot remembers of the obstacles reported to it: accepted, ageing, forgotten.

An obstacle that nobody sees any more is believed less and less: its confidence halves every
    ``HALF_LIFE``, and below ``ENOUGH``
it frees its cells. One of full confidence therefore stands for ``FREED_AFTER``; one whose source
says 0 is gone at once.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import cos, exp2, hypot, isfinite, sin

import numpy as np

from housefly.geometry import Vec2
from housefly.messages.obstacles import Obstacle
from housefly.messages.words import UNSAID, Words, figure
from housefly.numeric import FloatArray
from housefly.pilot.planning.people import may_be_person, predicted_velocity

CERTAINTY_HALF_LIFE = 1.0
"""An obstacle that is not seen is half as believable after this [s]."""
CERTAINTY_MIN = 0.25
"""Obstacles less believable than this do not count."""
FREED_AFTER = 2.0
"""An obstacle of full confidence that is not seen any more frees its cells after this [s]."""
OBSTACLES_MAX = 64
"""No more obstacles than this are kept; the most believable stay."""
OBSTACLE_SIZE_MAX = 5.0
"""No obstacle reaches farther from its middle than this [m]."""
OBSTACLE_SPEED_MAX = 10.0
"""No obstacle moves faster than this [m/s]; people run, and are believed to be where they are."""
OBSTACLE_CLOCK_TOLERANCE = 0.05
"""How far a capture time may lie in the future [s]: clocks of two processes on one machine agree
better.
"""

MapExtent = tuple[float, float, float, float]


def obstacle_fault(obstacle: Obstacle, now: float, extent: MapExtent) -> Words:
    """Return why an obstacle is not believed, in words, or UNSAID.

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
    if not all(map(isfinite, (*shape, *obstacle.velocity, obstacle.confidence, obstacle.seen_at))):
        return Words("not all its numbers are finite")
    if not 0.0 <= obstacle.confidence <= 1.0:
        return Words("its confidence does not lie between 0 and 1")
    if obstacle.radius < 0.0 or min(obstacle.size) < 0.0 or _reach(obstacle) > OBSTACLE_SIZE_MAX:
        return Words("its size makes no sense (at most {d} m)", d=figure(OBSTACLE_SIZE_MAX, ".0f"))
    if hypot(*obstacle.velocity) > OBSTACLE_SPEED_MAX:
        return Words("it is faster than {d} m/s", d=figure(OBSTACLE_SPEED_MAX, ".0f"))
    if obstacle.seen_at > now + OBSTACLE_CLOCK_TOLERANCE:
        return Words("it was seen in the future")
    (x, y), (x_min, y_min, x_max, y_max) = obstacle.position, extent
    if not (
        x_min - OBSTACLE_SIZE_MAX <= x <= x_max + OBSTACLE_SIZE_MAX
        and y_min - OBSTACLE_SIZE_MAX <= y <= y_max + OBSTACLE_SIZE_MAX
    ):
        return Words("it lies far outside the map")
    return UNSAID


def certainty_now(obstacle: Obstacle, now: float) -> float:
    """Return how far an obstacle is believed now, 0 to 1."""
    age = max(0.0, now - obstacle.seen_at)
    return float(obstacle.confidence * exp2(-age / CERTAINTY_HALF_LIFE))


@dataclass(frozen=True, slots=True)
class ObstacleMemory:
    """The obstacles that count, the newest word of each; in the order of source and id."""

    obstacles: tuple[Obstacle, ...] = ()

    def updated(self, heard: Iterable[Obstacle], now: float) -> ObstacleMemory:
        """Return the memory after new words of obstacles, without those that are forgotten."""
        known = {(obstacle.source, obstacle.id): obstacle for obstacle in self.obstacles}
        for obstacle in heard:
            name = obstacle.source, obstacle.id
            if name not in known or known[name].seen_at <= obstacle.seen_at:
                known[name] = obstacle
        counting = [
            name for name in sorted(known) if certainty_now(known[name], now) >= CERTAINTY_MIN
        ]
        if len(counting) > OBSTACLES_MAX:
            counting = sorted(
                sorted(counting, key=lambda name: -certainty_now(known[name], now))[:OBSTACLES_MAX]
            )
        obstacles = tuple(known[name] for name in counting)
        return self if obstacles == self.obstacles else ObstacleMemory(obstacles)


def obstacle_rows(
    obstacles: Iterable[Obstacle],
    now: float,
    horizon: float,
    band: Vec2,
    comfort: float = 0.0,
) -> tuple[FloatArray, tuple[str, ...]]:
    """Return the ground that obstacles may cover until a time ahead, and the rows' names.

    A row is x, y, half length, half width, cos yaw, sin yaw, radius, and the way that it moves in x
    and y [m]: from where it was seen, because it may have stopped since, to where it will be. A
    rectangle that moves counts as the disc around it.

    Args:
        obstacles: what is known.
        now: time [s].
        horizon: how far ahead [s].
        band: heights between which an obstacle counts [m]; people count at any height, because
            nobody is flown over.
        comfort: people count as so much larger [m].
    """
    counting = [obstacle for obstacle in obstacles if is_in_band(obstacle, band)]
    rows = np.array(
        [obstacle_row(obstacle, now, horizon, comfort) for obstacle in counting], dtype=np.float64
    ).reshape(-1, 9)
    return rows, tuple(obstacle.id for obstacle in counting)


def is_in_band(obstacle: Obstacle, band: Vec2) -> bool:
    """Return whether an obstacle counts between two heights [m]; people do at any."""
    return (obstacle.bottom <= band[1] and obstacle.top >= band[0]) or may_be_person(obstacle)


def obstacle_row(
    obstacle: Obstacle, now: float, horizon: float, comfort: float = 0.0
) -> tuple[float, ...]:
    """Return the row of one obstacle, as ``obstacle_rows``."""
    (x, y), (length, width) = obstacle.position, obstacle.size
    vx, vy = predicted_velocity(obstacle)
    ahead = max(0.0, now - obstacle.seen_at) + horizon
    grown = comfort if may_be_person(obstacle) else 0.0
    if vx or vy:
        return x, y, 0.0, 0.0, 1.0, 0.0, _reach(obstacle) + grown, vx * ahead, vy * ahead
    return (
        x,
        y,
        length / 2,
        width / 2,
        cos(obstacle.yaw),
        sin(obstacle.yaw),
        obstacle.radius + grown,
        0.0,
        0.0,
    )


def _reach(obstacle: Obstacle) -> float:
    """Return the radius of the disc around an obstacle [m]."""
    return hypot(*obstacle.size) / 2 + obstacle.radius
