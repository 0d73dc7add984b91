"""The simulated depth camera: each pixel is a ray in the same model that the drone flies in."""

from __future__ import annotations

from math import pi, tan

import numpy as np

from housefly.config.depth import DepthCameraConfig
from housefly.geometry import quaternion_from_euler, rotate
from housefly.messages import DepthImage, Pose
from housefly.twin.mujoco_engine import mujoco
from housefly.twin.physics import Physics
from housefly.twin.sensors.scanner import VISIBLE_GROUPS

DEPTH_WIDTH, DEPTH_HEIGHT = 80, 60
_FIELD_OF_VIEW = 1.22
"""Across the image [rad]; 70 degrees, as such cameras have."""
_MIN_RANGE, _MAX_RANGE = 0.3, 8.0
"""Depths outside this are not measured [m]."""
_NOISE = 0.003
"""One-sigma noise at one metre [m]; it grows with the square of the depth."""
_DROPOUT = 0.01
"""Share of the pixels that measure nothing."""
_SEED_KEY = 7927
"""Keeps the cameras' noise apart from all other noise of the same seed."""


class DepthCamera:
    """One depth camera of the site.

    Args:
        config: where it is.
        seed: of the twin.
        number: its place in the site's list.
        physics: what it looks at.
    """

    def __init__(self, config: DepthCameraConfig, seed: int, number: int, physics: Physics) -> None:
        self._name, self._physics = config.name, physics
        self._random = np.random.default_rng(
            np.random.SeedSequence(seed, spawn_key=(_SEED_KEY, number))
        )
        self._focal = 0.5 * DEPTH_WIDTH / tan(0.5 * _FIELD_OF_VIEW)
        self._middle = (0.5 * (DEPTH_WIDTH - 1), 0.5 * (DEPTH_HEIGHT - 1))
        # A level camera that looks along x has its own z along x, its x to the right and its y
        # down.
        orientation = quaternion_from_euler(-0.5 * pi - config.pitch, 0.0, config.yaw - 0.5 * pi)
        self._pose = Pose((config.x, config.y, config.z), orientation)
        u, v = np.meshgrid(np.arange(DEPTH_WIDTH), np.arange(DEPTH_HEIGHT))
        away = np.stack(
            [
                (u - self._middle[0]) / self._focal,
                (v - self._middle[1]) / self._focal,
                np.ones_like(u),
            ],
            axis=2,
        )
        away = away.reshape(-1, 3) / np.linalg.norm(away, axis=2).reshape(-1, 1)
        axes = np.array(
            [
                rotate(orientation, axis)
                for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
            ]
        )
        self._along = away[:, 2]
        self._rays = np.einsum("nk,km->nm", away, axes).ravel()
        self._geoms = np.zeros(DEPTH_WIDTH * DEPTH_HEIGHT, np.int32)
        self._reached = np.zeros(DEPTH_WIDTH * DEPTH_HEIGHT)

    def image(self, captured_at: float) -> DepthImage:
        """Return what it sees now, stamped with a time [s]."""
        model, data, pixels = self._physics.model, self._physics.data, DEPTH_WIDTH * DEPTH_HEIGHT
        origin = np.array(self._pose.position)
        far = _MAX_RANGE / self._along.min()
        mujoco.mj_multiRay(
            model, data, origin, self._rays, VISIBLE_GROUPS, 1, -1,
            self._geoms, self._reached, None, pixels, far,
        )  # fmt: skip
        depth = self._reached * self._along
        measured = depth + _NOISE * depth**2 * self._random.standard_normal(pixels)
        nothing = (
            (self._random.random(pixels) < _DROPOUT)
            | (self._reached < 0.0)
            | (measured < _MIN_RANGE)
            | (measured > _MAX_RANGE)
        )
        image = np.where(nothing, 0.0, np.rint(1000.0 * measured)).astype("<u2").tobytes()
        size, lens = (DEPTH_WIDTH, DEPTH_HEIGHT), (self._focal, self._focal, *self._middle)
        return DepthImage(self._name, captured_at, *size, image, *lens, self._pose)
