"""Tracked way against onboard way over sliding windows, compiled.

A row is one sighting and the odometry of its time. Over each window the two displacements should be
the same; what the odometry may be off by is known, so a drone whose tracking is honest hardly ever
passes its bound: once in about a hundred hours. Short windows expect what the flow's bias of the
last seconds makes of them, so that a drift that begins is seen early; all the others expect
nothing, so that one that was always there is seen, too.

A body or a map that is defined turned, and one that is mirrored, show the drone's ways and turns
otherwise than it felt them.
"""

from __future__ import annotations

from math import atan2, nan, sqrt
from typing import Any, NamedTuple

from housefly.numeric import compiled, wrapped
from housefly.pilot.estimation.displacement import (
    AGREE_AGAIN,
    MANOEUVRE_ROWS,
    ROW_PERIOD,
    TIMING_ERROR,
    OdometryTolerance,
    TrackRing,
    expected_bound,
    keep_bias,
    known_bias,
    learned_velocity,
    next_bias,
    parted,
    parted_from_prediction,
    predicted_bias_since,
    speed_change,
    way_parted,
)
from housefly.pilot.estimation.flow_bias import bias_updated, first_bias
from housefly.pilot.estimation.flow_model import flow_bias_variance
from housefly.pilot.estimation.onboard_odometry import OdometryAt

DRIFT_WINDOWS = (1.0, 2.5, 5.0, 7.0, 10.0, 15.0)
"""Windows over which displacements are compared [s]."""
BIAS_WINDOWS = (1.0, 1.5, 2.0, 2.5, 3.5, 5.0)
"""Windows over which a displacement is compared with what the bias before it predicts [s]."""
FRAME_WINDOWS = (0.5, 1.0, 2.0, 4.0)
"""Windows over which directions and turns are compared [s]."""
DOUBT_MIN = 1.0
"""Ways that disagree for no longer than this were at the edge of their bound [s]."""
YAW_GAP_MAX = 0.5
"""Over a longer gap of poses the drone may turn by more than half a turn [s]."""
AGE_SLACK = 1e-6
"""A row that is younger than a window by this fills it, too [s]."""
DIRECTION_WAY_MIN = 0.12
"""A direction is read from no shorter way than this [m]."""
DIRECTION_SIGMAS = 12.0
"""... and from none shorter than this many standard deviations: 5 degrees."""
TURN_MIN = 0.15
"""Turns are compared from here on [rad]."""


class TrackWindows(NamedTuple):
    """What the windows say.

    Attributes:
        taken: how many rows were taken in.
        first: number of the first row that counts.
        anchored: tracked and onboard way disagree.
        anchored_at: since when [s].
        anchor_way: way where both agreed last [m]; the bias predicts from there on.
        kept: what parted before and never came back [m]; the windows know nothing of it.
        drift: how far the two have parted in all [m]; nan before a window is full.
        frame_error: angle between the two directions or turns [rad]; nan before the first way.
        mirrored: turns go the other way round.
    """

    taken: int
    first: int
    anchored: bool
    anchored_at: float
    anchor_way: float
    kept: float
    drift: float
    frame_error: float
    mirrored: bool


EMPTY_WINDOWS = TrackWindows(
    taken=0,
    first=0,
    anchored=False,
    anchored_at=0.0,
    anchor_way=0.0,
    kept=0.0,
    drift=nan,
    frame_error=nan,
    mirrored=False,
)


@compiled
def windows_restarted(w: TrackWindows) -> TrackWindows:
    """Return the windows emptied in flight, at a hole of the odometry; what parted is kept."""
    return _emptied(w, w.drift if w.drift > w.kept else w.kept)


@compiled
def windows_cleared(w: TrackWindows) -> TrackWindows:
    """Return the windows emptied, with nothing kept: another flight."""
    return _emptied(w, 0.0)


