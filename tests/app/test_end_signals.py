"""One wish to end, however often it comes."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Iterator

import pytest

from housefly.app.end_signals import EndSignals

NUMBERS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


@pytest.fixture(autouse=True)
def heard_hangup() -> Iterator[None]:
    """Hear SIGHUP although the tests themselves may run under nohup."""
    before = signal.signal(signal.SIGHUP, signal.SIG_DFL)
    yield
    signal.signal(signal.SIGHUP, before)


@pytest.mark.parametrize("first", NUMBERS)
@pytest.mark.parametrize("later", NUMBERS)
def test_the_first_signal_interrupts_and_no_later_one_does(first: int, later: int) -> None:
    with EndSignals() as signals:
        with pytest.raises(KeyboardInterrupt):
            os.kill(os.getpid(), first)
        for _ in range(5):
            os.kill(os.getpid(), later)
        time.sleep(0.6 if later == signal.SIGINT else 0.0)
        os.kill(os.getpid(), later)
        if later != signal.SIGINT:
            assert not signals.is_impatient


@pytest.mark.parametrize("first", [signal.SIGTERM, signal.SIGHUP])
def test_one_ctrl_c_after_another_signal_is_the_first_that_a_person_types(
    first: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("housefly.app.end_signals._is_in_foreground", lambda: True)
    with EndSignals() as signals:
        with pytest.raises(KeyboardInterrupt):
            os.kill(os.getpid(), first)
        time.sleep(0.6)
        os.kill(os.getpid(), signal.SIGINT)
        assert not signals.is_impatient
        time.sleep(0.6)
        os.kill(os.getpid(), signal.SIGINT)
        assert signals.is_impatient


def test_what_is_sent_twice_at_once_is_one_ctrl_c(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("housefly.app.end_signals._is_in_foreground", lambda: True)
    with EndSignals() as signals:
        with pytest.raises(KeyboardInterrupt):
            os.kill(os.getpid(), signal.SIGINT)
        os.kill(os.getpid(), signal.SIGINT)
        assert not signals.is_impatient
        time.sleep(0.6)
        os.kill(os.getpid(), signal.SIGINT)
        assert signals.is_impatient


def test_the_handlers_from_before_come_back() -> None:
    before = [signal.getsignal(number) for number in NUMBERS]
    with EndSignals():
        assert [signal.getsignal(number) for number in NUMBERS] != before
    assert [signal.getsignal(number) for number in NUMBERS] == before


def test_under_nohup_a_closed_terminal_ends_nothing() -> None:
    before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    try:
        with EndSignals():
            os.kill(os.getpid(), signal.SIGHUP)
    finally:
        signal.signal(signal.SIGHUP, before)
