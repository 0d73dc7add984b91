from __future__ import annotations

from itertools import product
from math import pi, radians

import pytest
from acceptor_words import described
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.control import ControlConfig
from housefly.messages import Behavior
from housefly.pilot.behavior.acceptor import (
    PAPER_TOLERANCES,
    REST,
    STATES,
    TABLE,
    Acceptor,
    AcceptorState,
    Condition,
    Tolerances,
    acceptor_advanced,
    printed_conditions,
    steady_conditions,
)

EPS1, EPS2, EPS3 = PAPER_TOLERANCES[:3]
heights = st.floats(-3.0, 3.0) | st.sampled_from([EPS1, -EPS1, 0.0])
yaws = st.floats(-pi, pi) | st.sampled_from([EPS2, -EPS2, 0.0])
distances = st.floats(0.0, 10.0) | st.sampled_from([EPS3, 0.0])
states = st.sampled_from(STATES)
CONTROL = ControlConfig()
OURS = Tolerances(
    CONTROL.epsilon_height, CONTROL.epsilon_yaw, CONTROL.epsilon_position, CONTROL.dwell
)


def looked(
    acceptor: Acceptor,
    errors: tuple[float, float, float],
    now: float,
    paper: bool = False,
    dwell: float = 0.0,
) -> Acceptor:
    """Return the acceptor after errors of height [m], yaw [rad] and place [m], in a mode."""
    if paper:
        bits = printed_conditions(*errors, *PAPER_TOLERANCES[:3])
    else:
        bits = steady_conditions(acceptor.state, *errors, *OURS[:3])
    return acceptor_advanced(acceptor, bits, now, dwell)


def test_the_table_names_one_next_state_for_every_state_and_every_set_of_conditions() -> None:
    assert TABLE.shape == (len(Behavior), 2 ** len(Condition))
    assert set(TABLE.flatten().tolist()) <= set(range(len(Behavior)))


def test_the_table_keeps_the_papers_execution_order() -> None:
    for state, bits in product(STATES, range(32)):
        target = STATES[TABLE[STATES.index(state), bits]]
        if bits & Condition.REST:
            assert target is Behavior.HOVER
        elif bits & Condition.Q1:
            assert target is Behavior.ALTITUDE_CONTROL
        elif bits & Condition.Q2:
            assert target is Behavior.YAW_CONTROL
        elif bits & Condition.Q3:
            assert target is Behavior.PATH_TRACKING
        elif bits & Condition.Q4:
            assert target is Behavior.HOVER
        else:
            assert target is state


@given(heights, yaws, distances)
def test_printed_conditions_are_the_four_lines_of_the_paper(z: float, psi: float, d: float) -> None:
    bits = printed_conditions(z, psi, d, EPS1, EPS2, EPS3)
    q1, q2 = abs(z) > EPS1, abs(psi) > EPS2 and abs(z) < EPS1
    assert bool(bits & Condition.Q1) == q1
    assert bool(bits & Condition.Q2) == q2
    assert bool(bits & Condition.Q3) == (not q1 and not q2 and d > EPS3)
    assert bool(bits & Condition.Q4) == (d < EPS3)
    assert bits == printed_conditions.py_func(z, psi, d, EPS1, EPS2, EPS3)  # type: ignore[attr-defined]


def test_printed_conditions_overlap_and_leave_gaps_as_the_paper_does() -> None:
    assert printed_conditions(1.0, 0.0, 0.1, EPS1, EPS2, EPS3) == Condition.Q1 | Condition.Q4
    assert printed_conditions(0.0, 0.0, EPS3, EPS1, EPS2, EPS3) == 0


@given(states, heights, yaws, distances)
def test_mended_conditions_always_hold_exactly_one_at_a_time(
    state: Behavior, z: float, psi: float, d: float
) -> None:
    bits = steady_conditions(STATES.index(state), z, psi, d, EPS1, 0.35, 0.15)
    assert bin(bits).count("1") == 1
    assert bits == steady_conditions.py_func(STATES.index(state), z, psi, d, EPS1, 0.35, 0.15)  # type: ignore[attr-defined]


@given(states, heights, yaws, distances, st.booleans())
def test_every_input_has_one_next_state_in_both_modes(
    state: Behavior, z: float, psi: float, d: float, paper: bool
) -> None:
    acceptor = Acceptor(STATES.index(state), 0.0)
    once = looked(acceptor, (z, psi, d), 1.0, paper)
    assert once == looked(acceptor, (z, psi, d), 1.0, paper)
    assert once.state in list(AcceptorState)


@given(states, heights, yaws, distances)
def test_hysteresis_never_leaves_a_state_that_it_would_enter_again_at_once(
    state: Behavior, z: float, psi: float, d: float
) -> None:
    first = looked(Acceptor(STATES.index(state), 0.0), (z, psi, d), 1.0)
    second = looked(first, (z, psi, d), 2.0)
    third = looked(second, (z, psi, d), 3.0)
    assert third.state == second.state


def test_dwell_holds_a_state_for_a_while_but_never_holds_up_rest() -> None:
    fresh = Acceptor(int(AcceptorState.YAW_CONTROL), since=1.0)
    assert acceptor_advanced(fresh, Condition.Q3, 1.2, 0.3) == fresh
    tracking = Acceptor(int(AcceptorState.PATH_TRACKING), since=1.3)
    assert acceptor_advanced(fresh, Condition.Q3, 1.3, 0.3) == tracking
    assert acceptor_advanced(fresh, REST, 1.1, 0.3).state == AcceptorState.HOVER


def test_noise_of_half_a_degree_chatters_at_the_printed_epsilon_and_not_at_ours() -> None:
    noise = [radians(0.5) * (-1.0) ** n * (n % 3) for n in range(300)]
    switches = {}
    for paper in (True, False):
        acceptor, switches[paper] = Acceptor(0, 0.0), 0
        for n, yaw in enumerate(noise):
            before, dwell = acceptor, 0.0 if paper else CONTROL.dwell
            acceptor = looked(acceptor, (0.0, yaw, 1.0), 0.01 * n, paper, dwell)
            switches[paper] += acceptor.state != before.state
    assert switches[True] > 100
    assert switches[False] <= 1


def test_the_description_names_every_pair_of_states_once() -> None:
    lines = described().splitlines()
    assert len(lines) == 16
    assert "hover -> altitudeControl: Q1" in lines
    assert "pathTracking -> hover: Q4, REST" in lines


@pytest.mark.parametrize("state", AcceptorState)
def test_nothing_to_track_means_hover(state: AcceptorState) -> None:
    conditions = Condition.REST | Condition.Q1
    assert acceptor_advanced(Acceptor(int(state), 0.0), conditions, 5.0, 0.0).state == 0
