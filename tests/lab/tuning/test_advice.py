"""What the gain advisor recommends, judges and refuses."""

from __future__ import annotations

from dataclasses import replace
from math import radians

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from housefly.geometry import GRAVITY
from housefly.lab.tuning.advice import (
    MIN_DELAY_MARGIN,
    MIN_GAIN_MARGIN,
    MIN_PHASE_MARGIN,
    WRONG_LAG_GAIN_MARGIN,
    WRONG_LAG_PHASE_MARGIN,
    GainQuestion,
    advise,
    judge,
    position_error,
    routh_objection,
)
from housefly.lab.tuning.loop import Loop
from housefly.lab.tuning.rate_loop import rate_loop, rate_margins

DRONE = Loop(1.0, 0.25, lag=7.0, delay=0.06)


@settings(max_examples=8, deadline=None)
@given(
    st.floats(3.0, 12.0),
    st.floats(0.0, 0.12),
    st.sampled_from([10.0, 30.0, 100.0]),
    st.floats(0.0, 0.1),
    st.booleans(),
)
def test_the_recommended_pair_keeps_every_promise(
    lag: float, delay: float, rate: float, latency: float, paper: bool
) -> None:
    question = GainQuestion(
        replace(DRONE, lag=lag, delay=delay, tracking_hz=rate, latency=latency, paper=paper)
    )
    advice = advise(question)
    assume(advice is not None)
    assert advice is not None
    found = advice.judgement
    assert found.objections == ()
    assert found.margins.gain >= MIN_GAIN_MARGIN and found.margins.phase >= MIN_PHASE_MARGIN
    assert found.margins.delay >= max(MIN_DELAY_MARGIN, 1.0 / rate)
    assert all(
        wrong.gain >= WRONG_LAG_GAIN_MARGIN and wrong.phase >= WRONG_LAG_PHASE_MARGIN
        for _, wrong in found.wrong_lag
    )
    assert found.loop.beta < lag * found.loop.alpha
    assert found.loop.beta * question.step <= GRAVITY * 0.2132


@given(st.floats(0.1, 20.0), st.floats(0.1, 100.0), st.floats(1.0, 20.0))
def test_a_pair_is_refused_exactly_where_routh_says(alpha: float, beta: float, lag: float) -> None:
    assert bool(routh_objection(alpha, beta, lag)) is (beta >= lag * alpha)


def test_slower_tracking_gets_no_faster_gains() -> None:
    pairs = [
        advise(GainQuestion(replace(DRONE, tracking_hz=hz, latency=late, paper=True)))
        for hz, late in ((100.0, 0.02), (10.0, 0.1))
    ]
    assert pairs[0] is not None and pairs[1] is not None
    assert pairs[1].judgement.frequency < pairs[0].judgement.frequency


def test_a_step_that_saturates_even_the_slowest_pair_gets_no_advice() -> None:
    assert advise(GainQuestion(DRONE, step=30.0)) is None


def test_the_sites_own_pair_keeps_the_promises_and_a_stiff_one_is_objected_to() -> None:
    assert judge(GainQuestion(replace(DRONE, tracking_hz=100.0)), 3.6, 3.24).objections == ()
    stiff = judge(GainQuestion(replace(DRONE, tracking_hz=10.0, latency=0.1)), 12.0, 36.0)
    assert any("gain margin" in objection for objection in stiff.objections)
    assert any("saturates" in objection for objection in stiff.objections)


def test_more_noise_leaves_more_error() -> None:
    loop = replace(DRONE, alpha=3.6, beta=3.24)
    assert (
        position_error(loop, 0.1)
        > 1.05 * position_error(loop, 0.03)
        > 1.005 * position_error(loop, 0.001)
        > 0.0
    )


@given(st.floats(0.5, 30.0), st.floats(0.01, 0.4))
def test_the_p_laws_keep_their_promises_or_are_the_slowest(pole: float, delay: float) -> None:
    law = rate_loop(pole, delay)
    assert law.gain == pytest.approx(0.1) or (law.phase >= radians(60.0) and law.factor >= 2.5)


def test_the_margins_of_a_p_law_without_lag_are_the_textbooks() -> None:
    law = rate_margins(2.0, 1e6, 0.1)  # L = 2 e^(-0.1 s) / s
    assert law.phase == pytest.approx(radians(90.0) - 0.2, abs=1e-4)
    assert law.factor == pytest.approx(radians(90.0) / 0.2, rel=1e-4)
    assert law.delay == pytest.approx(law.phase / 2.0, rel=1e-4)
