"""Bytes to messages and back: any bytes are messages or a WireError, and a stream finds its way."""

from __future__ import annotations

import builtins
import sys
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import MissingPartError, WireError
from housefly.geometry import quaternion_from_euler
from housefly.messages import (
    AnySetpoint,
    Pose,
    PositionSetpoint,
    Setpoint,
    VelocitySetpoint,
)
from housefly.wires.mavlink import requests
from housefly.wires.mavlink.dialect import dialect
from housefly.wires.mavlink.framing import FrameReader, FrameWriter, messages_in
from housefly.wires.mavlink.poses import PoseSpeed, pose_in, pose_message
from housefly.wires.mavlink.reports import report_in
from housefly.wires.mavlink.setpoints import setpoint_in, setpoint_message

numbers = st.floats(-50.0, 50.0)
TARGET = (1, 1)
asked = st.one_of(
    st.builds(VelocitySetpoint, numbers, numbers, numbers, numbers),
    st.builds(PositionSetpoint, numbers, numbers, numbers, numbers),
)

noises = st.binary(max_size=60).filter(lambda noise: not set(noise) & {0xFD, 0xFE})
"""No byte in it begins a message: that one would swallow what follows."""


def sent(*messages: Any) -> bytes:
    writer = FrameWriter(255, 190)
    return b"".join(map(writer.packed, messages))


@given(st.binary(max_size=400))
def test_any_bytes_are_messages_or_a_wire_error(data: bytes) -> None:
    for message in FrameReader().feed(data):
        try:
            report_in(message)
            setpoint_in(message)
            pose_in(message)
        except (WireError, AttributeError):  # a message of another kind has other fields
            continue
    try:
        messages_in(data)
    except WireError as error:
        assert str(error)


@given(
    st.sampled_from(sorted(dialect().mavlink_map)),
    st.binary(min_size=255, max_size=255),
)
def test_any_content_of_a_good_frame_is_a_report_none_or_a_wire_error(
    number: int, payload: bytes
) -> None:
    kind = dialect().mavlink_map[number]
    payload = payload[: kind.unpacker.size]
    body = bytes((len(payload), 0, 0, 7, 1, 1)) + number.to_bytes(3, "little") + payload
    checksum = dialect().x25crc(body + bytes((kind.crc_extra,))).crc
    data = b"\xfd" + body + checksum.to_bytes(2, "little")
    (read,) = messages_in(data)
    try:
        report_in(read)
    except WireError as error:
        assert "allowed" in str(error)


@given(st.lists(st.integers(1, 40), max_size=30), noises)
def test_a_stream_in_any_pieces_gives_the_same_messages_noise_before_them_included(
    pieces: list[int], noise: bytes
) -> None:
    wanted = [requests.heartbeat(), requests.arming(TARGET, True), requests.heartbeat()]
    data, reader, found = noise + sent(*wanted), FrameReader(), []
    for size in pieces:
        found += reader.feed(data[:size])
        data = data[size:]
    found += reader.feed(data)
    assert [one.get_type() for one in found] == [one.get_type() for one in wanted]
    assert bool(reader.broken) is bool(noise)


def test_a_wrong_checksum_and_an_unfinished_message_are_refused_in_words() -> None:
    good = sent(requests.heartbeat())
    assert len(messages_in(good)) == 1
    with pytest.raises(WireError, match="CRC"):
        messages_in(good[:-1] + bytes([good[-1] ^ 1]))
    with pytest.raises(WireError, match="ends early"):
        messages_in(good[:-3])


@given(asked)
def test_a_setpoint_is_read_as_it_was_asked(wanted: AnySetpoint) -> None:
    (message,) = messages_in(sent(setpoint_message(wanted, TARGET, 1234.5)))
    got = setpoint_in(message)
    assert type(got) is type(wanted)
    for name in wanted.__slots__:  # type: ignore[union-attr]
        assert getattr(got, name) == pytest.approx(getattr(wanted, name), abs=1e-4)


def test_a_velocity_goes_along_the_heading_with_down_positive_and_only_it_counts() -> None:
    message = setpoint_message(VelocitySetpoint(1.0, 2.0, 3.0, 0.5), TARGET, 0.0)
    assert (message.coordinate_frame, message.type_mask) == (8, 0b0101_1100_0111)
    assert (message.vx, message.vy, message.vz, message.yaw_rate) == (1.0, -2.0, -3.0, -0.5)
    message = setpoint_message(PositionSetpoint(1.0, 2.0, 3.0, 0.5), TARGET, 0.0)
    assert (message.coordinate_frame, message.type_mask) == (1, 0b0101_1111_1000)
    assert (message.x, message.y, message.z) == (2.0, 1.0, -3.0)
    with pytest.raises(WireError, match="Setpoint has no message"):
        setpoint_message(Setpoint(), TARGET, 0.0)


@given(numbers, numbers, numbers, st.floats(-3.0, 3.0))
def test_a_pose_is_read_as_it_was_seen(x: float, y: float, z: float, yaw: float) -> None:
    pose = Pose((x, y, z), quaternion_from_euler(0.1, -0.2, yaw))
    (message,) = messages_in(sent(pose_message(pose, (0.4, 0.0, 0.0), 77.25)))
    got, at = pose_in(message)
    assert got.position == pytest.approx(pose.position, abs=1e-4)
    assert got.yaw == pytest.approx(pose.yaw, abs=1e-5) and at == pytest.approx(77.25)
    assert (message.frame_id, message.child_frame_id) == (20, 12)


def test_the_velocity_beside_a_pose_is_the_bodys_own_and_the_slope_of_the_last_ones() -> None:
    speed = PoseSpeed()
    velocities = [speed.after((0.5 * n * 0.02, 1.0, 1.0), 10.0 + n * 0.02) for n in range(12)]
    assert velocities[0] == (0.0, 0.0, 0.0)
    assert velocities[-1] == pytest.approx((0.5, 0.0, 0.0), abs=1e-9)
    assert speed.after((9.0, 9.0, 9.0), 99.0) == (0.0, 0.0, 0.0), "a gap begins anew"
    looking_north = Pose((0.0, 0.0, 1.0), quaternion_from_euler(0.0, 0.0, 1.5707963))
    message = pose_message(looking_north, (0.0, 0.5, 0.1), 0.0)
    assert (message.vx, message.vy, message.vz) == pytest.approx((0.5, 0.0, -0.1), abs=1e-6)


def test_without_pymavlink_the_error_names_the_extra(monkeypatch: pytest.MonkeyPatch) -> None:
    real = builtins.__import__

    def refuse(name: str, *rest: Any, **more: Any) -> Any:
        if name.startswith("pymavlink"):
            raise ImportError(name)
        return real(name, *rest, **more)

    for module in [name for name in sys.modules if name.startswith("pymavlink")]:
        monkeypatch.delitem(sys.modules, module)
    monkeypatch.setattr("housefly.wires.mavlink.dialect.import_module", refuse)
    dialect.cache_clear()
    try:
        with pytest.raises(MissingPartError, match=r'pip install "housefly\[mavlink\]"'):
            dialect()
    finally:
        dialect.cache_clear()
