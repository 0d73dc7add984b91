"""Reports and poses are dated alike, whatever stands still: the machine or the drone's world."""

from __future__ import annotations

from math import cos, inf, isnan, nan, pi, sin

import pytest
from ardrone_flow import FLOW
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.airframe import airframe_named
from housefly.geometry import GRAVITY, quaternion_from_euler
from housefly.messages import DroneStatus, Pose, Sighting, Telemetry
from housefly.pilot.estimation.consistency import OFFSET_WINDOW, ReportClock
from housefly.pilot.estimation.displacement import OdometryTolerance
from housefly.pilot.estimation.tracking_monitor import TrackingMonitor
from housefly.pilot.safety.tracking_rules import DRIFT_WARN
from housefly.tracking.capture_clock import CaptureClock

TICK = 0.01
LINK = 0.004
"""From drone to pilot [s]."""
DRAG = 0.58
SONAR = airframe_named("ardrone").sonar
TOLERANCE = OdometryTolerance(0.005, 0.04, FLOW)


@given(st.lists(st.floats(0.0, 0.4), min_size=1, max_size=80))
def test_a_report_that_is_read_late_tells_of_the_moment_when_it_was_written(
    lates: list[float],
) -> None:
    clock = ReportClock()
    clock.written_at(7.0, 100.0)
    for n, late in enumerate(lates, 1):
        written = 100.0 + n * TICK
        assert clock.written_at(7.0 + n * TICK, written + late) == pytest.approx(written)


@pytest.mark.parametrize("told", [None, nan, inf])
def test_a_drone_without_a_clock_is_heard_when_it_is_heard(told: float | None) -> None:
    assert ReportClock().written_at(told, 3.0) == 3.0


def test_a_clock_that_wraps_or_starts_anew_is_another_one() -> None:
    clock = ReportClock()
    clock.written_at(2047.9, 50.0)
    assert clock.written_at(0.0, 50.1) == 50.1


def test_a_world_that_lost_time_is_believed_after_a_second() -> None:
    clock = ReportClock()
    clock.written_at(0.0, 10.0)
    assert clock.written_at(0.01, 10.31) == pytest.approx(10.01)
    assert clock.written_at(1.05, 11.35 + OFFSET_WINDOW - 1.0) == pytest.approx(11.35)


def test_a_clock_that_stands_is_none_after_a_second() -> None:
    clock = ReportClock()
    dated = [clock.written_at(5.0, 10.0 + n * TICK) for n in range(300)]
    assert dated[50] == 10.0, "a world may stand still"
    assert dated[299] == 10.0 + 299 * TICK
    assert clock.written_at(5.01, 13.0) == pytest.approx(13.0)


def speed(t: float) -> float:
    """Return how fast a drone flies that goes to and fro every 4 s [m/s]."""
    return 0.6 * sin(0.5 * pi * max(t, 0.0))


def lean(t: float) -> float:
    """Return the pitch that flies so, against drag [rad]."""
    faster = 0.3 * pi * cos(0.5 * pi * t) if t > 0.0 else 0.0
    return (faster + DRAG * speed(t)) / GRAVITY


def worst_drift(stall: float, *, tells_time: bool) -> float:
    """Return the largest drift [m] that is seen while the drone's world stands still every 3 s;
    inf where the drone's own speed is not believed any more.
    """
    monitor, capture = (
        TrackingMonitor(TOLERANCE, DRAG, SONAR),
        CaptureClock(),
    )
    lost, x, worst = 0.0, 0.0, 0.0
    for n in range(1800):
        lost += stall if n and n % 300 == 0 else 0.0
        world = n * TICK
        now = 50.0 + world + lost + LINK
        x += TICK * speed(world - 0.5 * TICK)
        report = Telemetry(
            now,
            DroneStatus.FLYING,
            0.9,
            theta=lean(world),
            velocity=(speed(world - FLOW.delay), 0.0, 0.0),
            height=1.0,
            drone_time=world if tells_time else None,
        )
        monitor.feel(report, DroneStatus.FLYING, 0.0)
        pose = Pose((x, 0.0, 1.0), quaternion_from_euler(0.0, lean(world), 0.0))
        at = capture.captured_at(n, TICK, LINK, now)
        monitor.accept(Sighting("ardrone", pose, at, now))
        known = monitor.consistency(now)
        worst = max(worst, 0.0 if isnan(known.drift) else known.drift)
        if not known.flow_believed:
            return inf
    return worst


@pytest.mark.parametrize("stall", [0.05, 0.1, 0.2, 0.24])
def test_a_world_that_stands_still_now_and_then_is_no_drift(stall: float) -> None:
    assert worst_drift(stall, tells_time=True) < DRIFT_WARN


def test_reports_dated_when_they_come_would_take_it_for_one() -> None:
    assert worst_drift(0.2, tells_time=False) > DRIFT_WARN
