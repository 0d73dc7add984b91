"""People as the pilot thinks of them: discs that walk on as they walk now, less and less surely."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import hypot, inf

import numpy as np

from housefly.geometry import Vec2
from housefly.messages.obstacles import Obstacle, ObstacleKind
from housefly.numeric import FloatArray, compiled
from housefly.room.grid import OccupancyGrid

PREDICTED_SPEED_MAX = 3.0
"""Who is faster is believed to be where they are, and to go on at this speed [m/s]."""
SPEED_UNCERTAINTY = 0.1
"""A prediction is less sure by this much for every second ahead [m/s]."""
UNCERTAIN_TIME = 3.0
"""Up to this time ahead [s]; who walks into a corridor goes on to its end."""
WALKING_SPEED = 0.35
"""Who is faster walks; slower ones sway, or their place is not exact [m/s]."""
WALKING_TIME_MAX = 6.0
"""Nobody is thought to walk straight on for longer than this [s]."""
PERSON_WALL_DISTANCE = 0.15
"""Who walks stops where the next wall is nearer to their middle than this [m]."""
SPEED_SHARE_MIN = 0.3
"""Share of the cruise speed at the comfort distance from people, and nearer."""
MOVING_SPEED = 0.2
"""What is faster may be a person, whatever its source says [m/s]."""
_MET = frozenset({ObstacleKind.PERSON, ObstacleKind.DRONE})


def may_be_person(obstacle: Obstacle) -> bool:
    """Return whether to keep a person's distance: from people, and from unknown things that move.

    From other drones, too. Things with a name (furniture) are pushed, not met.
    """
    if obstacle.kind is ObstacleKind.UNKNOWN:
        return hypot(*obstacle.velocity) > MOVING_SPEED
    return obstacle.kind in _MET


def is_walking(obstacle: Obstacle) -> bool:
    """Return whether to think of an obstacle as somebody who walks on."""
    return may_be_person(obstacle) and hypot(*predicted_velocity(obstacle)) > WALKING_SPEED


@compiled
def speed_share(apart: float, slow: float, comfort: float) -> float:
    """Return the share of the usual speed to fly at near people.

    Args:
        apart: from hull to body [m].
        slow: nearer than this the drone is slower [m].
        comfort: here and nearer it is slowest [m].
    """
    if apart >= slow:
        return 1.0
    share = max(0.0, (apart - comfort) / max(slow - comfort, 1e-6))
    return SPEED_SHARE_MIN + (1.0 - SPEED_SHARE_MIN) * share


def predicted_velocity(obstacle: Obstacle) -> Vec2:
    """Return how an obstacle goes on [m/s]."""
    (vx, vy), speed = obstacle.velocity, hypot(*obstacle.velocity)
    share = min(1.0, PREDICTED_SPEED_MAX / speed) if speed > 0.0 else 1.0
    return vx * share, vy * share


@dataclass(frozen=True, slots=True)
class ObservedPeople:
    """Everybody at one time.

    Attributes:
        rows: x, y [m], velocity x, y [m/s], radius [m] of each, and how long there is room to walk
            on [s], shape (n, 6).
        names: of each.
    """

    rows: FloatArray
    names: tuple[str, ...] = ()

    def __len__(self) -> int:
        return len(self.names)

    def walking(self) -> ObservedPeople:
        """Return those who walk."""
        walk = np.hypot(self.rows[:, 2], self.rows[:, 3]) > WALKING_SPEED
        names = tuple(name for name, does in zip(self.names, walk, strict=True) if does)
        return ObservedPeople(self.rows[walk], names)

    def distances(self, places: FloatArray, ahead: float) -> FloatArray:
        """Return how far places are from bodies a while ahead, less what is not sure [m].

        Args:
            places: shape (m, 2) [m].
            ahead: [s].

        Returns:
            Shape (m, n); negative inside a body.
        """
        return self.distances_along(places, np.full(len(places), ahead))

    def distances_along(self, places: FloatArray, times: FloatArray) -> FloatArray:
        """Return how far each place is from bodies at its own time ahead, less what is not sure.

        Args:
            places: shape (m, 2) [m].
            times: shape (m,) [s].

        Returns:
            Shape (m, n) [m]; negative inside a body.
        """
        x, y, vx, vy, radius, room = self.rows.T
        walked = np.minimum(times[:, None], room)
        apart = np.hypot(places[:, :1] - (x + walked * vx), places[:, 1:] - (y + walked * vy))
        # Somebody who stands counts as standing, else whoever is near would seem to approach.
        walks = np.hypot(vx, vy) > 0.0
        unsure = SPEED_UNCERTAINTY * np.minimum(times, UNCERTAIN_TIME)
        result: FloatArray = apart - radius - unsure[:, None] * walks
        return result

    def nearest(self, place: Vec2, ahead: float) -> float:
        """Return how far a place [m] is from the next body in so long [s]; infinite for nobody."""
        return min(
            (
                hypot(place[0] - x - vx * min(ahead, room), place[1] - y - vy * min(ahead, room))
                - radius
                for x, y, vx, vy, radius, room in self.rows.tolist()
            ),
            default=inf,
        )


NOBODY = ObservedPeople(np.zeros((0, 6)))


def people_at(
    obstacles: Iterable[Obstacle], now: float, walls: OccupancyGrid | None = None
) -> ObservedPeople:
    """Return everybody among the obstacles, where they are at a time [s].

    With ``walls`` nobody walks on through them.
    """
    found = [obstacle for obstacle in obstacles if may_be_person(obstacle)]
    if not found:
        return NOBODY
    rows = np.array([_row_of(obstacle, now, walls) for obstacle in found])
    return ObservedPeople(rows, tuple(obstacle.id for obstacle in found))


def _row_of(obstacle: Obstacle, now: float, walls: OccupancyGrid | None) -> tuple[float, ...]:
    (x, y), (vx, vy) = obstacle.position, predicted_velocity(obstacle)
    age = max(0.0, now - obstacle.seen_at)
    radius = hypot(*obstacle.size) / 2 + obstacle.radius
    here = (x + vx * age, y + vy * age)
    room = WALKING_TIME_MAX if walls is None else walking_time(walls, here, (vx, vy))
    return *here, vx, vy, radius, room


def walking_time(walls: OccupancyGrid, start: Vec2, velocity: Vec2) -> float:
    """Return for how long somebody can walk straight on before the next wall [s]."""
    speed = hypot(*velocity)
    if speed == 0.0 or walls.clearance_at(start) < PERSON_WALL_DISTANCE:
        return WALKING_TIME_MAX
    stride = walls.resolution / speed
    for n in range(1, int(WALKING_TIME_MAX / stride) + 1):
        at = n * stride
        place = (start[0] + at * velocity[0], start[1] + at * velocity[1])
        if walls.clearance_at(place) < PERSON_WALL_DISTANCE:
            return at
    return WALKING_TIME_MAX
