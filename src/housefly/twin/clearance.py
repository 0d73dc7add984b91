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
        """Return the distance to the nearest of some geoms [m]; nearest spheres come first."""
        model, data = self._physics.model, self._physics.data
        centres, radii = data.geom_xpos[geoms], model.geom_rbound[geoms]
        away = np.linalg.norm(centres - data.xpos[self._physics.drone_id], axis=1) - radii
        # A plane has no bounding sphere and no end.
        bounds = np.where(radii > 0.0, away - _HULL_RADIUS, -inf)
        bounds[centres[:, 2] < AWAY_Z / 2] = inf
        nearest = inf
        for place in np.argsort(bounds).tolist():
            if bounds[place] >= nearest:
                break
            nearest = min(nearest, self._gap(int(geoms[place]), min(nearest, _FAR)))
        return max(0.0, nearest)

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
