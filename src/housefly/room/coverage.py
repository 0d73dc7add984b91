"""Which tracking cameras see a point of the room: field of view, reach, occlusion."""

from __future__ import annotations

from math import tan

import numpy as np

from housefly.geometry import rotate
from housefly.numeric import FloatArray
from housefly.room.model import Room, TrackingCamera
from housefly.room.reach import Mask
from housefly.room.sight import hiding_rows, in_sight

_BRACKET = 0.10
"""Solids within this distance of a camera are its bracket and are ignored [m]."""


def seen_by(room: Room, points: FloatArray) -> Mask:
    """Return which cameras see which points.

    Args:
        room: its cameras and solids.
        points: world [m], shape (n, 3).

    Returns:
        shape (n, cameras).
    """
    rows = hiding_rows(room.solids, glass=True)
    seen = np.zeros((len(points), len(room.cameras)), dtype=np.bool_)
    for column, camera in enumerate(room.cameras):
        inside = np.flatnonzero(_in_view(camera, points))
        eye = np.array([camera.position])
        seen[inside, column] = in_sight(rows, points[inside], eye, _BRACKET)[:, 0]
    return seen


def _in_view(camera: TrackingCamera, points: FloatArray) -> Mask:
    right, down, ahead = (
        np.array(rotate(camera.orientation, axis))
        for axis in ((1.0, 0, 0), (0, 1.0, 0), (0, 0, 1.0))
    )
    rays = points - np.array(camera.position)
    depth = np.einsum("nk,k->n", rays, ahead)
    horizontal, vertical = (tan(angle / 2) for angle in camera.field_of_view)
    inside: Mask = (
        (depth > 0.0)
        & (np.abs(np.einsum("nk,k->n", rays, right)) <= depth * horizontal)
        & (np.abs(np.einsum("nk,k->n", rays, down)) <= depth * vertical)
        & (np.linalg.norm(rays, axis=1) <= camera.reach)
    )
    return inside
