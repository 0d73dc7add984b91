"""What the drone's reports say when they lie."""

from __future__ import annotations

from dataclasses import fields, replace
from math import isnan, pi

import pytest
from hypothesis import given
from hypothesis import strategies as st
from kinematic_world import KinematicWorld

from housefly.geometry import wrap_angle
from housefly.twin.contracts import OnboardState
from housefly.twin.faults.fault import FaultSchedule
from housefly.twin.faults.onboard_stream import OnboardStream, not_numbers
from housefly.twin.faults.parse import parse_fault

TRUE = KinematicWorld().onboard()


def reported(fault: str, *states: OnboardState) -> list[OnboardState]:
    stream, schedule = OnboardStream(), FaultSchedule(parse_fault(fault))
    return [stream.reported(state, schedule) for state in states]


def changes(state: OnboardState, of: OnboardState = TRUE) -> set[str]:
    return {key.name for key in fields(of) if getattr(state, key.name) != getattr(of, key.name)}


def test_without_a_lie_the_report_is_the_state() -> None:
    assert reported("mocap:off", TRUE)[0] is TRUE


@given(st.floats(-3.1, 3.1), st.floats(-3.1, 3.1))
def test_a_heading_that_lies_stays_an_angle(psi: float, off: float) -> None:
    (told,) = reported(f"telemetry.yaw:wrong={off}", replace(TRUE, psi=psi))
    assert -pi < told.psi <= pi
    assert wrap_angle(told.psi - psi - off) == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize(
    ("fault", "key"),
    [
        ("telemetry.height:wrong=0.3", "height"),
        ("telemetry.velocity:wrong=0.3", "velocity"),
        ("battery:garbage", "battery"),
    ],
)
def test_each_lie_changes_one_thing(fault: str, key: str) -> None:
    assert changes(reported(fault, TRUE)[0]) == {key}


def test_what_stands_still_keeps_all_but_its_time() -> None:
    states = [replace(TRUE, at=float(n), height=0.1 * n) for n in range(4)]
    told = reported("telemetry:stuck@1s+2s", *states)
    assert [state.at for state in told] == [0.0, 1.0, 2.0, 3.0]
    assert [state.height for state in told] == pytest.approx([0.0, 0.1, 0.1, 0.3])


def test_noise_has_no_numbers() -> None:
    (fault,) = parse_fault("telemetry:garbage")
    told = not_numbers(fault, TRUE, 1)
    assert all(isnan(value) for value in (told.phi, told.theta, told.psi, told.height))
    assert changes(told) == {"phi", "theta", "psi", "height", "velocity", "battery"}
