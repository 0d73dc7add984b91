"""How many tracking cameras see each part of the room: a coarse grid, computed once on a thread."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from math import ceil, tan

import numpy as np
from pydantic import TypeAdapter

from housefly.geometry import Vec2, Vec3, rotate
from housefly.room.coverage import seen_by
from housefly.room.model import Room, TrackingCamera

COVERAGE_CELL = 0.25
"""Edge of a cell [m]."""
_DIGITS = "0123456789abcdefghijklmnopqrstuvwxyz"
"""One digit a cell: the number of cameras; the last digit also stands for more."""


@dataclass(frozen=True, slots=True)
class CameraCone:
    """One tracking camera: place [m], the corners of its picture at 1 m depth [m], reach [m]."""

    name: str
    position: Vec3
    corners: tuple[Vec3, ...]
    reach: float


@dataclass(frozen=True, slots=True)
class CoverageView:
    """How many cameras see the middle of each cell.

    Attributes:
        height: above the floor [m].
        cameras: how many there are.
        enough: cameras that must see a body to track it.
        origin: world xy of the lower left corner [m].
        resolution: edge of a cell [m].
        rows: lowest y first, one digit of base 36 a cell.
        lenses: the cameras.
    """

    height: float
    cameras: int
    enough: int
    origin: Vec2
    resolution: float
    rows: tuple[str, ...]
    lenses: tuple[CameraCone, ...] = ()


def coverage_view(room: Room, height: float, enough: int = 2) -> CoverageView:
    """Return the coverage of a room at a height [m]."""
    x0, y0, x1, y1 = room.bounds
    xs = x0 + COVERAGE_CELL * (np.arange(ceil((x1 - x0) / COVERAGE_CELL)) + 0.5)
    ys = y0 + COVERAGE_CELL * (np.arange(ceil((y1 - y0) / COVERAGE_CELL)) + 0.5)
    grid = np.array(np.meshgrid(xs, ys)).reshape(2, -1).T
    points = np.column_stack([grid, np.full(len(grid), height)])
    counts = seen_by(room, points).sum(axis=1).clip(max=len(_DIGITS) - 1).reshape(len(ys), len(xs))
    rows = tuple("".join(_DIGITS[count] for count in row) for row in counts.tolist())
    lenses = tuple(map(camera_view, room.cameras))
    return CoverageView(height, len(room.cameras), enough, (x0, y0), COVERAGE_CELL, rows, lenses)


def camera_view(camera: TrackingCamera) -> CameraCone:
    """Return what is drawn of a camera: it looks along its own +z, x right, y down."""
    across, down = (tan(angle / 2.0) for angle in camera.field_of_view)
    x, y, z = camera.position
    rays = [
        rotate(camera.orientation, (u * across, v * down, 1.0))
        for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1))
    ]
    corners = tuple((x + a, y + b, z + c) for a, b, c in rays)
    return CameraCone(camera.name, camera.position, corners, camera.reach)


class CoverageLayer:
    """Computes the view on first request, on its own thread, and keeps it.

    Args:
        compute: returns the view.
    """

    def __init__(self, compute: Callable[[], CoverageView]) -> None:
        self._compute = compute
        self._thread = ThreadPoolExecutor(1, "coverage")
        self._text: asyncio.Future[bytes] | None = None

    async def text(self) -> bytes:
        """Return the view as JSON; raises what the computation raises."""
        if self._text is None or (self._text.done() and self._text.exception() is not None):
            self._text = asyncio.get_running_loop().run_in_executor(self._thread, self._dumped)
        # A browser that leaves must not cancel the answer for the others.
        return await asyncio.shield(self._text)

    def close(self) -> None:
        """Shut the thread down without waiting."""
        self._thread.shutdown(wait=False, cancel_futures=True)

    def _dumped(self) -> bytes:
        return TypeAdapter(CoverageView).dump_json(self._compute())
