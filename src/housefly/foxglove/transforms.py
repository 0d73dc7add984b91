"""Where a drone is, as tf2_msgs/TFMessage: its frame, by its name, in the frame ``world``."""

from __future__ import annotations

from typing import Any

from housefly.geometry import quaternion_from_euler
from housefly.messages import Estimate, Telemetry
from housefly.record.ros_messages import WORLD_FRAME, transform_message


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
