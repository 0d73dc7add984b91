"""Frames become sightings; what cannot be is dropped and counted."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.geometry import IDENTITY, quaternion_from_euler
from housefly.messages import Sighting
from housefly.tracking.counts import FrameCounts
from housefly.tracking.vicon_frames import ViconFrames
from housefly.wires.vicon import (
    TICKS_PER_SECOND,
    ApplicationInfo,
    FrameInfo,
    GlobalSegments,
    LatencyInfo,
    Segment,
    SegmentPose,
    StreamInfo,
    SubjectInfo,
    ViconObject,
    matrix_from_quaternion,
)

STATIC: list[ViconObject] = [
    StreamInfo(TICKS_PER_SECOND // 100),
    ApplicationInfo(),
    SubjectInfo(3, "ardrone", (Segment(8, "arm", parent=9), Segment(9, "ardrone"))),
]
POSE = SegmentPose(
    9, (1000.0, -2000.0, 500.0), matrix_from_quaternion(quaternion_from_euler(0.0, 0.0, pi / 2))
)


def frame(number: int, pose: SegmentPose = POSE, latency: float = 0.03) -> list[ViconObject]:
    return [
        FrameInfo(number),
        LatencyInfo((("a", latency / 2), ("b", latency / 2))),
        GlobalSegments(3, (pose,)),
    ]


def reader() -> tuple[ViconFrames, FrameCounts]:
    counts = FrameCounts()
    return ViconFrames(latency=0.02, counts=counts), counts


def only(sightings: tuple[Sighting, ...] | None) -> Sighting:
    assert sightings is not None
    (sighting,) = sightings
    return sighting


def test_the_root_segment_becomes_a_sighting_in_metres() -> None:
    frames, _ = reader()
    seen = only(frames.read(STATIC + frame(1), 50.0))
    assert (seen.body, seen.received_at) == ("ardrone", 50.0)
    assert seen.pose.position == (1.0, -2.0, 0.5)
    assert seen.pose.yaw == pytest.approx(pi / 2)
    assert seen.captured_at == pytest.approx(49.97)


def test_subjects_are_remembered_when_the_server_does_not_repeat_them() -> None:
    frames, _ = reader()
    frames.read(STATIC + frame(1), 50.0)
    assert only(frames.read(frame(2), 50.01)).body == "ardrone"


def test_a_frame_without_latency_uses_the_configured_one() -> None:
    frames, _ = reader()
    seen = only(frames.read([*STATIC, FrameInfo(1), GlobalSegments(3, (POSE,))], 50.0))
    assert seen.captured_at == pytest.approx(49.98)


@pytest.mark.parametrize("latency", [float("nan"), float("inf"), -1.0, 1e6])
def test_an_impossible_latency_is_not_believed(latency: float) -> None:
    frames, _ = reader()
    assert only(frames.read(STATIC + frame(1, latency=latency), 50.0)).captured_at == pytest.approx(
        49.98
    )


def test_repeated_and_backward_frames_are_dropped_and_counted() -> None:
    frames, counts = reader()
    taken = [
        frames.read(STATIC + frame(number), 50.0) is not None for number in (10, 11, 11, 9, 12)
    ]
    assert taken == [True, True, False, False, True]
    assert (counts.frames, counts.repeated, counts.backward) == (3, 1, 1)


def test_a_server_that_counts_anew_is_followed() -> None:
    frames, counts = reader()
    frames.read(STATIC + frame(5000), 50.0)
    seen = only(frames.read(STATIC + frame(1), 50.5))
    assert seen.captured_at == pytest.approx(50.47)
    assert counts.backward == 0


@pytest.mark.parametrize(
    "pose",
    [
        replace(POSE, translation_mm=(float("nan"), 0.0, 0.0)),
        replace(POSE, translation_mm=(0.0, 2e6, 0.0)),
        replace(POSE, rotation=(2.0, *POSE.rotation[1:])),
    ],
)
def test_a_pose_that_cannot_be_is_dropped_and_counted(pose: SegmentPose) -> None:
    frames, counts = reader()
    assert frames.read(STATIC + frame(1, pose), 50.0) == ()
    assert counts.refused == 1


def test_y_up_is_not_flown_with() -> None:
    frames, _ = reader()
    assert frames.read([*STATIC, ApplicationInfo(y_up=True), *frame(1)], 50.0) == ()
    assert frames.y_up


def test_packets_without_a_frame_are_no_frame() -> None:
    frames, _ = reader()
    assert frames.read(STATIC, 50.0) is None


@given(
    st.lists(
        st.tuples(
            st.integers(0, 2**32 - 1),
            st.floats(width=64),
            st.floats(),
            st.integers(-(2**63), 2**63 - 1),
        ),
        max_size=20,
    )
)
def test_whatever_numbers_come_every_sighting_is_finite_and_ordered(
    rows: list[tuple[int, float, float, int]],
) -> None:
    frames, _ = reader()
    last, now = float("-inf"), 50.0
    for number, coordinate, latency, ticks in rows:
        now += 0.01
        pose = replace(
            POSE, translation_mm=(coordinate, 0.0, 0.0), rotation=matrix_from_quaternion(IDENTITY)
        )
        for seen in (
            frames.read([*STATIC, StreamInfo(ticks), *frame(number, pose, latency)], now) or ()
        ):
            assert abs(seen.pose.position[0]) <= 1000.0
            assert last <= seen.captured_at <= seen.received_at
            last = seen.captured_at
