"""Where the drone's camera was while a picture was taken, as far as anybody knows."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from itertools import pairwise

from housefly.geometry import Quaternion, Vec3, quaternion_from_euler
from housefly.messages import PilotStep

PICTURE_LATENCY_MAX = 0.35
"""From the moment a picture shows to the arrival of its last byte, at most [s]."""
_POSE_AGE_MAX = 0.5
"""An estimate that tracking has not confirmed for longer says nothing [s]."""
_ATTITUDE_AGE_MAX = 0.2
"""An older report of the drone says nothing about its tilt [s]."""
_GAP_MAX = 0.2
"""Poses further apart leave the time between them unknown [s]."""
_KEPT = 2.0
"""Poses are kept so long [s]."""


@dataclass(frozen=True, slots=True)
class CameraPose:
    """Pose of the drone's body at one moment, with what it may be wrong by.

    Attributes:
        at: when [s, our monotonic clock].
        position: of the body's origin in the world [m].
        orientation: (w, x, y, z), body to world.
        position_std: one-sigma uncertainty of the position [m].
    """

    at: float
    position: Vec3
    orientation: Quaternion
    position_std: float = 0.0


def camera_pose_of(step: PilotStep) -> CameraPose | None:
    """Return the pose that a step of the pilot believes in, or None when it knows too little."""
    estimate, report = step.outputs.estimate, step.inputs.telemetry
    if estimate is None or report is None or estimate.pose_age > _POSE_AGE_MAX:
        return None
    if step.now - report.received_at > _ATTITUDE_AGE_MAX:
        return None
    return CameraPose(
        step.now,
        estimate.position,
        quaternion_from_euler(report.phi, report.theta, estimate.yaw),
        estimate.position_std,
    )


class CameraTrack:
    """The poses of the last seconds, and which of them a picture may have been taken in.

    Args:
        latency_max: of pictures; the real moment lies anywhere in it [s].
    """

    def __init__(self, latency_max: float = PICTURE_LATENCY_MAX) -> None:
        self._latency_max = latency_max
        self._poses: deque[CameraPose] = deque()

    def add(self, pose: CameraPose | None) -> None:
        """Keep a pose; None, an unknown one, leaves a gap."""
        if pose is None or (self._poses and pose.at == self._poses[-1].at):
            return
        if self._poses and pose.at < self._poses[-1].at:
            self._poses.clear()  # another pilot, another clock
        self._poses.append(pose)
        while self._poses[0].at < pose.at - _KEPT:
            self._poses.popleft()

    def poses(self, received_at: float, late: float = 0.0) -> tuple[CameraPose, ...]:
        """Return the poses around the moment of a picture, by time; () when it is not known.

        Args:
            received_at: when the picture came [s].
            late: by how much it came later than others [s].
        """
        start = received_at - self._latency_max - late
        before = max((pose.at for pose in self._poses if pose.at <= start), default=start)
        chosen = tuple(pose for pose in self._poses if before <= pose.at <= received_at)
        times = (*(pose.at for pose in chosen), received_at)
        known = bool(chosen) and all(b - a <= _GAP_MAX for a, b in pairwise(times))
        return chosen if known and chosen[0].at <= start + _GAP_MAX else ()
