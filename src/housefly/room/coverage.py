"""Which tracking cameras see a point of the room: field of view, reach, occlusion."""

from __future__ import annotations

from math import cos, sin, tan

import numpy as np

from housefly.geometry import rotate
from housefly.numeric import FloatArray
from housefly.room.model import Room, Shape, Solid, TrackingCamera
from housefly.room.reach import Mask

_TOUCH = 1e-6
_BRACKET = 0.10
"""Solids within this distance of a camera are its bracket and are ignored [m]."""


def seen_by(room: Room, points: FloatArray) -> Mask:
    """Return which cameras see which points.

    Args:
        room: its cameras and solids; a cylinder hides what the largest square pillar inside it
            would.
        points: world [m], shape (n, 3).

    Returns:
        shape (n, cameras).
    """
    seen = np.zeros((len(points), len(room.cameras)), dtype=np.bool_)
    for column, camera in enumerate(room.cameras):
        seen[:, column] = _in_view(camera, points)
        for solid in room.solids:
            rows = np.flatnonzero(seen[:, column])
            if rows.size == 0:
                break
            seen[rows[_hides(solid, np.array(camera.position), points[rows])], column] = False
    return seen


def _in_view(camera: TrackingCamera, points: FloatArray) -> Mask:
    right, down, ahead = (
        np.array(rotate(camera.orientation, axis))
        for axis in ((1.0, 0, 0), (0, 1.0, 0), (0, 0, 1.0))
    )
    rays = points - np.array(camera.position)
    depth = rays @ ahead
    horizontal, vertical = (tan(angle / 2) for angle in camera.field_of_view)
    inside: Mask = (
        (depth > 0.0)
        & (np.abs(rays @ right) <= depth * horizontal)
        & (np.abs(rays @ down) <= depth * vertical)
        & (np.linalg.norm(rays, axis=1) <= camera.reach)
    )
    return inside


def _hides(solid: Solid, eye: FloatArray, points: FloatArray) -> Mask:
    """Return which segments from eye to points pass through the solid's box (slab test)."""
    c, s = cos(solid.yaw), sin(solid.yaw)
    turn = np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
    start = turn @ (eye - np.array(solid.position))
    rays = (points - eye) @ turn.T
    half = np.array(solid.size) / 2 * (0.5**0.5 if solid.shape is Shape.CYLINDER else 1.0)
    with np.errstate(divide="ignore", invalid="ignore"):
        first, second = (-half - start) / rays, (half - start) / rays
    enter = np.nanmax(np.minimum(first, second), axis=1)
    leave = np.nanmin(np.maximum(first, second), axis=1)
    length = np.linalg.norm(rays, axis=1)
    hidden: Mask = (enter < leave) & (leave * length > _BRACKET) & (enter < 1.0 - _TOUCH)
    return hidden
