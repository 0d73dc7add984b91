"""What a controller tells of itself: there and back, and any bytes are a report or an error."""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import WireError
from housefly.geometry import wrap_angle
from housefly.wires.betaflight import reports, settings
from housefly.wires.betaflight.arming import ArmingFlag, flags_of, told_flags
from housefly.wires.betaflight.commands import Msp
from housefly.wires.betaflight.reports import FcAttitude, FcBattery, FcStatus

READERS: tuple[Callable[[bytes], object], ...] = (
    reports.read_status,
    reports.read_attitude,
    reports.read_battery,
    reports.read_firmware,
    lambda data: reports.read_channels(Msp.RC, data),
    settings.read_mode_ranges,
    settings.read_tuning,
    settings.read_receiver,
    settings.read_order,
    settings.read_failsafe,
    settings.read_silent_channels,
    settings.read_angle_limit,
    settings.read_motor_idle,
)


@given(st.binary(max_size=80))
@pytest.mark.parametrize("read", READERS)
def test_any_payload_is_a_report_or_an_error_that_says_what_is_allowed(
    read: Callable[[bytes], object], data: bytes
) -> None:
    try:
        read(data)
    except WireError as error:
        assert "allowed" in str(error)


@given(
    st.builds(
        FcStatus, st.integers(0, 2**60 - 1), st.integers(0, 2**30 - 1).map(ArmingFlag), st.just(20)
    )
)
def test_a_state_comes_back(status: FcStatus) -> None:
    assert reports.read_status(reports.encode_status(status)) == status


@given(st.builds(FcAttitude, *[st.floats(-1.5, 1.5)] * 2, st.floats(-pi, pi)))
def test_an_attitude_comes_back_as_exactly_as_the_wire_can_say(attitude: FcAttitude) -> None:
    back = reports.read_attitude(reports.encode_attitude(attitude))
    assert back.phi == pytest.approx(attitude.phi, abs=0.001)
    assert back.theta == pytest.approx(attitude.theta, abs=0.001)
    assert abs(wrap_angle(back.psi - attitude.psi)) < 0.009


@given(st.integers(1, 8), st.floats(0.0, 1.0))
def test_a_charge_comes_back_by_the_voltage_of_a_cell(cells: int, charge: float) -> None:
    told = FcBattery(cells, cells * reports.cell_voltage_of(charge))
    back = reports.read_battery(reports.encode_battery(told))
    assert back.charge == pytest.approx(charge, abs=0.02)


def test_without_a_battery_there_is_no_charge() -> None:
    assert FcBattery(0, 0.0).charge == 0.0


def test_channels_come_back_and_others_are_refused() -> None:
    channels = (1500, 1000, 2000, 885)
    payload = reports.encode_channels(channels)
    assert reports.read_channels(Msp.SET_RAW_RC, payload) == channels
    with pytest.raises(WireError, match=r"RC.channel \[us\]\[0\] is 65535"):
        reports.read_channels(Msp.RC, b"\xff\xff")
    with pytest.raises(WireError, match="18 channels at most"):
        reports.read_channels(Msp.RC, bytes(38))
    with pytest.raises(WireError, match="0 to 2500"):
        reports.encode_channels((2501,))


def test_in_older_firmware_the_last_flag_is_the_arm_switch() -> None:
    """API 1.46 has 26 flags, and bit 25 is what is bit 29 now."""
    assert flags_of(1 << 25 | 1 << 7, 26) == ArmingFlag.ARM_SWITCH | ArmingFlag.THROTTLE
    assert flags_of(1 << 25, 30) == ArmingFlag.CRASH_FLIP


@given(st.integers(0, 2**32 - 1), st.integers(0, 255))
def test_every_flag_has_words(bits: int, count: int) -> None:
    flags = flags_of(bits, count)
    assert len(told_flags(flags)) == bin(flags).count("1")


def test_the_version_is_that_of_the_year_or_of_old_numbering() -> None:
    assert reports.read_firmware(bytes((4, 5, 1))) == "4.5.1"
    assert reports.read_firmware(b"\x1a\x0c\x00\x0e2026.12.0-alpha"[:18]) == "2026.12.0-alph"
