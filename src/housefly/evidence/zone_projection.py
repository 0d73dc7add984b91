"""Privacy zones as the camera sees them: which part of a picture must be blank.

A zone is a prism. Each convex piece of it, grown by what the position may be wrong by, is projected
from every pose in which the picture may have been taken; the hull of all that, grown by what the
attitude may be wrong by, is blank. What stands before or behind a zone is blank with it.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import product
from math import atan, cos, hypot, pi, radians, sin, sqrt, tan

import numpy as np

from housefly.config.house_mode import HouseMode
from housefly.config.tasks import PrivacyZone, TasksConfig
from housefly.evidence.camera_pose import CameraPose
from housefly.evidence.polygon_pieces import ConvexPolygon, convex_pieces, corner_and_neighbours
from housefly.evidence.privacy_mask import MASK_ALL, MASK_NONE, PrivacyMask
from housefly.geometry import Vec3, rotate
from housefly.numeric import FloatArray
from housefly.room.level_camera import LevelCamera

ATTITUDE_ERROR = radians(2.0)
"""Attitude, mount and lens may be wrong by this [rad]."""
_STANDARD_DEVIATIONS = 3.0
_NEAR_PLANE = 0.05
"""Nothing nearer than this is projected; who is so near to a zone is in it [m]."""
_CUBE_CORNERS = np.array(list(product((-1.0, 1.0), repeat=3)))
_AXES: tuple[Vec3, ...] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
_SIDE_NORMALS = np.array([(cos(n * pi / 48), sin(n * pi / 48)) for n in range(96)])
"""Directions in the picture to which the sides of what is blank are square."""


class ZoneProjector:
    """Projects the privacy zones of a room into the drone's picture.

    Args:
        zones: of the room.
        camera: of the drone.
        margin: by which each is grown, besides what the pose is known to be wrong by [m].
    """

    def __init__(
        self,
        zones: tuple[PrivacyZone, ...],
        camera: LevelCamera,
        margin: float = 0.1,
    ) -> None:
        self._pieces = tuple(
            _Piece.of(polygon, zone) for zone in zones for polygon in convex_pieces(zone.polygon)
        )
        self._margin, self._camera = margin, camera

    @property
    def has_zones(self) -> bool:
        """Whether there is any zone."""
        return bool(self._pieces)

    def mask(self, poses: tuple[CameraPose, ...], width: int, height: int) -> PrivacyMask:
        """Return what must be blank in a picture; everything while the pose is not known.

        Args:
            poses: in which it may have been taken, by time.
            width: of the picture [px].
            height: of the picture [px].
        """
        if not self._pieces:
            return MASK_NONE
        if not poses:
            return MASK_ALL
        views = _Views.of(poses, self._camera, self._margin)
        if any(piece.contains_camera(views) for piece in self._pieces):
            return MASK_ALL
        pinhole = _Pinhole.of(self._camera, width, height)
        near = (piece for piece in self._pieces if views.may_see(piece, pinhole.half_angle))
        shown = (pinhole.pixels(views.in_front(piece.corners)) for piece in near)
        return PrivacyMask(
            polygons=tuple(part for points in shown if (part := pinhole.outline(points)))
        )


def zone_projectors(
    config: TasksConfig, camera: LevelCamera
) -> dict[HouseMode | None, ZoneProjector]:
    """Return what projects the zones of each mode of the house; under None, all of them."""
    zones, margin = config.privacy_zones, config.privacy_margin
    projectors: dict[HouseMode | None, ZoneProjector] = {None: ZoneProjector(zones, camera, margin)}
    for mode in HouseMode:
        projectors[mode] = ZoneProjector(private_zones(mode, zones), camera, margin)
    return projectors


@dataclass(frozen=True, slots=True)
class _Piece:
    """A convex prism: footprint, heights [m], corners, shape (n, 3), and a ball around it [m]."""

    footprint: ConvexPolygon
    z_min: float
    z_max: float
    corners: FloatArray
    centre: FloatArray
    radius: float

    @classmethod
    def of(cls, footprint: ConvexPolygon, zone: PrivacyZone) -> _Piece:
        heights = zone.z_min, zone.z_max
        corners = np.array([(x, y, z) for x, y in footprint for z in heights])
        centre: FloatArray = corners.mean(axis=0)
        radius = float(np.linalg.norm(corners - centre, axis=1).max())
        return cls(footprint, *heights, corners, centre, radius)

    def contains_camera(self, views: _Views) -> bool:
        """Return whether the camera is, in any view, in the prism or near it."""
        reach = views.margins + _NEAR_PLANE
        x, y, z = views.eyes.T
        inside = (z >= self.z_min - reach) & (z <= self.z_max + reach)
        for n in range(len(self.footprint)):
            _, (ax, ay), (bx, by) = corner_and_neighbours(self.footprint, n)
            across, length = (bx - ax) * (y - ay) - (by - ay) * (x - ax), hypot(bx - ax, by - ay)
            inside &= across >= -reach * length
        return bool(inside.any())


@dataclass(frozen=True, slots=True)
class _Views:
    """Where the camera is, pose by pose.

    Attributes:
        eyes: [m], shape (n, 3).
        axes: forward, left and up as columns, shape (n, 3, 3).
        margins: by which zones are grown [m], shape (n,).
    """

    eyes: FloatArray
    axes: FloatArray
    margins: FloatArray

    @classmethod
    def of(cls, poses: tuple[CameraPose, ...], camera: LevelCamera, margin: float) -> _Views:
        axes = np.array([[rotate(pose.orientation, axis) for axis in _AXES] for pose in poses])
        places = np.array([pose.position for pose in poses])
        spreads = np.array([pose.position_std for pose in poses])
        return cls(
            places + camera.ahead * axes[:, 0],
            axes.transpose(0, 2, 1),
            margin + _STANDARD_DEVIATIONS * spreads,
        )

    def may_see(self, piece: _Piece, half_angle: float) -> bool:
        """Return whether a ball around a piece reaches into a cone around the view [rad]."""
        offsets = piece.centre - self.eyes
        distances = np.linalg.norm(offsets, axis=1)
        ahead = (offsets * self.axes[:, :, 0]).sum(axis=1) / np.maximum(distances, 1e-9)
        balls = piece.radius + sqrt(3.0) * self.margins
        wide = np.arcsin(np.minimum(1.0, balls / np.maximum(distances, 1e-9)))
        return bool((np.arccos(np.clip(ahead, -1.0, 1.0)) - wide <= half_angle).any())

    def in_front(self, corners: FloatArray) -> FloatArray:
        """Return the corners of what of a grown convex body lies before the camera, in any view.

        Args:
            corners: of the body, world [m], shape (n, 3).

        Returns:
            forward, left, up from the camera [m], shape (m, 3).
        """
        grown = self.margins[:, None, None] * _CUBE_CORNERS
        points = (corners[None, :, None, :] + grown[:, None, :, :]).reshape(len(grown), -1, 3)
        points = (points - self.eyes[:, None, :]) @ self.axes
        is_whole = points[:, :, 0].min(axis=1) >= _NEAR_PLANE
        parts = [_clipped(view) for view in points[~is_whole]]
        before: FloatArray = np.concatenate((points[is_whole].reshape(-1, 3), *parts))
        return before


@dataclass(frozen=True, slots=True)
class _Pinhole:
    """Focal length, size and angular margin [px], and the angle that the corners reach [rad]."""

    focal: float
    width: int
    height: int
    margin: float
    half_angle: float

    @classmethod
    def of(cls, camera: LevelCamera, width: int, height: int) -> _Pinhole:
        focal = width / 2 / tan(camera.width / 2)
        corner = atan(hypot(width, height) / 2 / focal)
        # In the corner of a picture an angle is widest; one pixel more for the edge of a pixel.
        margin = focal * ATTITUDE_ERROR / cos(corner + ATTITUDE_ERROR) ** 2 + 1.0
        return cls(focal, width, height, margin, corner + ATTITUDE_ERROR)

    def pixels(self, points: FloatArray) -> FloatArray:
        """Return where points in front of the camera are in the picture, shape (n, 2) [px]."""
        centre = np.array((self.width / 2, self.height / 2))
        shown: FloatArray = centre - self.focal * points[:, 1:] / points[:, :1]
        return shown

    def outline(self, points: FloatArray) -> tuple[tuple[float, float], ...]:
        """Return a convex polygon around points with the margin; () when it is not in the picture.

        Its sides have fixed directions, so that it is quickly found; it is never too small.
        """
        if not len(points):
            return ()
        reach = (points @ _SIDE_NORMALS.T).max(axis=0) + self.margin
        quarter = len(_SIDE_NORMALS) // 4
        right, down, left, up = (float(reach[n * quarter]) for n in range(4))
        if right < 0 or down < 0 or -left > self.width or -up > self.height:
            return ()
        after, after_reach = np.roll(_SIDE_NORMALS, -1, axis=0), np.roll(reach, -1)
        across = _SIDE_NORMALS[:, 0] * after[:, 1] - _SIDE_NORMALS[:, 1] * after[:, 0]
        x = (reach * after[:, 1] - after_reach * _SIDE_NORMALS[:, 1]) / across
        y = (_SIDE_NORMALS[:, 0] * after_reach - after[:, 0] * reach) / across
        return tuple(zip(x.tolist(), y.tolist(), strict=True))


def _clipped(points: FloatArray) -> FloatArray:
    """Return the corners of what of a convex body lies before the camera."""
    front, back = points[points[:, 0] >= _NEAR_PLANE], points[points[:, 0] < _NEAR_PLANE]
    # Every edge that crosses the near plane is among the lines from front to back.
    share = (front[:, None, 0] - _NEAR_PLANE) / (front[:, None, 0] - back[None, :, 0])
    cut = front[:, None, :] + share[:, :, None] * (back[None, :, :] - front[:, None, :])
    return np.concatenate((front, cut.reshape(-1, 3)))


def private_zones(mode: HouseMode, zones: Iterable[PrivacyZone]) -> tuple[PrivacyZone, ...]:
    """Return the zones that no picture shows in a mode."""
    return tuple(zone for zone in zones if not zone.modes or mode.value in zone.modes)
