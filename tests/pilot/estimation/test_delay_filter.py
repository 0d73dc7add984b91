from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.pilot.estimation.delay_filter import (
    COMMAND_SPAN,
    CommandHistory,
    DelayFilterState,
    axes_and_covariance_at,
    axes_at,
    command_recorded,
    delay_filter_advanced,
    delay_filter_created,
    delay_filter_initialized,
    delay_filter_updated,
    history_trimmed,
)
from housefly.pilot.estimation.lagged_axis import (
    AxisCovariance,
    AxisModel,
    AxisState,
    initial_covariance,
    predicted_axis,
    predicted_covariance,
    transition,
    updated_axis,
)

MODEL = AxisModel(7.0, 1.0, 0.58, 2.0, 0.4, 0.2)
FIRST = initial_covariance(9e-6, 0.4)
VARIANCE = 9e-6


class Plan:
    """The filter of a drone first seen at rest at the origin at time 0, and its commands."""

    def __init__(self, delay: float, length: int = 1024) -> None:
        self.spans: CommandHistory = np.zeros(length, COMMAND_SPAN)
        self.delay = delay
        self.commands: list[tuple[float, float, bool]] = []
        self.h = delay_filter_initialized(
            delay_filter_created(self.spans, 0.0, FIRST),
            self.spans,
            MODEL,
            delay,
            0.0,
            0.0,
            0.0,
            FIRST,
        )

    def give(self, at: float, ux: float, flown: bool = True) -> None:
        self.h = delay_filter_advanced(self.h, self.spans, MODEL, self.delay, at)
        command_recorded(self.h, self.spans, ux, 0.0, flown)
        self.commands.append((at, ux, flown))

    def look(self, at: float) -> AxisState:
        return axes_at(self.h, self.spans, MODEL, self.delay, at)[0]

    def see(self, at: float, x: float) -> None:
        there = axes_and_covariance_at(self.h, self.spans, MODEL, self.delay, at)
        self.h = delay_filter_updated(
            self.h, self.spans, MODEL, self.delay, at, there, x, 0.0, VARIANCE
        )


def by_hand(
    plan: Plan, start: float, end: float, axis: AxisState, p: AxisCovariance, piece: float = 0.0005
) -> tuple[AxisState, AxisCovariance]:
    """The same way in tiny steps through a list of commands: nothing cached, no ring."""
    steps = round((end - start) / piece)
    for n in range(steps):
        at = start + (n + 0.5) * piece
        acting = [c for c in plan.commands if c[0] + plan.delay <= at]
        _, u, flown = acting[-1] if acting else (0.0, 0.0, False)
        step = transition(MODEL, flown, piece)
        axis, p = predicted_axis(axis, u if flown else 0.0, step), predicted_covariance(p, step)
    return axis, p


def test_a_command_acts_one_delay_after_it_was_sent() -> None:
    plan = Plan(0.06)
    plan.give(1.0, 1.0)
    assert plan.look(1.06).a == pytest.approx(0.0, abs=1e-9)
    assert plan.look(1.2).a > 0.5


@given(
    st.sampled_from([0.0, 0.013, 0.06, 0.1]),
    st.lists(
        st.tuples(st.floats(-2.0, 2.0), st.booleans(), st.sampled_from([0.01, 0.02, 0.05])),
        min_size=3,
        max_size=25,
    ),
    st.lists(st.sampled_from([0.0, 0.004, 0.02, 0.03]), max_size=4),
)
def test_looking_ahead_agrees_with_tiny_steps_through_all_commands(
    delay: float, series: list[tuple[float, bool, float]], sights: list[float]
) -> None:
    plan, now, capture = Plan(delay), 0.0, 0.0
    axis, p = AxisState(0.0, 0.0, 0.0, 0.0), FIRST
    for n, (u, flown, dt) in enumerate(series):
        now += dt
        if n < len(sights) and now - sights[n] > capture:
            axis, p = by_hand(plan, capture, now - sights[n], axis, p)
            capture = now - sights[n]
            there = axes_and_covariance_at(plan.h, plan.spans, MODEL, delay, capture)
            axis = updated_axis(axis, there.covariance, 0.01 * n, VARIANCE)
            plan.see(capture, 0.01 * n)
            p = plan.h.covariance
        plan.give(now, u, flown)
        assert tuple(plan.look(now)) == pytest.approx(
            tuple(by_hand(plan, capture, now, axis, p)[0]), abs=2e-3
        )
    ahead = by_hand(plan, capture, now + delay, axis, p)[0]
    assert tuple(plan.look(now + delay)) == pytest.approx(tuple(ahead), abs=2e-3)


