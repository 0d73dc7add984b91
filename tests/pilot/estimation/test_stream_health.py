from __future__ import annotations

from math import nan

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.pilot.estimation.stream_health import StreamHealth, health_updated

UNKNOWN = StreamHealth(nan, nan, nan, nan)


@given(st.floats(0.005, 0.2), st.floats(0.0, 0.2), st.floats(0.0, 5.0), st.floats(0.0, 5.0))
def test_a_steady_stream_is_told_as_it_is(
    interval: float, latency: float, nis: float, height_nis: float
) -> None:
    h = UNKNOWN
    for _ in range(5):
        h = health_updated(h, interval, latency, nis, height_nis)
    assert tuple(h) == pytest.approx((interval, latency, nis, height_nis))


def test_a_change_shows_after_some_seconds() -> None:
    h = health_updated(UNKNOWN, 0.01, 0.02, 1.0, 1.0)
    for _ in range(60):
        h = health_updated(h, 0.1, 0.12, 4.0, 1.0)
    assert h.interval == pytest.approx(0.1, abs=0.015)
    assert h.latency == pytest.approx(0.12, abs=0.015)
    assert h.nis == pytest.approx(4.0, abs=0.5)


def test_squares_of_normal_numbers_average_to_one() -> None:
    h, noise = UNKNOWN, np.random.default_rng(1)
    for square in noise.normal(size=3000) ** 2:
        h = health_updated(h, 0.01, 0.02, float(square), 1.0)
    assert h.nis == pytest.approx(1.0, abs=0.3)
