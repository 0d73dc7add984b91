"""Converts VRPN messages to poses in metres; holds the state that spans messages."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import groupby

from housefly.errors import WireError
from housefly.messages import Sighting
from housefly.tracking.counts import FrameCounts
from housefly.tracking.poses import checked_pose
from housefly.tracking.sender_clock import SenderClock
from housefly.wires.vrpn import POSE_TYPE, TrackerPose, VrpnMessage, VrpnNames, decode_pose

_SENSORS_MAX = 1000
"""Sensors of one tracker are numbered below this."""
_MICROSECOND = 1e-6


class VrpnFrames:
    """Converts the messages of one connection to sightings.

    A body has the name of its tracker; from sensor 1 on it is called tracker/sensor.

    Args:
        latency: from exposure to arrival [s]; VRPN does not carry it.
        y_up: whether the server has y up.
        counts: kept up to date.
    """

    def __init__(self, latency: float, y_up: bool, counts: FrameCounts) -> None:
        self._latency = latency
        self._y_up = y_up
        self._counts = counts
        self._names = VrpnNames()
        self._clocks: dict[tuple[int, int], SenderClock] = {}

    def read(
        self, messages: Iterable[VrpnMessage], received_at: float
    ) -> list[tuple[Sighting, ...]]:
        """Return the sightings, those of one time stamp together; raises WireError."""
        poses = [message for message in messages if self._is_pose(message)]
        frames = []
        for _, group in groupby(poses, key=lambda message: message.stamp):
            sightings = tuple(
                seen
                for message in group
                if (seen := self._sighting(message, received_at)) is not None
            )
            if sightings:
                self._counts.frames += 1
                frames.append(sightings)
        return frames

    def _is_pose(self, message: VrpnMessage) -> bool:
        return not self._names.learn(message) and self._names.kind(message) == POSE_TYPE

    def _sighting(self, message: VrpnMessage, received_at: float) -> Sighting | None:
        report = decode_pose(message.body)
        name = self._body_name(message, report)
        if not name:
            self._counts.unnamed += 1
            return None
        clock = self._clocks.setdefault((message.sender, report.sensor), SenderClock(self._counts))
        captured_at = clock.captured_at(message.stamp, _MICROSECOND, self._latency, received_at)
        if captured_at is None:
            return None
        try:
            pose = checked_pose(report.position, report.orientation, self._y_up)
        except WireError:
            self._counts.refuse(name, report.position, received_at)
            return None
        return Sighting(name, pose, captured_at, received_at)

    def _body_name(self, message: VrpnMessage, report: TrackerPose) -> str:
        name = self._names.sender(message)
        if not name or not 0 <= report.sensor < _SENSORS_MAX:
            return ""
        return name if report.sensor == 0 else f"{name}/{report.sensor}"
