"""What the drone's front camera really shows: a coarse picture of owners, cast ray by ray.

Needs no graphics: a picture of 64 x 36 rays through the pinhole of the camera. Glass is looked
through, the drone itself is left out, as in its pictures.
"""

from __future__ import annotations

from math import radians, tan

import numpy as np

from housefly.numeric import FloatArray
from housefly.twin.contracts import DroneCamera
from housefly.twin.drone_body import DroneBody
from housefly.twin.mujoco_engine import mujoco
from housefly.twin.quadrotor.body import camera_name, camera_of
from housefly.twin.solids import SolidOwner

_COLUMNS, _ROWS = 64, 36
_CLEAR = 0.5
"""What is less opaque is looked through."""
_PANES_MAX = 3
"""Through so many panes at most."""
_PAST = 1e-3
"""A ray goes on so far behind a pane [m]."""


class PictureSegments:
    """Casts the picture of the front camera.

    Args:
        drone: whose camera it is, in its room.
        owners: whom each geom belongs to.
    """

    def __init__(self, drone: DroneBody, owners: tuple[SolidOwner | None, ...]) -> None:
        self._drone, self._owners = drone, owners
        name = camera_name(DroneCamera.FRONT.value, drone.name)
        self._camera = int(drone.model.camera(name).id)
        camera = camera_of(drone.airframe)
        self._rays = _rays(float(drone.model.cam_fovy[self._camera]), camera.width, camera.height)
        self._clear = drone.model.geom_rgba[:, 3] < _CLEAR

    def shares(self) -> dict[str, float]:
        """Return the share of the picture that each thing and person takes, by name, 0 to 1."""
        data = self._drone.data
        eye = np.array(data.cam_xpos[self._camera])
        axes = data.cam_xmat[self._camera].reshape(3, 3)
        rays = np.einsum("nk,mk->nm", self._rays, axes)
        counted: dict[str, int] = {}
        for geom in self._first_opaque(eye, rays).tolist():
            owner = self._owners[geom] if geom >= 0 else None
            if owner is not None:
                counted[owner.name] = counted.get(owner.name, 0) + 1
        return {name: count / len(rays) for name, count in counted.items()}

    def _first_opaque(
        self, eye: FloatArray, rays: FloatArray
    ) -> np.ndarray[tuple[int], np.dtype[np.int32]]:
        """Return the geom that each ray meets first behind all glass; -1 for none."""
        model, data, drone = self._drone.model, self._drone.data, self._drone.number
        count = len(rays)
        found, away = np.full(count, -1, np.int32), np.zeros(count)
        mujoco.mj_multiRay(
            model, data, eye, rays.flatten(), None, 1, drone, found, away, None, count, 1e3
        )
        geom = np.zeros(1, np.int32)
        for n in np.flatnonzero((found >= 0) & self._clear[found]).tolist():
            for _ in range(_PANES_MAX):
                start = eye + (away[n] + _PAST) * rays[n]
                gone = mujoco.mj_ray(model, data, start, rays[n], None, 1, drone, geom)
                found[n], away[n] = geom[0], away[n] + _PAST + gone
                if geom[0] < 0 or not self._clear[geom[0]]:
                    break
        return found


def _rays(height_degrees: float, width: int, height: int) -> FloatArray:
    """Return unit rays of a picture in the camera's frame: x right, y up, looking along -z."""
    up = tan(radians(height_degrees) / 2)
    right = up * width / height
    xs = (np.arange(_COLUMNS) + 0.5) / _COLUMNS * 2.0 - 1.0
    ys = (np.arange(_ROWS) + 0.5) / _ROWS * 2.0 - 1.0
    x, y = np.meshgrid(xs * right, ys * up)
    rays = np.column_stack([x.ravel(), y.ravel(), -np.ones(x.size)])
    unit: FloatArray = rays / np.linalg.norm(rays, axis=1)[:, None]
    return unit
