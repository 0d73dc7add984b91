"""Every packet is read as it was written, and any bytes are a value or a WireError."""

from __future__ import annotations

from collections.abc import Callable
from math import dist, isclose, pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import WireError
from housefly.geometry import normalized, wrap_angle
from housefly.wires.crazyflie import high_level, localization, log_blocks, parameters, tables
from housefly.wires.crazyflie import setpoints as sp
from housefly.wires.crazyflie import supervisor as words
from housefly.wires.crazyflie.crtp import (
    DATA_MAX,
    NULL_PACKET,
    Packet,
    Port,
    decode_crtp,
    encode_crtp,
    is_null,
)

numbers = st.floats(-30.0, 30.0, width=32)
angles = st.floats(-3.0, 3.0)
packets = st.builds(Packet, st.integers(0, 15), st.integers(0, 3), st.binary(max_size=DATA_MAX))
READERS: tuple[Callable[[Packet], object], ...] = (
    sp.decode_setpoint,
    sp.is_notify_stop,
    localization.decode_poses,
    localization.emergency_of,
    high_level.decode_high_level,
    high_level.read_high_level_answer,
    words.decode_order,
    words.decode_info,
    words.read_version,
    words.is_source,
    tables.read_question,
    tables.read_info,
    tables.read_item,
    log_blocks.decode_block_request,
    log_blocks.read_block_answer,
    lambda packet: log_blocks.read_values(packet, (tables.ValueType.FLOAT,)),
    parameters.number_of,
    lambda packet: parameters.read_value(packet, tables.ValueType.UINT8),
    lambda packet: parameters.written_value(packet, tables.ValueType.FLOAT),
)


@given(packets)
def test_a_packet_is_read_as_it_was_written(packet: Packet) -> None:
    assert decode_crtp(encode_crtp(packet)) == packet


@given(packets)
def test_any_packet_is_a_value_or_a_wire_error(packet: Packet) -> None:
    for read in READERS:
        try:
            read(packet)
        except WireError:
            continue


@given(st.binary(max_size=80))
def test_any_datagram_is_a_packet_or_a_wire_error(datagram: bytes) -> None:
    try:
        packet = decode_crtp(datagram)
    except WireError:
        assert not 1 <= len(datagram) <= DATA_MAX + 1
        return
    assert encode_crtp(packet)[1:] == datagram[1:]


def test_the_probe_of_a_scan_is_a_null_packet() -> None:
    assert is_null(decode_crtp(NULL_PACKET))


@given(
    st.one_of(
        st.builds(sp.AltHold, angles, angles, angles, numbers),
        st.builds(sp.ZDistance, angles, angles, angles, numbers),
        st.builds(sp.Hover, numbers, numbers, angles, numbers),
        st.builds(sp.WorldVelocity, numbers, numbers, numbers, angles),
        st.builds(sp.Place, numbers, numbers, numbers, angles),
        st.just(sp.Stop()),
    )
)
def test_a_setpoint_is_read_as_it_was_given(setpoint: sp.GenericSetpoint) -> None:
    read = sp.decode_setpoint(sp.encode_setpoint(setpoint))
    assert type(read) is type(setpoint)
    for name in getattr(setpoint, "__dataclass_fields__", {}):
        assert getattr(read, name) == pytest.approx(getattr(setpoint, name), abs=1e-4)


@given(st.tuples(numbers, numbers, numbers), st.tuples(numbers, numbers, numbers), angles, angles)
def test_a_full_state_is_told_to_the_millimetre_with_its_heading(
    position: tuple[float, float, float],
    velocity: tuple[float, float, float],
    yaw: float,
    turn: float,
) -> None:
    state = sp.FullState(position, velocity, yaw=yaw, yaw_rate=turn)
    read = sp.decode_setpoint(sp.encode_setpoint(state))
    assert isinstance(read, sp.FullState)
    assert dist(read.position, position) < 1e-3 and dist(read.velocity, velocity) < 1e-3
    assert isclose(read.yaw_rate, turn, abs_tol=1e-3)
    assert abs(wrap_angle(read.yaw - yaw)) < 5e-3


