"""What ROS is told of one drone: messages made of the pilot's steps."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from math import tan
from typing import Any

import numpy as np

from housefly.config.capabilities import OnboardCamera
from housefly.messages import (
    Path,
    Phase,
    PilotStep,
    PlannedTrajectory,
    Telemetry,
    VideoFrame,
)
from housefly.record import ros_messages
from housefly.record.ros_messages import (
    header,
    message,
    nanoseconds,
    transform,
    transform_message,
)
from housefly.ros2.topic_table import (
    BATTERY,
    DRONE_EVENTS,
    ODOMETRY,
    PATH,
    PHASE,
    POSE,
    TRANSFORMS,
    RosTopic,
)

Outgoing = tuple[RosTopic, Callable[[], Any]]
"""A topic, and what makes its message: nothing is made for whom nobody hears."""
_BATTERY_PERIOD = 1.0
"""The charge is told at most so often [s]."""


@dataclass(frozen=True, slots=True)
class RosFrames:
    """Names of the frames of one drone.

    Attributes:
        world: the map's.
        body: of the drone: forward, left, up.
        optical: of its camera.
    """

    world: str
    body: str
    optical: str

    @classmethod
    def of(cls, world: str, drone: str) -> RosFrames:
        """Return those of a drone by its ROS name."""
        return cls(world, f"{drone}/base_link", f"{drone}/camera_optical_frame")


class DroneMessages:
    """Turns steps into messages; remembers only what was told last.

    Args:
        body: what tracking calls the drone.
        frames: of the drone.
        flight_height: where a planned path is drawn [m].
    """

    def __init__(self, body: str, frames: RosFrames, flight_height: float) -> None:
        self._body, self._frames, self._flight_height = body, frames, flight_height
        self._path: Path | None = None
        self._phase: Phase | None = None
        self._battery_at = float("-inf")

    def of(self, step: PilotStep, offset: float) -> Iterator[Outgoing]:
        """Yield what a step has to tell.

        Args:
            step: of the pilot.
            offset: Unix time at which its clock was zero [s].
        """
        frames, outputs, now = self._frames, step.outputs, step.now
        for seen in step.inputs.sightings:
            if seen.body == self._body:
                at, pose = seen.captured_at + offset, seen.pose
                yield POSE, partial(ros_messages.pose_stamped, at, pose, frames.world)
                yield (
                    TRANSFORMS,
                    partial(
                        transform_message,
                        at,
                        frames.world,
                        frames.body,
                        pose.position,
                        pose.orientation,
                    ),
                )
        if (estimate := outputs.estimate) is not None:
            moved = replace(estimate, at=estimate.at + offset)
            yield ODOMETRY, partial(ros_messages.odometry, moved, frames.world, frames.body)
        telemetry = step.inputs.telemetry
        if telemetry is not None and now - self._battery_at >= _BATTERY_PERIOD:
            self._battery_at = now
            yield BATTERY, partial(self._battery, telemetry, offset)
        if outputs.phase is not self._phase:
            self._phase = outputs.phase
            yield PHASE, partial(text_message, outputs.phase.value)
        if outputs.path != self._path:
            self._path = outputs.path
            yield PATH, partial(self._planned, now + offset, outputs.path)
        for event in outputs.events:
            yield DRONE_EVENTS, partial(ros_messages.log_message, replace(event, at=now + offset))

    def _battery(self, telemetry: Telemetry, offset: float) -> Any:
        told = replace(telemetry, received_at=telemetry.received_at + offset)
        return ros_messages.battery_state(told, self._frames.body)

    def _planned(self, at: float, path: Path | None) -> Any:
        return ros_messages.planned_path(at, path, self._flight_height, self._frames.world)


def trajectory_message(planned: PlannedTrajectory, offset: float, frames: RosFrames) -> Any:
    """Return trajectory_msgs/MultiDOFJointTrajectory of a trajectory in space."""
    points = [
        message(
            "trajectory_msgs/msg/MultiDOFJointTrajectoryPoint",
            [transform(point.position)],
            [],
            [],
            message(
                "builtin_interfaces/msg/Duration", *divmod(nanoseconds(point.time), 1_000_000_000)
            ),
        )
        for point in planned.points
    ]
    return message(
        "trajectory_msgs/msg/MultiDOFJointTrajectory",
        header(planned.at + offset, frames.world),
        [frames.body],
        points,
    )


def camera_info(at: float, frames: RosFrames, camera: OnboardCamera, frame: VideoFrame) -> Any:
    """Return sensor_msgs/CameraInfo of a picture: a pinhole without distortion."""
    across = frame.width / 2.0 / tan(camera.field_of_view / 2.0)
    up = frame.height / 2.0 / tan(camera.field_of_view_up / 2.0)
    middle = frame.width / 2.0, frame.height / 2.0
    matrix = np.array([across, 0.0, middle[0], 0.0, up, middle[1], 0.0, 0.0, 1.0])
    projection = np.zeros((3, 4))
    projection[:, :3] = matrix.reshape(3, 3)
    return message(
        "sensor_msgs/msg/CameraInfo",
        header(at, frames.optical),
        frame.height,
        frame.width,
        "plumb_bob",
        np.zeros(5),
        matrix,
        np.eye(3).reshape(-1),
        projection.reshape(-1),
        0,
        0,
        message("sensor_msgs/msg/RegionOfInterest", 0, 0, 0, 0, False),
    )


def compressed_image(at: float, frames: RosFrames, form: str, data: bytes) -> Any:
    """Return sensor_msgs/CompressedImage; ``form`` is "jpeg" or "h264"."""
    return message(
        "sensor_msgs/msg/CompressedImage",
        header(at, frames.optical),
        form,
        np.frombuffer(data, dtype=np.uint8),
    )


def text_message(text: str) -> Any:
    """Return std_msgs/String."""
    return message("std_msgs/msg/String", text)
