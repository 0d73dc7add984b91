"""Asking from the command line while nothing runs: the memory answers."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from housefly.app.commands import ask
from housefly.cli import main
from housefly.hub.api.answers import SensorAnswer, SensorsAnswer
from housefly.hub.memory import RoomMemory
from housefly.hub.store.open import open_site_store
from housefly.messages import RoomEvent
from housefly.sites.loaded_site import open_site, read_site


@pytest.fixture(autouse=True)
def _own_state(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path / "run"))


def test_where_answers_from_the_memory_and_says_so(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["where", "sofa"]) == 0
    told = capsys.readouterr()
    assert "no room is running (start one with `housefly demo`)" in told.err
    assert told.out == (
        "sofa: at (11.75, 2.60, 0.31) m, as the catalogue has it, never seen by a sensor\n"
    )


def test_the_things_and_people_of_the_demo_are_known_before_it_ran(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["where", "cup"]) == 0
    assert capsys.readouterr().out == "the cup: never seen by a sensor\n"
    assert main(["ask", "where", "is", "the", "cup"]) == 0
    told = capsys.readouterr()
    assert "no room is running" in told.err and told.out == "Nobody has seen the cup yet.\n"
    assert main(["is", "resident", "up"]) == 3
    assert main(["ask", "look at the sofa"]) == 2
    assert "that needs a running room" in capsys.readouterr().err
    assert main(["tasks", "--services"]) == main(["tasks", "--history"]) == 0
    assert "night_round" in capsys.readouterr().out


def test_a_thing_that_nobody_knows_is_refused_with_a_suggestion(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["where", "soffa"]) == 2
    assert "sofa" in capsys.readouterr().err


def test_an_empty_history_says_since_when(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["history", "--since", "10m"]) == 0
    assert "nothing is kept since" in capsys.readouterr().out


def test_a_bad_time_is_told_with_what_is_allowed(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["history", "--since", "whenever"]) == 2
    assert "a time of day (10:02)" in capsys.readouterr().err


def test_sensors_are_not_well_when_nothing_runs(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["sensors"]) == 1
    assert "only while a room runs" in capsys.readouterr().out


def test_watching_nothing_is_told_with_what_to_do(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["watch"]) == 2
    assert "housefly demo" in capsys.readouterr().err


def test_what_happened_is_told_with_whose_word_it_is(capsys: pytest.CaptureFixture[str]) -> None:
    memory = RoomMemory((), lambda: open_site_store(open_site(read_site("bsen")).site))
    memory.add(RoomEvent("door opened", "entrance", time.time() - 60.0, "situations/doors"))
    memory.close()
    assert main(["history", "--since", "10m"]) == 0
    assert "the entrance was opened" in capsys.readouterr().out
    assert main(["history", "--since", "10m", "--details"]) == 0
    assert "[situations/doors]" in capsys.readouterr().out


def test_what_a_device_says_is_text_and_neither_a_style_nor_the_end_of_the_command(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    said = "topic is 'x[/red][link=http://y]'; :bomb:"
    sensor = SensorAnswer("plug", "power", "Plug", False, 0.0, None, said, {})

    class Room:
        def ask(self, question: object) -> SensorsAnswer:
            return SensorsAnswer((sensor,), "")

    @contextmanager
    def room(options: object) -> Iterator[Room]:
        yield Room()

    monkeypatch.setattr(ask, "asked_room", room)
    assert main(["sensors"]) == 1
    out = "".join(capsys.readouterr().out.split())
    for part in ("x[/red]", "[link=http://y]", ":bomb:"):
        assert part in out
