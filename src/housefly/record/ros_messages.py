"""Standard ROS 2 messages made of ours, for the tools that know only those.

A recording's stamps are the monotonic clock, its frames ``world`` and ``drone``; a live node says
Unix time and its own frames.
"""

from __future__ import annotations

from math import cos, nan, sin
from typing import Any

import numpy as np

from housefly.bus.interfaces import type_store
from housefly.geometry import IDENTITY, Quaternion, Vec3, rotate
from housefly.messages import (
    DroneStatus,
    Estimate,
    Event,
    Path,
    Pose,
    Setpoint,
    Severity,
    Telemetry,
    VelocitySetpoint,
    VideoFrame,
)
from housefly.room.grid import Cell, OccupancyGrid

WORLD_FRAME, DRONE_FRAME = "world", "drone"

_LOG_LEVEL = {Severity.INFO: 20, Severity.WARNING: 30, Severity.FAULT: 40}
_MAP_VALUE = {
    Cell.FREE: 0,
    Cell.OCCUPIED: 100,
    Cell.VIRTUAL: 90,
    Cell.INFLATED: 50,
    Cell.OUTSIDE: -1,
}
_NO_COVARIANCE = np.zeros(36)
_POWER_DISCHARGING, _TECHNOLOGY_LITHIUM_POLYMER = 2, 3


def nanoseconds(seconds: float) -> int:
    """Return a time as whole nanoseconds; times before zero do not exist in ROS and become zero."""
    return max(0, round(seconds * 1e9))


def pose_stamped(at: float, pose: Pose, frame: str = WORLD_FRAME) -> Any:
    """Return geometry_msgs/PoseStamped of a body in the world."""
    return message(
        "geometry_msgs/msg/PoseStamped",
        header(at, frame),
        pose_message(pose.position, pose.orientation),
    )


def odometry(estimate: Estimate, frame: str = WORLD_FRAME, child: str = DRONE_FRAME) -> Any:
    """Return nav_msgs/Odometry of the estimate, with the variances of x and y.

    The pose is in the world, the velocity in the drone's frame.
    """
    turn = about_z(estimate.yaw)
    covariance = np.zeros(36)
    covariance[[0, 7]] = estimate.position_std**2
    pose = message(
        "geometry_msgs/msg/PoseWithCovariance", pose_message(estimate.position, turn), covariance
    )
    back = (turn[0], 0.0, 0.0, -turn[3])
    twist = message(
        "geometry_msgs/msg/TwistWithCovariance",
        _twist(rotate(back, estimate.velocity), (0.0, 0.0, 0.0)),
        _NO_COVARIANCE,
    )
    return message("nav_msgs/msg/Odometry", header(estimate.at, frame), child, pose, twist)


def velocity_command(at: float, setpoint: Setpoint | VelocitySetpoint) -> Any:
    """Return geometry_msgs/TwistStamped of a setpoint.

    Where the drone takes angles, not speeds, linear.x is theta [rad] (positive forward), linear.y
    is -phi [rad] (positive left); linear.z is the climb rate [m/s], angular.z the yaw rate [rad/s].
    """
    if isinstance(setpoint, VelocitySetpoint):
        ahead, left = setpoint.forward, setpoint.left
    else:
        ahead, left = setpoint.theta, -setpoint.phi
    twist = _twist((ahead, left, setpoint.vz), (0.0, 0.0, setpoint.yaw_rate))
    return message("geometry_msgs/msg/TwistStamped", header(at, DRONE_FRAME), twist)


def battery_state(telemetry: Telemetry, frame: str = DRONE_FRAME) -> Any:
    """Return sensor_msgs/BatteryState; unknown values are nan."""
    known = telemetry.status is not DroneStatus.UNKNOWN
    electrical = [nan] * 6
    return message(
        "sensor_msgs/msg/BatteryState",
        header(telemetry.received_at, frame),
        *electrical,
        telemetry.battery if known else nan,
        _POWER_DISCHARGING,
        0,
        _TECHNOLOGY_LITHIUM_POLYMER,
        True,
        np.array([], dtype=np.float32),
        np.array([], dtype=np.float32),
        "",
        "",
    )


