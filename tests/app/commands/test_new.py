"""A newcomer types a room, and it flies: ``housefly new`` in a real terminal."""

from __future__ import annotations

import shlex
import subprocess
from pathlib import Path

import pytest
from new_site_run import CTRL_C, HOUSEFLY, flown, typed_site

from housefly.cli import main
from housefly.sites.loaded_site import load_site

KEYS_IN_TEN_MINUTES = 600
"""One key a second; the typing of a newcomer who thinks in between."""


@pytest.fixture(autouse=True)
def own_state(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Keep these sites away from the memory of a room that runs meanwhile."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))


@pytest.mark.slow
@pytest.mark.usefixtures("no_report")
def test_an_empty_rectangle_is_typed_with_few_keys_and_a_service_lands(tmp_path: Path) -> None:
    done = typed_site(tmp_path / "mylab", "6x4x2.5", "", "", "", "", "", "crazyflie")
    assert done.status == 0, done.shown
    assert done.keys < KEYS_IN_TEN_MINUTES / 10
    assert "housefly doctor --site mylab" in done.shown
    assert "housefly fly far --headless --lockstep --site mylab" in done.shown
    assert flown(done.folder) == "completed"


def test_ctrl_c_loses_nothing_and_the_same_line_goes_on(tmp_path: Path) -> None:
    broken = typed_site(tmp_path / "mylab", "6x4x2.5", "table 3,1 1x1x.7", CTRL_C)
    assert broken.status == 130, broken.shown
    assert "go on with: housefly new mylab" in broken.shown
    assert not (tmp_path / "mylab" / "site.toml").exists()
    done = typed_site(tmp_path / "mylab", "", "", "", "", "", "")
    assert done.status == 0, done.shown
    room = load_site(str(tmp_path / "mylab")).room
    assert room.bounds == (0.0, 0.0, 6.0, 4.0)
    assert "table" in {solid.thing for solid in room.solids}


def test_a_script_answers_through_a_pipe(tmp_path: Path) -> None:
    done = subprocess.run(
        [*HOUSEFLY, "new", "mylab"],
        input="6x4\n\n1,2\nkitchen 5,2\n\n\nsimulated\n\n",
        cwd=tmp_path, capture_output=True, text=True, timeout=100.0, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert [p.name for p in load_site(str(tmp_path / "mylab")).room.places] == ["home", "kitchen"]


def test_options_describe_a_real_room_without_a_question(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "mylab"
    options = ["--room", "6x4", "--pad", "1,2", "--place", "kitchen 5,2", "--drone", "192.168.1.1",
               "--tracking", "vicon 10.0.0.5", "--point", "1,2 = 0,0,.05",
               "--point", "5,2 = 4,0,.05", "--point", "1,3.5 = 0,1.5,.05"]  # fmt: skip
    assert main(["new", str(folder), *options, "--yes", "--no-test"]) == 0
    site = load_site(str(folder)).site
    assert (site.tracking.x, site.tracking.y, site.tracking.yaw) == (1.0, 2.0, 0.0)
    assert "simulated.toml" in capsys.readouterr().out
    assert load_site(str(folder / "simulated.toml")).site.twin.enabled


def test_a_refused_option_ends_with_words_and_keeps_what_was_there(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "mylab"
    assert main(["new", str(folder), "--room", "6x4", "--pad", "0,0", "--yes"]) == 2
    assert "the drone cannot start at (0.00, 0.00) m" in capsys.readouterr().err
    assert main(["new", str(folder), "--pad", "1,2", "--yes"]) == 0


def test_a_ros_map_is_taken_as_it_is(shared_data: Path, tmp_path: Path) -> None:
    path = shared_data / "rooms" / "small_house" / "map.yaml"
    assert main(["new", str(tmp_path / "house"), "--room", str(path), "--yes"]) == 0
    loaded = load_site(str(tmp_path / "house"))
    assert all(loaded.plan(place.name).path for place in loaded.room.places[1:])


def test_a_draft_of_another_program_is_refused_and_left_alone(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "draft.json").write_text("[1, 2]")
    assert main(["new", str(tmp_path), "--room", "6x4", "--yes"]) == 2
    assert "draft.json" in capsys.readouterr().err
    assert (tmp_path / "draft.json").read_text() == "[1, 2]"


def test_the_help_names_every_way(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["new", "--help"])
    shown = capsys.readouterr().out
    assert all(word in shown for word in ("--page", "--yes", "Ctrl-C", "map.yaml", "scan.ply"))


def test_the_next_commands_can_be_pasted_whatever_the_name(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["new", "K\u00fcche 'x'", "--room", "6x4", "--yes"]) == 0
    shown = capsys.readouterr().out
    lines = [line for line in shown.splitlines() if line.startswith("  housefly ")]
    assert len(lines) == 3
    for line in lines:
        assert shlex.split(line)[-1] == "K\u00fcche 'x'"


@pytest.mark.parametrize("name", ["", "  "])
def test_a_site_without_a_name_is_not_written_here(
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    name: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["new", name, "--room", "6x4", "--yes"]) == 2
    assert "argument 2: is empty" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []
