"""Betaflight's simulator wire: any bytes are motors or a WireError, any state is a packet."""

from __future__ import annotations

import socket
import struct

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import LinkError, WireError
from housefly.geometry import GRAVITY, quaternion_from_euler
from housefly.twin.firmware.beside import Beside
from housefly.twin.firmware.betaflight_fdm import motor_output_in, state_packet
from housefly.twin.simulated_body import BodyState

STANDING = BodyState((1.0, 2.0, 0.05), (1.0, 0.0, 0.0, 0.0), (0.0,) * 3, (0.0,) * 3, (0.0,) * 3)
throttles = st.floats(0.0, 1.0, width=32)


@given(throttles, throttles, throttles, throttles)
def test_four_throttles_are_read_in_the_order_of_our_motors(
    front_right: float, rear_left: float, front_left: float, rear_right: float
) -> None:
    packet = struct.pack("<4f", front_right, rear_left, front_left, rear_right)
    assert motor_output_in(packet).gains == (front_left, front_right, rear_right, rear_left)


@given(st.binary(max_size=20))
def test_any_bytes_are_motors_or_a_wire_error(data: bytes) -> None:
    try:
        assert all(0.0 <= throttle <= 1.0 for throttle in motor_output_in(data).throttles)
    except WireError as error:
        assert "allowed" in str(error)


def test_a_lean_is_told_by_gravity_and_by_the_gyro_alike() -> None:
    nose_down = quaternion_from_euler(0.0, 0.2, 0.0)
    told = struct.unpack("<18d", state_packet(2.5, STANDING._replace(orientation=nose_down)))
    assert told[0] == 2.5
    assert told[4] > 1.0 and told[6] < -9.0
    turning = struct.unpack("<18d", state_packet(0.0, STANDING._replace(rate=(0.1, 0.2, 0.3))))
    assert turning[1:4] == (0.1, -0.2, -0.3) and turning[4:7] == (0.0, 0.0, -GRAVITY)


def test_what_was_told_last_holds_for_a_while_and_then_the_motors_stand() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as program:
        program.bind(("127.0.0.1", 0))
        program.settimeout(5.0)
        room = Beside(state_port=program.getsockname()[1], motor_port=0)
        program.sendto(struct.pack("<4f", 0.1, 0.1, 0.1, 0.1), ("127.0.0.1", room.port))
        program.sendto(struct.pack("<4f", 0.4, 0.4, 0.4, 0.4), ("127.0.0.1", room.port))
        program.sendto(b"no", ("127.0.0.1", room.port))
        told = room.exchange(0.0, STANDING)
        assert told == pytest.approx((0.4,) * 4)
        assert len(program.recv(1000)) == 144
        assert room.exchange(0.4, STANDING) == told
        assert room.exchange(0.6, STANDING) == (0.0, 0.0, 0.0, 0.0)
        assert (room.heard, room.broken) == (2, 1)
        with pytest.raises(LinkError, match="cannot hear motors"):
            Beside(motor_port=room.port)
        room.close()
