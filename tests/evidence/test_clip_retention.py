"""A clock that leaps deletes no clip, and what takes too much space is said in words."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from clip_rows import DAY, NOW, added, clip, found
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.config.tasks import TasksConfig
from housefly.evidence.clip_clock import (
    CLOCK_STEP_MAX,
    PROOF_TIME,
    RESTART_LEAP_MAX,
    BelievedTime,
    ClockWatch,
)
from housefly.evidence.clip_index import ClipIndex

CONFIG = TasksConfig(clip_days=30, snapshot_days=90, clip_space_gb=0.01)


class Clock:
    """A wall clock that the test sets."""

    def __init__(self) -> None:
        self.now = NOW

    def __call__(self) -> float:
        return self.now


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def index(tmp_path: Path, clock: Clock) -> Iterator[ClipIndex]:
    made = ClipIndex(tmp_path, CONFIG, clock)
    yield made
    made.close()


def test_a_clock_that_leaps_ahead_deletes_nothing_and_is_said(
    index: ClipIndex, tmp_path: Path, clock: Clock
) -> None:
    name = added(index, tmp_path, clip(NOW - DAY))
    assert index.tidy() == ()
    assert index.notices == ()
    clock.now = NOW + 400 * DAY
    assert index.tidy() == ()
    (notice,) = index.notices
    assert "the clock went on by 400 days at once" in notice
    clock.now = NOW + 600.0
    assert index.tidy() == ()
    assert index.notices == ()
    assert found(index) == [name]


def test_after_a_long_pause_the_clock_is_believed_a_day_later(
    index: ClipIndex, tmp_path: Path, clock: Clock
) -> None:
    name = added(index, tmp_path, clip(NOW - DAY))
    clock.now = NOW + 40 * DAY
    assert index.tidy() == ()
    index.close()
    again = ClipIndex(tmp_path, CONFIG, clock)
    clock.now += PROOF_TIME - 60.0
    assert again.tidy() == ()
    clock.now += 120.0
    assert again.tidy() == (name,)
    assert again.notices == ()
    again.close()


def test_a_person_who_says_that_the_clock_is_right_is_believed_at_once(
    index: ClipIndex, tmp_path: Path, clock: Clock
) -> None:
    name = added(index, tmp_path, clip(NOW - DAY))
    clock.now = NOW + 40 * DAY
    assert index.tidy() == ()
    assert index.tidy(is_right=True) == (name,)


def test_a_clip_of_a_clock_that_was_ahead_does_not_stay_for_ever(
    index: ClipIndex, tmp_path: Path, clock: Clock
) -> None:
    name = added(index, tmp_path, clip(NOW + 4000 * DAY))
    assert index.tidy() == ()
    assert index.info(name).keep_until == pytest.approx(NOW + 30 * DAY)
    gone: list[str] = []
    for day in range(1, 32):
        clock.now = NOW + day * DAY
        gone += index.tidy()
        assert gone == ([name] if day >= 30 else [])


@settings(max_examples=300)
@given(
    st.lists(
        st.tuples(
            st.floats(60, 5 * DAY),
            st.floats(-900 * DAY, 4000 * DAY),
            st.floats(60, PROOF_TIME - CLOCK_STEP_MAX),
        ),
        max_size=6,
    )
)
def test_a_clock_that_is_wrong_for_less_than_a_day_at_a_time_makes_nothing_older(
    leaps: list[tuple[float, float, float]],
) -> None:
    """True time passes; now and then the clock shows something else, and goes back."""
    known, watch, true, wrong = BelievedTime(NOW), ClockWatch(), NOW, 0.0
    until = NOW
    for pause, offset, lasts in (*leaps, (3 * DAY, 0.0, 60.0)):
        for wrong, span in ((0.0, pause), (offset, lasts)):
            until = true + span
            while true < until:
                known = known.after(watch.read(true + wrong, true))
                assert known.believed <= true + RESTART_LEAP_MAX + (len(leaps) + 1) * CLOCK_STEP_MAX
                true = min(until, true + 0.3 * DAY)
    known = known.after(watch.read(true, true))
    end = true + PROOF_TIME + 1.0
    known = known.after(watch.read(end, end))
    assert known == BelievedTime(end), "in the end the right time is believed"


def test_kept_clips_over_the_budget_are_said_until_some_are_deleted(
    index: ClipIndex, tmp_path: Path
) -> None:
    first = added(index, tmp_path, clip(NOW - 100), 8_000_000)
    second = added(index, tmp_path, clip(NOW - 50), 8_000_000)
    index.keep(first, "anna")
    assert "kept until somebody deletes it" in index.notices[0], "at once, not in ten minutes"
    index.keep(second, "anna")
    index.tidy()
    (notice,) = index.notices
    assert "clips take 0.016 GB, more than tasks.clip_space_gb = 0.01" in notice
    index.delete(first, "anna")
    assert index.notices == ()
