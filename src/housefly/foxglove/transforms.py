"""Where a drone is, as tf2_msgs/TFMessage: its frame, by its name, in the frame ``world``."""

from __future__ import annotations

from typing import Any

from housefly.bus.interfaces import type_store
from housefly.foxglove.markers import WORLD
from housefly.geometry import quaternion_from_euler
from housefly.messages import Estimate, Telemetry
from housefly.record.ros_messages import nanoseconds


def drone_transform(frame: str, estimate: Estimate, telemetry: Telemetry | None) -> Any:
    """Return where a drone is: place and heading of the estimate, the tilt that the drone reports.

    Args:
        frame: of the drone.
        estimate: its time is Unix time [s].
        telemetry: None draws it level.
    """
    phi, theta = (telemetry.phi, telemetry.theta) if telemetry else (0.0, 0.0)
    w, x, y, z = quaternion_from_euler(phi, theta, estimate.yaw)
    stamp = _new("builtin_interfaces/msg/Time", *divmod(nanoseconds(estimate.at), 1_000_000_000))
    transform = _new(
        "geometry_msgs/msg/Transform",
        _new("geometry_msgs/msg/Vector3", *estimate.position),
        _new("geometry_msgs/msg/Quaternion", x, y, z, w),
    )
    header = _new("std_msgs/msg/Header", stamp, WORLD)
    stamped = _new("geometry_msgs/msg/TransformStamped", header, frame, transform)
    return _new("tf2_msgs/msg/TFMessage", [stamped])


def _new(name: str, *values: Any) -> Any:
    return type_store().types[name](*values)
