"""Standard ROS 2 messages made of ours, for the tools that know only those.

Stamps are the monotonic clock; positions are in the frame ``world``, velocities of the drone in the
frame ``drone``.
"""

from __future__ import annotations

from math import cos, nan, sin
from typing import Any

import numpy as np

from housefly.bus.interfaces import type_store
from housefly.geometry import Quaternion, Vec3, rotate
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

_WORLD_FRAME, _DRONE_FRAME = "world", "drone"

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


def pose_stamped(at: float, pose: Pose) -> Any:
    """Return geometry_msgs/PoseStamped of a body in the world."""
    return _new(
        "geometry_msgs/msg/PoseStamped",
        _header(at, _WORLD_FRAME),
        _pose(pose.position, pose.orientation),
    )


def odometry(estimate: Estimate) -> Any:
    """Return nav_msgs/Odometry of the estimate, with the variances of x and y.

    The pose is in the world, the velocity in the drone's frame.
    """
    turn = _about_z(estimate.yaw)
    covariance = np.zeros(36)
    covariance[[0, 7]] = estimate.position_std**2
    pose = _new("geometry_msgs/msg/PoseWithCovariance", _pose(estimate.position, turn), covariance)
    back = (turn[0], 0.0, 0.0, -turn[3])
    twist = _new(
        "geometry_msgs/msg/TwistWithCovariance",
        _twist(rotate(back, estimate.velocity), (0.0, 0.0, 0.0)),
        _NO_COVARIANCE,
    )
    return _new(
        "nav_msgs/msg/Odometry", _header(estimate.at, _WORLD_FRAME), _DRONE_FRAME, pose, twist
    )


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
    return _new("geometry_msgs/msg/TwistStamped", _header(at, _DRONE_FRAME), twist)


def battery_state(telemetry: Telemetry) -> Any:
    """Return sensor_msgs/BatteryState; unknown values are nan."""
    known = telemetry.status is not DroneStatus.UNKNOWN
    electrical = [nan] * 6
    return _new(
        "sensor_msgs/msg/BatteryState",
        _header(telemetry.received_at, _DRONE_FRAME),
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


def planned_path(at: float, path: Path | None, height: float) -> Any:
    """Return nav_msgs/Path at the flight height [m]; empty when there is no path."""
    waypoints = path.waypoints if path else ()
    stamped = [
        _new(
            "geometry_msgs/msg/PoseStamped",
            _header(at, _WORLD_FRAME),
            _pose((x, y, height), _about_z(0.0)),
        )
        for x, y in waypoints
    ]
    return _new("nav_msgs/msg/Path", _header(at, _WORLD_FRAME), stamped)


def occupancy(at: float, grid: OccupancyGrid) -> Any:
    """Return nav_msgs/OccupancyGrid: 0 free, 50 inflated, 90 virtual, 100 occupied, -1 outside."""
    width, height = grid.cells.shape
    info = _new(
        "nav_msgs/msg/MapMetaData",
        _time(at),
        grid.resolution,
        width,
        height,
        _pose((*grid.origin, 0.0), _about_z(0.0)),
    )
    values = np.zeros(256, dtype=np.int8)
    for cell, value in _MAP_VALUE.items():
        values[cell] = value
    return _new(
        "nav_msgs/msg/OccupancyGrid",
        _header(at, _WORLD_FRAME),
        info,
        values[grid.cells.T].reshape(-1),
    )


def log_message(event: Event) -> Any:
    """Return rcl_interfaces/Log of an event."""
    return _new(
        "rcl_interfaces/msg/Log",
        _time(event.at),
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
    return _new(
        "foxglove_msgs/msg/CompressedVideo", _time(frame.received_at), "camera", data, "h264"
    )


def _new(name: str, *values: Any) -> Any:
    return type_store().types[name](*values)


def _time(at: float) -> Any:
    return _new("builtin_interfaces/msg/Time", *divmod(nanoseconds(at), 1_000_000_000))


def _header(at: float, frame: str) -> Any:
    return _new("std_msgs/msg/Header", _time(at), frame)


def _pose(position: Vec3, orientation: Quaternion) -> Any:
    w, x, y, z = orientation
    return _new(
        "geometry_msgs/msg/Pose",
        _new("geometry_msgs/msg/Point", *position),
        _new("geometry_msgs/msg/Quaternion", x, y, z, w),
    )


def _twist(linear: Vec3, angular: Vec3) -> Any:
    return _new(
        "geometry_msgs/msg/Twist",
        _new("geometry_msgs/msg/Vector3", *linear),
        _new("geometry_msgs/msg/Vector3", *angular),
    )


def _about_z(yaw: float) -> Quaternion:
    return cos(yaw / 2), 0.0, 0.0, sin(yaw / 2)
