from __future__ import annotations

from pathlib import Path

from housefly.app.origin_memory import ORIGIN_FILE, OriginMemory
from housefly.config.frame_check import FrameCheckRecord, tracking_digest, write_frame_check
from housefly.sites.loaded_site import load_site

SITE = load_site("bsen", hub__enabled=False).site


def test_what_one_pilot_of_a_run_has_seen_the_next_one_knows(tmp_path: Path) -> None:
    first = OriginMemory(SITE, tmp_path)
    assert not first.known
    first.note()
    assert first.known and OriginMemory(SITE, tmp_path).known


def test_it_holds_for_the_same_tracking_only(tmp_path: Path) -> None:
    OriginMemory(SITE, tmp_path).note()
    assert not OriginMemory(load_site("bsen", tracking__x=1.0).site, tmp_path).known


def test_a_folder_that_is_gone_a_file_that_is_none_and_no_folder_remember_nothing(
    tmp_path: Path,
) -> None:
    gone = OriginMemory(SITE, tmp_path / "gone")
    gone.note()
    (tmp_path / f"{ORIGIN_FILE}-drone").write_bytes(b"\xff\xfe")
    alone = OriginMemory(SITE)
    alone.note()
    assert not gone.known and not OriginMemory(SITE, tmp_path).known and not alone.known


def test_frames_that_somebody_compared_are_known_from_the_start(tmp_path: Path) -> None:
    site = load_site("bsen", twin__enabled=False, hub__store=str(tmp_path / "room.db")).site
    assert not OriginMemory(site).known
    write_frame_check(site, FrameCheckRecord("2026-11-25", tracking_digest(site.tracking)))
    assert OriginMemory(site).known


def test_tracking_that_was_found_lying_is_not_known_to_the_next_pilot_either(
    tmp_path: Path,
) -> None:
    site = load_site("bsen", twin__enabled=False, hub__store=str(tmp_path / "room.db")).site
    write_frame_check(site, FrameCheckRecord("2026-11-25", tracking_digest(site.tracking)))
    memory = OriginMemory(site, tmp_path)
    memory.revoke()
    assert not memory.known and not OriginMemory(site, tmp_path).known
    memory.note()
    assert memory.known and OriginMemory(site, tmp_path).known
