"""Tracks obstacles in the images of a room's depth cameras. Pure: no clock, no wire."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import ceil, sqrt
from operator import mul

import numpy as np

from housefly.config.depth import DepthCameraConfig
from housefly.geometry import Vec2, normalized, rotate
from housefly.messages import DepthImage, Obstacle, Pose
from housefly.messages.obstacles import TRACK
from housefly.numeric import FloatArray, running_sum
from housefly.perception.depth import MIN_DEPTH, Intrinsics, points_of
from housefly.perception.depth_checks import DepthChecks
from housefly.perception.depth_clusters import known_room, unexplained
from housefly.perception.laser_tracker import (
    SEE_THROUGH_MARGIN,
    OwnFootprint,
    TrackingResult,
    known_discs,
    obstacle_of,
)
from housefly.perception.tracker import ObstacleTrack, TrackSet
from housefly.room.model import Room

_SOURCE = "depth"
"""Source of the obstacles of the depth cameras."""
MAX_SAMPLED_PIXELS = 80_000
"""Larger images are subsampled to at most this many pixels [px]."""
_SEE_THROUGH_SHARE = 0.7
"""A camera sees through a place if this share of the pixels there ends behind it."""


@dataclass(frozen=True, slots=True)
class _DepthView:
    """An accepted image.

    Attributes:
        depth: distance along the camera's axis [m], NaN if not measured, shape (height, width).
        camera: its intrinsics.
        pose: of the camera in the world.
    """

    depth: FloatArray
    camera: Intrinsics
    pose: Pose

    def sees_through(self, place: Vec2, height: float, radius: float) -> bool:
        """Return whether the camera sees through a place [m] at a height [m] with a radius [m]."""
        away = [a - b for a, b in zip((*place, height), self.pose.position, strict=True)]
        x, y, z = (
            running_sum(map(mul, rotate(self.pose.orientation, axis), away)) for axis in _AXES
        )
        if z <= MIN_DEPTH:
            return False
        u, v = (
            round(self.camera.cx + x / z * self.camera.fx),
            round(self.camera.cy + y / z * self.camera.fy),
        )
        rows, columns = self.depth.shape
        if not (0 <= u < columns and 0 <= v < rows):
            return False
        spread = max(1, int(0.5 * radius * self.camera.fx / z))
        near = self.depth[max(0, v - 1) : v + 2, max(0, u - spread) : u + spread + 1]
        measured = np.isfinite(near)
        return bool(
            (near[measured] > z + SEE_THROUGH_MARGIN).sum()
            > _SEE_THROUGH_SHARE * measured.sum()
            > 0
        )


class DepthTracker:
    """Tracks what no map shows, for each camera separately.

    Args:
        room: what the map shows.
        cameras: of the site.
        band: heights between which the drone flies [m].
    """

    def __init__(self, room: Room, cameras: tuple[DepthCameraConfig, ...], band: Vec2) -> None:
        self._known, self._band = known_room(room, band), band
        self._checks = DepthChecks(cameras)
        self._tracks = {camera.name: TrackSet() for camera in cameras}

    def update(
        self, image: DepthImage, now: float, own: tuple[OwnFootprint, ...] = ()
    ) -> TrackingResult:
        """Process one image.

        Args:
            image: of any of the cameras.
            now: time [s].
            own: where the drones are that are off the ground, as far as it is known.
        """
        problem = self._checks.fault(image, now)
        if problem:
            return TrackingResult(problem=f"{image.source[:40]}: {problem}")
        view = depth_view(image)
        points = points_of(view.depth, view.camera, view.pose)
        for footprint in own:
            known = known_discs(self._tracks[image.source], image.captured_at)
            points = points[footprint.others(points, known)]
        clusters = unexplained(points, self._known, self._band, view.pose.position[:2])
        middle = (self._band[0] + self._band[1]) / 2
        last = self._tracks[image.source]
        tracks = last.updated(
            clusters,
            image.captured_at,
            lambda place, radius: view.sees_through(place, middle, radius),
        )
        self._tracks[image.source] = tracks
        confirmed = tuple(track for track in tracks.tracks if track.confirmed)
        gone = (
            replace(_named(track, image), confidence=0.0, seen_at=image.captured_at)
            for track in tracks.gone
        )
        return TrackingResult((*(_named(track, image) for track in confirmed), *gone))


def depth_view(image: DepthImage) -> _DepthView:
    """Return a checked image in metres, subsampled if it is large."""
    every = ceil(sqrt(image.width * image.height / MAX_SAMPLED_PIXELS))
    raw = np.frombuffer(image.data, dtype="<u2").reshape(image.height, image.width)[
        ::every, ::every
    ]
    depth = np.where(raw > 0, raw / 1000.0, np.nan)
    camera = Intrinsics(image.fx / every, image.fy / every, image.cx / every, image.cy / every)
    return _DepthView(depth, camera, Pose(image.pose.position, normalized(image.pose.orientation)))


def _named(track: ObstacleTrack, image: DepthImage) -> Obstacle:
    return replace(obstacle_of(track), id=f"{TRACK}{image.source}-{track.number}", source=_SOURCE)


_AXES = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
