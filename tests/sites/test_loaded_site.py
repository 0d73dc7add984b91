"""A start takes the newest edits, says so, and refuses those that do not fit any more."""

from __future__ import annotations

from pathlib import Path

import pytest

from housefly.app.new_runtime import new_runtime
from housefly.config.edits import Edits, NoFlyZone, PlaceEdit
from housefly.config.site import Site, changed
from housefly.config.state import edits_folder
from housefly.errors import ConfigError
from housefly.room.edit_versions import EditVersions
from housefly.room.grid import Cell
from housefly.sites.loaded_site import load_site, open_site, read_site, with_newest_edits

CORNER = PlaceEdit(
    name="corner", title="Reading corner", viewpoint=(6.0, 4.25), look_at=(5.0, 5.0, 1.0)
)
WET = NoFlyZone(rectangle=(5.0, 3.0, 6.0, 4.0), reason="wet floor")


@pytest.fixture
def site(tmp_path: Path) -> Site:
    return read_site("bsen", hub__store=str(tmp_path / "room.db"))


def test_every_process_of_a_run_gets_the_edits_with_the_site(site: Site, tmp_path: Path) -> None:
    EditVersions(edits_folder(site)).save(Edits(places=(CORNER,), zones=(WET,)), 0)
    edited, words = with_newest_edits(site)
    assert words == "places and zones as edited, version 1"
    loaded = open_site(new_runtime(edited, tmp_path).site())
    assert loaded.room.place("corner").title == "Reading corner"
    assert loaded.grid.kind(loaded.grid.cell_of((5.5, 3.5))) is Cell.VIRTUAL


def test_nobody_else_is_influenced_by_what_the_machine_has_saved(site: Site) -> None:
    EditVersions(edits_folder(site)).save(Edits(places=(CORNER,)), 0)
    assert "corner" not in {place.name for place in open_site(site).room.places}


@pytest.mark.parametrize("change", [{"hub__edits": False}, {"mode": "paper"}])
def test_edits_are_switched_off_and_never_apply_to_the_paper(
    site: Site, change: dict[str, object]
) -> None:
    EditVersions(edits_folder(site)).save(Edits(removed=("bed",)), 0)
    other = changed(site, **change)
    assert with_newest_edits(other) == (other, "")


def test_edits_that_do_not_fit_the_room_any_more_stop_the_start_and_say_what_to_do(
    site: Site,
) -> None:
    EditVersions(edits_folder(site)).save(Edits(removed=("cellar",)), 0)
    with pytest.raises(ConfigError, match=r"no place called 'cellar'.*hub.edits = false"):
        with_newest_edits(site)


def test_what_was_undone_does_not_come_back_with_a_site_that_was_recorded_with_it(
    site: Site,
) -> None:
    versions = EditVersions(edits_folder(site))
    recorded = changed(site, edits=versions.save(Edits(removed=("bed",)), 0).edits)
    versions.undo(1)
    assert with_newest_edits(recorded) == (site, "places and zones as edited, version 2")


def test_a_damaged_version_is_told_at_the_start(site: Site) -> None:
    versions = EditVersions(edits_folder(site))
    versions.save(Edits(removed=("bed",)), 0)
    versions.save(Edits(), 1)
    (versions.folder / "0002.json").write_text("")
    edited, words = with_newest_edits(site)
    assert edited.edits == Edits(removed=("bed",)) and "version 1; 0002.json" in words


@pytest.mark.parametrize(
    ("store", "folder"),
    [
        ("/data/room.db", "/data/edits"),
        ("/data/lab.db", "/data/lab-edits"),
        ("postgresql://x@y/z", "/state/housefly/b-sen/edits"),
    ],
)
def test_edits_are_beside_the_rooms_memory(
    monkeypatch: pytest.MonkeyPatch, store: str, folder: str
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", "/state")
    assert edits_folder(changed(Site(), hub__store=store)) == Path(folder)


def test_points_of_a_plan_are_written_as_people_do() -> None:
    refused = load_site("bsen").plan((12.2, 2.5))
    assert str(refused.suggestion) == "(12.15, 1.45)"
    assert len(str(load_site("bsen").plan("entrance").path)) < 160