def test_covariance_through_cached_spans_is_that_of_the_same_steps() -> None:
    plan = Plan(0.0)
    for n, u in enumerate((1.0, -2.0, 0.5)):
        plan.give(0.01 * (n + 1), u)
    plan.give(0.04, 0.0)
    p = FIRST
    for flown in (False, True, True, True):
        p = predicted_covariance(p, transition(MODEL, flown, 0.01))
    assert tuple(
        axes_and_covariance_at(plan.h, plan.spans, MODEL, 0.0, 0.04).covariance
    ) == pytest.approx(tuple(p), rel=1e-9)


def test_before_the_first_command_the_drone_counts_as_not_flown() -> None:
    plan = Plan(0.0)
    plan.spans["x_v"][0] = 0.1
    plan.give(2.0, 1.0)
    assert 0.0 < plan.look(1.0).v < 0.05


def test_a_second_command_at_the_same_time_replaces_the_first() -> None:
    plan = Plan(0.0)
    plan.give(1.0, 1.0)
    plan.give(1.0, 2.0)
    assert plan.h.newest == 1 and plan.spans[1]["ux"] == 2.0


def test_a_ring_that_is_full_moves_the_measurement_on_and_keeps_flying() -> None:
    small, large = Plan(0.06, 64), Plan(0.06)
    for n in range(1, 300):
        for plan in (small, large):
            plan.give(0.01 * n, np.sin(0.05 * n))
    assert small.h.newest - small.h.span < 64
    assert tuple(small.look(3.0)) == pytest.approx(tuple(large.look(3.0)), abs=1e-9)


@given(st.floats(0.001, 0.3))
def test_trimming_changes_nothing_that_is_seen_later(at: float) -> None:
    plan = Plan(0.06)
    for n in range(1, 40):
        plan.give(0.01 * n, 1.0)
    before = plan.look(0.45)
    plan.h = history_trimmed(plan.h, plan.spans, MODEL, 0.06, at)
    assert plan.look(0.45) == before
    assert tuple(axes_and_covariance_at(plan.h, plan.spans, MODEL, 0.06, 0.45).x) == pytest.approx(
        tuple(before), abs=1e-4
    )


def test_compiled_way_equals_the_plain_one() -> None:
    plan = Plan(0.06)
    for n in range(1, 40):
        plan.give(0.01 * n, (-1.0) ** (n // 7))
    twin = _plain_looked(plan.h, plan.spans, 0.06, 0.433)
    assert tuple(plan.look(0.433)) == pytest.approx(tuple(twin), abs=1e-12)


def _plain_looked(h: DelayFilterState, spans: CommandHistory, delay: float, at: float) -> AxisState:
    """Walk from the measurement through every span with plain Python."""
    begin = spans[h.span]
    axis, start = AxisState(*(float(begin[f"x_{name}"]) for name in AxisState._fields)), h.at
    for number in range(h.span, h.newest + 1):
        row = spans[number]
        end = at if number == h.newest else min(at, spans[number + 1]["sent"] + delay)
        left = end - start
        while left > 1e-12:
            whole = number < h.newest and abs(left - row["seconds"]) < 1e-12
            dt = (
                row["seconds"] / row["pieces"]
                if whole
                else min(left, left / np.ceil(left / 0.02 - 1e-9))
            )
            step = transition.py_func(MODEL, bool(row["flown"]), dt)  # type: ignore[attr-defined]
            axis = predicted_axis.py_func(axis, float(row["ux"]), step)  # type: ignore[attr-defined]
            start += dt
            left = end - start
    return axis
