"""Packets say what the firmware believes, in the drone's own units and signs."""

from __future__ import annotations

from dataclasses import replace
from math import atan2, degrees, radians

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.geometry import GRAVITY
from housefly.messages import DroneStatus
from housefly.twin.ardrone.link import Link
from housefly.twin.ardrone.navdata_writer import NavdataWriter
from housefly.twin.contracts import FlightState, OnboardState
from housefly.wires.ardrone.conversions import telemetry_from_navdata
from housefly.wires.ardrone.navdata import StateBits, decode_navdata
from housefly.wires.ardrone.navdata_options import (
    Demo,
    EulerAngles,
    Magneto,
    PhysMeasures,
    Pwm,
    RawMeasures,
    Time,
)

RESTING = OnboardState(
    at=1.5,
    flight=FlightState.LANDED,
    battery=0.5,
    battery_voltage=11.686,
    phi=0.0,
    theta=0.0,
    psi=0.0,
    height=0.0,
    velocity=(0.0, 0.0, 0.0),
    acceleration=(0.0, 0.0, GRAVITY),
    angular_rate=(0.0, 0.0, 0.0),
    motors=(0.0, 0.0, 0.0, 0.0),
)


def finite(limit):
    return st.floats(-limit, limit, allow_nan=False)


vectors = st.tuples(finite(20.0), finite(20.0), finite(20.0))
onboards = st.builds(
    OnboardState,
    at=st.floats(0.0, 1e5),
    flight=st.sampled_from(FlightState),
    battery=st.floats(0.0, 1.0),
    battery_voltage=st.floats(8.0, 13.0),
    phi=finite(1.0),
    theta=finite(1.0),
    psi=finite(3.14),
    height=st.floats(0.0, 6.0),
    velocity=vectors,
    acceleration=vectors,
    angular_rate=vectors,
    motors=st.tuples(*[st.floats(0.0, 1.0)] * 4),
    low_battery=st.booleans(),
    com_watchdog=st.booleans(),
    com_lost=st.booleans(),
    angles_out_of_range=st.booleans(),
    motors_problem=st.booleans(),
)


def writer(
    *, demo: bool, bootstrap: bool = False, acknowledged: bool = False, tells_vz: bool = True
) -> NavdataWriter:
    made = NavdataWriter(Link(acknowledged=acknowledged, bootstrap=bootstrap), tells_vz)
    made.demo = demo
    return made


def test_sizes_are_those_of_the_real_drone():
    assert len(writer(demo=True, bootstrap=True).packet(RESTING)) == 24
    assert len(writer(demo=True).packet(RESTING)) == 500
    full = decode_navdata(writer(demo=False).packet(RESTING))
    assert [raw.tag for raw in full.options] == list(range(27))
    assert full.unknown == ()


def test_a_full_packet_has_the_options_of_a_recorded_one(shared_data):
    recorded = decode_navdata(
        (shared_data / "ardrone" / "navdata_full_fw2.4+_landed_node-ar-drone.bin").read_bytes()
    )
    ours = decode_navdata(writer(demo=False).packet(RESTING))
    assert [(raw.tag, raw.size) for raw in ours.options] == [
        (raw.tag, raw.size) for raw in recorded.options if raw.tag != 27
    ]


def test_state_bits_at_rest_are_those_of_a_recorded_packet():
    packet = decode_navdata(
        writer(demo=False, acknowledged=True).packet(replace(RESTING, com_watchdog=True))
    )
    assert packet.state == 0x4F8000D0


def test_state_bits_in_flight_are_those_of_a_recorded_packet():
    flying = writer(demo=True, acknowledged=True).packet(
        replace(RESTING, flight=FlightState.FLYING)
    )
    assert decode_navdata(flying).state == 0x0F8004F5


@pytest.mark.parametrize(
    ("field", "bit"),
    [
        ("low_battery", StateBits.BATTERY_LOW),
        ("com_watchdog", StateBits.COM_WATCHDOG),
        ("ultrasound_deaf", StateBits.ULTRASOUND_DEAF),
        ("com_lost", StateBits.COM_LOST),
        ("angles_out_of_range", StateBits.ANGLES_OUT_OF_RANGE),
        ("motors_problem", StateBits.MOTORS_PROBLEM),
    ],
)
def test_each_complaint_has_its_bit(field, bit):
    quiet = decode_navdata(writer(demo=True).packet(RESTING))
    loud = decode_navdata(writer(demo=True).packet(replace(RESTING, **{field: True})))
    assert loud.state ^ quiet.state == bit