def test_leaning_forward_is_a_negative_pitch_in_degrees_on_the_wire() -> None:
    packet = sp.encode_setpoint(sp.AltHold(phi=pi / 18, theta=pi / 9, yaw_rate=pi, vz=0.5))
    assert packet.port == Port.GENERIC_SETPOINT and packet.channel == 0
    assert packet.data.hex() == "04" + "00002041" + "0000a0c1" + "00003443" + "0000003f"


@pytest.mark.parametrize("kind", [1, 2, 5])
def test_the_old_setpoints_with_the_yaw_rate_turned_round_are_refused(kind: int) -> None:
    with pytest.raises(WireError, match=f"type {kind}"):
        sp.decode_setpoint(Packet(Port.GENERIC_SETPOINT, 0, bytes((kind,)) + bytes(16)))


@pytest.mark.parametrize("bad", [float("nan"), float("inf"), 1e39])
def test_a_setpoint_of_numbers_that_are_none_is_not_sent(bad: float) -> None:
    with pytest.raises(WireError):
        sp.encode_setpoint(sp.AltHold(0.0, 0.0, 0.0, bad))
    with pytest.raises(WireError):
        localization.encode_told_pose((bad, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0))


quaternions = (
    st.tuples(*(st.floats(-1.0, 1.0) for _ in range(4)))
    .filter(lambda q: sum(part * part for part in q) > 0.01)
    .map(normalized)
)


@given(st.tuples(numbers, numbers, numbers), quaternions)
def test_a_pose_is_read_as_it_was_told(
    position: tuple[float, float, float], orientation: tuple[float, float, float, float]
) -> None:
    (told,) = localization.decode_poses(localization.encode_told_pose(position, orientation))
    assert told.drone is None and told.orientation is not None
    assert dist(told.position, position) < 1e-4
    assert dist(told.orientation, orientation) < 1e-5


@given(
    st.lists(
        st.tuples(st.integers(0, 255), st.tuples(numbers, numbers, numbers), quaternions),
        min_size=1,
        max_size=2,
    )
)
def test_packed_poses_are_told_to_the_millimetre_and_a_fifth_of_a_degree(poses) -> None:
    read = localization.decode_poses(localization.encode_packed_poses(poses))
    assert [told.drone for told in read] == [drone for drone, _, _ in poses]
    for told, (_, position, orientation) in zip(read, poses, strict=True):
        assert dist(told.position, position) < 1e-3
        along = sum(a * b for a, b in zip(told.orientation, orientation, strict=True))
        assert abs(along) > 1.0 - 1e-5


def test_three_packed_poses_are_too_many() -> None:
    pose = (1, (0.0, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0))
    with pytest.raises(WireError, match="2 or less"):
        localization.encode_packed_poses([pose] * 3)


@given(
    st.one_of(
        st.builds(high_level.TakeOff, numbers, st.floats(0.0, 30.0, width=32)),
        st.builds(high_level.Land, numbers, st.floats(0.0, 30.0, width=32)),
        st.builds(
            high_level.GoTo,
            st.tuples(numbers, numbers, numbers),
            numbers,
            st.floats(0.0, 30.0, width=32),
            st.booleans(),
        ),
        st.just(high_level.StopTrajectory()),
    )
)
def test_a_high_level_order_is_read_as_it_was_given(order: high_level.HighLevelOrder) -> None:
    assert high_level.decode_high_level(high_level.encode_high_level(order)) == order


