"""Navdata against recorded packets, Parrot's option sizes, and a stranger's strict parser."""

from __future__ import annotations

from dataclasses import fields
from math import pi, radians
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import WireError
from housefly.messages import DroneStatus, Setpoint
from housefly.wires.ardrone import at, conversions
from housefly.wires.ardrone import navdata_options as options
from housefly.wires.ardrone.layout import Structure
from housefly.wires.ardrone.navdata import (
    NavdataPacket,
    RawOption,
    StateBits,
    decode_navdata,
    encode_navdata,
)

SIZES = (
    148,
    8,
    52,
    46,
    16,
    12,
    88,
    16,
    24,
    76,
    56,
    16,
    44,
    92,
    108,
    364,
    328,
    8,
    40,
    65,
    12,
    18,
    75,
    56,
    72,
    32,
    8,
)
"""Sizes with their header, compiled from Parrot's navdata_common.h (ARDroneLib SDK 2.0.1)."""

RANGES = {
    "b": (-128, 127),
    "B": (0, 255),
    "h": (-(2**15), 2**15 - 1),
    "H": (0, 2**16 - 1),
    "i": (-(2**31), 2**31 - 1),
    "I": (0, 2**32 - 1),
}


def _field_values(form: str) -> st.SearchStrategy[object]:
    letter, count = form[-1], int(form[:-1] or 0)
    one = st.floats(width=32, allow_nan=False) if letter == "f" else st.integers(*RANGES[letter])
    return st.tuples(*[one] * count) if count else one


def _structures(kind: type[Structure]) -> st.SearchStrategy[Structure]:
    return st.builds(kind, *(_field_values(item.metadata["wire"]) for item in fields(kind)))  # type: ignore[arg-type]


any_option = st.one_of(*map(_structures, options.OPTION_TYPES))
raw_option = st.builds(RawOption, st.integers(27, 0xFFFE), st.binary(max_size=60))


def _full(shared_data: Path) -> bytes:
    return (shared_data / "ardrone" / "navdata_full_fw2.4+_landed_node-ar-drone.bin").read_bytes()


def _flying(shared_data: Path) -> bytes:
    return (shared_data / "ardrone" / "navdata_demo_inflight_uavpilot.bin").read_bytes()


def test_every_option_has_the_size_of_parrots_header() -> None:
    assert tuple(option.size() + 4 for option in options.OPTION_TYPES) == SIZES
    assert all(len(option().encode()) == option.size() for option in options.OPTION_TYPES)


@given(
    st.integers(0, 2**32 - 1),
    st.integers(0, 2**32 - 1),
    st.lists(st.one_of(any_option, raw_option), max_size=5),
)
def test_what_we_write_we_read_back(
    state: int, sequence: int, sent: list[Structure | RawOption]
) -> None:
    data = encode_navdata(state, sequence, sent)
    packet = decode_navdata(data)
    assert (packet.state, packet.sequence) == (state, sequence)
    assert packet.decoded() == tuple(option for option in sent if isinstance(option, Structure))
    assert packet.unknown == tuple(
        (option.tag, option.size) for option in sent if isinstance(option, RawOption)
    )
    assert encode_navdata(packet.state, packet.sequence, packet.options) == data


def test_the_packet_recorded_in_flight_says_what_its_owner_saw(shared_data: Path) -> None:
    packet = decode_navdata(_flying(shared_data))
    demo = packet.option(options.Demo)
    assert packet.state == 0x0F8004F5
    assert (
        packet.has(StateBits.FLYING)
        and packet.has(StateBits.NAVDATA_DEMO)
        and not packet.has(StateBits.EMERGENCY)
    )
    assert demo is not None
    assert (demo.major, demo.minor, demo.battery_percent) == (options.MajorState.FLYING, 0, 76)
    assert (demo.theta, demo.phi, demo.psi, demo.altitude) == (-92.0, -440.0, 14668.0, 534)
    assert (demo.vx, demo.vy, demo.vz) == pytest.approx((268.5, -195.3, 0.0), abs=0.06)


def test_the_packet_recorded_on_the_ground_says_what_its_owner_saw(shared_data: Path) -> None:
    packet = decode_navdata(_full(shared_data))
    demo, raw, phys = (
        packet.option(options.Demo),
        packet.option(options.RawMeasures),
        packet.option(options.PhysMeasures),
    )
    pressure = packet.option(options.PressureRaw)
    assert (packet.state, packet.sequence) == (0x4F8000D0, 300711)
    assert demo is not None and raw is not None and phys is not None and pressure is not None
    assert (demo.major, demo.battery_percent) == (options.MajorState.LANDED, 50)
    assert (raw.accelerometers, raw.battery_millivolts) == ((2040, 2036, 2528), 11686)
    assert phys.accelerations == pytest.approx((80.3, -33.3, -942.5), abs=0.05)
    assert pressure.pressure == 101586
    assert packet.unknown == ((27, 216),)
    assert len(packet.decoded()) == 27


