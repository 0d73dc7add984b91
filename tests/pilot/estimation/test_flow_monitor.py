"""The third witness: who moves otherwise than the drone leans is blamed, flow or tracking."""

from __future__ import annotations

from collections.abc import Callable
from math import atan, cos, inf, pi, sin

import numpy as np
import pytest
from ardrone_flow import FLOW

from housefly.config.airframe import airframe_named
from housefly.geometry import GRAVITY, quaternion_from_euler
from housefly.messages import DroneStatus, Pose, Sighting, Telemetry
from housefly.pilot.estimation.consistency import TrackingConsistency
from housefly.pilot.estimation.displacement import OdometryTolerance
from housefly.pilot.estimation.flow_monitor import TOGETHER_TIME
from housefly.pilot.estimation.onboard_odometry import UNTOLD_AFTER
from housefly.pilot.estimation.tracking_monitor import TrackingMonitor

TICK, DRAG, BEGIN = 0.01, 0.58, 6.0
DELAY_TICKS = 4
Lie = Callable[[float, float], float]
"""What becomes of a value at a time [s]."""


def honest(t: float, value: float) -> float:
    return value


def from_begin(lie: Lie, until: float = inf) -> Lie:
    return lambda t, value: lie(t, value) if BEGIN <= t < until else value


def shuttle(t: float) -> float:
    """Return a speed that comes and goes [m/s]."""
    return 0.5 * sin(2.0 * pi * t / 5.0)


def said(
    flow: Lie = honest,
    place: Lie = honest,
    *,
    seen_every: float = 0.01,
    seconds: float = 10.0,
    push: float = 0.0,
    offset: float = 0.0035,
    sees: Callable[[float], bool] = lambda t: True,
    speed: Callable[[float], float] = shuttle,
    yaw: float = 0.6,
) -> list[tuple[float, TrackingConsistency]]:
    """Return what the monitor says at every pose of a drone that leans as it must to fly so.

    Args:
        flow: what becomes of the forward speed that is told.
        place: what becomes of the tracked way along the nose.
        seen_every: time between two poses [s].
        seconds: how long it flies.
        push: steady push forward [m/s^2].
        offset: of the reported pitch [rad].
        sees: whether tracking sees it.
        speed: true, forward [m/s].
        yaw: its heading [rad].
    """
    rng, monitor = (
        np.random.default_rng(3),
        TrackingMonitor(
            OdometryTolerance(0.003, 0.001, FLOW), 0.58, airframe_named("ardrone").sonar
        ),
    )
    told: list[tuple[float, TrackingConsistency]] = []
    way, next_seen, past = 0.0, 0.0, [speed(0.0)] * (DELAY_TICKS + 1)
    for n in range(round(seconds / TICK)):
        t = n * TICK
        before, now = speed(t - TICK), speed(t)
        way += TICK * now
        past = [*past[1:], now]
        theta = atan(((now - before) / TICK + DRAG * now - push) / GRAVITY)
        noise = 0.02 * rng.standard_normal(2)
        velocity = (flow(t, past[0] + noise[0]), noise[1], 0.0)
        report = Telemetry(
            t, DroneStatus.FLYING, 0.9, 0.0005 * rng.standard_normal(), theta + offset, 0.0, 1.0,
            velocity, drone_time=t,
        )  # fmt: skip
        monitor.feel(report, DroneStatus.FLYING, 0.0)
        if t >= next_seen - 1e-9 and sees(t):
            next_seen = t + seen_every
            x, y = rng.normal(place(t, way), 0.001), rng.normal(0.0, 0.001)
            position = cos(yaw) * x - sin(yaw) * y, sin(yaw) * x + cos(yaw) * y, 1.05
            pose = Pose(position, quaternion_from_euler(0.0, 0.0, yaw))
            sighting = Sighting("drone", pose, t, t)
            monitor.see(sighting)
            if monitor.agrees(sighting, None):
                monitor.accept(sighting)
            else:
                monitor.refuse(t)
        told.append((t, monitor.consistency(t)))
    return told