def test_a_landing_that_is_under_way_already_counts_as_answered() -> None:
    order = high_level.encode_high_level(high_level.Land(0.0, 2.0))
    assert high_level.is_land_answer(high_level.high_level_answer(order, 0))
    assert high_level.is_land_answer(high_level.high_level_answer(order, high_level.ALREADY))
    assert not high_level.is_land_answer(high_level.high_level_answer(order, 16))
    take_off = high_level.encode_high_level(high_level.TakeOff(1.0, 2.0))
    assert not high_level.is_land_answer(high_level.high_level_answer(take_off, 0))


@given(st.integers(0, 0xFFFF))
def test_bits_that_later_firmware_may_set_are_left_out(number: int) -> None:
    info = words.info_of(number)
    assert int(info) == number & 0x0FFF
    read = words.decode_info(words.encode_info(words.INFO_BITFIELD, info))
    assert read == info


def test_arming_is_answered_with_whether_it_is_armed() -> None:
    order = words.SupervisorOrder.ARM
    assert words.decode_order(words.encode_order(order)) == (order, True)
    assert words.decode_order(words.encode_order(order, on=False)) == (order, False)
    answer = words.OrderAnswer(order, is_done=True, state=False)
    assert words.decode_info(words.encode_order_answer(answer)) == answer


names = st.from_regex(r"[a-zA-Z]{1,9}\.[a-zA-Z0-9_]{1,9}", fullmatch=True)
entries = st.builds(tables.TableEntry, names, st.sampled_from(list(tables.ValueType)[:8]))


@given(st.integers(0, 900), st.sampled_from([Port.LOG, Port.PARAMETERS]), entries)
def test_an_entry_of_a_table_is_read_as_it_was_told(
    number: int, port: Port, entry: tables.TableEntry
) -> None:
    assert tables.read_question(tables.item_question(port, number)) == number
    told = tables.item_answer(port, number, (entry,) * (number + 1))
    assert tables.read_item(told) == (number, entry)
    count, check = tables.read_info(tables.info_answer(port, (entry,), (16, 128)))
    assert (count, check) == (1, tables.table_checksum(port, (entry,)))


def test_an_entry_that_is_not_there_is_no_entry() -> None:
    with pytest.raises(WireError):
        tables.read_item(tables.item_answer(Port.LOG, 3, ()))


@given(
    st.lists(
        st.tuples(st.sampled_from(list(tables.ValueType)[:7]), st.integers(0, 100)), max_size=6
    ),
    st.integers(0, 1 << 30),
)
def test_logged_values_are_read_as_they_were_sent(values, clock: int) -> None:
    packet = log_blocks.encode_values(3, clock, values)
    read = log_blocks.read_values(packet, [kind for kind, _ in values])
    assert read == (clock & 0xFFFFFF, tuple(float(value) for _, value in values))


@pytest.mark.parametrize(
    "request_",
    [
        log_blocks.BlockRequest(log_blocks.BlockOrder.RESET),
        log_blocks.BlockRequest(log_blocks.BlockOrder.CREATE, 2, ((tables.ValueType.FLOAT, 300),)),
        log_blocks.BlockRequest(log_blocks.BlockOrder.START, 2, period=0.05),
        log_blocks.BlockRequest(log_blocks.BlockOrder.START_MS, 2, period=0.005),
        log_blocks.BlockRequest(log_blocks.BlockOrder.DELETE, 9),
    ],
)
def test_an_order_about_a_block_is_read_as_it_was_given(
    request_: log_blocks.BlockRequest,
) -> None:
    assert log_blocks.decode_block_request(log_blocks.encode_block_request(request_)) == request_


@given(st.integers(0, 0xFFFF), st.floats(-1e6, 1e6, width=32))
def test_a_parameter_is_read_as_it_was_written(number: int, value: float) -> None:
    kind = tables.ValueType.FLOAT
    order = parameters.encode_write(number, kind, value)
    assert parameters.number_of(order) == number
    assert parameters.written_value(order, kind) == value
    assert parameters.read_value(parameters.parameter_answer(number, kind, value), kind) == value
