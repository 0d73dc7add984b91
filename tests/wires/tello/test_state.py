"""The state of a Tello: lines of real ones, what is refused, and signs and units."""

from __future__ import annotations

from math import degrees, nan, radians

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.airframe import airframe_named
from housefly.errors import WireError
from housefly.messages import DroneFault, DroneStatus, Telemetry, VelocitySetpoint
from housefly.wires.tello.conversions import (
    FullSticks,
    full_sticks_of,
    native_state,
    sticks_of,
    telemetry_of_state,
    velocity_of,
)
from housefly.wires.tello.lines import Sticks
from housefly.wires.tello.state import TelloState, decode_state, encode_state

PLAIN = (
    b"pitch:1;roll:-2;yaw:30;vgx:0;vgy:0;vgz:-1;templ:83;temph:86;tof:86;h:70;bat:63;"
    b"baro:162.63;time:12;agx:5.00;agy:-7.00;agz:-998.00;\r\n"
)
"""As SDK 1.3 sends it."""
EDU = b"mid:-1;x:-100;y:-100;z:-100;mpry:-1,-1,-1;" + PLAIN
"""As SDK 2.0 and 3.0 send it, mission pads on and none in sight."""
FULL = FullSticks(1.5, 0.45, 1.0)

whole = st.integers(-180, 180)
states = st.builds(
    TelloState,
    pitch=whole,
    roll=whole,
    yaw=whole,
    tof=st.integers(0, 10_000),
    h=st.integers(-500, 5000),
    bat=st.integers(0, 100),
    time=st.integers(0, 100_000),
    temph=st.integers(0, 120),
    baro=st.floats(-100, 1000).map(lambda number: round(number, 2)),
    vgz=st.integers(-80, 80),
    agz=st.floats(-3000, 3000).map(lambda number: round(number, 2)),
)


@given(states)
def test_what_is_told_is_read_as_it_was(state):
    assert decode_state(encode_state(state)) == state


@given(st.one_of(st.binary(max_size=200), st.text("abhtoefpimr:;.-0123456789n", max_size=200)))
def test_any_bytes_are_a_state_or_a_wire_error(data):
    try:
        decode_state(data.encode() if isinstance(data, str) else data)
    except WireError:
        return


@pytest.mark.parametrize("line", [PLAIN, EDU, PLAIN.replace(b"agx:5.00;", b"")])
def test_lines_of_every_sdk_are_read(line):
    state = decode_state(line)
    assert (state.pitch, state.roll, state.yaw) == (1, -2, 30)
    assert (state.tof, state.h, state.bat, state.time) == (86, 70, 63, 12)


@pytest.mark.parametrize(
    ("good", "bad", "told"),
    [
        (b"bat:63", b"bat:163", "bat: 163; allowed: 0 to 100"),
        (b"bat:63", b"bat:nan", "bat: nan; allowed: 0 to 100"),
        (b"bat:63", b"bat:6.5", "bat: 6.5; allowed: a whole number"),
        (b"bat:63", b"bat:full", "bat: 'full' is no number"),
        (b"bat:63;", b"", "a state without bat"),
        (b"bat:63;", b"bat:63;bat:64;", "says bat twice"),
        (b"pitch:1", b"pitch:1000", "pitch: 1000; allowed: -180 to 180"),
        (b"pitch", b"\xffitch", "not text"),
    ],
)
def test_what_is_wrong_is_named_with_what_is_allowed(good, bad, told):
    assert good in PLAIN
    with pytest.raises(WireError) as error:
        decode_state(PLAIN.replace(good, bad, 1))
    assert told in str(error.value)


def test_its_angles_become_ours_and_its_distance_the_height():
    report = telemetry_of_state(decode_state(PLAIN), DroneStatus.FLYING, 4.0)
    assert degrees(report.theta) == pytest.approx(-1.0), "its nose up is our nose up, theta falls"
    assert degrees(report.phi) == pytest.approx(-2.0)
    assert degrees(report.psi) == pytest.approx(-30.0), "it counts clockwise"
    assert report.height == pytest.approx(0.86)
    assert report.battery == pytest.approx(0.63)
    assert report.received_at == 4.0 and report.faults == ()


def test_where_nothing_comes_back_its_height_over_the_take_off_counts():
    state = decode_state(PLAIN.replace(b"tof:86", b"tof:6553"))
    assert telemetry_of_state(state, DroneStatus.FLYING, 0.0).height == pytest.approx(0.7)


def test_a_battery_that_takes_off_no_more_is_a_fault():
    state = decode_state(PLAIN.replace(b"bat:63", b"bat:9"))
    assert telemetry_of_state(state, DroneStatus.LANDED, 0.0).faults == (DroneFault.BATTERY_LOW,)


@given(st.floats(-3, 3), st.floats(-0.5, 0.5), st.floats(-0.5, 0.5), st.floats(0.1, 3.0))
def test_the_twin_tells_what_the_driver_understands(psi, theta, phi, height):
    told = Telemetry(0.0, DroneStatus.FLYING, 0.5, theta=theta, phi=phi, psi=psi, height=height)
    heard = telemetry_of_state(
        decode_state(encode_state(native_state(told, 3.2, 0.1))), DroneStatus.FLYING, 0.0
    )
    assert heard.theta == pytest.approx(theta, abs=radians(0.51))
    assert heard.phi == pytest.approx(phi, abs=radians(0.51))
    assert heard.psi == pytest.approx(psi, abs=radians(0.51))
    assert heard.height == pytest.approx(height, abs=0.0051)


@given(st.floats(-1.5, 1.5), st.floats(-1.5, 1.5), st.floats(-0.45, 0.45), st.floats(-1, 1))
def test_sticks_and_velocities_are_one_another(forward, left, vz, rate):
    back = velocity_of(sticks_of(VelocitySetpoint(forward, left, vz, rate), FULL), FULL)
    assert back.forward == pytest.approx(forward, abs=0.008)
    assert back.left == pytest.approx(left, abs=0.008)
    assert back.vz == pytest.approx(vz, abs=0.003)
    assert back.yaw_rate == pytest.approx(rate, abs=0.006)


def test_sticks_have_its_own_signs_are_cut_and_never_come_of_what_is_no_number():
    assert sticks_of(VelocitySetpoint(0.75, 0.3, 0.45, 0.5), FULL) == Sticks(-20, 50, 100, -50)
    assert sticks_of(VelocitySetpoint(9.0, -9.0, -9.0, -9.0), FULL) == Sticks(100, 100, -100, 100)
    assert sticks_of(VelocitySetpoint(nan, nan, nan, nan), FULL) == Sticks()


def test_its_airframe_says_what_full_sticks_mean():
    assert full_sticks_of(airframe_named("tello").response) == FULL
