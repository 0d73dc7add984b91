"""People as the pilot thinks of them: discs that walk on as they walk now, less and less surely."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import hypot

import numpy as np

from housefly.geometry import Vec2
from housefly.messages.obstacles import Obstacle, ObstacleKind
from housefly.numeric import FloatArray

PREDICTED_SPEED_MAX = 3.0
"""Who is faster is believed to be where they are, and to go on at this speed [m/s]."""
SPEED_UNCERTAINTY = 0.1
"""A prediction is less sure by this much for every second ahead [m/s]."""
UNCERTAIN_TIME = 3.0
"""Up to this time ahead [s]; who walks into a corridor goes on to its end."""
WALKING_SPEED = 0.35
"""Who is faster walks; slower ones sway, or their place is not exact [m/s]."""
MOVING_SPEED = 0.2
"""What is faster may be a person, whatever its source says [m/s]."""


def may_be_person(obstacle: Obstacle) -> bool:
    """Return whether to keep a person's distance: from people, and from unknown things that move.

    Things with a name (furniture) are pushed, not met.
    """
    if obstacle.kind is ObstacleKind.UNKNOWN:
        return hypot(*obstacle.velocity) > MOVING_SPEED
    return obstacle.kind is ObstacleKind.PERSON


def predicted_velocity(obstacle: Obstacle) -> Vec2:
    """Return how an obstacle goes on [m/s]."""
    (vx, vy), speed = obstacle.velocity, hypot(*obstacle.velocity)
    share = min(1.0, PREDICTED_SPEED_MAX / speed) if speed > 0.0 else 1.0
    return vx * share, vy * share


@dataclass(frozen=True, slots=True)
class People:
    """Everybody at one time.

    Attributes:
        rows: x, y [m], velocity x, y [m/s] and radius [m] of each, shape (n, 5).
        names: of each.
    """

    rows: FloatArray
    names: tuple[str, ...] = ()

    def __len__(self) -> int:
        return len(self.names)

    def walking(self) -> People:
        """Return those who walk."""
        walk = np.hypot(self.rows[:, 2], self.rows[:, 3]) > WALKING_SPEED
        names = tuple(name for name, does in zip(self.names, walk, strict=True) if does)
        return People(self.rows[walk], names)

    def distances(self, places: FloatArray, ahead: float) -> FloatArray:
        """Return how far places are from bodies a while ahead, less what is not sure [m].

        Args:
            places: shape (m, 2) [m].
            ahead: [s].

        Returns:
            Shape (m, n); negative inside a body.
        """
        there = self.rows[:, :2] + ahead * self.rows[:, 2:4]
        apart = np.hypot(
            places[:, :1] - there[None, :, 0].reshape(1, -1),
            places[:, 1:] - there[None, :, 1].reshape(1, -1),
        )
        unsure = SPEED_UNCERTAINTY * min(ahead, UNCERTAIN_TIME)
        result: FloatArray = apart - self.rows[:, 4] - unsure
        return result


NOBODY = People(np.zeros((0, 5)))


def people_at(obstacles: Iterable[Obstacle], now: float) -> People:
    """Return everybody among the obstacles, where they are at a time [s]."""
    found = [obstacle for obstacle in obstacles if may_be_person(obstacle)]
    if not found:
        return NOBODY
    rows = np.array([_row_of(obstacle, now) for obstacle in found])
    return People(rows, tuple(obstacle.id for obstacle in found))


def _row_of(obstacle: Obstacle, now: float) -> tuple[float, ...]:
    (x, y), (vx, vy) = obstacle.position, predicted_velocity(obstacle)
    age = max(0.0, now - obstacle.seen_at)
    radius = hypot(*obstacle.size) / 2 + obstacle.radius
    return x + vx * age, y + vy * age, vx, vy, radius
