"""Yes or no, who and how often from the command line while nothing runs: the memory answers."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from housefly.app.commands.ask_state import parse_window, split_state
from housefly.cli import main
from housefly.errors import ConfigError
from housefly.hub.memory import RoomMemory
from housefly.hub.store.open import open_site_store
from housefly.messages import Observation
from housefly.sites.loaded_site import open_site, read_site

SITE = """
name = "my flat"

[[mqtt.sensors]]
id = "stove-plug"
kind = "power"
thing = "stove"
state_topic = "zigbee2mqtt/stove-plug"
"""


@pytest.fixture(autouse=True)
def _own_state(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path / "run"))


@pytest.fixture
def flat(tmp_path: Path) -> str:
    """Return a site whose stove last drew 1 420 W ten minutes ago."""
    path = tmp_path / "flat.toml"
    path.write_text(SITE)
    memory = RoomMemory((), lambda: open_site_store(open_site(read_site(str(path))).site))
    at = time.time() - 600.0
    memory.add(Observation("stove-plug", "stove-plug", at, at, facts=(("power", 1420.0),)))
    memory.close()
    return str(path)


def test_a_thing_of_the_site_file_is_asked_about_before_and_after_its_device_spoke(
    flat: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["is", "stove", "on", "--site", flat]) == 3
    assert (
        "I do not know: its sensor has been silent for 10 min; then it drew 1 420 W; nothing"
        " listens to it now"
    ) in capsys.readouterr().out
    assert main(["is", "the", "stove", "on?", "--site", flat, "--at", "599s"]) == 0
    assert "Yes: the stove draws 1 420 W, now" in capsys.readouterr().out
    assert main(["is", "stove", "off", "--site", flat, "--at", "599s"]) == 1


def test_what_is_no_state_is_refused_with_those_that_there_are(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["is", "stove", "boiling"]) == 2
    told = capsys.readouterr().err
    assert "does not end in a state; allowed: a thing, then away, closed, " in told
    assert main(["is", "stove"]) == 2


@pytest.mark.parametrize(
    "said",
    [
        "stove on", "the Stove on?", "is the stove on", "stove on!", "the stove ON .",
        "is the stove still on ?",
    ],
)  # fmt: skip
def test_a_question_is_understood_as_people_say_it(said: str) -> None:
    assert split_state(said.split()) == ("stove", "on")


def test_what_says_not_is_never_taken_for_what_it_denies() -> None:
    assert split_state(["stove", "not", "on"]) == ("stove not", "on")  # nothing is called so
    with pytest.raises(ConfigError):
        split_state(["is", "on"])


def test_who_is_there_while_nothing_runs_is_not_guessed(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["who"]) == 3
    assert "the visitor was never seen by a sensor" in capsys.readouterr().out
    assert main(["who", "visitr"]) == 2


def test_nights_without_a_bed_are_told_so(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["nights"]) == 0
    assert "no bed was occupied, as far as the memory knows" in capsys.readouterr().out
    assert main(["nights", "visitor", "--nights", "2"]) == 0
    assert "nothing was kept of 2 nights" in capsys.readouterr().out
    assert main(["nights", "--nights", "0"]) == 2
    assert "--nights: is 0; allowed: 1 to 366" in capsys.readouterr().err
    assert main(["nights", "--window", "22"]) == 2
    assert "allowed: two hours of the day, such as 22-6" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "thing", "state"),
    [
        ("stove on", "stove", "on"),
        ("the tea bottle empty?", "tea bottle", "empty"),
        ("resident on the floor", "resident", "on the floor"),
        ("Guest IN BED", "guest", "in bed"),
        ("entrance-door open", "entrance-door", "open"),
    ],
)
def test_the_longest_state_at_the_end_counts(words: str, thing: str, state: str) -> None:
    assert split_state(words.split()) == (thing, state)


def test_a_window_is_two_hours_with_or_without_minutes() -> None:
    assert parse_window("22-6") == (22.0, 6.0)
    assert parse_window("22:30-6:15") == (22.5, 6.25)
    for words in ("", "22-", "25-6", "a-b", "1-2-3"):
        with pytest.raises(ConfigError):
            parse_window(words)