def blamed_at(told: list[tuple[float, TrackingConsistency]]) -> float:
    return next((t for t, known in told if known.flow_wrong), inf)


@pytest.mark.parametrize("seen_every", [0.01, 0.1])
@pytest.mark.parametrize("bias", [0.2, 0.6, -0.4, 10.0])
def test_flow_with_a_bias_is_blamed_before_tracking_is_landed_for_it(
    bias: float, seen_every: float
) -> None:
    told = said(from_begin(lambda t, v: v + bias), seen_every=seen_every)
    assert BEGIN <= blamed_at(told) < BEGIN + 0.25
    later = [known for t, known in told if t > BEGIN + 0.5]
    assert all(not known.drift > 0.0 and known.refused_for == 0.0 for known in later)
    assert all(known.drift < 0.15 for t, known in told if known.drift == known.drift)


@pytest.mark.parametrize(
    "lie",
    [
        lambda t, v: 0.0,
        lambda t, v: 0.37,
        lambda t, v: 0.5 * v,
        lambda t, v: 3.0 * v,
        lambda t, v: v + 0.5 * sin(1e4 * t),
    ],
    ids=["off", "stuck", "half", "threefold", "noise"],
)
def test_flow_that_fails_in_any_other_way_is_not_left_to_itself(lie: Lie) -> None:
    told = said(from_begin(lie))
    assert all(known.flow_believed for t, known in told if t < BEGIN)
    first = next(t for t, known in told if not known.flow_believed)
    assert first < BEGIN + max(UNTOLD_AFTER + 0.05, 1.5)


@pytest.mark.parametrize(
    "lie",
    [
        lambda t, x: x + 1.0,
        lambda t, x: x + 0.02 * (t - BEGIN),
        lambda t, x: x + 0.3 * (t - BEGIN),
        lambda t, x: x + 0.14 * (1.0 + int(t - BEGIN)),
        lambda t, x: 0.0,
        lambda t, x: -x,
    ],
    ids=["jump", "drift", "fast_drift", "steps", "frozen", "mirrored"],
)
@pytest.mark.parametrize("seen_every", [0.01, 0.1])
def test_flow_is_not_blamed_for_tracking_that_lies(lie: Lie, seen_every: float) -> None:
    told = said(place=from_begin(lie), seen_every=seen_every, seconds=14.0)
    assert blamed_at(told) == inf


@pytest.mark.parametrize("late", [0.15, 0.3])
def test_flow_is_not_blamed_for_poses_that_are_late(late: float) -> None:
    def delayed(t: float, x: float) -> float:
        return x - sum(TICK * shuttle(t - TICK * n) for n in range(round(late / TICK)))

    assert blamed_at(said(place=from_begin(delayed), seconds=20.0)) == inf


@pytest.mark.parametrize("push", [-0.58, 0.58])
def test_a_draught_and_a_trim_that_is_off_blame_nobody(push: float) -> None:
    told = said(push=push, offset=0.01, seconds=20.0, seen_every=0.1)
    assert all(known.flow_believed for _, known in told)
    assert all(not known.drift > 0.05 for _, known in told)


def test_a_witness_that_knows_the_draught_still_decides() -> None:
    told = said(from_begin(lambda t, v: v - 0.4), push=0.58, offset=0.01)
    assert BEGIN <= blamed_at(told) < BEGIN + 0.3


def test_flow_that_comes_right_again_is_believed_again() -> None:
    told = said(from_begin(lambda t, v: v + 0.5, until=7.0), seconds=14.0)
    last = max(t for t, known in told if known.flow_wrong)
    assert 7.0 + TOGETHER_TIME < last < 7.5 + TOGETHER_TIME


def test_without_tracking_the_witness_alone_finds_flow_that_jumps() -> None:
    told = said(from_begin(lambda t, v: v + 0.6), sees=lambda t: t < 4.0)
    assert BEGIN <= blamed_at(told) < BEGIN + 0.4
    calm = said(sees=lambda t: t < 4.0, seconds=12.0)
    assert blamed_at(calm) == inf
