"""Hours of honest and drifting tracking beside a noisy onboard report, without a world."""

from __future__ import annotations

import numpy as np
from ardrone_flow import FLOW
from numba import njit

from housefly.pilot.estimation.displacement import (
    TRACK_ROW,
    WINDOW_RING_SIZE,
    OdometryTolerance,
    TrackRing,
)
from housefly.pilot.estimation.onboard_odometry import (
    MOTION_RING_SIZE,
    ONBOARD_MOTION,
    MotionRing,
    OnboardReport,
    odometry_advanced,
    odometry_at,
    odometry_begun,
    odometry_headed,
)
from housefly.pilot.estimation.track_windows import EMPTY_WINDOWS, windows_advanced

TICK = 0.01
LONG_LEG = 8.0
"""The drone goes to and fro, as long each way [s]."""


_BEGUN = odometry_begun(FLOW)


@njit
def _flown(
    seed: int,
    seconds: float,
    speed: float,
    period: float,
    loss: float,
    drift: float,
    flow_scale: float,
    motion: MotionRing,
    rows: TrackRing,
) -> tuple[float, float, float]:
    np.random.seed(seed)
    odometry, windows = _BEGUN, EMPTY_WINDOWS
    bias_x, bias_y, x, next_at = 0.0, 0.0, 0.0, 0.0
    worst, told, landed = 0.0, np.inf, np.inf
    keep = np.exp(-TICK / FLOW.bias_time)
    drive = FLOW.bias * np.sqrt(1.0 - keep * keep)
    past = np.zeros(4)
    tolerance = OdometryTolerance(0.002, max(0.001, abs(flow_scale - 1.0)), FLOW)
    for tick in range(1, int(seconds / TICK)):
        at = tick * TICK
        wanted = speed if at % (2.0 * LONG_LEG) < LONG_LEG else -speed
        v = past[-1] + min(max(wanted - past[-1], -0.01), 0.01)
        x += TICK * 0.5 * (v + past[-1])
        bias_x = keep * bias_x + drive * np.random.normal()
        bias_y = keep * bias_y + drive * np.random.normal()
        noise_x, noise_y = FLOW.noise * np.random.normal(), FLOW.noise * np.random.normal()
        report = OnboardReport(
            at=at,
            theta=0.0,
            phi=0.0,
            psi=0.0,
            forward=flow_scale * past[0] + bias_x + noise_x,
            left=bias_y + noise_y,
            height=1.0,
            vz=0.0,
            airborne=True,
            drone_time=np.nan,
        )
        past[:-1] = past[1:]
        past[-1] = v
        odometry = odometry_advanced(odometry, motion, report)
        if at < next_at:
            continue
        next_at += period
        if np.random.random() < loss:
            continue
        lied = drift * max(at - 10.0, 0.0)
        seen_x = x + 0.001 * np.random.normal()
        seen_y = lied + 0.001 * np.random.normal()
        odometry = odometry_headed(odometry, motion, at, 0.003 * np.random.normal())
        if odometry.since > at:
            continue
        onboard = odometry_at(odometry, motion, at)
        windows = windows_advanced(windows, rows, at, seen_x, seen_y, 0.0, onboard, tolerance)
        if windows.drift == windows.drift:
            worst = max(worst, windows.drift)
        if windows.drift > 0.05 and lied > 0.0:
            told = min(told, lied)
        if windows.drift > 0.15 and lied > 0.0:
            landed = min(landed, lied)
    return worst, told, landed


def flown(
    seed: int,
    seconds: float,
    speed: float = 0.5,
    period: float = 0.01,
    loss: float = 0.0,
    drift: float = 0.0,
    flow_scale: float = 1.0,
) -> tuple[float, float, float]:
    """Return the largest drift told, and how far a drift had come when it was told, and landed.

    Args:
        seed: of all noise.
        seconds: flown [s].
        speed: to and fro [m/s].
        period: between two poses [s].
        loss: share of poses lost.
        drift: of tracking across the way, after 10 s [m/s].
        flow_scale: of the flow's velocity; its error is known and tolerated.
    """
    motion, rows = np.zeros(MOTION_RING_SIZE, ONBOARD_MOTION), np.zeros(WINDOW_RING_SIZE, TRACK_ROW)
    return _flown(seed, seconds, speed, period, loss, drift, flow_scale, motion, rows)
