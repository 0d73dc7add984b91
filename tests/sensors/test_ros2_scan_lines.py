"""Lines of the scan child become scans with honest ages; whatever else comes is said."""

from __future__ import annotations

import base64
import json
from math import nan

import pytest
from hypothesis import given
from hypothesis import strategies as st
from ros_scans import scan_cdr

from housefly.config.laser import LaserConfig
from housefly.errors import LinkError, WireError
from housefly.messages import Scan
from housefly.sensors.ros2_scan import LASER_SCAN
from housefly.sensors.ros2_scan_lines import REFUSAL_SHOWN_FOR, Ros2ScanLines

CONFIG = LaserConfig(name="hall", kind="ros2", latency=0.02)
UNIX = 1.7e9


def lines() -> Ros2ScanLines:
    return Ros2ScanLines(CONFIG)


def line(stamp: float, at: float, data: bytes | None = None) -> bytes:
    cdr = scan_cdr(stamp) if data is None else data
    return json.dumps({"scan": base64.b64encode(cdr).decode(), "at": at}).encode()


def looked(nodes: list[str], flooded: int = 0, types: tuple[str, ...] = (LASER_SCAN,)) -> bytes:
    return json.dumps({"nodes": nodes, "types": types, "flooded": flooded}).encode()


def read(reader: Ros2ScanLines, stamp: float, at: float) -> Scan:
    scan = reader.read(line(stamp, at), at)
    assert scan is not None
    return scan


def test_the_age_of_a_scan_is_by_its_stamp_whatever_the_network_does() -> None:
    reader, late = lines(), (0.0, 0.0, 0.3, 0.05, 0.0)
    found = [read(reader, UNIX + 0.1 * k, 5.0 + 0.1 * k + delay) for k, delay in enumerate(late)]
    captured = [scan.captured_at for scan in found]
    assert captured == pytest.approx([4.98 + 0.1 * k for k in range(5)], abs=1e-3)


def test_a_scan_that_waited_for_the_parent_is_as_old_as_the_child_says() -> None:
    reader = lines()
    scan = reader.read(line(UNIX, 5.0), 9.0)
    assert scan is not None and scan.captured_at == pytest.approx(4.98)


@pytest.mark.parametrize("at", [99.0, -1.0, nan])
def test_a_time_of_arrival_that_cannot_be_is_now(at: float) -> None:
    scan = lines().read(line(UNIX, at), 5.0)
    assert scan is not None and scan.received_at == 5.0


def test_a_scan_without_a_stamp_is_as_old_as_the_latency_says() -> None:
    reader = lines()
    for at in (5.0, 5.1):
        assert read(reader, 0.0, at).captured_at == pytest.approx(at - 0.02)


def test_what_was_said_before_or_is_a_little_older_is_dropped() -> None:
    reader = lines()
    read(reader, UNIX, 5.0)
    assert reader.read(line(UNIX, 5.1), 5.1) is None
    assert reader.read(line(UNIX - 0.5, 5.2), 5.2) is None
    assert reader.stale == 2


def test_a_clock_that_was_set_back_is_mapped_anew() -> None:
    reader = lines()
    read(reader, UNIX, 5.0)
    assert read(reader, UNIX - 3600.0, 5.1).captured_at == pytest.approx(5.08)


def test_an_absurd_stamp_spoils_nothing_for_the_next() -> None:
    reader = lines()
    for stamp, at in ((UNIX, 5.0), (2.0e9, 5.1), (UNIX + 0.2, 5.2), (1.0, 5.3), (UNIX + 0.4, 5.4)):
        assert read(reader, stamp, at).captured_at == pytest.approx(at - 0.02)


def test_stamps_that_run_at_half_speed_grow_old() -> None:
    reader = lines()
    scans = [read(reader, UNIX + 0.05 * k, 5.0 + 0.1 * k) for k in range(60)]
    assert scans[-1].received_at - scans[-1].captured_at > 1.0


def test_of_two_nodes_on_one_topic_none_is_believed() -> None:
    reader = lines()
    reader.read(looked(["/a", "/b"]), 5.0)
    assert reader.read(line(UNIX, 5.1), 5.1) is None
    assert "/a, /b" in reader.refusal(5.2) and "topic of its own" in reader.refusal(5.2)
    reader.read(looked(["/a"]), 6.0)
    assert reader.read(line(UNIX, 6.1), 6.1) is not None
    assert not reader.refusal(6.0 + REFUSAL_SHOWN_FOR)


def test_a_flood_is_said_while_it_lasts() -> None:
    reader = lines()
    reader.read(looked(["/a"], flooded=0), 5.0)
    assert not reader.refusal(5.0)
    reader.read(looked(["/a"], flooded=900), 6.0)
    assert "more than 100" in reader.refusal(6.0)
    reader.read(looked(["/a"], flooded=900), 12.0)
    assert not reader.refusal(12.0)


def test_a_scan_that_is_none_is_said_and_the_next_counts() -> None:
    reader = lines()
    assert reader.read(line(0.0, 5.0, scan_cdr(angle_increment=0.0)), 5.0) is None
    assert "angle_increment" in reader.refusal(5.0)
    assert reader.read(b'{"too_large": 123456789}', 5.1) is None
    assert "123456789" in reader.refusal(5.1)
    assert reader.read(line(UNIX, 5.2), 5.2) is not None


def test_the_child_says_what_fails() -> None:
    with pytest.raises(LinkError, match="no domain"):
        lines().read(b'{"problem": "no domain"}', 1.0)


@given(st.binary(max_size=80))
def test_any_other_line_is_refused_in_words(data: bytes) -> None:
    try:
        lines().read(data, 1.0)
    except (WireError, LinkError) as error:
        assert str(error)


@pytest.mark.parametrize(
    "data",
    [
        b'{"nodes": 3}',
        b'{"nodes": [], "types": []}',
        b'{"scan": "?", "at": 1}',
        b'{"scan": "AA=="}',
    ],
)
def test_a_line_of_another_shape_is_refused(data: bytes) -> None:
    with pytest.raises(WireError):
        lines().read(data, 1.0)
