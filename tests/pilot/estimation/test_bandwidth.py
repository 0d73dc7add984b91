from __future__ import annotations

from math import nan

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.pilot.estimation.bandwidth import GAIN_MARGIN, bandwidth

shares = st.floats(0.1, 1.0)
times = st.floats(0.0, 0.3)


@given(times, times, st.floats(0.005, 0.2), shares, st.floats(0.001, 0.1))
def test_whatever_is_later_or_rarer_makes_the_loop_softer(
    delay: float, latency: float, interval: float, mistrust: float, more: float
) -> None:
    wn = bandwidth(delay, latency, interval, 7.0, mistrust)
    assert bandwidth(delay + more, latency, interval, 7.0, mistrust) < wn
    assert bandwidth(delay, latency + more, interval, 7.0, mistrust) < wn
    assert bandwidth(delay, latency, interval + more, 7.0, mistrust) < wn


def test_the_gains_of_the_site_stand_with_its_own_tracking() -> None:
    assert bandwidth(0.06, 0.02, 0.01, 7.0, 0.3) > 1.8


def test_ten_hertz_and_a_tenth_of_a_second_late_lower_them() -> None:
    assert bandwidth(0.1, 0.1, 0.1, 7.0, 0.3) == pytest.approx(1.64, abs=0.05)


def test_what_is_not_known_yet_does_not_count() -> None:
    assert bandwidth(0.06, nan, nan, 7.0, 0.3) == bandwidth(0.06, 0.0, 0.0, 7.0, 0.3)


@pytest.mark.parametrize("delta", [0.03, 0.08, 0.2])
def test_the_small_gain_bound_holds_and_is_tight(delta: float) -> None:
    """Against the characteristic equation s^2 + (2 wn s + wn^2) exp(-s delta), by Nyquist."""
    wn = GAIN_MARGIN * bandwidth(0.0, 0.0, 2.0 * delta, 1e9, 0.0)
    assert is_stable(wn, delta)
    assert not is_stable(2.0 * wn, delta)


def is_stable(wn: float, delta: float) -> bool:
    """Whether the phase at the crossing of gain one is above -180 degrees."""
    w = np.geomspace(0.01, 500.0, 200_000)
    gain = np.hypot(2.0 * wn * w, wn * wn) / w**2
    crossing = w[np.argmax(gain < 1.0)]
    return bool(np.arctan2(2.0 * crossing, wn) > crossing * delta)
