"""From VRPN messages to poses in metres; state that spans messages lives here."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import groupby

from housefly.errors import WireError
from housefly.messages import Sighting
from housefly.tracking.counts import FrameCounts
from housefly.tracking.poses import checked_pose
from housefly.tracking.sender_clock import SenderClock
from housefly.wires.vrpn import POSE, Message, Names, TrackerPose, decode_pose

MOST_SENSORS = 1000
"""Sensors of one tracker are numbered below this."""
_MICROSECOND = 1e-6


class VrpnFrames:
    """Turns the messages of one connection into sightings.

    A body is called as its tracker; where a tracker has several sensors, as tracker/sensor from
    sensor 1 on.

    Args:
        latency: from exposure to arrival [s]; VRPN does not tell it.
        y_up: whether the server has y up.
        counts: kept up to date.
    """

    def __init__(self, latency: float, y_up: bool, counts: FrameCounts) -> None:
        self._latency = latency
        self._y_up = y_up
        self._counts = counts
        self._names = Names()
        self._clocks: dict[tuple[int, int], SenderClock] = {}

    def read(self, messages: Iterable[Message], received_at: float) -> list[tuple[Sighting, ...]]:
        """Return the sightings of some messages, those of one time stamp together; raises
        WireError.
        """
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

    def _is_pose(self, message: Message) -> bool:
        return not self._names.learn(message) and self._names.kind(message) == POSE

    def _sighting(self, message: Message, received_at: float) -> Sighting | None:
        report = decode_pose(message.body)
        name = self._body(message, report)
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
            self._counts.refused += 1
            return None
        return Sighting(name, pose, captured_at, received_at)

    def _body(self, message: Message, report: TrackerPose) -> str:
        name = self._names.sender(message)
        if not name or not 0 <= report.sensor < MOST_SENSORS:
            return ""
        return name if report.sensor == 0 else f"{name}/{report.sensor}"
