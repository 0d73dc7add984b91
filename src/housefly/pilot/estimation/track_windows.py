"""Tracked way against onboard way over sliding windows, compiled.

A row is one sighting and the odometry of its time. Over each window the two displacements should be
the same; what the odometry may be off by is known, so a drone whose tracking is honest hardly ever
passes its bound: once in about a hundred hours.
"""

from __future__ import annotations

from math import atan2, nan, sqrt
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from housefly.numeric import compiled, wrapped
from housefly.pilot.estimation.onboard_odometry import OdometryAt, flow_bias_variance

DRIFT_WINDOWS = (1.0, 2.5, 5.0, 7.0, 10.0, 15.0)
"""Windows over which displacements are compared [s]."""
FRAME_WINDOWS = (0.5, 1.0, 2.0, 4.0)
"""Windows over which directions and turns are compared [s]."""
SIGMAS = 5.25
"""Displacements further apart than this many standard deviations disagree."""
AGREE_AGAIN = 0.6
"""Displacements closer than this share of the bound agree again."""
TIMING_ERROR = 0.01
"""Stamps and reports may be apart by this [s]: it counts while the velocity changes."""
DIRECTION_WAY_MIN = 0.12
"""A direction is read from no shorter way than this [m]."""
DIRECTION_SIGMAS = 12.0
"""... and from none shorter than this many standard deviations: 5 degrees."""
TURN_MIN = 0.15
"""Turns are compared from here on [rad]."""
ROW_PERIOD = 0.05
"""Time between two rows [s]."""

WINDOW_RING_SIZE = 512
"""Rows kept: 25 s; a power of two."""
TRACK_ROW = np.dtype(
    [
        (name, "f8")
        for name in ("at", "px", "py", "ox", "oy", "vx", "vy", "way", "variance", "yaw", "psi")
    ]
)
"""Time of capture [s], tracked place and odometry [m], its velocity [m/s], way [m] and variance
[m^2], tracked and onboard heading, unwrapped [rad].
"""
TrackRing = NDArray[Any]


class OdometryTolerance(NamedTuple):
    """What tracking and odometry may be off by.

    Attributes:
        position_noise: one sigma of a sighting [m].
        way_error: share of the way by which flow scale and heading may misjudge it.
    """

    position_noise: float
    way_error: float


class TrackWindows(NamedTuple):
    """What the windows say.

    Attributes:
        taken: how many rows were taken in.
        first: number of the first row that counts.
        anchored: tracked and onboard way disagree.
        anchor_x, anchor_y, anchor_at, anchor_way, anchor_variance: tracked minus onboard place
            [m] where both agreed last, its time [s], way [m] and variance [m^2].
        drift: how far the two have parted since [m]; nan before a window is full.
        frame_error: angle between the two directions or turns [rad]; nan before the first way.
        mirrored: turns go the other way round.
    """

    taken: int
    first: int
    anchored: bool
    anchor_x: float
    anchor_y: float
    anchor_at: float
    anchor_way: float
    anchor_variance: float
    drift: float
    frame_error: float
    mirrored: bool


EMPTY_WINDOWS = TrackWindows(
    taken=0,
    first=0,
    anchored=False,
    anchor_x=0.0,
    anchor_y=0.0,
    anchor_at=0.0,
    anchor_way=0.0,
    anchor_variance=0.0,
    drift=nan,
    frame_error=nan,
    mirrored=False,
)


@compiled
def displacement_bound(
    seconds: float, white: float, way: float, speed_change: float, tolerance: OdometryTolerance
) -> float:
    """Return how far tracked and onboard displacement may be apart [m].

    Args:
        seconds: between the two looks [s].
        white: variance of the odometry by white noise [m^2].
        way: flown in between [m].
        speed_change: between the two looks [m/s].
        tolerance: of tracking and odometry.
    """
    noise = tolerance.position_noise
    variance = white + flow_bias_variance(seconds) + 2.0 * noise * noise
    return SIGMAS * sqrt(variance) + tolerance.way_error * way + TIMING_ERROR * speed_change


@compiled
def windows_restarted(w: TrackWindows) -> TrackWindows:
    """Return the windows emptied; what was found stays until a window is full again."""
    return TrackWindows(
        taken=w.taken,
        first=w.taken,
        anchored=False,
        anchor_x=0.0,
        anchor_y=0.0,
        anchor_at=0.0,
        anchor_way=0.0,
        anchor_variance=0.0,
        drift=nan,
        frame_error=nan,
        mirrored=False,
    )


@compiled
def windows_advanced(
    w: TrackWindows,
    ring: TrackRing,
    at: float,
    x: float,
    y: float,
    yaw: float,
    onboard: OdometryAt,
    tolerance: OdometryTolerance,
) -> TrackWindows:
    """Return the windows after a sighting captured at a time [s], at (x, y) [m] and yaw [rad]."""
    mask = ring.size - 1
    before, row = ring[(w.taken - 1) & mask], ring[w.taken & mask]
    is_first = w.taken == w.first
    if onboard.stalled or (not is_first and at - before.at < ROW_PERIOD - 1e-6):
        return w
    row.at, row.px, row.py, row.psi = at, x, y, onboard.psi
    row.ox, row.oy, row.vx, row.vy = onboard.x, onboard.y, onboard.vx, onboard.vy
    row.way, row.variance = onboard.way, onboard.variance
    row.yaw = yaw if is_first else before.yaw + wrapped(yaw - before.yaw)
    return _compared(w, ring, tolerance)


