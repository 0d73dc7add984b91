"""How far the drone's hull really is from everything, and from the next person."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import inf

import numpy as np
from numpy.typing import NDArray

from housefly.twin.contracts import AWAY_Z
from housefly.twin.mujoco_engine import mujoco
from housefly.twin.physics import Physics
from housefly.twin.solids import SolidKind, SolidOwner

_HULL_RADIUS = 0.5
"""The hull lies within this distance of the drone's centre [m]."""
_FAR = 1000.0
"""Nothing of a room is farther than this [m]."""


@dataclass(frozen=True, slots=True)
class Clearance:
    """True distances from the hull [m]: 0 while touching, infinite when there is nothing.

    Attributes:
        solid: to the nearest wall, ceiling, furniture or movable; the floor does not count.
        person: to the nearest person.
    """

    solid: float
    person: float


class ClearanceMeter:
    """Measures between the hull's shapes and those of the room.

    MuJoCo knows the shapes as they were half a control period ago: a hull at 1 m/s is 2.5 mm
    farther on.
    """

    def __init__(self, physics: Physics, owners: tuple[SolidOwner | None, ...]) -> None:
        self._physics = physics
        model = physics.model
        self._hull = np.flatnonzero(
            (model.geom_bodyid == physics.drone_id) & (model.geom_contype != 0)
        ).tolist()
        self._solids = _geoms(owners, lambda kind: kind is not SolidKind.PERSON)
        self._people = _geoms(owners, lambda kind: kind is SolidKind.PERSON)

    def measure(self) -> Clearance:
        """Return the distances now."""
        return Clearance(self._nearest(self._solids), self._nearest(self._people))

    def _nearest(self, geoms: NDArray[np.intp]) -> float:
        """Return the distance to the nearest of some geoms [m]; those that may be come first."""
        bounds = self._lower_bounds(geoms)
        nearest = inf
        for place in np.argsort(bounds).tolist():
            if bounds[place] >= nearest:
                break
            nearest = min(nearest, self._gap(int(geoms[place]), min(nearest, _FAR)))
        return max(0.0, nearest)

    def _lower_bounds(self, geoms: NDArray[np.intp]) -> NDArray[np.float64]:
        """Return what no distance to some geoms falls below [m]; infinite for those put away."""
        model, data = self._physics.model, self._physics.data
        offsets = data.xpos[self._physics.drone_id] - data.geom_xpos[geoms]
        axes = data.geom_xmat[geoms].reshape(-1, 3, 3)
        local = np.einsum("gk,gka->ga", offsets, axes)
        # The box around a geom in its own frame; a plane has none, and no end.
        centres, halves = model.geom_aabb[geoms, :3], model.geom_aabb[geoms, 3:]
        outside = np.maximum(np.abs(local - centres) - halves, 0.0)
        bounds = np.linalg.norm(outside, axis=1) - _HULL_RADIUS
        bounds[model.geom_rbound[geoms] <= 0.0] = -inf
        bounds[data.geom_xpos[geoms, 2] < AWAY_Z / 2] = inf
        return np.asarray(bounds, np.float64)

    def _gap(self, geom: int, bound: float) -> float:
        """Return the distance from the hull to a geom [m], or a bound that it exceeds."""
        model, data = self._physics.model, self._physics.data
        gap: float = min(
            mujoco.mj_geomDistance(model, data, part, geom, bound, None) for part in self._hull
        )
        return gap


def _geoms(
    owners: tuple[SolidOwner | None, ...], wanted: Callable[[SolidKind], bool]
) -> NDArray[np.intp]:
    """Return the ids of the geoms whose owners are wanted."""
    return np.array(
        [n for n, owner in enumerate(owners) if owner is not None and wanted(owner.kind)], np.intp
    )
