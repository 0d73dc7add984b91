from __future__ import annotations

from math import exp, pi

import numpy as np
import pytest
from ardrone_flow import FLOW
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.pilot.estimation.flow_bias import (
    bias_predicted,
    bias_updated,
    first_bias,
    parted_from,
)
from housefly.pilot.estimation.flow_model import flow_bias_variance

NOISE = 0.002


@settings(max_examples=50)
@given(st.floats(0.01, 30.0), st.integers(1, 40))
def test_many_short_predictions_are_one_long_one(seconds: float, steps: int) -> None:
    start = first_bias(1.0, 2.0, NOISE, FLOW)._replace(rate_x=0.004, rate_y=-0.002)
    together, apart = bias_predicted(start, seconds, 0.0, 1e-5, 0.0, FLOW), start
    for _ in range(steps):
        apart = bias_predicted(apart, seconds / steps, 0.0, 1e-5 / steps, 0.0, FLOW)
    assert np.asarray(apart) == pytest.approx(np.asarray(together), rel=1e-6, abs=1e-12)


@settings(max_examples=50)
@given(st.floats(0.01, 30.0))
def test_who_knows_nothing_expects_the_spread_of_a_whole_flight(seconds: float) -> None:
    unknown = bias_predicted(first_bias(0.0, 0.0, 0.0, FLOW), seconds, 0.0, 0.0, 0.0, FLOW)
    assert unknown.variance == pytest.approx(flow_bias_variance(FLOW, seconds), rel=1e-6)
    assert unknown.rate_variance == pytest.approx(FLOW.bias**2)


def test_a_bias_that_stays_is_learned_and_carried_on() -> None:
    bias, white = first_bias(0.0, 0.0, NOISE, FLOW), 4e-6 * 0.05
    for row in range(1, 101):
        bias = bias_predicted(bias, 0.05, 0.0, white, 0.0, FLOW)
        bias = bias_updated(bias, 0.006 * 0.05 * row, 0.0, NOISE)
    assert 0.004 < bias.rate_x <= 0.006 and bias.rate_y == 0.0
    assert bias.rate_variance < 0.5 * FLOW.bias**2
    later = bias_predicted(bias, 2.0, 0.0, 0.0, 0.0, FLOW)
    assert 0.007 < later.x - bias.x < 0.012
    assert later.variance < 0.5 * flow_bias_variance(FLOW, 2.0)


def test_the_bias_turns_with_the_drone() -> None:
    bias = first_bias(0.0, 0.0, NOISE, FLOW)._replace(rate_x=0.004)
    turned = bias_predicted(bias, 1.0, pi / 2, 0.0, 0.0, FLOW)
    keep = exp(-1.0 / FLOW.bias_time)
    assert (turned.rate_x, turned.rate_y) == pytest.approx((0.0, 0.004 * keep), abs=1e-12)
    assert turned.x == pytest.approx(turned.y)


def test_a_change_of_velocity_makes_it_less_sure() -> None:
    bias = first_bias(0.0, 0.0, NOISE, FLOW)
    flown = bias_predicted(bias, 0.05, 0.0, 0.0, 0.001, FLOW)
    assert flown.rate_variance == pytest.approx(FLOW.bias**2 + 0.001)


def test_how_far_a_place_is_from_the_expected_one() -> None:
    assert parted_from(first_bias(1.0, 1.0, NOISE, FLOW), 1.3, 0.6) == pytest.approx(0.5)
