"""The frames of the simulated tracking system: how often, how late and how noisy."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.site import Site, changed
from housefly.geometry import quaternion_from_euler
from housefly.messages import Pose
from housefly.room.model import Room, TrackingCamera
from housefly.twin.contracts import MocapFrame
from housefly.twin.mocap.frames import LEVER_ARM, FrameMaker
from housefly.twin.world import SimulatedWorld

MakeWorld = Callable[..., SimulatedWorld]
MakeRoom = Callable[..., Room]
Cameras = tuple[TrackingCamera, ...]
POSE = Pose((1.0, 2.0, 3.0), quaternion_from_euler(0.1, -0.2, 2.5))


def run(frames: FrameMaker, seconds: float) -> list[MocapFrame]:
    taken: list[MocapFrame] = []
    for tick in range(round(seconds / 0.005)):
        now = tick * 0.005
        if frames.is_due(now):
            frames.expose(now, (("body", POSE),))
        taken.extend(frames.due_frames(now))
    return taken


def maker(seed: int = 1, **twin: float) -> FrameMaker:
    return FrameMaker(
        changed(Site(), **{f"twin__{key}": value for key, value in twin.items()}),
        np.random.default_rng(seed),
    )


@pytest.mark.parametrize("rate", [10.0, 30.0, 100.0, 200.0])
def test_frames_come_at_the_configured_rate(rate: float) -> None:
    frames = run(maker(mocap_rate_hz=rate, mocap_latency=0.0), 10.0)
    assert len(frames) == pytest.approx(10 * rate, abs=2)


def test_frames_leave_after_the_latency_and_a_little_jitter() -> None:
    frames = run(maker(mocap_latency=0.03), 10.0)
    delays = [frame.due_at - frame.captured_at for frame in frames]
    assert min(delays) >= 0.03
    assert max(delays) < 0.04
    assert np.std(delays) > 0.0001


def test_lost_frames_are_missing_but_counted() -> None:
    frames = run(maker(mocap_dropout=0.3), 20.0)
    assert len(frames) == pytest.approx(2000 * 0.7, rel=0.05)
    assert frames[-1].number > 1980


def test_a_system_that_loses_everything_says_nothing() -> None:
    assert run(maker(mocap_dropout=1.0), 1.0) == []


def test_noise_is_as_large_as_configured_and_has_no_bias() -> None:
    poses = [frame.bodies[0][1] for frame in run(maker(mocap_noise=0.002), 30.0)]
    errors = np.array([pose.position for pose in poses if pose]) - POSE.position
    assert errors.std(axis=0) == pytest.approx((0.002,) * 3, rel=0.1)
    assert errors.mean(axis=0) == pytest.approx((0.0,) * 3, abs=0.0002)
    yaws = np.array([pose.yaw - POSE.yaw for pose in poses if pose])
    assert yaws.std() == pytest.approx(0.002 / LEVER_ARM, rel=0.15)


def test_without_noise_the_pose_is_the_truth() -> None:
    pose = run(maker(mocap_noise=0.0), 0.1)[0].bodies[0][1]
    assert pose is not None
    assert pose.position == POSE.position
    assert pose.orientation == pytest.approx(POSE.orientation)


@given(st.integers(0, 2**31), st.floats(1, 200), st.floats(0, 0.5), st.floats(0, 1))
def test_frames_are_ordered_and_none_leaves_before_it_was_taken(
    seed: int, rate: float, latency: float, dropout: float
) -> None:
    frames = run(maker(seed, mocap_rate_hz=rate, mocap_latency=latency, mocap_dropout=dropout), 1.0)
    assert [frame.number for frame in frames] == sorted({frame.number for frame in frames})
    dues = [frame.due_at for frame in frames]
    assert dues == sorted(dues)
    assert all(frame.due_at >= frame.captured_at + latency for frame in frames)
