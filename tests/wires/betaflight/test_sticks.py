"""RadioSticks: curves inverted, switches found, and the room's signs."""

from __future__ import annotations

from math import radians

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.wires.betaflight.settings import (
    AxisRates,
    Box,
    FcSettings,
    ModeRange,
    RatesType,
    RcTuning,
    encode_mode_ranges,
    read_mode_ranges,
)
from housefly.wires.betaflight.sticks import (
    RadioSticks,
    deflection_for,
    flight_channels,
    radio_sticks_of,
    raw_channels,
    turn_rate,
)
from housefly.wires.betaflight.switches import Switches, boxes_at, switches_of

RATES = st.builds(AxisRates, st.integers(3, 200), st.integers(0, 90), st.integers(0, 90))
KINDS = st.sampled_from(RatesType)
TUNING = st.builds(RcTuning, KINDS, RATES, RATES, RATES)


@given(KINDS, RATES, st.floats(-1.0, 1.0), st.floats(-1.0, 1.0))
def test_a_stick_that_is_deflected_further_asks_for_no_less(
    kind: RatesType, axis: AxisRates, one: float, other: float
) -> None:
    low, high = sorted((one, other))
    assert turn_rate(kind, axis, low) <= turn_rate(kind, axis, high) + 1e-9


@given(KINDS, RATES, st.floats(-0.99, 0.99))
def test_the_deflection_for_a_turn_rate_asks_for_it(
    kind: RatesType, axis: AxisRates, deflection: float
) -> None:
    rate = turn_rate(kind, axis, deflection)
    back = turn_rate(kind, axis, deflection_for(kind, axis, rate))
    assert back == pytest.approx(rate, rel=1e-3, abs=0.05)


@given(
    TUNING,
    st.integers(20, 80),
    st.integers(0, 30),
    st.floats(-0.21, 0.21),
    st.floats(-0.21, 0.21),
    st.floats(0.0, 1.0),
)
def test_a_lean_within_its_limit_is_asked_for_as_exactly_as_a_stick_can(
    tuning: RcTuning, limit: int, deadband: int, phi: float, theta: float, throttle: float
) -> None:
    fc = FcSettings(tuning=tuning, angle_limit=limit, deadband=deadband)
    wanted = RadioSticks(phi, theta, 0.0, throttle)
    got = radio_sticks_of(flight_channels(wanted, fc), fc)
    # one microsecond more or less is what a channel can say
    steps = [
        radio_sticks_of((1500 + sign * n, 1500, 1500, 1500), fc).phi
        for sign in (-1, 1)
        for n in range(0, 501, 25)
    ]
    coarse = max(abs(a - b) for a, b in zip(sorted(steps), sorted(steps)[1:], strict=False))
    assert got.phi == pytest.approx(phi, abs=coarse / 20 + 0.002)
    assert got.throttle == pytest.approx(throttle, abs=0.001)


def test_leaning_forward_right_and_turning_left_move_the_sticks_as_a_person_would() -> None:
    fc = FcSettings()
    roll, pitch, yaw, throttle = flight_channels(RadioSticks(0.1, 0.1, 0.5, 0.5), fc)
    assert roll > 1500 < pitch and yaw < 1500
    assert throttle == 1525
    assert flight_channels(RadioSticks(), fc) == (1500, 1500, 1500, 1000)
    assert radio_sticks_of((1500, 1500, 1500, 1000), fc).throttle is None


def test_expo_makes_a_small_lean_a_larger_deflection() -> None:
    bent = AxisRates(7, 67, 60)
    straight = FcSettings(tuning=RcTuning(RatesType.BETAFLIGHT, *[AxisRates(100, 0, 0)] * 3))
    curved = FcSettings(tuning=RcTuning(RatesType.ACTUAL, bent, bent, bent))
    lean = RadioSticks(theta=radians(6.0), throttle=0.3)
    assert flight_channels(lean, straight)[1] == 1550, "a tenth of 60 degrees, a tenth of the stick"
    assert flight_channels(lean, curved)[1] > 1600


def test_sticks_leave_in_the_order_of_the_controller() -> None:
    aetr = raw_channels((1, 2, 3, 4), (5, 6, 7, 8), FcSettings())
    assert aetr == (1, 2, 4, 3, 5, 6, 7, 8)
    taer = raw_channels((1, 2, 3, 4), (5,), FcSettings(order=(1, 2, 3, 0)))
    assert taer[:5] == (4, 1, 2, 3, 5)


RANGES = st.lists(
    st.builds(
        ModeRange,
        st.sampled_from(Box),
        st.integers(0, 7),
        st.sampled_from((900, 1300, 1700)),
        st.sampled_from((1300, 1700, 2100)),
    ).filter(lambda one: one.low < one.high),
    max_size=8,
).map(tuple)


@given(RANGES)
def test_positions_arm_it_or_not_and_hold_it_level_or_a_mode_is_named(
    ranges: tuple[ModeRange, ...],
) -> None:
    found = switches_of(ranges)
    if isinstance(found, Box):
        assert found in (Box.ARM, Box.ANGLE)
        return
    assert Box.ARM in boxes_at(ranges, found.armed)
    assert Box.ARM not in boxes_at(ranges, found.disarmed)
    assert Box.ANGLE in boxes_at(ranges, found.armed) & boxes_at(ranges, found.disarmed)


@given(RANGES)
def test_switches_come_back(ranges: tuple[ModeRange, ...]) -> None:
    assert read_mode_ranges(encode_mode_ranges(ranges)) == ranges


def test_a_switch_that_arms_and_one_that_levels_are_ours_and_the_failsafe_stays_off() -> None:
    ranges = (
        ModeRange(Box.ARM, 0, 1700, 2100),
        ModeRange(Box.ANGLE, 1, 900, 1300),
        ModeRange(Box.FAILSAFE, 1, 900, 1050),
        ModeRange(Box.HORIZON, 2, 1300, 1700),
    )
    found = switches_of(ranges)
    assert isinstance(found, Switches)
    assert found.armed[:3] == (1700, 1100, 1000) and found.disarmed[0] == 1000
    assert found.own == {0, 1}


@pytest.mark.parametrize("lacking", [Box.ARM, Box.ANGLE])
def test_a_mode_that_no_switch_turns_on_is_named(lacking: Box) -> None:
    other = Box.ANGLE if lacking is Box.ARM else Box.ARM
    assert switches_of((ModeRange(other, 0, 1700, 2100),)) is lacking