def test_recorded_packets_are_written_again_byte_for_byte(shared_data: Path) -> None:
    for data in (_flying(shared_data), _full(shared_data)):
        packet = decode_navdata(data)
        again = [
            options.OPTION_TYPES[raw.tag].decode(raw.payload) if raw.tag < 27 else raw
            for raw in packet.options
        ]
        assert (
            encode_navdata(
                packet.state, packet.sequence, again, vision=packet.vision, magic=packet.magic
            )
            == data
        )


def test_the_corrupt_recorded_packet_is_refused(shared_data: Path) -> None:
    with pytest.raises(WireError, match="checksum is 0x3c1, the bytes give 0x400"):
        decode_navdata((shared_data / "ardrone" / "navdata_stateonly_uavpilot.bin").read_bytes())


def test_any_changed_byte_is_noticed(shared_data: Path) -> None:
    data = _flying(shared_data)
    for at_byte in range(len(data)):
        with pytest.raises(WireError):
            decode_navdata(data[:at_byte] + bytes([data[at_byte] ^ 0x40]) + data[at_byte + 1 :])


@pytest.mark.parametrize("size", [12, 216])
def test_both_sizes_of_option_27_are_carried_along(size: int) -> None:
    packet = decode_navdata(encode_navdata(0, 1, [options.Demo(), RawOption(27, bytes(size - 4))]))
    assert packet.unknown == ((27, size),)
    assert packet.option(options.Demo) == options.Demo()


def test_a_known_option_of_another_size_is_not_misread() -> None:
    packet = decode_navdata(encode_navdata(0, 1, [RawOption(0, bytes(10))]))
    assert packet.option(options.Demo) is None
    assert packet.unknown == ((0, 14),)


def test_the_bootstrap_packet_has_24_bytes() -> None:
    data = encode_navdata(StateBits.NAVDATA_BOOTSTRAP, 1)
    assert len(data) == 24
    assert decode_navdata(data).options == ()


def test_a_demo_packet_has_500_bytes() -> None:
    assert len(encode_navdata(0, 1, [options.Demo(), options.VisionDetect()])) == 500


@given(st.binary(max_size=600))
def test_no_bytes_make_the_parser_raise_anything_else(data: bytes) -> None:
    _only_wire_errors(data)


@given(st.binary(max_size=300), st.integers(0, 2**32 - 1))
def test_no_bytes_behind_a_good_header_and_before_a_good_checksum_do_either(
    body: bytes, state: int
) -> None:
    head = encode_navdata(state, 1)[:16]
    _only_wire_errors(
        head + body + b"\xff\xff\x08\x00" + (sum(head + body) & 0xFFFFFFFF).to_bytes(4, "little")
    )


def _only_wire_errors(data: bytes) -> None:
    try:
        packet = decode_navdata(data)
        packet.decoded()
        conversions.telemetry_from_navdata(packet, 0.0)
    except WireError:
        pass


def test_a_packet_of_absurd_length_is_not_looked_at() -> None:
    with pytest.raises(WireError, match="bytes"):
        decode_navdata(bytes(60_000))


def test_a_value_that_does_not_fit_is_not_written() -> None:
    with pytest.raises(WireError, match="Demo"):
        encode_navdata(0, 1, [options.Demo(battery_percent=-1)])
    with pytest.raises(WireError, match="header"):
        encode_navdata(0, -1)


def test_drone_time_counts_seconds_and_microseconds() -> None:
    assert options.Time.of(12.345678).seconds == pytest.approx(12.345678)
    assert options.Time.of(2048.0 + 3.0).seconds == pytest.approx(3.0)


# --- signs ---------------------------------------------------------------------------------------


def test_the_recorded_flight_in_our_signs(shared_data: Path) -> None:
    told = conversions.telemetry_from_navdata(decode_navdata(_flying(shared_data)), 5.0)
    assert told.status is DroneStatus.FLYING
    assert (told.battery, told.height, told.received_at) == (0.76, 0.534, 5.0)
    assert (told.theta, told.phi, told.psi) == pytest.approx(
        (radians(0.092), radians(-0.44), radians(-14.668))
    )
    assert told.velocity == pytest.approx((0.2685, 0.1953, 0.0), abs=1e-4)
    assert told.faults == ()


def test_the_specific_force_of_a_resting_drone_points_up_and_is_one_g(shared_data: Path) -> None:
    told = conversions.telemetry_from_navdata(decode_navdata(_full(shared_data)), 0.0)
    assert told.acceleration is not None
    forward, left, up = told.acceleration
    assert (forward, left, up) == pytest.approx((0.787, 0.327, 9.243), abs=0.01)
    demo_only = conversions.telemetry_from_navdata(decode_navdata(_flying(shared_data)), 0.0)
    assert demo_only.acceleration is None


def test_at_rest_the_accelerometer_reads_up(shared_data: Path) -> None:
    phys = decode_navdata(_full(shared_data)).option(options.PhysMeasures)
    assert phys is not None
    x, y, z = phys.accelerations
    assert conversions.flu_from_frd((x, y, z))[2] > 900


angles = st.floats(-pi + 1e-3, pi - 1e-3)
speeds = st.floats(-5, 5)


