"""The files of a draft: what a person reads is what flies, and nothing is lost."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from drafts import completed

from housefly.errors import ConfigError, RoomError
from housefly.room.draft.files import SIMULATED_FILE, load_draft, save_draft, write_site
from housefly.room.draft.model import (
    DraftBox,
    DraftDrone,
    DraftTracking,
    DraftZone,
    FramePoint,
    SiteDraft,
    with_size,
)
from housefly.sites.loaded_site import load_site


def whole() -> SiteDraft:
    draft = replace(
        with_size(SiteDraft('the "lab"'), 6.0, 4.0),
        furniture=(DraftBox("table", 3.0, 1.0, 1.2, 0.8, 0.75),),
        zones=(DraftZone((0.0, 0.0, 0.5, 0.5), "the door swings"),),
    )
    return completed(draft)


def real() -> SiteDraft:
    points = tuple(
        FramePoint(name, (x, y, 0.05), (y - 2.0, 1.0 - x, 0.05))
        for name, x, y in (("a", 1.0, 2.0), ("b", 5.0, 2.0), ("c", 1.0, 3.5))
    )
    return replace(
        whole(), hardware=True, tracking=DraftTracking("vicon", "10.0.0.5", body="drone1"),
        drone=DraftDrone("10.0.0.7", model="tello"), frame_points=points,
    )  # fmt: skip


def test_a_simulated_site_loads_as_it_was_described(tmp_path: Path) -> None:
    draft = whole()
    write_site(draft, tmp_path)
    loaded = load_site(str(tmp_path))
    assert loaded.site.name == draft.name
    assert loaded.site.twin.enabled
    assert loaded.room.home == draft.pad
    assert [place.name for place in loaded.room.places] == ["home", *(p.name for p in draft.places)]
    assert loaded.site.map.virtual_obstacles[0].reason == "the door swings"
    assert loaded.plan(draft.places[0].name).path


def test_a_real_site_has_its_frame_and_a_simulated_one_beside_it(tmp_path: Path) -> None:
    write_site(real(), tmp_path)
    site = load_site(str(tmp_path)).site
    assert (site.tracking.address, site.tracking.port) == ("10.0.0.5", 801)
    assert site.tracking.body == "drone1"
    assert (site.tracking.x, site.tracking.y) == pytest.approx((1.0, 2.0), abs=1e-3)
    assert site.tracking.yaw == pytest.approx(1.5708, abs=1e-3)
    assert not site.twin.enabled
    assert (site.drone.kind, site.drone.address) == ("tello", "10.0.0.7")
    simulated = load_site(str(tmp_path / SIMULATED_FILE))
    assert simulated.site.twin.enabled
    assert (simulated.site.drone.kind, simulated.site.drone.address) == ("tello", "127.0.0.1")
    assert simulated.site.name != site.name  # two memories


def test_every_line_of_the_site_file_is_short_and_every_section_explained(tmp_path: Path) -> None:
    write_site(real(), tmp_path)
    text = (tmp_path / "site.toml").read_text()
    assert text.startswith("# A site of Housefly")
    assert "+90.0 deg" in text and "left over" in text
    assert max(map(len, text.splitlines())) <= 100


def test_a_site_that_lacks_something_is_not_written(tmp_path: Path) -> None:
    with pytest.raises(ConfigError, match="no place to fly to"):
        write_site(replace(whole(), places=()), tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_what_was_changed_by_hand_is_kept(tmp_path: Path) -> None:
    write_site(whole(), tmp_path)
    site = tmp_path / "site.toml"
    site.write_text("# mine\n" + site.read_text())
    write_site(whole(), tmp_path)
    assert (tmp_path / "site.toml.old").read_text().startswith("# mine")
    assert not (tmp_path / "room.toml.old").exists()


def test_a_draft_is_kept_whole_and_found_again(tmp_path: Path) -> None:
    assert load_draft(tmp_path / "lab") is None
    save_draft(real(), tmp_path / "lab")
    assert load_draft(tmp_path / "lab") == real()
    assert [path.name for path in (tmp_path / "lab").iterdir()] == ["draft.json"]


def test_a_broken_draft_is_refused_with_its_file(tmp_path: Path) -> None:
    (tmp_path / "draft.json").write_text('{"bounds": "wide"}')
    with pytest.raises(ConfigError, match=r"draft\.json: bounds"):
        load_draft(tmp_path)


def test_a_folder_that_cannot_be_written_is_told(tmp_path: Path) -> None:
    (tmp_path / "lab").write_text("a file")
    with pytest.raises(RoomError, match="cannot be"):
        save_draft(whole(), tmp_path / "lab")
    with pytest.raises(RoomError, match="cannot be"):
        load_draft(tmp_path / "lab")


def test_a_site_file_in_another_encoding_is_kept_byte_by_byte(tmp_path: Path) -> None:
    mine = 'name = "Küche"\n'.encode("latin-1")
    (tmp_path / "site.toml").write_bytes(mine)
    write_site(whole(), tmp_path)
    assert (tmp_path / "site.toml.old").read_bytes() == mine
