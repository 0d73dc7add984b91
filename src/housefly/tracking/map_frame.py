"""Moves and turns the poses of a tracking system into the frame of the map."""

from __future__ import annotations

from dataclasses import replace
from math import cos, sin

from housefly.config.tracking import TrackingConfig
from housefly.geometry import Quaternion, quaternion_from_euler, quaternion_product
from housefly.messages import Pose, Sighting
from housefly.messages.words import Words
from housefly.tracking.contracts import SightingSink, Tracker


class MapFrame:
    """The frame of a tracking system on the map, as its site file says it."""

    def __init__(self, config: TrackingConfig) -> None:
        self._body = config.body
        self._origin = config.x, config.y, config.z
        self._cos, self._sin = cos(config.yaw), sin(config.yaw)
        self._turn = quaternion_from_euler(0.0, 0.0, config.yaw)
        self._nose = quaternion_from_euler(0.0, 0.0, config.body_yaw)

    def on_map(self, sighting: Sighting) -> Sighting:
        """Return a sighting as the map has it; the drone's nose along its body's x axis."""
        pose = sighting.pose
        (x, y, z), (dx, dy, dz) = pose.position, self._origin
        c, s = self._cos, self._sin
        orientation = quaternion_product(self._turn, pose.orientation)
        if sighting.body == self._body:
            orientation = quaternion_product(orientation, self._nose)
        position = (c * x - s * y + dx, s * x + c * y + dy, z + dz)
        return replace(sighting, pose=Pose(position, _with_positive_w(orientation)))


class MapFrameTracker:
    """A tracking client whose sightings are moved into the frame of the map."""

    def __init__(self, inner: Tracker, config: TrackingConfig) -> None:
        self._inner = inner
        self._frame = MapFrame(config)

    async def run(self, sink: SightingSink) -> None:
        """Run the client; hand on what it sees, as the map has it."""
        await self._inner.run(
            lambda sightings: sink(tuple(self._frame.on_map(seen) for seen in sightings))
        )

    @property
    def connected(self) -> bool:
        """Whether frames arrive (within the last second)."""
        return self._inner.connected

    @property
    def problem(self) -> Words:
        """Why not; UNSAID where all is well."""
        return self._inner.problem


def _with_positive_w(turn: Quaternion) -> Quaternion:
    w, x, y, z = turn
    return turn if w >= 0.0 else (-w, -x, -y, -z)
