"""A scan as perception works with it: distances in an array, and what the room lets expect."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, sin

import numpy as np

from housefly.config.laser import LaserConfig
from housefly.messages import Scan
from housefly.numeric import FloatArray, elementwise
from housefly.perception.background import expected_ranges
from housefly.perception.clusters import foreground_limit
from housefly.room.model import Room

MAX_BEAMS = 10_000
"""Most beams of a scan."""


@dataclass(frozen=True, slots=True, eq=False)
class BeamScan:
    """A ``messages.Scan`` whose distances are an array.

    Attributes:
        source: name of the scanner.
        captured_at: when it measured [s, our monotonic clock].
        first_angle: of the first beam [rad], counter-clockwise from the scanner's front.
        step: from beam to beam [rad].
        ranges: distances [m], infinite where nothing came back, shape (n,).
    """

    source: str
    captured_at: float
    first_angle: float
    step: float
    ranges: FloatArray


def beam_scan_of(scan: Scan) -> BeamScan:
    """Return a scan with its distances in an array; of too many beams one too many is kept."""
    ranges = np.array(scan.ranges[: MAX_BEAMS + 1], np.float64)
    return BeamScan(scan.source, scan.captured_at, scan.first_angle, scan.step, ranges)


@dataclass(frozen=True, slots=True, eq=False)
class BeamBackground:
    """What a scanner's beams meet in the modelled room.

    Attributes:
        limit: a beam that ends before this hits something new [m], shape (n,).
        cosines, sines: of the beams' directions in the world, shape (n,).
    """

    limit: FloatArray
    cosines: FloatArray
    sines: FloatArray


def background_of(room: Room, laser: LaserConfig, scan: BeamScan) -> BeamBackground:
    """Return the background of a scan in a room."""
    beams = len(scan.ranges)
    expected = expected_ranges(room.solids, laser, scan.first_angle, scan.step, beams)
    angles = laser.yaw + scan.first_angle + np.arange(beams, dtype=np.float64) * scan.step
    return BeamBackground(
        foreground_limit(expected), elementwise(cos, angles), elementwise(sin, angles)
    )
