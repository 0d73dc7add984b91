"""A scan of a simulated room, as somebody makes it who carries the twin's own depth camera about.

``python tests/support/depth_scan.py SITE OUT.ply [STEP]`` writes the points of all views.
"""

from __future__ import annotations

import sys
from math import pi
from pathlib import Path

import numpy as np

from housefly.config.site import changed
from housefly.messages import DepthImage
from housefly.numeric import FloatArray
from housefly.perception.depth import Intrinsics, points_of
from housefly.room.grid import Cell
from housefly.sites.loaded_site import LoadedSite, load_site
from housefly.twin.world import SimulatedWorld

HEADINGS = tuple(n * pi / 4 - pi for n in range(8))
TILTS = (0.9, 0.25, -0.5)
"""How far it looks down [rad]."""
EYE_HEIGHT = 1.5
FARTHEST = 3.5
"""What is farther away is left out [m]: the noise grows with the square of the depth."""


def scan_points(loaded: LoadedSite, step: float = 1.2) -> FloatArray:
    """Return the points [m] of views from every free spot of a grid, shape (n, 3)."""
    cameras = [
        {"name": f"v{n}-{a}-{b}", "x": x, "y": y, "z": EYE_HEIGHT, "yaw": yaw, "pitch": tilt}
        for n, (x, y) in enumerate(_spots(loaded, step))
        for a, yaw in enumerate(HEADINGS)
        for b, tilt in enumerate(TILTS)
    ]
    site = changed(loaded.site, depth_cameras=cameras, twin__visitor_present=False)
    world = SimulatedWorld(site, loaded.room)
    images = (world.depth_image(camera.name, 0.0) for camera in site.depth_cameras)
    return np.vstack([_points(image) for image in images])


def _points(image: DepthImage) -> FloatArray:
    depth = np.frombuffer(image.data, "<u2").reshape(image.height, image.width) / 1000.0
    depth = np.where((depth > 0.0) & (depth < FARTHEST), depth, np.nan)
    return points_of(depth, Intrinsics(image.fx, image.fy, image.cx, image.cy), image.pose)


def _spots(loaded: LoadedSite, step: float) -> list[tuple[float, float]]:
    x_min, y_min, x_max, y_max = loaded.room.bounds
    spots = [
        (float(x), float(y))
        for x in np.arange(x_min + 0.4, x_max, step)
        for y in np.arange(y_min + 0.4, y_max, step)
    ]
    grid = loaded.grid
    return [
        spot
        for spot in spots
        if grid.kind(grid.cell_of(spot)) in (Cell.FREE, Cell.INFLATED, Cell.VIRTUAL)
    ]


def write_ply(points: FloatArray, path: Path) -> None:
    """Write points as a binary PLY file."""
    head = (
        f"ply\nformat binary_little_endian 1.0\nelement vertex {points.shape[0]}\n"
        "property float x\nproperty float y\nproperty float z\nend_header\n"
    )
    path.write_bytes(head.encode() + points.astype("<f4").tobytes())


if __name__ == "__main__":
    write_ply(
        scan_points(load_site(sys.argv[1]), float(sys.argv[3]) if len(sys.argv) > 3 else 1.2),
        Path(sys.argv[2]),
    )
