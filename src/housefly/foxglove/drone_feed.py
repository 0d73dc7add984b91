"""What one drone's pilot says, as channels of the live view."""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot
from typing import Any

from housefly.bus.bus import Bus, Subscription
from housefly.bus.interfaces import type_store
from housefly.bus.topics import DroneTopics
from housefly.foxglove.channels import drone_topic
from housefly.foxglove.demand import Feed
from housefly.foxglove.json_values import DroneNumbers, LinkNumbers, to_json
from housefly.foxglove.live_server import LiveServer
from housefly.foxglove.markers import drone_markers
from housefly.foxglove.unix_time import in_unix_time
from housefly.geometry import quaternion_from_euler
from housefly.hub.wall_clock import WallClock
from housefly.messages import (
    Estimate,
    LinkStatus,
    PilotStep,
    PlannedTrajectory,
    Pose,
    Telemetry,
)
from housefly.record import ros_messages
from housefly.record.ros_messages import WORLD_FRAME, transform_message
from housefly.record.ros_topics import StepTopics, topic_part
from housefly.sites.loaded_site import LoadedSite

_NUMBERS_PERIOD = 0.05
"""Plots get a point this often [s]; a step comes five times as often."""
_STEP_NAMES = ("odom", "path", "cmd_vel", "cmd_pose", "battery", "events", "state")
_RECORDED_FRAME = "drone"
"""The drone's frame in a recording, which is of one drone."""


class DroneFeed:
    """The channels of one drone.

    Args:
        bus: where its pilot is.
        server: where the channels are.
        site: room and map as this drone has them.
        wall: Unix time of the monotonic clock.
    """

    def __init__(self, bus: Bus, server: LiveServer, site: LoadedSite, wall: WallClock) -> None:
        self._bus, self._server, self._site, self._wall = bus, server, site, wall
        self._drone = site.site.drone
        self._bus_topics = DroneTopics(self._drone.name)
        self.frame = topic_part(self._drone.name)

    @property
    def feeds(self) -> tuple[Feed, ...]:
        """What fills the channels, each part only while it is watched."""
        steps = ("/tf", *map(self._topic, _STEP_NAMES))
        return (
            Feed(steps, self._hear_steps),
            Feed((self._topic("trajectory"),), self._hear_trajectory),
            Feed((self._topic("link"),), self._hear_link),
            Feed((self._topic("map"),), self._draw_map),
            Feed((self._topic("body"),), self._draw_body),
        )

    def _topic(self, name: str) -> str:
        return drone_topic(self._drone.name, name)

    def _hear_steps(self) -> Sequence[Subscription]:
        # A fresh one tells path and battery again.
        topics, last = StepTopics(self._site.site.map.flight_height), [float("-inf")]

        def heard(step: PilotStep) -> None:
            moved = in_unix_time(step, self._wall.offset())
            estimate, telemetry = moved.outputs.estimate, moved.inputs.telemetry
            if estimate is not None and self._server.is_wanted("/tf"):
                transform = drone_transform(self.frame, estimate, telemetry)
                self._server.send("/tf", estimate.at, transform)
            for sample in topics.of(moved):
                message = _in_frame(sample.message, self.frame)
                self._server.send(self._topic(sample.topic[1:]), sample.at, message)
            numbers = self._topic("state")
            if moved.now - last[0] >= _NUMBERS_PERIOD and self._server.is_wanted(numbers):
                last[0] = moved.now
                self._server.send_bytes(numbers, moved.now, to_json(drone_numbers(moved)))

        return (self._bus.subscribe(self._bus_topics.step, heard),)

    def _hear_trajectory(self) -> Sequence[Subscription]:
        def heard(planned: PlannedTrajectory) -> None:
            at = planned.at + self._wall.offset()
            self._server.send(self._topic("trajectory"), at, path_in_space(at, planned))

        return (self._bus.subscribe(self._bus_topics.trajectory, heard),)

    def _hear_link(self) -> Sequence[Subscription]:
        def heard(status: LinkStatus) -> None:
            at = status.at + self._wall.offset()
            self._server.send_bytes(self._topic("link"), at, to_json(link_numbers(at, status)))

        return (self._bus.subscribe(self._bus_topics.link, heard),)

    def _draw_map(self) -> Sequence[Subscription]:
        at = self._wall.now()
        self._server.send(self._topic("map"), at, ros_messages.occupancy(at, self._site.grid))
        return ()

    def _draw_body(self) -> Sequence[Subscription]:
        at = self._wall.now()
        self._server.send(self._topic("body"), at, drone_markers(at, self._drone, self.frame))
        return ()


