"""Scans as a ROS node tells them: sensor_msgs/LaserScan, as CDR."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np

from housefly.bus.interfaces import type_store
from housefly.record.ros_messages import header, message
from housefly.sensors.ros2_scan import LASER_SCAN

BEAMS = 5
STEP = pi / 8


def scan_cdr(at: float = 1.7e9, ranges: Any = (2.0,) * BEAMS, **changes: Any) -> bytes:
    """Return a scan of a quarter turn or so, as bytes.

    Args:
        at: Unix time of its stamp [s].
        ranges: distances [m].
        changes: other fields.
    """
    beams = np.asarray(ranges, np.float32)
    told = {
        "header": header(at, "laser"),
        "angle_min": -2 * STEP,
        "angle_max": -2 * STEP + STEP * (len(beams) - 1),
        "angle_increment": STEP,
        "time_increment": 0.0,
        "scan_time": 0.025,
        "range_min": 0.1,
        "range_max": 30.0,
        "ranges": beams,
        "intensities": np.zeros(0, np.float32),
    }
    return bytes(
        type_store().serialize_cdr(message(LASER_SCAN, *(told | changes).values()), LASER_SCAN)
    )
