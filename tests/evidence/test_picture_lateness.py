"""How late a picture is, by the stamp of the drone."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.evidence.picture_lateness import PictureLateness
from housefly.messages import VideoFrame

PERIOD = 1 / 30


def picture(received_at: float, drone_time: float) -> VideoFrame:
    return VideoFrame(b"", False, 640, 360, 1, received_at, drone_time)


@given(
    st.lists(st.floats(0.0, 2.0), min_size=1, max_size=60),
    st.floats(1.0, 1e6),
    st.floats(0.0, 1e5),
)
def test_each_picture_is_as_late_as_it_waited_longer_than_the_quickest_so_far(
    waits: list[float], booted: float, now: float
) -> None:
    lateness, arrived, least = PictureLateness(), 0.0, 10.0
    for n, wait in enumerate(waits):
        arrived = max(arrived, now + n * PERIOD + wait)
        delay = arrived - now - n * PERIOD
        least = min(least, delay)
        told = lateness.of(picture(arrived, booted + n * PERIOD))
        assert told == pytest.approx(delay - least, abs=1e-6)


def test_a_burst_after_a_stall_is_late_and_what_comes_after_it_is_not() -> None:
    lateness = PictureLateness()
    for n in range(30):
        assert lateness.of(picture(100.0 + n * PERIOD, 7.0 + n * PERIOD)) == pytest.approx(0.0)
    stalled = [lateness.of(picture(101.8, 8.0 + n * PERIOD)) for n in range(24)]
    assert stalled[0] == pytest.approx(0.8)
    assert stalled[-1] == pytest.approx(0.8 - 23 * PERIOD)
    assert lateness.of(picture(101.85, 8.85)) == pytest.approx(0.0)


def test_a_drone_that_starts_again_or_counts_over_is_compared_with_itself_only() -> None:
    lateness = PictureLateness()
    lateness.of(picture(100.0, 4_294_967.0))
    assert lateness.of(picture(100.1, 0.1)) == 0.0
    assert lateness.of(picture(100.4, 0.2)) == pytest.approx(0.2)


def test_what_was_quick_half_a_minute_ago_counts_no_longer() -> None:
    lateness = PictureLateness()
    lateness.of(picture(100.0, 50.0))
    assert lateness.of(picture(129.0, 78.5)) == pytest.approx(0.5)
    assert lateness.of(picture(131.0, 80.5)) == 0.0


def test_without_stamps_nothing_is_known_of_lateness() -> None:
    lateness = PictureLateness()
    assert [lateness.of(picture(at, 0.0)) for at in (1.0, 3.0)] == [0.0, 0.0]
