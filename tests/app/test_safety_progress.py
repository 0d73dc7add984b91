"""What is told of the flights of the safety case where the output is no terminal."""

from __future__ import annotations

import pytest

from housefly.app.safety_progress import LINE_PERIOD, SafetyProgress


def test_a_line_is_told_at_once_then_each_minute_and_an_unsafe_flight_when_it_was_flown(
    capsys: pytest.CaptureFixture[str],
) -> None:
    now = 0.0
    with SafetyProgress("flights", 100, 10, clock=lambda: now) as progress:
        assert "flights: 10 of 100, 0 unsafe\n" in capsys.readouterr().out
        for _ in range(9):
            now += LINE_PERIOD / 10
            progress.advance("")
        progress.advance("F13/2cm seed 7: touched the sofa")
        assert capsys.readouterr().out == "unsafe: F13/2cm seed 7: touched the sofa\n"
        now += LINE_PERIOD / 10
        progress.advance("")
        told = capsys.readouterr().out
    assert told == "flights: 21 of 100, 1 unsafe, about 7 min left\n"


def test_where_nothing_is_flown_nothing_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    with SafetyProgress("in real time", 0, 0):
        pass
    assert "in real time" not in capsys.readouterr().out
