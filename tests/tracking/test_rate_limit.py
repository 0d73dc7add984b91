"""The limit on frames per second."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.tracking.rate_limit import FrameLimiter


@given(st.lists(st.floats(0.0, 0.3), max_size=200), st.integers(1, 20))
def test_never_more_than_twice_the_limit_passes_in_any_second(
    pauses: list[float], most: int
) -> None:
    limiter, now, passed = FrameLimiter(most), 0.0, []
    for pause in pauses:
        now += pause
        if limiter.admits(now):
            passed.append(now)
    for at in passed:
        assert sum(at <= other < at + 1.0 for other in passed) <= 2 * most


def test_what_keeps_within_the_limit_passes() -> None:
    limiter = FrameLimiter(100)
    assert all(limiter.admits(0.01001 * number) for number in range(1000))
