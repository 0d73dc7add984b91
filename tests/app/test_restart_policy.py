"""When a dead process is started again, and what is said."""

from __future__ import annotations

import signal
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.app.restart_policy import (
    START_ATTEMPTS,
    START_TIME,
    Death,
    last_words,
    restart_after,
)

outside = st.sampled_from([-signal.SIGKILL, -signal.SIGTERM, -signal.SIGINT, -signal.SIGHUP])
by_itself = st.sampled_from([0, 1, 2, 120, -signal.SIGSEGV, -signal.SIGABRT])


@given(outside, st.floats(0.0, 1e6), st.integers(0, 100))
def test_who_was_killed_is_always_started_again_soon(
    code: int, uptime: float, failures: int
) -> None:
    restart = restart_after(code, uptime, failures)
    assert restart.pause is not None and restart.pause <= 0.5
    assert restart.failures == 0


@given(by_itself, st.floats(START_TIME, 1e6), st.integers(0, START_ATTEMPTS - 1))
def test_who_ran_for_a_while_is_always_started_again(
    code: int, uptime: float, failures: int
) -> None:
    assert restart_after(code, uptime, failures).pause is not None


@given(st.lists(by_itself, min_size=START_ATTEMPTS, max_size=START_ATTEMPTS))
def test_who_cannot_start_waits_longer_each_time_and_is_given_up(codes: list[int]) -> None:
    failures, pauses = 0, []
    for code in codes:
        restart = restart_after(code, 1.0, failures)
        failures = restart.failures
        pauses.append(restart.pause)
    assert pauses[-1] is None
    known = [pause for pause in pauses if pause is not None]
    assert len(known) == START_ATTEMPTS - 1
    assert known == sorted(known) and max(known) > min(known)


def test_last_words_are_the_last_lines_since_the_start(tmp_path: Path) -> None:
    log = tmp_path / "hub.log"
    log.write_text("an earlier life\n")
    since = log.stat().st_size
    log.write_text("an earlier life\none\n\ntwo\nthree\nfour\n")
    assert last_words(log, since) == ("two", "three", "four")
    assert last_words(log, log.stat().st_size) == ()
    assert last_words(tmp_path / "none", 0) == ()


@pytest.mark.parametrize("words", [("hub: disk is full",), ()])
def test_a_death_for_good_quotes_the_process_and_says_what_to_do(words: tuple[str, ...]) -> None:
    text = str(Death("hub", True, words, Path("/logs/hub.log")))
    assert "cannot start" in text and "mend that" in text and "/logs/hub.log" in text
    assert (words[0] if words else "disk full?") in text
