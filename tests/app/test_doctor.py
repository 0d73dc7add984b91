"""The doctor looks at the room, too: a site passes only where every place can be flown to."""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import pytest

from housefly.app import doctor
from housefly.app.doctor import check_room
from housefly.cli import main
from housefly.config.site import Site, changed
from housefly.room.bsen import bsen
from housefly.room.files import save_room
from housefly.sites.loaded_site import read_site


def site_with(folder: Path, **changes: object) -> Site:
    save_room(replace(bsen(), **changes), folder)  # type: ignore[arg-type]
    return changed(read_site("bsen"), room__model=str(folder))


def test_the_shipped_room_passes() -> None:
    assert check_room(read_site("bsen")).well


def test_a_place_without_a_way_and_a_pad_in_a_wall_are_told_with_a_mend(tmp_path: Path) -> None:
    places = bsen().places
    in_wall = next(solid for solid in bsen().solids if solid.thing == "wall").position[:2]
    lost = replace(places[1], viewpoint=in_wall)
    found = check_room(site_with(tmp_path / "a", places=(places[0], lost)))
    assert not found.well
    assert f"no way leads to {lost.name}" in found.found and "housefly room show" in found.remedy
    walled = replace(places[0], viewpoint=in_wall)
    found = check_room(site_with(tmp_path / "b", places=(walled,), home=in_wall))
    assert not found.well
    assert "the drone cannot start" in found.found


def test_a_room_that_cannot_be_read_is_told(tmp_path: Path) -> None:
    found = check_room(changed(read_site("bsen"), room__model=str(tmp_path)))
    assert not found.well
    assert "room.toml" in found.found


def test_a_missing_simulator_is_a_lack_only_of_a_simulated_room_and_its_command_is_whole(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "mujoco", None)
    monkeypatch.setattr(doctor, "check_machine", lambda site: (doctor._physics(site),))
    monkeypatch.setenv("COLUMNS", "120")
    assert main(["doctor"]) == 1
    assert "pip install 'housefly[twin]'" in capsys.readouterr().out
    real = tmp_path / "real.toml"
    real.write_text("[twin]\nenabled = false\n")
    assert main(["doctor", "--site", str(real)]) == 0
    assert "note" in capsys.readouterr().out
