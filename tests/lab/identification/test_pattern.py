"""The pattern stays in the checked box for any drone within a factor of two."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.config.site import Site
from housefly.errors import RoomError
from housefly.lab.identification.box import Box, find_box, free_reach
from housefly.lab.identification.maneuver import REST_TIME, IdentificationManeuver
from housefly.lab.identification.pattern import (
    TILT_AXES,
    Axis,
    Block,
    blocks,
    excursion,
    largest_excursion,
)
from housefly.messages import Action, Command, Estimate
from housefly.pilot.control.model import Constants, DroneState, drone_step
from housefly.room.files import load_room
from housefly.room.grid import build_grid

PLAN = blocks(4, 0.21)
HOLD = Command(Action.HOVER)


@settings(max_examples=40, deadline=None)
@given(
    st.floats(3.5, 14.0),
    st.floats(0.8, 1.25),
    st.floats(0.29, 1.16),
    st.floats(0.0, 0.12),
    st.sampled_from(PLAN),
)
def test_no_drone_within_a_factor_of_two_leaves_the_predicted_excursion(
    lag: float, gain: float, drag: float, delay: float, block: Block
) -> None:
    if block.axis not in TILT_AXES:
        return
    allowed = largest_excursion(PLAN, 7.0, 1.0, 0.58, 0.06)
    body, reach = DroneState(), 0.0
    for step in range(round((block.duration + delay) / 0.01)):
        value = block.asked(step * 0.01 - delay)
        theta, phi = (value, 0.0) if block.axis is Axis.PITCH else (0.0, value)
        body = DroneState(
            *drone_step(body, theta, phi, 0.0, 0.0, (0.0, 0.0), Constants(lag, gain, drag), 0.01)
        )
        reach = max(reach, abs(body.x), abs(body.y))
    assert reach <= allowed + 0.005


def test_the_predicted_excursion_is_that_of_the_drone() -> None:
    assert excursion(PLAN[0], 7.0, 1.0, 0.58, 0.06) == pytest.approx(0.21, abs=0.02)


def test_every_axis_is_flown_both_ways_and_asks_nothing_after_its_last_part() -> None:
    for axis in Axis:
        signs = {np.sign(block.amplitude) for block in PLAN if block.axis is axis}
        assert signs == {-1.0, 1.0}
    assert all(
        block.asked(block.duration + 0.01) == 0.0 and block.asked(-0.01) == 0.0 for block in PLAN
    )


@given(st.sampled_from(PLAN))
def test_a_block_asks_of_its_own_axis_alone(block: Block) -> None:
    setpoint = block.setpoint(0.5 * block.part)
    asked = {
        Axis.PITCH: setpoint.theta,
        Axis.ROLL: setpoint.phi,
        Axis.CLIMB: setpoint.vz,
        Axis.TURN: setpoint.yaw_rate,
    }
    assert asked.pop(block.axis) == block.amplitude
    assert set(asked.values()) == {0.0}


@pytest.fixture(scope="module")
def grid() -> object:
    return build_grid(load_room("bsen"), Site())


def test_the_box_is_free_air_and_near_the_pad(grid: object) -> None:
    room = load_room("bsen")
    box = find_box(grid, room.home, 0.62, 1.1)  # type: ignore[arg-type]
    assert free_reach(grid, box.centre) >= 0.6  # type: ignore[arg-type]
    assert np.hypot(box.centre[0] - room.home[0], box.centre[1] - room.home[1]) < 4.0


def test_a_room_without_so_much_room_says_where_the_most_is(grid: object) -> None:
    with pytest.raises(
        RoomError, match=r"no free square of 6\.0 m anywhere: the most room is .* around \("
    ):
        find_box(grid, (10.0, 2.0), 3.0, 1.1)  # type: ignore[arg-type]


def at(x: float, now: float, *, age: float = 0.01, speed: float = 0.0) -> Estimate:
    return Estimate(now, (x, 0.0, 1.1), (speed, 0.0, 0.0), 0.0, age, 0.001)


def begun() -> tuple[IdentificationManeuver, float]:
    """Return a maneuver in the middle of its first block, and the time."""
    maneuver, now = IdentificationManeuver(PLAN, Box((0.0, 0.0), 0.62, 1.1)), 0.0
    while not maneuver.flown:
        maneuver.propose(now, at(0.0, now), HOLD)
        now += 0.01
    for _ in range(20):
        command = maneuver.propose(now, at(0.05, now), HOLD)
        assert command.setpoint.theta == PLAN[0].amplitude
        now += 0.01
    return maneuver, now


def test_a_block_begins_only_after_rest_in_the_middle() -> None:
    maneuver, now = IdentificationManeuver(PLAN, Box((0.0, 0.0), 0.62, 1.1)), 0.0
    for _ in range(300):
        assert maneuver.propose(now, at(0.0, now, speed=0.2), HOLD) is HOLD
        now += 0.01
    calm_since = now
    while not maneuver.flown:
        maneuver.propose(now, at(0.0, now), HOLD)
        now += 0.01
    assert maneuver.flown[0].began - calm_since == pytest.approx(REST_TIME, abs=0.02)


@pytest.mark.parametrize(
    ("x", "age", "later", "words"),
    [
        (0.7, 0.01, 0.01, "left the box"),
        (0.05, 0.3, 0.01, "tracking was lost for 0.30 s"),
        (0.05, 0.01, 0.5, "interrupted in the middle of a step"),
    ],
)
def test_a_block_is_given_up_and_never_taken_up_again(
    x: float, age: float, later: float, words: str
) -> None:
    maneuver, now = begun()
    now += later
    assert maneuver.propose(now, at(x, now, age=age), HOLD) is HOLD
    assert words in maneuver.problem
    assert maneuver.finished
    for _ in range(100):
        now += 0.01
        assert maneuver.propose(now, at(0.0, now), HOLD) is HOLD


def test_a_drone_that_never_rests_is_given_up() -> None:
    maneuver, now = IdentificationManeuver(PLAN, Box((0.0, 0.0), 0.62, 1.1)), 0.0
    while not maneuver.finished and now < 60.0:
        maneuver.propose(now, at(0.0, now, speed=0.5), HOLD)
        now += 0.05
    assert "did not come to rest within 25 s" in maneuver.problem