@given(onboards, st.booleans())
def test_what_goes_in_comes_out_in_our_signs(onboard, demo):
    packet = decode_navdata(writer(demo=demo).packet(onboard))
    told = telemetry_from_navdata(packet, 0.0)
    assert told.phi == pytest.approx(onboard.phi, abs=1e-5)
    assert told.theta == pytest.approx(onboard.theta, abs=1e-5)
    assert told.psi == pytest.approx(onboard.psi, abs=1e-5)
    assert told.velocity == pytest.approx(onboard.velocity, abs=1e-5)
    assert told.height == pytest.approx(onboard.height, abs=6e-4)
    assert told.battery == pytest.approx(onboard.battery, abs=6e-3)
    assert (told.status is DroneStatus.EMERGENCY) == (onboard.flight is FlightState.EMERGENCY)


def test_the_real_drone_does_not_tell_its_vertical_speed():
    climbing = replace(RESTING, velocity=(1.0, 0.0, 0.5))
    demo = decode_navdata(writer(demo=True, tells_vz=False).packet(climbing)).option(Demo)
    assert (demo.vx, demo.vz) == (1000.0, 0.0)


@pytest.mark.parametrize(("demo", "height"), [(False, 0.7), (True, 1.1)])
def test_a_table_below_is_told_by_full_reports_alone(demo, height):
    flying = replace(RESTING, flight=FlightState.FLYING, height=1.1)
    tell = writer(demo=demo)
    tell.packet(flying)
    above = decode_navdata(tell.packet(replace(flying, at=flying.at + 0.005, height=0.7)))
    assert telemetry_from_navdata(above, 0.0).height == pytest.approx(height)


def test_hovering_without_a_client_is_told_as_such():
    lost = replace(RESTING, flight=FlightState.HOVERING, com_lost=True)
    demo = decode_navdata(writer(demo=True).packet(lost)).option(Demo)
    assert (demo.major, demo.minor) == (4, 8)


def test_measurements_are_in_the_drones_own_units():
    moving = replace(
        RESTING, angular_rate=(radians(10.0), 0.0, radians(30.0)), motors=(0.0, 0.5, 1.0, 2.0)
    )
    packet = decode_navdata(writer(demo=False).packet(moving))
    physical = packet.option(PhysMeasures)
    assert physical.accelerations == pytest.approx((0.0, 0.0, -1000.0))
    assert physical.rates == pytest.approx((10.0, 0.0, -30.0))
    assert packet.option(RawMeasures).battery_millivolts == 11686
    assert packet.option(RawMeasures).accelerometers == (2048, 2048, 2560)
    assert packet.option(Pwm).motors == (0, 128, 255, 255)
    assert packet.option(Time).seconds == 1.5


def test_packets_are_numbered_from_one():
    made = writer(demo=True)
    assert [decode_navdata(made.packet(RESTING)).sequence for _ in range(3)] == [1, 2, 3]


def test_angles_are_thousandths_of_degrees():
    tilted = replace(RESTING, theta=0.1, phi=0.2, psi=0.3)
    packet = decode_navdata(writer(demo=False).packet(tilted))
    demo, euler = packet.option(Demo), packet.option(EulerAngles)
    assert (euler.theta, euler.phi) == (demo.theta, demo.phi)
    assert (demo.theta, demo.phi, demo.psi) == pytest.approx(
        (-1e3 * degrees(0.1), 1e3 * degrees(0.2), -1e3 * degrees(0.3))
    )


def test_a_client_in_demo_mode_gets_the_options_that_it_asks_for_besides():
    writer = NavdataWriter(Link(bootstrap=False), tells_vertical_speed=False)
    writer.demo, writer.demo_options = True, 1 << 1 | 1 << 22
    packet = decode_navdata(writer.packet(RESTING))
    assert [option.tag for option in packet.options] == [0, 1, 16, 22]


@given(st.floats(-3.1, 3.1))
def test_the_magnetometer_points_north(psi):
    writer = NavdataWriter(Link(bootstrap=False), tells_vertical_speed=False)
    found = decode_navdata(writer.packet(replace(RESTING, psi=psi))).option(Magneto)
    assert found is not None
    ahead, right, down = found.rectified
    assert down > 0.0
    assert atan2(-right, ahead) == pytest.approx(radians(found.heading_unwrapped), abs=1e-5)
    assert -radians(found.heading_unwrapped) == pytest.approx(psi, abs=1e-5)
