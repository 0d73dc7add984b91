"""The standard ROS 2 topics in a recording, beside the complete steps."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any, NamedTuple

from housefly.messages import (
    AnySetpoint,
    Path,
    PilotStep,
    Pose,
    PositionSetpoint,
    Telemetry,
)
from housefly.record import ros_messages


class Sample(NamedTuple):
    """One message of one topic: topic, time [s], ROS 2 message."""

    topic: str
    at: float
    message: Any


class StepTopics:
    """Turns the pilot's steps into standard messages; remembers only the last ones.

    Args:
        flight_height: where a planned path is drawn [m].
    """

    def __init__(self, flight_height: float) -> None:
        self._flight_height = flight_height
        self._telemetry: Telemetry | None = None
        self._path: Path | None = None

    def of(self, step: PilotStep) -> Iterator[Sample]:
        """Yield the messages of one step; battery, path and events only when they are new."""
        now, outputs, telemetry = step.now, step.outputs, step.inputs.telemetry
        for sighting in step.inputs.sightings:
            stamped = ros_messages.pose_stamped(sighting.captured_at, sighting.pose)
            yield Sample(f"/sighting/{topic_part(sighting.body)}", now, stamped)
        if outputs.estimate is not None:
            yield Sample("/odom", now, ros_messages.odometry(outputs.estimate))
        yield ros_command(now, outputs.command.asked)
        if telemetry is not None and (
            self._telemetry is None or telemetry.battery != self._telemetry.battery
        ):
            self._telemetry = telemetry
            yield Sample("/battery", now, ros_messages.battery_state(telemetry))
        if outputs.path != self._path:
            self._path = outputs.path
            yield Sample(
                "/path", now, ros_messages.planned_path(now, outputs.path, self._flight_height)
            )
        for event in outputs.events:
            yield Sample("/events", now, ros_messages.log_message(event))


def ros_command(now: float, asked: AnySetpoint) -> Sample:
    """Return what is asked of the drone at a time [s], on the topic of its form."""
    if isinstance(asked, PositionSetpoint):
        return Sample(
            "/cmd_pose", now, ros_messages.pose_stamped(now, Pose((asked.x, asked.y, asked.z)))
        )
    return Sample("/cmd_vel", now, ros_messages.velocity_command(now, asked))


def topic_part(name: str) -> str:
    """Return a body's name as ROS 2 allows it in a topic."""
    cleaned = re.sub(r"\W", "_", name, flags=re.ASCII)
    return cleaned if re.match(r"[A-Za-z]", cleaned) else f"body_{cleaned}"
