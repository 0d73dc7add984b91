"""Margins of the sampled loop, against the simulated edge and against simpler loops."""

from __future__ import annotations

from dataclasses import replace
from math import degrees, inf

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.config.estimation import ONLY_LEVEL_PUSHES
from housefly.config.site import Site
from housefly.lab.experiments.cases import Cases, cases
from housefly.lab.experiments.engine import fly_many
from housefly.lab.experiments.flight_plan import SETTLE, FlightPlan, Task
from housefly.lab.tuning.loop import Loop, period_of, timing_of
from housefly.lab.tuning.margins import (
    delay_margin,
    gain_margin,
    is_stable,
    margins_of,
    phase_margin,
)
from housefly.pilot.estimation.estimator_state import EstimatorKind

STEP = 0.02
"""So small that nothing saturates [m]."""
POINTS = [
    Loop(2.4, 1.44, lag=5.0, delay=0.06, tracking_hz=100.0, latency=0.02),
    Loop(3.6, 3.24, lag=7.0, delay=0.06, tracking_hz=30.0, latency=0.05),
    Loop(3.6, 3.24, lag=10.0, delay=0.03, tracking_hz=10.0, latency=0.1),
    Loop(4.0, 4.0, lag=7.0, delay=0.06, tracking_hz=50.0, latency=0.0),
]
POINTS = [replace(loop, paper=paper) for paper in (False, True) for loop in POINTS]


def name_of(loop: Loop) -> str:
    mode = "paper" if loop.paper else "default"
    return f"{mode}-lag{loop.lag:g}-{loop.tracking_hz:g}Hz-{1000 * loop.latency:g}ms"


def settles(loop: Loop, **truth: float) -> bool:
    """Fly the batch engine's nonlinear loop; frames fall anywhere between ticks."""
    drones = 6
    case: Cases = cases(
        Site(estimation=ONLY_LEVEL_PUSHES),
        drones,
        seed=np.arange(drones),
        estimator=EstimatorKind.ON_ARRIVAL if loop.paper else EstimatorKind.DELAY_COMPENSATED,
        alpha=loop.alpha,
        beta=loop.beta,
        model_lag=loop.lag,
        model_delay=loop.delay,
        model_drag=loop.drag,
        drag=loop.drag,
        position_noise=loop.position_noise,
        acceleration_noise=loop.acceleration_noise,
        mocap_rate_hz=loop.tracking_hz,
        mocap_latency=loop.latency,
        mocap_jitter=0.0,
        mocap_noise=1e-9,
        tilt_max=0.5,
        pose_age_level=10.0,
        pose_age_land=20.0,
        **{"lag": loop.lag, "delay": loop.delay, **truth},
    )
    flown = fly_many(case, FlightPlan(Task.STEP, ((0.0, 0.0), (STEP, 0.0)), SETTLE + 60.0))
    return bool((flown["residual"] < 0.2 * STEP).all())


def simulated_edge(loop: Loop, column: str, inside: float, outside: float) -> float:
    while outside - inside > 0.004 * outside:
        middle = 0.5 * (inside + outside)
        inside, outside = (
            (middle, outside) if settles(loop, **{column: middle}) else (inside, middle)
        )
    return 0.5 * (inside + outside)


@pytest.mark.parametrize("loop", POINTS, ids=name_of)
def test_the_gain_margin_is_the_simulated_edge_within_five_percent(loop: Loop) -> None:
    expected = gain_margin(loop)
    assert simulated_edge(loop, "gain", 1.0, 1.6 * expected) == pytest.approx(expected, rel=0.05)


@pytest.mark.parametrize("loop", POINTS, ids=name_of)
def test_the_delay_margin_is_the_simulated_edge_within_five_percent(loop: Loop) -> None:
    expected = delay_margin(loop)
    edge = simulated_edge(loop, "delay", loop.delay, min(0.5, loop.delay + 1.6 * expected))
    assert edge - loop.delay == pytest.approx(expected, rel=0.05)


def test_a_wrong_delay_in_the_analysis_would_be_noticed() -> None:
    loop = POINTS[0]
    mistaken = gain_margin(replace(loop, delay=loop.delay + 0.03, model_delay=loop.delay))
    assert abs(mistaken / simulated_edge(loop, "gain", 1.0, 8.0) - 1.0) > 0.05


