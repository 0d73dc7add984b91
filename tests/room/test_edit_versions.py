"""Versions of edits in files: undone, never lost, whole or not there at all."""

from __future__ import annotations

import os
import threading
from pathlib import Path

import pytest

from housefly.config.edits import Edits, NoFlyZone
from housefly.errors import EditsError, StaleEdits
from housefly.room.edit_versions import EditVersion, EditVersions


def edits(k: int) -> Edits:
    return (
        Edits(zones=(NoFlyZone(rectangle=(0.0, 0.0, 1.0 + k, 1.0), reason=f"number {k}"),))
        if k
        else Edits()
    )


@pytest.fixture
def versions(tmp_path: Path) -> EditVersions:
    return EditVersions(tmp_path / "edits", lambda: 12.0)


def test_without_files_there_is_the_room_as_its_file_has_it(versions: EditVersions) -> None:
    assert versions.newest() == EditVersion()
    assert not versions.folder.exists()
    with pytest.raises(EditsError, match="nothing to undo"):
        versions.undo(0)


def test_each_save_is_a_new_version_that_another_process_reads(versions: EditVersions) -> None:
    assert versions.save(edits(1), 0, "Ada").number == 1
    saved = versions.save(edits(2), 1, "Bob")
    assert (
        EditVersions(versions.folder).newest() == saved == EditVersion(2, edits(2), 2, 12.0, "Bob")
    )
    assert sorted(path.name for path in versions.folder.iterdir()) == ["0001.json", "0002.json"]


def test_undo_goes_back_step_by_step_and_forgets_nothing(versions: EditVersions) -> None:
    for k in (1, 2):
        versions.save(edits(k), k - 1)
    assert versions.undo(2) == EditVersion(3, edits(1), 1, 12.0)
    assert versions.undo(3) == EditVersion(4, Edits(), 0, 12.0)
    with pytest.raises(EditsError, match="nothing to undo"):
        versions.undo(4)
    versions.save(edits(5), 4)
    assert versions.undo(5).edits == Edits()
    assert len(list(versions.folder.iterdir())) == 6


def test_a_file_torn_in_mid_write_is_moved_aside_and_the_version_before_counts(
    versions: EditVersions,
) -> None:
    first = versions.save(edits(1), 0)
    versions.save(edits(2), 1)
    whole = (versions.folder / "0002.json").read_bytes()
    (versions.folder / "0002.json").write_bytes(whole[: len(whole) // 2])
    assert versions.newest() == first
    assert (
        "0002.json" in versions.problem
        and "is damaged" in versions.problem
        and "0002.json.damaged" in versions.problem
    )
    assert (versions.folder / "0002.json.damaged").read_bytes() == whole[: len(whole) // 2], (
        "nothing is deleted"
    )
    assert versions.save(edits(3), 1).number == 3, "its number is not used again"
    assert versions.newest().edits == edits(3)


@pytest.mark.parametrize(
    "damage",
    [
        b"",
        b"\xff\xfe",
        b"[]",
        b'{"version": 1}',
        b'{"edits": {}, "equals": 9, "saved_at": 0, "by": ""}',
    ],
)
def test_no_damage_stops_anybody(versions: EditVersions, damage: bytes) -> None:
    versions.folder.mkdir()
    for _ in range(2):
        (versions.folder / "0001.json").write_bytes(damage)
        assert versions.newest() == EditVersion()
    assert len(list(versions.folder.iterdir())) == 2


def test_a_writer_killed_before_the_end_leaves_nothing_that_counts(
    versions: EditVersions, monkeypatch: pytest.MonkeyPatch
) -> None:
    versions.save(edits(1), 0)

    def killed(*paths: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "link", killed)
    with pytest.raises(KeyboardInterrupt):
        versions.save(edits(2), 1)
    monkeypatch.undo()
    (versions.folder / ".0002.abcd.draft").write_text("{")
    assert versions.newest().edits == edits(1)
    assert versions.save(edits(3), 1).number == 2


def test_who_is_based_on_an_old_version_is_told_who_saved_meanwhile(versions: EditVersions) -> None:
    versions.save(edits(1), 0, "Ada")
    for attempt in (lambda: versions.save(edits(2), 0), lambda: versions.undo(0)):
        with pytest.raises(StaleEdits, match="version 1 was saved by Ada in between"):
            attempt()


def test_of_many_writers_at_once_one_wins(versions: EditVersions) -> None:
    start, outcomes = threading.Barrier(8), []

    def write(k: int) -> None:
        mine = EditVersions(versions.folder)
        start.wait()
        try:
            outcomes.append(mine.save(edits(k), 0).edits)
        except StaleEdits:
            outcomes.append(None)

    threads = [threading.Thread(target=write, args=(k,)) for k in range(1, 9)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    won = [one for one in outcomes if one is not None]
    assert len(outcomes) == 8 and len(won) == 1
    assert versions.newest().edits == won[0]
    assert [path.name for path in versions.folder.iterdir()] == ["0001.json"]


def test_a_disk_that_refuses_is_told_in_words(tmp_path: Path) -> None:
    (tmp_path / "edits").write_text("a file, not a folder")
    with pytest.raises(EditsError, match="cannot be"):
        EditVersions(tmp_path / "edits").save(edits(1), 0)
