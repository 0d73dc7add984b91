"""The simulated motion capture system: which bodies it sees, when, and how well.

A marker is seen by a camera when it lies in the camera's field of view and reach and nothing of the
room stands between. The drone's own hull hides nothing, for its markers stand on top; a person
hides what is behind them but not their own markers. A body is seen when three of its markers are
each seen by two cameras. A room without cameras is seen everywhere.
"""

from __future__ import annotations

from collections import deque
from math import hypot, tan
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.config.site import Site
from housefly.geometry import Vec3, normalized, rotate
from housefly.messages import Pose
from housefly.room.model import TrackingCamera
from housefly.twin.contracts import MocapFrame
from housefly.twin.engine import mujoco

MARKERS_NEEDED = 3
CAMERAS_NEEDED = 2
JITTER = 0.0005
"""Mean of the extra, exponentially distributed delay of a frame [s]."""
LEVER_ARM = 0.15
"""Distance of the markers from their centre [m]: position noise over this is orientation noise
[rad].
"""

Array = NDArray[np.float64]


class Cameras:
    """Lines of sight from the room's cameras to markers."""

    def __init__(self, cameras: tuple[TrackingCamera, ...], model: Any, data: Any) -> None:
        self._model, self._data = model, data
        self._positions = np.array([camera.position for camera in cameras]).reshape(-1, 3)
        axes = [[rotate(camera.orientation, axis) for axis in _AXES] for camera in cameras]
        self._axes = np.array(axes).reshape(-1, 3, 3).transpose(0, 2, 1)
        self._slopes = np.array(
            [[tan(angle / 2) for angle in camera.field_of_view] for camera in cameras]
        ).reshape(-1, 2)
        self._reach = np.array([camera.reach for camera in cameras])
        self._geom = np.zeros(1, np.int32)

    def see(self, markers: Array, own_body: int, groups: NDArray[np.uint8] | None = None) -> bool:
        """Tell whether enough of these markers are seen by enough cameras.

        Args:
            markers: world positions [m], shape (n, 3).
            own_body: id of the body that carries them, which hides nothing.
            groups: MuJoCo geom groups that block sight, shape (6,); None for all.
        """
        if not len(self._positions):
            return True
        rays = self._positions[:, None, :] - markers[None, :, :]
        in_view = self._in_view(rays)
        good = 0
        for index, marker in enumerate(markers):
            candidates = rays[in_view[:, index], index]
            good += len(candidates) >= CAMERAS_NEEDED and self._enough_reach_it(
                marker, candidates, own_body, groups
            )
            if good >= MARKERS_NEEDED:
                return True
        return False

    def _in_view(self, rays: Array) -> NDArray[np.bool_]:
        """Return which camera may see which marker, walls aside; rays run from marker to camera,
        shape (cameras, markers, 3).
        """
        local = -rays @ self._axes
        depth = local[:, :, 2]
        inside = (np.abs(local[:, :, :2]) < depth[:, :, None] * self._slopes[:, None, :]).all(
            axis=2
        )
        near = np.einsum("cmk,cmk->cm", rays, rays) < (self._reach**2)[:, None]
        result: NDArray[np.bool_] = inside & near
        return result

    def _enough_reach_it(
        self, marker: Array, rays: Array, own_body: int, groups: NDArray[np.uint8] | None
    ) -> bool:
        """Tell whether enough of the rays from a marker reach their camera; stops at the last one
        needed.

        One call for each ray: MuJoCo prepares a batch by looking at every geom of the room, which
            costs more than twenty rays.
        """
        reached = 0
        for ray in rays:
            share = mujoco.mj_ray(
                self._model, self._data, marker, ray, groups, 1, own_body, self._geom
            )
            reached += share < 0.0 or share > self._housing(ray)
            if reached >= CAMERAS_NEEDED:
                return True
        return False

    @staticmethod
    def _housing(ray: Array) -> float:
        """Return the share of a ray beyond which a hit is the camera's own housing or bracket."""
        return 1.0 - _CAMERA_SIZE / hypot(*ray)


_AXES: tuple[Vec3, ...] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
_CAMERA_SIZE = 0.15
"""Size of a camera with its bracket [m]."""


class FrameMaker:
    """Turns true poses into frames with rate, latency, jitter, noise and dropouts."""

    def __init__(self, site: Site, rng: np.random.Generator) -> None:
        twin = site.twin
        self._period = 1.0 / twin.mocap_rate_hz
        self._latency, self._noise, self._dropout = (
            twin.mocap_latency,
            twin.mocap_noise,
            twin.mocap_dropout,
        )
        self._rng = rng
        self._number = 0
        self._waiting: deque[MocapFrame] = deque()
        self._due = 0.0

    def is_due(self, now: float) -> bool:
        """Tell whether the next exposure has come."""
        return now >= self._number * self._period - 1e-9

    def expose(self, now: float, bodies: tuple[tuple[str, Pose | None], ...]) -> None:
        """Take one frame; the draw of noise is the same whether or not it is lost."""
        lost = self._rng.random() < self._dropout
        jitter = self._rng.exponential(JITTER)
        noisy = tuple((name, self._blurred(pose)) for name, pose in bodies)
        self._due = max(self._due, now + self._latency + jitter)
        if not lost:
            self._waiting.append(MocapFrame(self._number, now, self._due, noisy))
        self._number += 1

    def take(self, now: float) -> tuple[MocapFrame, ...]:
        """Return the frames that are due, oldest first, once."""
        ready = []
        while self._waiting and self._waiting[0].due_at <= now:
            ready.append(self._waiting.popleft())
        return tuple(ready)

    def _blurred(self, pose: Pose | None) -> Pose | None:
        x, y, z, *turn = (self._noise * self._rng.standard_normal(6)).tolist()
        if pose is None:
            return None
        half = [angle / LEVER_ARM / 2 for angle in turn]
        px, py, pz = pose.position
        return Pose((px + x, py + y, pz + z), _turned(pose, half))


def _turned(pose: Pose, half: list[float]) -> tuple[float, float, float, float]:
    """Return the orientation after a small rotation about the body axes, given as half angles
    [rad].
    """
    w, x, y, z = pose.orientation
    a, b, c = half
    return normalized(
        (
            w - x * a - y * b - z * c,
            x + w * a + y * c - z * b,
            y + w * b + z * a - x * c,
            z + w * c + x * b - y * a,
        )
    )
