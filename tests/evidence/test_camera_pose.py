"""In which poses a picture may have been taken, and when that is not known."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.evidence.camera_pose import CameraPose, CameraTrack, camera_pose_of
from housefly.geometry import euler_from_quaternion
from housefly.messages import (
    LEVEL,
    Action,
    Command,
    DroneStatus,
    Estimate,
    Inputs,
    Outputs,
    PilotStep,
    Telemetry,
)

ESTIMATE = Estimate(10.0, (1.0, 2.0, 3.0), (0.0, 0.0, 0.0), 0.5, 0.1, 0.02)
REPORT = Telemetry(10.0, DroneStatus.FLYING, 0.9, phi=0.1, theta=-0.2)


def step(estimate: Estimate | None = ESTIMATE, report: Telemetry | None = REPORT) -> PilotStep:
    command = Command(Action.HOVER, LEVEL)
    return PilotStep(1, 10.0, Inputs(telemetry=report), Outputs(command, estimate=estimate))


def at(time: float) -> CameraPose:
    return CameraPose(time, (0.0, 0.0, 1.0), (1.0, 0.0, 0.0, 0.0))


def test_the_pose_is_the_estimate_with_the_tilt_that_the_drone_reports() -> None:
    pose = camera_pose_of(step())
    assert pose is not None
    assert (pose.at, pose.position, pose.position_std) == (10.0, (1.0, 2.0, 3.0), 0.02)
    assert euler_from_quaternion(pose.orientation) == pytest.approx((0.1, -0.2, 0.5))


def test_without_estimate_report_or_tracking_the_pose_is_not_known() -> None:
    lost = Estimate(10.0, (1.0, 2.0, 3.0), (0.0, 0.0, 0.0), 0.5, 0.6, 0.02)
    for one in (step(None), step(report=None), step(lost)):
        assert camera_pose_of(one) is None


def test_a_tilt_that_was_reported_too_long_ago_leaves_the_pose_unknown() -> None:
    assert camera_pose_of(step(report=replace(REPORT, received_at=9.85))) is not None
    assert camera_pose_of(step(report=replace(REPORT, received_at=9.75))) is None


@given(st.lists(st.floats(0.001, 0.3), max_size=60), st.floats(0.0, 5.0))
def test_the_poses_of_a_picture_span_the_whole_latency_without_a_gap(
    pauses: list[float], received_at: float
) -> None:
    track, times = CameraTrack(0.35), [0.0]
    for pause in pauses:
        times.append(times[-1] + pause)
    for time in times:
        if time <= received_at:
            track.add(at(time))
    chosen = [pose.at for pose in track.poses(received_at)]
    told = [time for time in times if time <= received_at]
    needed = [time for time in told if time > received_at - 0.35]
    before = told[-len(needed) - 1 :][:1] if len(told) > len(needed) else []
    edges = [*before, *needed, received_at]
    is_known = max(b - a for a, b in pairwise(edges)) <= 0.2 if len(edges) > 1 else False
    starts = bool(edges[:-1]) and edges[0] <= received_at - 0.35 + 0.2
    assert bool(chosen) is (is_known and starts)
    if not chosen:
        return
    assert chosen == sorted(chosen)
    assert chosen[0] <= received_at - 0.35 + 0.2
    assert all(b - a <= 0.2 for a, b in zip(chosen, [*chosen[1:], received_at], strict=True))
    assert not [t for t in times if chosen[0] < t <= received_at and t not in chosen]


def test_the_same_pose_told_twice_is_one_and_an_older_one_starts_anew() -> None:
    track = CameraTrack()
    for time in (9.0, 9.1, 9.2, 9.3, 9.4, 9.4, 9.5, 9.5):
        track.add(at(time))
    track.add(None)
    assert len(track.poses(9.5)) == 5
    track.add(at(3.0))
    assert track.poses(9.5) == ()
    for n in range(1, 10):
        track.add(at(3.0 + n / 20))
    assert track.poses(3.45)[0] == at(3.1)


def test_a_picture_that_comes_long_after_the_last_pose_has_none() -> None:
    track = CameraTrack()
    for n in range(20):
        track.add(at(9.0 + n / 20))
    assert track.poses(9.95)
    assert not track.poses(10.3)


def test_a_late_picture_may_have_been_taken_in_older_poses_and_one_too_late_in_any() -> None:
    track = CameraTrack(0.35)
    for n in range(60):
        track.add(at(9.0 + n / 20))
    assert track.poses(11.96)[0].at == pytest.approx(11.6)
    assert track.poses(11.96, 0.8)[0].at == pytest.approx(10.8)
    assert track.poses(11.96, 1.9) == ()
