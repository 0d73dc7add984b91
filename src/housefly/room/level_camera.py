"""The drone's camera as a pinhole: what is in the picture from where."""

from __future__ import annotations

from dataclasses import dataclass
from math import radians, tan
from typing import Self

import numpy as np

from housefly.config.capabilities import OnboardCamera
from housefly.numeric import FloatArray
from housefly.room.reach import Mask


@dataclass(frozen=True, slots=True)
class LevelCamera:
    """A camera fixed to a level drone, looking straight ahead.

    Attributes:
        width: horizontal field of view [rad].
        height: vertical field of view [rad].
        ahead: how far before the drone's middle it sits [m].
        pixels: width of a picture [px].
    """

    width: float
    height: float
    ahead: float
    pixels: int

    @classmethod
    def of(cls, camera: OnboardCamera | None) -> Self:
        """Return a drone's camera; one without any faces things as if it had a usual one."""
        if camera is None:
            return cls(radians(69.0), radians(42.3), 0.21, 640)
        return cls(camera.field_of_view, camera.field_of_view_up, camera.ahead, camera.width)

    def eyes(self, places: FloatArray, look_at: FloatArray) -> FloatArray:
        """Return where the camera is when the drone faces a point.

        Args:
            places: of the drone's middle, world [m], shape (m, 3).
            look_at: what it faces, world [m], shape (3,).

        Returns:
            shape (m, 3).
        """
        flat = (look_at - places) * (1.0, 1.0, 0.0)
        away = np.maximum(np.linalg.norm(flat, axis=1), 1e-9)
        shifted: FloatArray = places + self.ahead * flat / away[:, None]
        return shifted

    def frames(self, eyes: FloatArray, look_at: FloatArray, points: FloatArray) -> Mask:
        """Return which points are in the picture, from cameras that face ``look_at``.

        Args:
            eyes: of the cameras, world [m], shape (m, 3).
            look_at: world [m], shape (3,).
            points: world [m], shape (n, 3).

        Returns:
            shape (m, n).
        """
        flat = (look_at - eyes)[:, :2]
        ahead = flat / np.maximum(np.linalg.norm(flat, axis=1), 1e-9)[:, None]
        rays = points[None, :, :] - eyes[:, None, :]
        depth = (rays[:, :, :2] * ahead[:, None, :]).sum(axis=2)
        aside = rays[:, :, 0] * ahead[:, None, 1] - rays[:, :, 1] * ahead[:, None, 0]
        return np.asarray(
            (depth > 0.0)
            & (np.abs(aside) <= depth * tan(self.width / 2))
            & (np.abs(rays[:, :, 2]) <= depth * tan(self.height / 2)),
            dtype=np.bool_,
        )
