"""Which bodies the simulated motion capture cameras see.

A camera sees a marker that lies within its field of view and reach, with nothing of the room in
between. The drone's own hull hides nothing, because its markers stand on top; a person hides what
is behind them but not their own markers. A body is seen when three of its markers are each seen by
two cameras. A room without cameras is seen everywhere.
"""

from __future__ import annotations

from math import hypot, tan
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.geometry import Vec3, rotate
from housefly.numeric import FloatArray
from housefly.room.model import TrackingCamera
from housefly.twin.mujoco_engine import mujoco

_MARKERS_NEEDED = 3
_CAMERAS_NEEDED = 2
_AXES: tuple[Vec3, ...] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
_CAMERA_SIZE = 0.15
"""Size of a camera with its bracket [m]."""


class MocapCameras:
    """Lines of sight from the room's cameras to markers."""

    def __init__(self, cameras: tuple[TrackingCamera, ...], model: Any, data: Any) -> None:
        self._model, self._data = model, data
        self._positions = np.array([camera.position for camera in cameras]).reshape(-1, 3)
        axes = [[rotate(camera.orientation, axis) for axis in _AXES] for camera in cameras]
        self._backward_axes = -np.array(axes).reshape(-1, 3, 3).transpose(0, 2, 1)
        self._slopes = np.array(
            [[tan(angle / 2) for angle in camera.field_of_view] for camera in cameras]
        ).reshape(-1, 1, 2)
        self._reach_squared = np.array([[camera.reach] for camera in cameras]) ** 2
        self._geom = np.zeros(1, np.int32)
        self._likeliest = list(range(len(cameras)))

    def see(
        self, markers: FloatArray, own_body: int, groups: NDArray[np.uint8] | None = None
    ) -> bool:
        """Return whether enough cameras see enough of these markers.

        Args:
            markers: world positions [m], shape (n, 3).
            own_body: id of the body that carries them, which hides nothing.
            groups: MuJoCo geom groups that block sight, shape (6,); None for all.
        """
        if not len(self._positions):
            return True
        rays = self._positions[:, None, :] - markers
        good = 0
        for index, in_view in enumerate(self._in_view(rays).T.tolist()):
            good += self._enough_reach_it(markers[index], rays[:, index], in_view, own_body, groups)
            if good >= _MARKERS_NEEDED:
                return True
        return False

    def _in_view(self, rays: FloatArray) -> NDArray[np.bool_]:
        """Return which camera may see which marker if nothing is in between.

        Args:
            rays: from marker to camera [m], shape (cameras, markers, 3).
        """
        local = np.einsum("cmk,cka->cma", rays, self._backward_axes)
        inside = np.abs(local[:, :, :2]) < local[:, :, 2:] * self._slopes
        near = np.einsum("cmk,cmk->cm", rays, rays) < self._reach_squared
        result: NDArray[np.bool_] = inside[:, :, 0] & inside[:, :, 1] & near
        return result

    def _enough_reach_it(
        self,
        marker: FloatArray,
        rays: FloatArray,
        in_view: list[bool],
        own_body: int,
        groups: NDArray[np.uint8] | None,
    ) -> bool:
        """Return whether enough rays from a marker reach their camera.

        One call per ray: for a batch MuJoCo visits every geom of the room first, which costs more
        than twenty rays. Who saw the last marker will most likely see this one.
        """
        seen_by: list[int] = []
        for camera in self._likeliest:
            if not in_view[camera]:
                continue
            ray = rays[camera]
            share = mujoco.mj_ray(
                self._model, self._data, marker, ray, groups, 1, own_body, self._geom
            )
            if share < 0.0 or share > self._housing(ray):
                seen_by.append(camera)
            if len(seen_by) >= _CAMERAS_NEEDED:
                self._try_first(seen_by)
                return True
        return False

    def _try_first(self, seen_by: list[int]) -> None:
        """Remember who saw a marker; whoever is asked first, the answer is the same."""
        if self._likeliest[:_CAMERAS_NEEDED] != seen_by:
            others = (camera for camera in self._likeliest if camera not in seen_by)
            self._likeliest = [*seen_by, *others]

    @staticmethod
    def _housing(ray: FloatArray) -> float:
        """Return the fraction of a ray beyond which a hit is the camera's own housing."""
        return 1.0 - _CAMERA_SIZE / hypot(*ray.tolist())