@compiled
def _compared(w: TrackWindows, ring: TrackRing, tolerance: OdometryTolerance) -> TrackWindows:
    """Return the windows with the newest row held against those before it."""
    mask = ring.size - 1
    new, oldest = ring[w.taken & mask], max(w.first, w.taken + 1 - ring.size)
    angle, turn, mirrored, parted, since = -1.0, -1.0, False, False, w.taken
    drift_window, frame_window = 0, 0
    for index in range(w.taken - 1, oldest - 1, -1):
        row = ring[index & mask]
        age = new.at - row.at + 1e-6
        if frame_window < len(FRAME_WINDOWS) and age >= FRAME_WINDOWS[frame_window]:
            frame_window += 1
            angle = max(angle, _direction_error(new, row, tolerance.position_noise))
            turn = max(turn, _turn_error(new, row))
            mirrored = mirrored or _turns_back(new, row)
        if drift_window < len(DRIFT_WINDOWS) and age >= DRIFT_WINDOWS[drift_window]:
            drift_window += 1
            # What has parted by a short window began before it: a slow drift is seen late.
            if _parted(new, row, tolerance, AGREE_AGAIN if parted else 1.0):
                parted, since = True, index
        if drift_window == len(DRIFT_WINDOWS):
            break
    anchored, ax, ay = w.anchored, w.anchor_x, w.anchor_y
    at, way, variance = w.anchor_at, w.anchor_way, w.anchor_variance
    if anchored and not parted and _back(w, new, tolerance):
        anchored = False
    if parted and not anchored:
        row = ring[since & mask]
        anchored, ax, ay = True, row.px - row.ox, row.py - row.oy
        at, way, variance = row.at, row.way, row.variance
    drift = nan if drift_window == 0 else 0.0
    if anchored:
        drift = sqrt((new.px - new.ox - ax) ** 2 + (new.py - new.oy - ay) ** 2)
    error = max(angle, turn)
    return TrackWindows(
        taken=w.taken + 1,
        first=w.first,
        anchored=anchored,
        anchor_x=ax,
        anchor_y=ay,
        anchor_at=at,
        anchor_way=way,
        anchor_variance=variance,
        drift=drift,
        frame_error=error if error >= 0.0 else w.frame_error,
        mirrored=mirrored,
    )


@compiled
def _parted(new: Any, row: Any, tolerance: OdometryTolerance, share: float) -> bool:
    """Return whether the two displacements since a row differ by this share of their bound."""
    dx = (new.px - new.ox) - (row.px - row.ox)
    dy = (new.py - new.oy) - (row.py - row.oy)
    change = sqrt((new.vx - row.vx) ** 2 + (new.vy - row.vy) ** 2)
    bound = displacement_bound(
        new.at - row.at, new.variance - row.variance, new.way - row.way, change, tolerance
    )
    return bool(dx * dx + dy * dy > (share * bound) ** 2)


@compiled
def _back(w: TrackWindows, new: Any, tolerance: OdometryTolerance) -> bool:
    """Return whether the ways have come together again since the anchor."""
    dx, dy = new.px - new.ox - w.anchor_x, new.py - new.oy - w.anchor_y
    bound = displacement_bound(
        new.at - w.anchor_at,
        new.variance - w.anchor_variance,
        new.way - w.anchor_way,
        0.0,
        tolerance,
    )
    return bool(dx * dx + dy * dy < (AGREE_AGAIN * bound) ** 2)


@compiled
def _direction_error(new: Any, row: Any, noise: float) -> float:
    """Return the angle between the two displacements [rad], -1 when one of them is too short."""
    px, py, ox, oy = new.px - row.px, new.py - row.py, new.ox - row.ox, new.oy - row.oy
    seconds, white = new.at - row.at, new.variance - row.variance
    sigma = sqrt(white + flow_bias_variance(seconds) + 2.0 * noise * noise)
    least = max(DIRECTION_WAY_MIN, DIRECTION_SIGMAS * sigma)
    if ox * ox + oy * oy < least * least or px * px + py * py < 0.25 * least * least:
        return -1.0
    change = sqrt((new.vx - row.vx) ** 2 + (new.vy - row.vy) ** 2)
    slack = TIMING_ERROR * change / sqrt(ox * ox + oy * oy)
    return max(0.0, abs(atan2(ox * py - oy * px, ox * px + oy * py)) - slack)


@compiled
def _turn_error(new: Any, row: Any) -> float:
    """Return how far the two turns differ [rad], -1 when that is nothing to speak of."""
    error = abs((new.yaw - row.yaw) - (new.psi - row.psi))
    return error if error > TURN_MIN else -1.0


@compiled
def _turns_back(new: Any, row: Any) -> bool:
    """Return whether tracking shows the mirror image of the drone's own turn."""
    tracked, onboard = new.yaw - row.yaw, new.psi - row.psi
    return bool(abs(onboard) > TURN_MIN and abs(tracked + onboard) < 0.5 * abs(onboard))
