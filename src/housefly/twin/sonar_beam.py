"""What the drone's sonar meets below it: the floor, furniture, movables, people, other drones."""

from __future__ import annotations

from math import ceil, floor, hypot
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.geometry import Vec2, Vec3
from housefly.twin.drone_body import DroneBody
from housefly.twin.mujoco_engine import mujoco

_SPREAD = 0.2
_RADIUS_MAX = 0.3
"""Radius of the beam over the height (a half angle of 11 degrees), and its bound [m]."""
_RAYS: tuple[Vec2, ...] = ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))
"""Where the beam is looked through: its middle, and four points on its rim."""
_FLAT = 0.02
"""What is lower than this [m] is floor: carpets, pads."""
_CELL = 0.25
"""Edge of the cells that are known to be bare floor, where no ray is cast [m]."""
_ECHO_GROUPS: NDArray[np.uint8] = np.array([1, 0, 0, 1, 0, 0], np.uint8)
"""Geom groups that echo: all but painted shadows, lamps, markers and the looks of drones."""
_DOWN = np.array((0.0, 0.0, -1.0))


class SonarBeam:
    """Finds the highest surface in the beam of the drone's sonar.

    Upright rays stand for the beam: upright walls beside the drone throw no echo back.
    """

    def __init__(self, drone: DroneBody) -> None:
        self._drone = drone
        self._start, self._geom = np.zeros(3), np.zeros(1, np.int32)
        self._echoes: list[bool] = (drone.model.geom_contype != 0).tolist()
        self._built = _built_cells(drone, self._echoes)
        self._bodies = _movable_bodies(drone)

    def height(self, position: Vec3) -> float:
        """Return the height of the surface below a position [m]; exactly 0 for the floor."""
        return 0.0 if self._is_bare(position) else self.cast(position)

    def cast(self, position: Vec3) -> float:
        """Return the same, always by rays."""
        x, y, z = position
        radius = min(_SPREAD * max(z, 0.0), _RADIUS_MAX)
        top = max(self._top(x + radius * dx, y + radius * dy, z) for dx, dy in _RAYS)
        return top if top > _FLAT else 0.0

    def _is_bare(self, position: Vec3) -> bool:
        x, y, _ = position
        if (floor(x / _CELL), floor(y / _CELL)) in self._built:
            return False
        places = self._drone.data.xpos
        return all(
            hypot(places[body, 0] - x, places[body, 1] - y) > reach for body, reach in self._bodies
        )

    def _top(self, x: float, y: float, z: float) -> float:
        drone, start = self._drone, self._start
        start[0], start[1], start[2] = x, y, z
        reached: float = mujoco.mj_ray(
            drone.model, drone.data, start, _DOWN, _ECHO_GROUPS, 1, drone.number, self._geom
        )
        return z - reached if reached >= 0.0 and self._echoes[self._geom.item()] else 0.0


def _built_cells(drone: DroneBody, echoes: list[bool]) -> frozenset[tuple[int, int]]:
    """Return the cells whose middle or rim rays could meet something that is built in."""
    model, data = drone.model, drone.data
    cells: set[tuple[int, int]] = set()
    for geom in np.flatnonzero(model.geom_bodyid == 0).tolist():
        if not echoes[geom] or model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_PLANE:
            continue
        turned = np.abs(data.geom_xmat[geom].reshape(3, 3))
        half = np.einsum("nk,k->n", turned, model.geom_aabb[geom, 3:])
        low, high = (data.geom_xpos[geom] + sign * (half + _RADIUS_MAX) for sign in (-1.0, 1.0))
        cells.update(
            (across, along)
            for across in range(floor(low[0] / _CELL), ceil(high[0] / _CELL))
            for along in range(floor(low[1] / _CELL), ceil(high[1] / _CELL))
        )
    return frozenset(cells)


def _movable_bodies(drone: DroneBody) -> tuple[tuple[int, float], ...]:
    """Return the bodies that move, but for the drone, and how far the beam meets each [m]."""
    model = drone.model
    return tuple(
        (body, _RADIUS_MAX + max(_reaches(model, body), default=0.0))
        for body in range(1, model.nbody)
        if body != drone.number
    )


def _reaches(model: Any, body: int) -> list[float]:
    """Return how far each geom of a body reaches from the body's origin [m]."""
    geoms = np.flatnonzero(model.geom_bodyid == body)
    reaches: list[float] = (
        np.linalg.norm(model.geom_pos[geoms], axis=1) + model.geom_rbound[geoms]
    ).tolist()
    return reaches
