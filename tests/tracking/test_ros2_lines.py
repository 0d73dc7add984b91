"""Lines of the ROS 2 child become poses with honest ages; whatever else comes is refused."""

from __future__ import annotations

import json
from math import nan

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import LinkError, WireError
from housefly.tracking.counts import FrameCounts
from housefly.tracking.ros2_child import topic_pattern
from housefly.tracking.ros2_lines import Ros2Lines

POSE = [1.0, 2.0, 1.1, 1.0, 0.0, 0.0, 0.0]


def lines(latency: float = 0.02) -> Ros2Lines:
    return Ros2Lines(latency, False, FrameCounts())


def line(stamp: int, body: str = "ardrone", pose: object = POSE) -> bytes:
    return json.dumps({"body": body, "stamp": stamp, "pose": pose}).encode()


def test_the_age_of_a_pose_is_by_its_stamp_whatever_the_network_does() -> None:
    reader, late = lines(), (0.0, 0.0, 0.08, 0.0, 0.15)
    found = [
        reader.read(line(10_000_000_000 + 10_000_000 * k), 5.0 + 0.01 * k + delay)
        for k, delay in enumerate(late)
    ]
    captured = [seen[0].captured_at for seen in found if seen]
    assert captured == pytest.approx([4.98 + 0.01 * k for k in range(5)])


def test_a_pose_without_a_stamp_is_as_old_as_the_latency_says() -> None:
    seen = lines(0.05).read(line(0), 5.0)
    assert seen is not None and seen[0].captured_at == pytest.approx(4.95)


def test_what_was_said_before_or_is_older_is_dropped() -> None:
    reader = lines()
    assert reader.read(line(2_000_000), 5.0) is not None
    assert reader.read(line(2_000_000), 5.01) is None
    assert reader.read(line(1_000_000), 5.02) is None


def test_bodies_have_clocks_of_their_own() -> None:
    reader = lines()
    assert reader.read(line(2_000_000_000, "a"), 5.0) is not None
    seen = reader.read(line(1_000_000, "b"), 5.0)
    assert seen is not None and seen[0].captured_at == pytest.approx(4.98)


@pytest.mark.parametrize("pose", [[nan] * 7, [1e6, 0, 0, 1, 0, 0, 0], [0, 0, 0, 0, 0, 0, 0]])
def test_a_pose_that_is_none_is_counted_and_dropped(pose: list[float]) -> None:
    reader = lines()
    assert reader.read(line(1, pose=pose), 5.0) is None


def test_the_child_says_what_it_hears_and_what_fails() -> None:
    reader = lines()
    assert reader.read(b'{"topics": ["/a/pose"]}', 1.0) is None and reader.topics == ("/a/pose",)
    with pytest.raises(LinkError, match="no domain"):
        reader.read(b'{"problem": "no domain"}', 1.0)


@given(st.binary(max_size=80))
def test_any_other_line_is_refused_in_words(data: bytes) -> None:
    try:
        lines().read(data, 1.0)
    except (WireError, LinkError) as error:
        assert str(error)


def test_a_pattern_finds_the_body_in_the_name_of_the_topic() -> None:
    found = topic_pattern("/vrpn_mocap/{body}/pose").fullmatch("/vrpn_mocap/cf1/pose")
    assert found is not None and found["body"] == "cf1"
    assert topic_pattern("/{body}/pose").fullmatch("/room/cf1/pose") is None
    assert topic_pattern("/tf").fullmatch("/tf") is not None