def planned_path(at: float, path: Path | None, height: float, frame: str = WORLD_FRAME) -> Any:
    """Return nav_msgs/Path at the flight height [m]; empty when there is no path."""
    waypoints = path.waypoints if path else ()
    stamped = [
        message(
            "geometry_msgs/msg/PoseStamped",
            header(at, frame),
            pose_message((x, y, height)),
        )
        for x, y in waypoints
    ]
    return message("nav_msgs/msg/Path", header(at, frame), stamped)


def occupancy(at: float, grid: OccupancyGrid, frame: str = WORLD_FRAME) -> Any:
    """Return nav_msgs/OccupancyGrid: 0 free, 50 inflated, 90 virtual, 100 occupied, -1 outside."""
    width, height = grid.cells.shape
    info = message(
        "nav_msgs/msg/MapMetaData",
        time_message(at),
        grid.resolution,
        width,
        height,
        pose_message((*grid.origin, 0.0)),
    )
    values = np.zeros(256, dtype=np.int8)
    for cell, value in _MAP_VALUE.items():
        values[cell] = value
    return message(
        "nav_msgs/msg/OccupancyGrid",
        header(at, frame),
        info,
        values[grid.cells.T].reshape(-1),
    )


def log_message(event: Event) -> Any:
    """Return rcl_interfaces/Log of an event."""
    return message(
        "rcl_interfaces/msg/Log",
        time_message(event.at),
        _LOG_LEVEL[event.severity],
        event.code,
        event.text,
        "",
        "",
        0,
    )


def compressed_video(frame: VideoFrame) -> Any:
    """Return foxglove_msgs/CompressedVideo of one H.264 access unit."""
    data = np.frombuffer(frame.data, dtype=np.uint8)
    return message(
        "foxglove_msgs/msg/CompressedVideo", time_message(frame.received_at), "camera", data, "h264"
    )


def message(name: str, *values: Any) -> Any:
    """Return a message of a ROS 2 type with all its fields, in order."""
    return type_store().types[name](*values)


def time_message(at: float) -> Any:
    """Return builtin_interfaces/Time."""
    return message("builtin_interfaces/msg/Time", *divmod(nanoseconds(at), 1_000_000_000))


def header(at: float, frame: str) -> Any:
    """Return std_msgs/Header."""
    return message("std_msgs/msg/Header", time_message(at), frame)


def pose_message(position: Vec3, orientation: Quaternion = IDENTITY) -> Any:
    """Return geometry_msgs/Pose."""
    w, x, y, z = orientation
    return message(
        "geometry_msgs/msg/Pose",
        message("geometry_msgs/msg/Point", *position),
        message("geometry_msgs/msg/Quaternion", x, y, z, w),
    )


def _twist(linear: Vec3, angular: Vec3) -> Any:
    return message(
        "geometry_msgs/msg/Twist",
        message("geometry_msgs/msg/Vector3", *linear),
        message("geometry_msgs/msg/Vector3", *angular),
    )


def about_z(yaw: float) -> Quaternion:
    """Return the turn by a heading [rad]."""
    return cos(yaw / 2), 0.0, 0.0, sin(yaw / 2)


def transform_message(
    at: float, parent: str, child: str, position: Vec3, orientation: Quaternion = IDENTITY
) -> Any:
    """Return tf2_msgs/TFMessage: a frame in another."""
    moved = transform(position, orientation)
    stamped = message("geometry_msgs/msg/TransformStamped", header(at, parent), child, moved)
    return message("tf2_msgs/msg/TFMessage", [stamped])


def transform(position: Vec3, orientation: Quaternion = IDENTITY) -> Any:
    """Return geometry_msgs/Transform."""
    w, x, y, z = orientation
    return message(
        "geometry_msgs/msg/Transform",
        message("geometry_msgs/msg/Vector3", *position),
        message("geometry_msgs/msg/Quaternion", x, y, z, w),
    )
