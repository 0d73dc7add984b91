"""How far a drone's hull really is from everything, from the next person, and the next drone."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import inf
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.numeric import FloatArray
from housefly.twin.contracts import AWAY_Z
from housefly.twin.drone_body import DroneBody
from housefly.twin.mujoco_engine import mujoco
from housefly.twin.solids import SolidKind, SolidOwner

_FAR = 1000.0
"""Nothing of a room is farther than this [m]."""
_MOVING = frozenset({SolidKind.PERSON, SolidKind.DRONE})


@dataclass(frozen=True, slots=True)
class Clearance:
    """True distances from the hull [m]: 0 while touching, infinite when there is nothing.

    Attributes:
        solid: to the nearest wall, ceiling, furniture or movable; the floor does not count.
        person: to the nearest person.
        drone: to the nearest hull of another drone.
    """

    solid: float
    person: float
    drone: float = inf


UNBOUNDED = Clearance(inf, inf)
"""Whatever the distances are, they are wanted."""


class ClearanceMeter:
    """Measures between the hull's shapes and those of the room.

    MuJoCo knows the shapes as they were half a control period ago: a hull at 1 m/s is 2.5 mm
    farther on.
    """

    def __init__(self, drone: DroneBody, owners: tuple[SolidOwner | None, ...]) -> None:
        self._drone = drone
        model = drone.model
        self._hull = np.flatnonzero(
            (model.geom_bodyid == drone.number) & (model.geom_contype != 0)
        ).tolist()
        reaches = np.linalg.norm(model.geom_pos[self._hull], axis=1) + model.geom_rbound[self._hull]
        self._hull_radius = float(reaches.max())
        self._solids = _boxes(model, owners, lambda kind: kind not in _MOVING)
        self._people = _boxes(model, owners, lambda kind: kind is SolidKind.PERSON)
        self._drones = _boxes(model, owners, lambda kind: kind is SolidKind.DRONE)

    def measure(self, within: Clearance = UNBOUNDED) -> Clearance:
        """Return the distances now; where nothing is nearer than ``within``, that."""
        return Clearance(
            self._nearest(self._solids, within.solid),
            self._nearest(self._people, within.person),
            self._nearest(self._drones, within.drone),
        )

    def _nearest(self, boxes: _Boxes, within: float) -> float:
        """Return the distance to the nearest of some geoms [m]; those that may be come first."""
        if not len(boxes.geoms):
            return within
        bounds = self._lower_bounds(boxes)
        candidates = np.flatnonzero(bounds < within)
        nearest = within
        for place in candidates[np.argsort(bounds[candidates], kind="stable")].tolist():
            if bounds[place] >= nearest:
                break
            nearest = min(nearest, self._gap(int(boxes.geoms[place]), min(nearest, _FAR)))
        return max(0.0, nearest)

    def _lower_bounds(self, boxes: _Boxes) -> FloatArray:
        """Return what no distance to some geoms falls below [m]; infinite for those put away."""
        data, geoms = self._drone.data, boxes.geoms
        places = data.geom_xpos[geoms]
        offsets = data.xpos[self._drone.number] - places
        axes = data.geom_xmat[geoms].reshape(-1, 3, 3)
        local = np.einsum("gk,gka->ga", offsets, axes)
        outside = np.maximum(np.abs(local - boxes.centres) - boxes.halves, 0.0)
        bounds = np.sqrt((outside * outside).sum(axis=1))
        bounds[boxes.endless] = local[boxes.endless, 2]
        bounds -= self._hull_radius
        bounds[places[:, 2] < AWAY_Z / 2] = inf
        return np.asarray(bounds, np.float64)

    def _gap(self, geom: int, bound: float) -> float:
        """Return the distance from the hull to a geom [m], or a bound that it exceeds."""
        model, data = self._drone.model, self._drone.data
        measure = mujoco.mj_geomDistance
        gap: float = min([measure(model, data, part, geom, bound, None) for part in self._hull])
        return gap


@dataclass(frozen=True, slots=True)
class _Boxes:
    """Some geoms, each with the box around it in its own frame [m]; a plane has no end, and its z
    axis leads out of it.
    """

    geoms: NDArray[np.intp]
    centres: FloatArray
    halves: FloatArray
    endless: NDArray[np.bool_]


def _boxes(
    model: Any, owners: tuple[SolidOwner | None, ...], wanted: Callable[[SolidKind], bool]
) -> _Boxes:
    """Return the geoms whose owners are wanted."""
    geoms = np.array(
        [n for n, owner in enumerate(owners) if owner is not None and wanted(owner.kind)], np.intp
    )
    box = model.geom_aabb[geoms]
    return _Boxes(geoms, box[:, :3], box[:, 3:], model.geom_rbound[geoms] <= 0.0)
