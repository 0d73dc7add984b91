"""Reads sensor_msgs/LaserScan from CDR: what it means, and what is none. Pure."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, isfinite, pi
from typing import Any

import numpy as np

from housefly.bus.interfaces import type_store
from housefly.errors import WireError
from housefly.numeric import FloatArray

LASER_SCAN = "sensor_msgs/msg/LaserScan"
"""The type."""
SCAN_BYTES_MAX = 256 * 1024
"""Larger messages are no scan [bytes]."""
SCAN_BEAMS_MAX = 10_000
_RANGE_LIMIT = 1000.0
"""A scanner that says it sees farther than this does not count in metres [m]."""
_TOO_NEAR = 0.05
"""What is nearer than a scanner can measure counts as here [m]: before its window."""
_TURN = 1.01 * 2.0 * pi
"""Angles may be rounded [rad]."""
_ANGLES_SLACK = 1.5
"""Drivers disagree by a beam about whether ``angle_max`` is the last one or the one after it."""


@dataclass(frozen=True, slots=True, eq=False)
class LaserScanMessage:
    """One scan as a ROS node tells it, its beams counter-clockwise.

    Attributes:
        stamp: of capture, by the sender's clock [ns]; 0 for none.
        first_angle: of the first beam [rad], counter-clockwise from the scanner's front.
        step: from beam to beam [rad].
        ranges: distances [m]; infinite where nothing came back, or nothing that counts.
    """

    stamp: int
    first_angle: float
    step: float
    ranges: FloatArray


def laser_scan_message(data: bytes) -> LaserScanMessage:
    """Read a scan.

    As REP-117 has it: +inf is no return, NaN no measurement, -inf something too near to be
    measured. Distances outside ``range_min`` to ``range_max`` do not count.

    Raises:
        WireError: it is no scan; says which field, its value and what is allowed.
    """
    if len(data) > SCAN_BYTES_MAX:
        raise WireError(f"a scan of {len(data)} bytes; allowed: {SCAN_BYTES_MAX}")
    try:
        told: Any = type_store().deserialize_cdr(data, LASER_SCAN)
    except Exception as error:  # whatever the reader raises on foreign bytes
        raise WireError(f"no {LASER_SCAN}: {type(error).__name__}") from error
    stamp, angles, ranges = _stamp(told.header.stamp), _angles(told), _ranges(told)
    first, step = angles
    if step < 0.0:
        first, step, ranges = first + step * (len(ranges) - 1), -step, ranges[::-1].copy()
    return LaserScanMessage(stamp, first, step, ranges)


def _stamp(told: Any) -> int:
    seconds, nanoseconds = int(told.sec), int(told.nanosec)
    if seconds < 0 or nanoseconds >= 1_000_000_000:
        raise WireError(
            f"its stamp is {seconds} s and {nanoseconds} ns; allowed: 0 s or more, below 1e9 ns"
        )
    return 1_000_000_000 * seconds + nanoseconds


def _angles(told: Any) -> tuple[float, float]:
    """Return the angle of the first beam and the step to the next, checked with their number."""
    first, last, step = float(told.angle_min), float(told.angle_max), float(told.angle_increment)
    beams = len(told.ranges)
    if not 2 <= beams <= SCAN_BEAMS_MAX:
        raise WireError(f"{beams} ranges; allowed: 2 to {SCAN_BEAMS_MAX}")
    if not all(map(isfinite, (first, last, step))) or step == 0.0:
        raise WireError(
            f"angle_min {first:g}, angle_max {last:g}, angle_increment {step:g} rad; allowed:"
            " finite, and a step that is not 0"
        )
    if abs(first) > _TURN or abs(step) * (beams - 1) > _TURN:
        raise WireError(
            f"{beams} beams of {step:g} rad from {first:g} rad; allowed: one turn (are these"
            " degrees?)"
        )
    told_beams = (last - first) / step + 1.0
    if abs(told_beams - beams) > _ANGLES_SLACK:
        raise WireError(
            f"{beams} ranges, where angle_min {first:g}, angle_max {last:g} and angle_increment"
            f" {step:g} rad make {told_beams:.0f}; allowed: one more or less"
        )
    return first, step


def _ranges(told: Any) -> FloatArray:
    nearest, farthest = float(told.range_min), float(told.range_max)
    if not 0.0 <= nearest < farthest or (isfinite(farthest) and farthest > _RANGE_LIMIT):
        raise WireError(
            f"range_min {nearest:g}, range_max {farthest:g} m; allowed: 0 or more, and above it to"
            f" {_RANGE_LIMIT:g} m (are these millimetres?)"
        )
    ranges = np.asarray(told.ranges, np.float64)
    is_distance = (ranges >= nearest) & (ranges <= farthest) & np.isfinite(ranges)
    kept = np.where(is_distance, ranges, inf)
    kept[np.isneginf(ranges)] = _TOO_NEAR
    if not np.isfinite(kept).any():
        raise WireError(
            "no beam has a distance between range_min and range_max: is it covered, or are the"
            " limits wrong?"
        )
    return kept
