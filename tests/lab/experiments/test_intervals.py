"""Intervals that leave no sample out."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.lab.experiments.intervals import bootstrap_mean, mean


@given(st.lists(st.floats(-1e3, 1e3), min_size=1, max_size=30))
def test_the_bootstrap_holds_every_sample_in_its_mean_and_is_the_same_every_time(
    samples: list[float],
) -> None:
    estimate = bootstrap_mean(samples)
    assert estimate.value == pytest.approx(np.mean(samples))
    assert min(samples) - 1e-9 <= estimate.low <= estimate.high <= max(samples) + 1e-9
    assert bootstrap_mean(samples) == estimate


def test_the_bootstrap_is_close_to_students_interval_for_many_normal_samples() -> None:
    samples = np.random.default_rng(3).normal(2.0, 0.5, 200)
    ours, textbook = bootstrap_mean(samples), mean(samples)
    assert ours.low == pytest.approx(textbook.low, abs=0.01)
    assert ours.high == pytest.approx(textbook.high, abs=0.01)


def test_nothing_has_no_mean() -> None:
    assert np.isnan(bootstrap_mean([]).value)
