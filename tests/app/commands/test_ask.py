"""Asking from the command line while nothing runs: the memory answers."""

from __future__ import annotations

from pathlib import Path

import pytest

from housefly.cli import main


@pytest.fixture(autouse=True)
def _own_state(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path / "run"))


def test_where_answers_from_the_memory_and_says_so(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["where", "sofa"]) == 0
    out = capsys.readouterr().out
    assert "no room is running" in out
    assert "sofa: at (11.75, 2.60, 0.31) m" in out


def test_a_thing_that_nobody_knows_is_refused_with_a_suggestion(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["where", "soffa"]) == 2
    assert "sofa" in capsys.readouterr().err


def test_an_empty_history_says_since_when(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["history", "--since", "10m"]) == 0
    assert "nothing happened since" in capsys.readouterr().out


def test_a_bad_time_is_told_with_what_is_allowed(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["history", "--since", "whenever"]) == 2
    assert "a time of day (10:02)" in capsys.readouterr().err


def test_sensors_are_not_well_when_nothing_runs(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["sensors"]) == 1
    assert "no sensor is running" in capsys.readouterr().out


def test_watching_nothing_is_told_with_what_to_do(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["watch"]) == 2
    assert "housefly demo" in capsys.readouterr().err
