"""ArduPilot's simulator wire: any bytes are a servo packet or a WireError, any state is a line."""

from __future__ import annotations

import json
import struct

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import WireError
from housefly.geometry import GRAVITY, quaternion_from_euler
from housefly.twin.firmware.ardupilot_json import body_line, servo_output_in
from housefly.twin.simulated_body import BodyState

STANDING = BodyState((1.0, 2.0, 0.05), (1.0, 0.0, 0.0, 0.0), (0.0,) * 3, (0.0,) * 3, (0.0,) * 3)
sizes = st.floats(-1e3, 1e3, allow_nan=False)
vectors = st.tuples(sizes, sizes, sizes)
angles = st.floats(-1.5, 1.5, allow_nan=False)


@given(
    rate=st.integers(1, 65535),
    frame=st.integers(0, 2**32 - 1),
    pulses=st.lists(st.integers(0, 3000), min_size=16, max_size=16),
    is_long=st.booleans(),
)
def test_what_is_packed_is_read(rate: int, frame: int, pulses: list[int], is_long: bool) -> None:
    sent = pulses * 2 if is_long else pulses
    magic = 29569 if is_long else 18458
    read = servo_output_in(struct.pack(f"<HHI{len(sent)}H", magic, rate, frame, *sent))
    assert (read.rate_hz, read.frame, read.pulses) == (rate, frame, tuple(sent))


@given(st.binary(max_size=90))
def test_any_bytes_are_a_servo_packet_or_a_wire_error(data: bytes) -> None:
    try:
        servo_output_in(data)
    except WireError as error:
        assert "allowed" in str(error)


@pytest.mark.parametrize(
    ("datagram", "words"),
    [
        (b"", "has 0 bytes; allowed: 40 or 72"),
        (struct.pack("<HHI16H", 1, 400, 0, *(0,) * 16), "magic number is 1; allowed: 18458"),
        (struct.pack("<HHI15H", 18458, 400, 0, *(0,) * 15), "has 38 bytes; allowed: 40"),
        (struct.pack("<HHI16H", 18458, 0, 0, *(0,) * 16), "rate is 0 Hz; allowed: 1 to 65535"),
        (struct.pack("<HHI16H", 18458, 1, 0, *(3001,) * 16), "pulse is 3001 us; allowed: 0 to"),
    ],
)
def test_what_is_refused_names_field_value_and_range(datagram: bytes, words: str) -> None:
    with pytest.raises(WireError, match=words):
        servo_output_in(datagram)


@given(position=vectors, velocity=vectors, rate=vectors, roll=angles, pitch=angles, yaw=angles)
def test_a_line_is_json_between_line_feeds_without_a_space(
    position: tuple[float, float, float],
    velocity: tuple[float, float, float],
    rate: tuple[float, float, float],
    roll: float,
    pitch: float,
    yaw: float,
) -> None:
    turned = quaternion_from_euler(roll, pitch, yaw)
    line = body_line(3.5, BodyState(position, turned, velocity, (0.0, 0.0, 0.0), rate))
    assert line[:1] == line[-1:] == b"\n" and b" " not in line
    told = json.loads(line)
    (x, y, z), (p, q, r) = position, rate
    assert told["timestamp"] == 3.5 and told["position"] == [y, x, -z]
    assert told["imu"]["gyro"] == [p, -q, -r]
    assert sum(part * part for part in told["imu"]["accel_body"]) == pytest.approx(GRAVITY**2)


def test_who_stands_feels_its_weight_upwards_and_faces_east_where_we_face_x() -> None:
    told = json.loads(body_line(0.0, STANDING))
    assert told["imu"]["accel_body"] == pytest.approx([0.0, 0.0, -GRAVITY])
    half = 0.5**0.5
    assert told["quaternion"] == pytest.approx([half, 0.0, 0.0, half])
