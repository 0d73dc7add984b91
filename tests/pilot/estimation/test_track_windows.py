from __future__ import annotations

from math import cos, isnan, pi, radians, sin

import numpy as np
import pytest
from ardrone_flow import FLOW
from hypothesis import given, settings
from hypothesis import strategies as st
from onboard_noise import flown

from housefly.pilot.estimation.displacement import (
    ROW_PERIOD,
    TRACK_ROW,
    WINDOW_RING_SIZE,
    OdometryTolerance,
)
from housefly.pilot.estimation.onboard_odometry import OdometryAt
from housefly.pilot.estimation.track_windows import (
    EMPTY_WINDOWS,
    TrackWindows,
    windows_advanced,
    windows_cleared,
    windows_restarted,
)


def turned(angle: float, speed: float = 0.5, seconds: float = 1.0) -> TrackWindows:
    """Return the windows after a straight way that tracking shows turned by an angle [rad]."""
    rows, windows = np.zeros(WINDOW_RING_SIZE, TRACK_ROW), EMPTY_WINDOWS
    for tick in range(round(seconds / ROW_PERIOD) + 1):
        way = speed * tick * ROW_PERIOD
        x, y = way * cos(angle), way * sin(angle)
        onboard = OdometryAt(0.0, 1.0, way, 0.0, speed, 0.0, way, 1e-6 * tick, False)
        windows = windows_advanced(
            windows,
            rows,
            tick * ROW_PERIOD,
            x,
            y,
            0.0,
            onboard,
            OdometryTolerance(0.002, 0.001, FLOW),
        )
    return windows


@settings(max_examples=30)
@given(st.floats(-pi, pi))
def test_the_angle_of_a_body_is_read_within_thirty_centimetres_of_way(angle: float) -> None:
    assert turned(angle, 0.5, 0.55).frame_error == pytest.approx(abs(angle), abs=1e-3)


def test_no_angle_is_read_from_a_way_that_is_too_short() -> None:
    assert isnan(turned(1.0, 0.02, 2.0).frame_error)


@pytest.mark.parametrize(("factor", "mirrored"), [(1.0, False), (-1.0, True), (0.0, False)])
def test_turns_the_other_way_round_are_a_mirror(factor: float, mirrored: bool) -> None:
    rows, windows = np.zeros(WINDOW_RING_SIZE, TRACK_ROW), EMPTY_WINDOWS
    for tick in range(41):
        psi = 0.5 * tick * ROW_PERIOD
        onboard = OdometryAt(psi, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, False)
        yaw = factor * psi + 3.0
        windows = windows_advanced(
            windows,
            rows,
            tick * ROW_PERIOD,
            0.0,
            0.0,
            yaw,
            onboard,
            OdometryTolerance(0.002, 0.001, FLOW),
        )
    assert windows.mirrored is mirrored
    assert (windows.frame_error > 0.4) is (factor != 1.0)


def test_a_way_that_comes_back_agrees_again() -> None:
    rows, windows = np.zeros(WINDOW_RING_SIZE, TRACK_ROW), EMPTY_WINDOWS
    still = OdometryAt(0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, False)
    drifts = []
    for tick in range(800):
        off = 0.2 if 100 <= tick < 160 else 0.0
        at = tick * ROW_PERIOD
        windows = windows_advanced(
            windows, rows, at, off, 0.0, 0.0, still, OdometryTolerance(0.002, 0.001, FLOW)
        )
        drifts.append(windows.drift)
    assert max(drifts[100:160]) == pytest.approx(0.2)
    assert drifts[-1] == 0.0


def test_what_was_seen_while_the_link_stood_still_is_held_against_nothing() -> None:
    rows, windows = np.zeros(WINDOW_RING_SIZE, TRACK_ROW), EMPTY_WINDOWS
    still = OdometryAt(0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, False)
    for tick in range(200):
        stalled = tick % 20 == 19
        windows = windows_advanced(
            windows,
            rows,
            tick * ROW_PERIOD,
            0.3 if stalled else 0.0,
            0.0,
            0.0,
            still._replace(stalled=stalled),
            OdometryTolerance(0.002, 0.001, FLOW),
        )
        assert not windows.drift > 0.0


