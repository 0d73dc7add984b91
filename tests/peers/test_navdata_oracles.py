"""Two parsers that other people wrote read our packets, whatever the firmware believes."""

from __future__ import annotations

import json
import shutil
import subprocess
from math import degrees
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pyardrone.navdata import NavData

from housefly.twin.ardrone.link import Link
from housefly.twin.ardrone.navdata_options import MAJOR_STATES
from housefly.twin.ardrone.navdata_writer import NavdataWriter
from housefly.twin.contracts import FlightState, OnboardState

HERE = Path(__file__).resolve().parent
EMERGENCY_BIT = 31


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


def packet(onboard: OnboardState, demo: bool) -> bytes:
    writer = NavdataWriter(Link(bootstrap=False), tells_vertical_speed=True)
    writer.demo = demo
    return writer.packet(onboard)


@given(onboards, st.booleans())
def test_pyardrone_reads_every_packet(onboard, demo):
    read = NavData(packet(onboard, demo))
    assert read.metadata.state >> EMERGENCY_BIT == (onboard.flight is FlightState.EMERGENCY)
    assert read.demo.ctrl_state >> 16 == MAJOR_STATES[onboard.flight]
    assert read.demo.theta == pytest.approx(-1e3 * degrees(onboard.theta), abs=0.1)
    assert read.demo.psi == pytest.approx(-1e3 * degrees(onboard.psi), abs=0.1)
    assert read.demo.altitude == round(1e3 * onboard.height)
    assert read.demo.vy == pytest.approx(-1e3 * onboard.velocity[1], abs=0.1)
    assert hasattr(read, "kalman_pressure") == (not demo)


@pytest.mark.slow
@settings(max_examples=5, deadline=None)
@given(st.lists(st.tuples(onboards, st.booleans()), min_size=20, max_size=40))
def test_node_ar_drone_reads_every_packet(cases):
    for (onboard, demo), read in zip(
        cases, node_reads([packet(*case) for case in cases]), strict=True
    ):
        assert "error" not in read
        assert read["droneState"]["emergencyLanding"] == (onboard.flight is FlightState.EMERGENCY)
        assert read["droneState"]["lowBattery"] == onboard.low_battery
        assert read["demo"]["rotation"]["pitch"] == pytest.approx(-degrees(onboard.theta), abs=1e-3)
        assert read["demo"]["rotation"]["roll"] == pytest.approx(degrees(onboard.phi), abs=1e-3)
        assert read["demo"]["altitude"] == pytest.approx(onboard.height, abs=1e-3)
        assert read["demo"]["velocity"]["x"] == pytest.approx(1e3 * onboard.velocity[0], abs=0.1)
        if not demo:
            assert read["physMeasures"]["gyroscopes"]["z"] == pytest.approx(
                -degrees(onboard.angular_rate[2]), rel=1e-4, abs=1e-3
            )
            assert read["pwm"]["motors"] == [round(255 * duty) for duty in onboard.motors]


def node_reads(packets: list[bytes]) -> list[dict]:
    node = shutil.which("node")
    if node is None or not (HERE / "node_modules").is_dir():
        pytest.skip(
            "node, or the packages of tests/peers, are not installed: npm ci --prefix tests/peers"
        )
    lines = "\n".join(data.hex() for data in packets)
    done = subprocess.run(
        [node, "navdata.js"],
        cwd=HERE,
        input=lines,
        capture_output=True,
        text=True,
        timeout=30,
        check=True,
    )
    return [json.loads(line) for line in done.stdout.splitlines()]