def drone_numbers(step: PilotStep) -> DroneNumbers:
    """Return a step as numbers and names for plots."""
    outputs, telemetry = step.outputs, step.inputs.telemetry
    estimate, reference = outputs.estimate, outputs.reference
    x, y, z = estimate.position if estimate else (None, None, None)
    wanted_x, wanted_y, wanted_z = reference.position if reference else (None, None, None)
    return DroneNumbers(
        at=step.now,
        phase=outputs.phase.value,
        behavior=outputs.behavior.value,
        safety=outputs.safety.value,
        goal=outputs.goal_name,
        reason=str(outputs.reason),
        late=step.inputs.late,
        status=telemetry.status.value if telemetry else None,
        battery=telemetry.battery if telemetry else None,
        x=x,
        y=y,
        z=z,
        yaw=estimate.yaw if estimate else None,
        speed=hypot(*estimate.velocity[:2]) if estimate else None,
        vertical_speed=estimate.velocity[2] if estimate else None,
        wanted_x=wanted_x,
        wanted_y=wanted_y,
        wanted_z=wanted_z,
        wanted_yaw=reference.yaw if reference else None,
        position_std=estimate.position_std if estimate else None,
        pose_age=estimate.pose_age if estimate else None,
        telemetry_age=step.now - telemetry.received_at if telemetry else None,
    )


def link_numbers(at: float, status: LinkStatus) -> LinkNumbers:
    """Return the health of a pilot's wires and loop at a Unix time [s]."""
    return LinkNumbers(
        at,
        status.tracking_connected,
        status.drone_connected,
        status.video_connected,
        status.tracking_rate_hz,
        status.telemetry_rate_hz,
        status.video_rate_hz,
        status.loop_p50_s,
        status.loop_p99_s,
        status.loop_max_s,
        status.missed_ticks,
        status.tracking_latency_s,
        status.command_delay_s,
        status.nis,
        status.push,
        status.load,
        tuple(map(str, status.notes)),
    )


def path_in_space(at: float, planned: PlannedTrajectory) -> Any:
    """Return nav_msgs/Path of a trajectory that is planned in space."""
    new = type_store().types
    poses = [ros_messages.pose_stamped(at, Pose(point.position)) for point in planned.points]
    header = ros_messages.pose_stamped(at, Pose((0.0, 0.0, 0.0))).header
    return new["nav_msgs/msg/Path"](header, poses)


def _in_frame(message: Any, frame: str) -> Any:
    """Return a message with the frame of this drone where a recording has that of its only one."""
    if getattr(message, "child_frame_id", "") == _RECORDED_FRAME:
        message.child_frame_id = frame
    header = getattr(message, "header", None)
    if header is not None and header.frame_id == _RECORDED_FRAME:
        header.frame_id = frame
    return message


def drone_transform(frame: str, estimate: Estimate, telemetry: Telemetry | None) -> Any:
    """Return where a drone is: place and heading of the estimate, the tilt that the drone reports.

    Args:
        frame: of the drone.
        estimate: its time is Unix time [s].
        telemetry: None draws it level.
    """
    phi, theta = (telemetry.phi, telemetry.theta) if telemetry else (0.0, 0.0)
    turn = quaternion_from_euler(phi, theta, estimate.yaw)
    return transform_message(estimate.at, WORLD_FRAME, frame, estimate.position, turn)