# Continuous time, exact velocity, no tracking: s^3 + lambda s^2 + c alpha s + c beta with a delay
# (docs/paper.md, trap 15).
@pytest.mark.parametrize(
    ("lag", "frequency", "damping", "delay_ms"),
    [
        (5.0, 0.8, 1.0, 646), (5.0, 1.2, 1.0, 392), (3.0, 2.0, 0.8, 153), (8.0, 1.6, 1.0, 308),
    ],
)  # fmt: skip
def test_with_perfect_tracking_the_delay_margin_is_that_of_the_continuous_loop(
    lag: float, frequency: float, damping: float, delay_ms: int
) -> None:
    fast = Loop(
        2 * damping * frequency, frequency**2, lag, delay=0.0, drag=0.0,
        tracking_hz=200.0, latency=0.0, rate_hz=200.0,
        paper=True, acceleration_noise=50.0, position_noise=0.00005,
    )  # fmt: skip
    # Sampling, hold and the finite difference inside the filter cost about one tick.
    assert 1000 * delay_margin(fast) == pytest.approx(delay_ms, abs=12)


@settings(max_examples=25, deadline=None)
@given(st.floats(0.5, 9.0), st.floats(0.2, 60.0), st.floats(2.0, 12.0))
def test_with_perfect_tracking_stability_ends_where_routh_says(
    alpha: float, beta: float, lag: float
) -> None:
    fast = Loop(
        alpha, beta, lag, delay=0.0, drag=0.0, tracking_hz=200.0, latency=0.0, rate_hz=200.0,
        paper=True, acceleration_noise=50.0, position_noise=0.00005,
    )  # fmt: skip
    share = beta / (lag * alpha)
    if share < 0.8 and alpha < 6.0:
        assert period_of(fast).growth < 1.0
    if share > 1.1:
        assert period_of(fast).growth > 1.0


@settings(max_examples=2, deadline=None)
@given(
    st.floats(0.6, 1.8),
    st.floats(4.0, 12.0),
    st.floats(0.0, 0.08),
    st.sampled_from([10.0, 30.0, 50.0, 100.0]),
    st.booleans(),
)
def test_more_latency_never_buys_margin_on_mode_papers_filter(
    frequency: float, lag: float, delay: float, rate: float, more: bool
) -> None:
    early = Loop(2 * frequency, frequency**2, lag, delay, tracking_hz=rate, latency=0.0, paper=True)
    late = replace(early, latency=0.1 if more else 0.05)
    assert gain_margin(late) <= gain_margin(early) * 1.01
    assert delay_margin(late) <= delay_margin(early) * 1.01


def test_an_unstable_loop_has_no_margins() -> None:
    assert margins_of(
        Loop(20.0, 100.0, lag=5.0, delay=0.1, tracking_hz=10.0, latency=0.1, paper=True)
    ) == (1.0, 0.0, 0.0)


def test_the_three_margins_are_each_on_the_edge() -> None:
    loop = POINTS[1]
    gain, phase, delay = margins_of(loop)
    for share, stable in ((0.98, True), (1.02, False)):
        assert is_stable(replace(loop, factor=1.0 + share * (gain - 1.0))) is stable
        assert is_stable(replace(loop, factor=np.exp(-1j * share * phase))) is stable
        assert (
            is_stable(replace(loop, delay=loop.delay + share * delay, model_delay=loop.delay))
            is stable
        )
    assert 20.0 < degrees(phase_margin(loop)) < 90.0
    assert delay < inf


@given(st.floats(5.0, 400.0), st.sampled_from([50.0, 100.0, 200.0]))
def test_any_rate_has_a_common_period_close_to_it(rate: float, loop_hz: float) -> None:
    timing = timing_of(Loop(1.0, 0.3, 7.0, 0.06, tracking_hz=rate, rate_hz=loop_hz))
    assert 1.0 / timing.interval == pytest.approx(rate, rel=0.03)
    assert timing.ticks * timing.tick == pytest.approx(timing.frames * timing.interval)
