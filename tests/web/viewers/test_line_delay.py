"""How late a page's messages arrive, whatever its clock says."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.web.viewers.viewer import LineDelay


@given(offset=st.floats(-1e5, 1e5), held=st.floats(0.0, 5.0))
def test_what_the_line_holds_up_is_late_whatever_the_pages_clock_says(
    offset: float, held: float
) -> None:
    delay = LineDelay()
    assert delay.lateness(offset, 100.0) == 0.0  # nothing is known yet
    for n in range(5):
        delay.learn(offset + n, 100.02 + n + 0.01 * n)
    assert delay.lateness(offset + 9.0, 109.02 + held) == pytest.approx(held, abs=1e-6)


def test_only_the_last_pings_count_so_a_clock_that_drifts_makes_nothing_late() -> None:
    delay = LineDelay()
    for n in range(4000):
        delay.learn(n * (1.0 - 1e-4), float(n))
    assert delay.lateness(4000 * (1.0 - 1e-4), 4000.0) < 0.002