def test_emptied_windows_know_nothing() -> None:
    emptied = windows_cleared(turned(1.0))
    assert isnan(emptied.drift) and isnan(emptied.frame_error) and not emptied.mirrored


def test_at_a_hole_of_the_odometry_what_has_parted_is_kept() -> None:
    parted = turned(1.0)
    assert parted.drift > 0.1
    kept = windows_restarted(windows_restarted(parted))
    assert kept.drift == parted.drift
    assert isnan(kept.frame_error) and not kept.anchored
    assert isnan(windows_restarted(EMPTY_WINDOWS).drift)


@pytest.mark.parametrize("speed", [0.0, 0.5])
def test_an_hour_of_honest_tracking_never_disagrees(speed: float) -> None:
    assert flown(1, 3600.0, speed)[0] == 0.0


@pytest.mark.safety
@pytest.mark.timeout(600)
@pytest.mark.parametrize(
    ("speed", "period", "loss"), [(0.0, 0.01, 0.0), (0.5, 0.01, 0.0), (0.5, 0.1, 0.3)]
)
def test_honest_tracking_disagrees_less_than_once_in_thirty_hours(
    speed: float, period: float, loss: float
) -> None:
    drifts = [flown(seed, 36000.0, speed, period, loss)[0] for seed in range(10)]
    assert sum(drift > 0.0 for drift in drifts) <= 3


@pytest.mark.parametrize("scale", [0.95, 1.05])
def test_a_flow_whose_scale_is_off_by_what_is_tolerated_is_no_drift(scale: float) -> None:
    assert flown(1, 3600.0, 0.5, flow_scale=scale)[0] == 0.0
    assert flown(2, 3600.0, 1.0, 0.1, 0.3, flow_scale=scale)[0] == 0.0


@pytest.mark.parametrize("speed", [0.0, 0.5])
def test_two_centimetres_a_second_are_told_at_ten_and_landed_before_thirty(speed: float) -> None:
    flights = [flown(seed, 40.0, speed, drift=0.02) for seed in range(300)]
    assert all(told <= 0.1 and landed < 0.3 for _, told, landed in flights)


@pytest.mark.parametrize("degrees", [180, -180])
def test_a_bias_that_was_learned_turns_with_the_drone(degrees: int) -> None:
    windows, ring = EMPTY_WINDOWS, np.zeros(WINDOW_RING_SIZE, TRACK_ROW)
    x = y = psi = 0.0
    for tick in range(300):
        if 150 <= tick < 170:
            psi += radians(degrees) / 20
        x, y = x + 0.011 * cos(psi) * ROW_PERIOD, y + 0.011 * sin(psi) * ROW_PERIOD
        onboard = OdometryAt(psi, 1.0, x, y, 0.0, 0.0, 0.0, 2e-7 * tick, False)
        windows = windows_advanced(
            windows,
            ring,
            tick * ROW_PERIOD,
            0.0,
            0.0,
            psi,
            onboard,
            OdometryTolerance(0.001, 0.0, FLOW),
        )
        assert not windows.anchored


def test_a_bias_is_learned_anew_after_ways_have_come_together() -> None:
    rows, windows = np.zeros(WINDOW_RING_SIZE, TRACK_ROW), EMPTY_WINDOWS
    still = OdometryAt(0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, False)
    for tick in range(900):
        off = 0.2 if 100 <= tick < 160 else 0.0
        windows = windows_advanced(
            windows,
            rows,
            tick * ROW_PERIOD,
            off,
            0.0,
            0.0,
            still,
            OdometryTolerance(0.002, 0.001, FLOW),
        )
    newest = rows[(windows.taken - 1) & (WINDOW_RING_SIZE - 1)]
    assert not windows.anchored and newest["b_variance"] < 1e-5
