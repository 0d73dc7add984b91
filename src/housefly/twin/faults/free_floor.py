"""Where somebody can walk in a room: not through walls and furniture."""

from __future__ import annotations

from math import cos, pi, sin

import numpy as np

from housefly.geometry import Vec2
from housefly.room.distance import clearance_field, footprints
from housefly.room.model import Room

BODY_HEIGHT = 1.7
"""What is lower than this stops somebody who walks [m] ..."""
THRESHOLD_HEIGHT = 0.1
"""... what is lower than this does not: carpets, pads [m]."""
WALKER_HALF_WIDTH = 0.25
"""Half the width of somebody who walks [m]."""
_STRIDE = 0.1
"""The floor is looked at every so often [m]."""
_TURNS = tuple(sign * n * pi / 12 for n in range(13) for sign in (1.0, -1.0))
"""Ways beside the wanted one, the nearest first [rad]."""


def along(start: Vec2, direction: float, length: float) -> Vec2:
    """Return the place this far from another in a direction [m, rad]."""
    return start[0] + length * cos(direction), start[1] + length * sin(direction)


class FreeFloor:
    """The floor of a room between its walls and its furniture."""

    def __init__(self, room: Room) -> None:
        self._standing = footprints(room.solids, THRESHOLD_HEIGHT, BODY_HEIGHT)

    def free_length(self, start: Vec2, direction: float, most: float) -> float:
        """Return how far somebody can walk straight on from a place, up to ``most`` [m]."""
        for n in range(1, int(most / _STRIDE + 1e-9) + 1):
            if not self.is_free(along(start, direction, n * _STRIDE)):
                return (n - 1) * _STRIDE
        return most

    def open_bearing(self, centre: Vec2, wanted: float, near: float, far: float) -> float:
        """Return the bearing nearest to the wanted one along which the floor is free [rad].

        Args:
            centre: where the drone is [m].
            wanted: bearing [rad].
            near: from here on the floor has to be free [m] ...
            far: ... to here [m]; where it never is, the longest stretch counts.
        """
        lengths = [
            near + self.free_length(along(centre, wanted + turn, near), wanted + turn, far - near)
            for turn in _TURNS
        ]
        return wanted + _TURNS[int(np.argmax(np.array(lengths) - 1e-6 * np.arange(len(_TURNS))))]

    def is_free(self, place: Vec2) -> bool:
        """Return whether somebody can stand at a place [m]."""
        x, y = (np.array([number]) for number in place)
        return bool(clearance_field(self._standing, x, y, 1.0)[0, 0] > WALKER_HALF_WIDTH)
