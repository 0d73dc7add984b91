"""Converts a depth image to world points and to occupied cells of the floor plan."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from housefly.geometry import Vec2, rotate
from housefly.messages import Pose
from housefly.numeric import FloatArray
from housefly.room.grid import OccupancyGrid

_MIN_CELL_POINTS = 4
"""Fewer points in a cell are noise."""
MIN_DEPTH, _MAX_DEPTH = 0.2, 8.0
"""Depths outside this are discarded [m]."""


@dataclass(frozen=True, slots=True)
class Intrinsics:
    """A pinhole camera: focal lengths and principal point [px]."""

    fx: float
    fy: float
    cx: float
    cy: float


def points_of(depth: FloatArray, camera: Intrinsics, pose: Pose) -> FloatArray:
    """Return the world points [m] of a depth image, shape (n, 3), without invalid pixels.

    Args:
        depth: distance along the camera's axis [m], shape (height, width).
        camera: its intrinsics.
        pose: of the camera in the world; it looks along its own +z, x right in the image, y down.
    """
    believable = np.isfinite(depth) & (depth >= MIN_DEPTH) & (depth <= _MAX_DEPTH)
    v, u = np.nonzero(believable)
    z = depth[v, u]
    local = np.stack([(u - camera.cx) / camera.fx * z, (v - camera.cy) / camera.fy * z, z])
    axes = np.array(
        [
            rotate(pose.orientation, axis)
            for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
        ]
    )
    points: FloatArray = np.einsum("km,kn->mn", axes, local).T + np.array(pose.position)
    return points


def occupied_cells(
    points: FloatArray, grid: OccupancyGrid, band: Vec2, fewest: int = _MIN_CELL_POINTS
) -> NDArray[np.bool_]:
    """Return which cells of a grid hold enough points between two heights; shape of the grid.

    Args:
        points: world points [m], shape (n, 3).
        grid: gives origin, resolution and shape.
        band: lowest and highest height that counts [m].
        fewest: points that a cell must hold.
    """
    at_height = points[(points[:, 2] >= band[0]) & (points[:, 2] <= band[1])]
    cells = np.floor((at_height[:, :2] - np.array(grid.origin)) / grid.resolution).astype(np.int64)
    inside = ((cells >= 0) & (cells < np.array(grid.shape))).all(axis=1)
    counts = np.zeros(grid.shape, dtype=np.int64)
    np.add.at(counts, (cells[inside, 0], cells[inside, 1]), 1)
    return np.asarray(counts >= fewest, dtype=np.bool_)
