"""A LaserScan means what REP-117 says; one that is none is refused with its field and value."""

from __future__ import annotations

from math import inf, nan, pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from ros_scans import BEAMS, STEP, scan_cdr

from housefly.errors import WireError
from housefly.record.ros_messages import message
from housefly.sensors.ros2_scan import SCAN_BEAMS_MAX, SCAN_BYTES_MAX, laser_scan_message


def test_a_scan_is_read_with_its_stamp_and_its_angles() -> None:
    told = laser_scan_message(scan_cdr(1.7e9 + 0.25, (1.0, 2.0, 3.0, 4.0, 5.0)))
    assert told.stamp == pytest.approx(1_700_000_000_250_000_000, abs=1000)
    assert (told.first_angle, told.step) == pytest.approx((-2 * STEP, STEP))
    assert told.ranges.tolist() == [1.0, 2.0, 3.0, 4.0, 5.0]


def test_what_is_no_distance_is_no_return() -> None:
    told = laser_scan_message(scan_cdr(ranges=(0.0, 0.05, 31.0, nan, inf, 3.0)))
    assert told.ranges.tolist() == [inf] * 5 + [3.0]


def test_what_is_too_near_to_be_measured_is_near() -> None:
    told = laser_scan_message(scan_cdr(ranges=(-inf, 3.0, 3.0)))
    assert told.ranges[0] < 0.1


def test_a_scanner_that_turns_clockwise_is_turned_round() -> None:
    told = laser_scan_message(
        scan_cdr(
            ranges=(1.0, 2.0, 3.0),
            angle_min=np.float32(0.5),
            angle_max=np.float32(0.3),
            angle_increment=np.float32(-0.1),
        )
    )
    assert (told.first_angle, told.step) == pytest.approx((0.3, 0.1))
    assert told.ranges.tolist() == [3.0, 2.0, 1.0]


@pytest.mark.parametrize("beams", [360, 361])
def test_a_beam_more_or_less_at_the_end_of_a_turn_is_no_fault(beams: int) -> None:
    step = 2 * pi / 360
    told = laser_scan_message(
        scan_cdr(ranges=(2.0,) * beams, angle_min=-pi, angle_max=pi, angle_increment=step)
    )
    assert len(told.ranges) == beams


BAD = {
    "no ranges": {"ranges": ()},
    "one range": {"ranges": (1.0,)},
    "too many": {"ranges": np.ones(SCAN_BEAMS_MAX + 1), "angle_increment": 1e-4},
    "no step": {"angle_increment": 0.0},
    "a step that is none": {"angle_increment": nan},
    "an angle that is none": {"angle_min": -inf},
    "degrees": {"angle_min": -135.0, "angle_max": 135.0, "angle_increment": 67.5},
    "more than a turn": {"angle_increment": 2.0, "angle_max": -2 * STEP + 8.0},
    "another number of beams": {"angle_max": 1.0 + 2 * STEP},
    "limits the wrong way round": {"range_min": 30.0, "range_max": 0.1},
    "no limits": {"range_min": 0.0, "range_max": 0.0},
    "a limit that is none": {"range_max": nan},
    "millimetres": {"ranges": (2000.0,) * BEAMS, "range_max": 30_000.0},
    "nothing but no returns": {"ranges": (inf,) * BEAMS},
    "nothing but nan": {"ranges": (nan,) * BEAMS},
}


@pytest.mark.parametrize("changes", BAD.values(), ids=BAD.keys())
def test_what_is_no_scan_is_refused_in_words(changes: dict[str, object]) -> None:
    with pytest.raises(WireError, match=r"allowed|covered"):
        laser_scan_message(scan_cdr(**changes))  # type: ignore[arg-type]


@pytest.mark.parametrize(("seconds", "nanoseconds"), [(-1, 0), (5, 2_000_000_000)])
def test_a_stamp_that_is_none_is_refused(seconds: int, nanoseconds: int) -> None:
    stamp = message("builtin_interfaces/msg/Time", seconds, nanoseconds)
    with pytest.raises(WireError, match="stamp"):
        laser_scan_message(scan_cdr(header=message("std_msgs/msg/Header", stamp, "laser")))


def test_a_giant_message_is_refused_before_it_is_read() -> None:
    with pytest.raises(WireError, match="bytes"):
        laser_scan_message(bytes(SCAN_BYTES_MAX + 1))


def test_a_frame_of_any_name_is_read() -> None:
    stamp = message("builtin_interfaces/msg/Time", 1, 0)
    for name in ("", "x" * 500, "レーザー"):
        told = scan_cdr(header=message("std_msgs/msg/Header", stamp, name))
        assert len(laser_scan_message(told).ranges) == BEAMS


@given(st.binary(max_size=200))
def test_other_bytes_are_refused_in_words(data: bytes) -> None:
    try:
        laser_scan_message(data)
    except WireError as error:
        assert str(error)