@compiled
def _emptied(w: TrackWindows, kept: float) -> TrackWindows:
    return TrackWindows(
        taken=w.taken,
        first=w.taken,
        anchored=False,
        anchored_at=0.0,
        anchor_way=0.0,
        kept=kept,
        drift=kept if kept > 0.0 else nan,
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
    row.yaw = yaw if is_first else _unwrapped(before, at, yaw, onboard.psi)
    off_x, off_y, noise = row.px - row.ox, row.py - row.oy, tolerance.position_noise
    row.mean_vx, row.mean_vy, bias = 0.0, 0.0, first_bias(off_x, off_y, noise, tolerance.flow)
    if not is_first:
        row.mean_vx, row.mean_vy = learned_velocity(before, row)
        earlier = ring[max(w.first, w.taken - MANOEUVRE_ROWS) & mask]
        bias = next_bias(earlier, before, row, tolerance)
        if not w.anchored:
            bias = bias_updated(bias, off_x, off_y, noise)
    keep_bias(row, bias)
    return _compared(w, ring, tolerance)


@compiled
def _unwrapped(before: Any, at: float, yaw: float, psi: float) -> float:
    """Return a tracked heading without jumps [rad]; over a gap of poses turns are the drone's."""
    turned = psi - before.psi if at - before.at > YAW_GAP_MAX else 0.0
    return float(before.yaw + turned + wrapped(yaw - before.yaw - turned))


@compiled
def _compared(w: TrackWindows, ring: TrackRing, tolerance: OdometryTolerance) -> TrackWindows:
    """Return the windows with the newest row held against those before it."""
    mask = ring.size - 1
    new, oldest = ring[w.taken & mask], max(w.first, w.taken + 1 - ring.size)
    error, mirrored = _frame_compared(ring, w.taken, oldest, tolerance)
    since, learned = _parting(ring, w.taken, oldest, tolerance)
    anchored, anchored_at, anchor_way = w.anchored, w.anchored_at, w.anchor_way
    first, kept = w.first, w.kept
    if anchored and since < 0 and _back(w, new, tolerance):
        anchored = False
        if new.at - anchored_at > DOUBT_MIN:
            # Nothing older is compared with what comes now: what did not come back is kept.
            first, kept = w.taken, kept + way_parted(known_bias(new), new)
    if since >= 0 and not anchored:
        row = ring[since & mask]
        anchored, anchored_at, anchor_way = True, new.at, row.way
        keep_bias(new, predicted_bias_since(row, new, learned, tolerance))
    is_full = new.at - ring[oldest & mask].at + AGE_SLACK >= DRIFT_WINDOWS[0]
    drift = kept if is_full or kept > 0.0 else nan
    if anchored:
        drift = kept + way_parted(known_bias(new), new)
    return TrackWindows(
        taken=w.taken + 1,
        first=first,
        anchored=anchored,
        anchored_at=anchored_at,
        anchor_way=anchor_way,
        kept=kept,
        drift=drift,
        frame_error=error if error >= 0.0 else w.frame_error,
        mirrored=mirrored,
    )


@compiled
def _frame_compared(
    ring: TrackRing, newest: int, oldest: int, tolerance: OdometryTolerance
) -> tuple[float, bool]:
    """Return the greatest angle of all windows [rad], -1 for none, and whether turns go back."""
    mask = ring.size - 1
    new, error, mirrored, window = ring[newest & mask], -1.0, False, 0
    for index in range(newest - 1, oldest - 1, -1):
        row = ring[index & mask]
        if new.at - row.at + AGE_SLACK >= FRAME_WINDOWS[window]:
            window += 1
            angle = _direction_error(new, row, tolerance)
            error = max(error, angle, _turn_error(new, row))
            mirrored = mirrored or _turns_back(new, row)
            if window == len(FRAME_WINDOWS):
                break
    return error, mirrored


@compiled
def _parting(
    ring: TrackRing, newest: int, oldest: int, tolerance: OdometryTolerance
) -> tuple[int, bool]:
    """Return the oldest row since which the ways have parted, -1 for none.

    The second value is whether it was seen by what the bias of that row predicts.
    """
    mask = ring.size - 1
    new, since, learned, window, bias_window = ring[newest & mask], -1, False, 0, 0
    for index in range(newest - 1, oldest - 1, -1):
        row = ring[index & mask]
        age = new.at - row.at + AGE_SLACK
        if bias_window < len(BIAS_WINDOWS) and age >= BIAS_WINDOWS[bias_window]:
            bias_window += 1
            if parted_from_prediction(new, row, tolerance):
                since, learned = index, True
        if age >= DRIFT_WINDOWS[window]:
            window += 1
            # What has parted by a short window began before it: a slow drift is seen late.
            if parted(new, row, tolerance, AGREE_AGAIN if since >= 0 else 1.0):
                since, learned = index, False
            if window == len(DRIFT_WINDOWS):
                break
    return since, learned


@compiled
def _back(w: TrackWindows, new: Any, tolerance: OdometryTolerance) -> bool:
    """Return whether the ways have come together again since the anchor."""
    known = known_bias(new)
    bound = expected_bound(known, new.way - w.anchor_way, tolerance)
    return way_parted(known, new) < AGREE_AGAIN * bound


@compiled
def _direction_error(new: Any, row: Any, tolerance: OdometryTolerance) -> float:
    """Return the angle between the two displacements [rad], -1 when one of them is too short."""
    px, py, ox, oy = new.px - row.px, new.py - row.py, new.ox - row.ox, new.oy - row.oy
    seconds, white = new.at - row.at, new.variance - row.variance
    noise = tolerance.position_noise
    sigma = sqrt(white + flow_bias_variance(tolerance.flow, seconds) + 2.0 * noise * noise)
    least = max(DIRECTION_WAY_MIN, DIRECTION_SIGMAS * sigma)
    if ox * ox + oy * oy < least * least or px * px + py * py < 0.25 * least * least:
        return -1.0
    slack = TIMING_ERROR * speed_change(new, row) / sqrt(ox * ox + oy * oy)
    return max(0.0, abs(atan2(ox * py - oy * px, ox * px + oy * py)) - slack)


@compiled
def _turn_error(new: Any, row: Any) -> float:
    """Return how far the two turns differ [rad], -1 when that is nothing to speak of."""
    error = abs(wrapped((new.yaw - row.yaw) - (new.psi - row.psi)))
    return error if error > TURN_MIN else -1.0


@compiled
def _turns_back(new: Any, row: Any) -> bool:
    """Return whether tracking shows the mirror image of the drone's own turn."""
    tracked, onboard = new.yaw - row.yaw, new.psi - row.psi
    return bool(abs(onboard) > TURN_MIN and abs(tracked + onboard) < 0.5 * abs(onboard))
