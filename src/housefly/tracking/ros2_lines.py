"""Converts the lines of the ROS 2 child to poses; holds the state that spans lines."""

from __future__ import annotations

import json
from typing import Any

from housefly.errors import LinkError, WireError
from housefly.messages import Sighting
from housefly.tracking.counts import FrameCounts
from housefly.tracking.poses import checked_pose
from housefly.tracking.sender_clock import SenderClock

_NANOSECOND = 1e-9
_STAMP_MAX = 2**32 * 1_000_000_000
"""ROS counts seconds in 32 bits."""
_BODIES_MAX = 1000


class Ros2Lines:
    """Converts lines to sightings.

    The age of a pose is by its stamp: the clock of each sender is mapped to ours by what arrived
    soonest. A pose whose stamp is 0 was captured when it arrived, less the configured latency.

    Args:
        latency: from capture to arrival at the soonest [s]; ROS does not carry it.
        y_up: whether poses come with y up.
        counts: kept up to date.

    Attributes:
        topics: that the child hears.
    """

    def __init__(self, latency: float, y_up: bool, counts: FrameCounts) -> None:
        self.topics: tuple[str, ...] = ()
        self._latency, self._y_up, self._counts = latency, y_up, counts
        self._clocks: dict[str, SenderClock] = {}

    def read(self, line: bytes, received_at: float) -> tuple[Sighting, ...] | None:
        """Return the bodies of a line, or None when nothing in it is new.

        Raises:
            LinkError: the child reports a failure.
            WireError: the line makes no sense.
        """
        tree = _tree(line)
        try:
            if "topics" in tree:
                self.topics = tuple(str(name) for name in tree["topics"])
                return None
            body, stamp = str(tree["body"]), int(tree["stamp"])
            px, py, pz, w, x, y, z = (float(number) for number in tree["pose"])
        except (KeyError, TypeError, ValueError, OverflowError) as error:
            raise WireError(f"ROS 2 line: {line[:40]!r} is no pose") from error
        if not 0 <= stamp < _STAMP_MAX:
            raise WireError("ROS 2 line: the stamp is none; allowed: 0 to 2**32 s")
        captured_at = self._captured_at(body, stamp, received_at)
        if captured_at is None:
            return None
        try:
            pose = checked_pose((px, py, pz), (w, x, y, z), self._y_up)
        except WireError:
            self._counts.refuse(body, (px, py, pz), received_at)
            return None
        self._counts.frames += 1
        return (Sighting(body, pose, captured_at, received_at),)

    def _captured_at(self, body: str, stamp: int, received_at: float) -> float | None:
        if stamp == 0:
            return received_at - self._latency
        if body not in self._clocks and len(self._clocks) >= _BODIES_MAX:
            self._counts.flooded += 1
            return None
        clock = self._clocks.setdefault(body, SenderClock(self._counts))
        return clock.captured_at(stamp, _NANOSECOND, self._latency, received_at)


def _tree(line: bytes) -> dict[str, Any]:
    try:
        tree = json.loads(line)
    except (ValueError, RecursionError) as error:
        raise WireError(f"ROS 2 line: {line[:40]!r} is no JSON") from error
    if not isinstance(tree, dict):
        raise WireError(f"ROS 2 line: {line[:40]!r} is no object")
    if "problem" in tree:
        raise LinkError(f"ROS 2 says: {tree['problem']}")
    return tree