@given(st.floats(0, 1), angles, angles, angles, st.floats(0, 6), st.tuples(speeds, speeds, speeds))
def test_the_twins_signs_are_the_inverse_of_the_drivers(
    battery: float,
    phi: float,
    theta: float,
    psi: float,
    height: float,
    velocity: tuple[float, float, float],
) -> None:
    demo = conversions.native_demo(
        options.MajorState.HOVERING,
        battery,
        phi=phi,
        theta=theta,
        psi=psi,
        height=height,
        velocity=velocity,
    )
    told = conversions.telemetry_from_navdata(
        decode_navdata(encode_navdata(StateBits.FLYING, 1, [demo])), 0.0
    )
    assert (told.phi, told.theta, told.psi) == pytest.approx((phi, theta, psi), abs=1e-5)
    assert told.velocity == pytest.approx(velocity, abs=1e-4)
    assert told.height == pytest.approx(height, abs=6e-4)
    assert told.battery == pytest.approx(battery, abs=6e-3)


def told_height(altitude: int, raw: int | None) -> float:
    """Return our height [m] of a packet with these altitudes [mm]."""
    demo = options.Demo(ctrl_state=options.MajorState.FLYING << 16, altitude=altitude)
    measured = [] if raw is None else [options.Altitude(raw=raw)]
    packet = decode_navdata(encode_navdata(StateBits.FLYING, 1, [demo, *measured]))
    return conversions.telemetry_from_navdata(packet, 0.0).height


@pytest.mark.parametrize(
    ("altitude", "raw", "height"),
    [
        (1100, 700, 0.7),  # above a table, which the blend leaves out
        (2600, 500, 0.5),  # a blend that has drifted
        (0, 243, 0.0),  # on the floor
        (90, 240, 0.09),  # too near for ultrasound
        (1100, 240, 0.24),  # something is very near
        (1100, 0, 1.1),  # no echo
        (1100, None, 1.1),  # short reports
    ],
)
def test_raw_ultrasound_tells_what_is_below(altitude: int, raw: int | None, height: float) -> None:
    assert told_height(altitude, raw) == pytest.approx(height)


def test_a_recorded_drone_that_stands_is_at_height_zero(shared_data: Path) -> None:
    packet = decode_navdata(_full(shared_data))
    altitude = packet.option(options.Altitude)
    assert altitude is not None and altitude.raw == 243
    assert conversions.telemetry_from_navdata(packet, 0.0).height == 0.0


def test_pcmd_has_parrots_signs() -> None:
    maxima = conversions.Maxima(tilt=0.2, climb=0.7, yaw_rate=1.75)
    forward = conversions.pcmd_from_setpoint(Setpoint(theta=0.1), maxima)
    right = conversions.pcmd_from_setpoint(Setpoint(phi=0.1), maxima)
    up_and_left_turn = conversions.pcmd_from_setpoint(Setpoint(vz=0.35, yaw_rate=1.75), maxima)
    assert (forward.pitch, right.roll) == pytest.approx((-0.5, 0.5))
    assert (up_and_left_turn.gaz, up_and_left_turn.yaw) == pytest.approx((0.5, -1.0))
    assert forward.flags is at.PcmdFlag.PROGRESSIVE


@given(st.builds(Setpoint, *[st.floats(-10, 10)] * 4))
def test_no_setpoint_asks_for_more_than_a_full_stick(setpoint: Setpoint) -> None:
    pcmd = conversions.pcmd_from_setpoint(setpoint, conversions.Maxima(0.21, 0.7, 1.75))
    stick = conversions.stick_from_pcmd(pcmd)
    assert max(map(abs, (pcmd.roll, pcmd.pitch, pcmd.gaz, pcmd.yaw))) <= 1.0
    assert stick.forward * setpoint.theta >= 0 and stick.left * setpoint.phi <= 0
    assert stick.up * setpoint.vz >= 0 and stick.turn * setpoint.yaw_rate >= 0


def test_a_setpoint_that_is_not_finite_is_a_centred_stick() -> None:
    for bad in (float("nan"), float("inf")):
        pcmd = conversions.pcmd_from_setpoint(
            Setpoint(bad, bad, bad, bad), conversions.Maxima(0.21, 0.7, 1.75)
        )
        assert (pcmd.roll, pcmd.pitch, pcmd.gaz, pcmd.yaw) == (0, 0, 0, 0)


def test_every_major_state_has_our_word_and_emergency_wins() -> None:
    for major in options.MajorState:
        demo = options.Demo(ctrl_state=major << 16)
        assert isinstance(conversions.status_of(NavdataPacket(0, 1), demo), DroneStatus)
        assert (
            conversions.status_of(NavdataPacket(StateBits.EMERGENCY, 1), demo)
            is DroneStatus.EMERGENCY
        )
    assert (
        conversions.status_of(NavdataPacket(0, 1), options.Demo(ctrl_state=99 << 16))
        is DroneStatus.UNKNOWN
    )


def test_numbers_that_are_not_finite_are_refused() -> None:
    packet = decode_navdata(encode_navdata(0, 1, [options.Demo(theta=float("nan"))]))
    with pytest.raises(WireError, match="finite"):
        conversions.telemetry_from_navdata(packet, 0.0)
