"""Clips are found, kept as long as allowed, deleted, exported, and who watched is known."""

from __future__ import annotations

import contextlib
import io
import json
import os
import sqlite3
import subprocess
import tempfile
import zipfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import av
import pytest
from clip_rows import DAY, NOW, added, clip, found
from filming import RATE_HZ, video
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.config.tasks import TasksConfig
from housefly.errors import StoreError, TaskError
from housefly.evidence.clip_export import write_folder, zipped
from housefly.evidence.clip_index import ClipIndex
from housefly.evidence.clip_values import ClipsQuestion, DeleteClip, KeepClip
from housefly.evidence.clip_writer import ClipWriter
from housefly.tasks.api.json import task_question_from_json, task_question_to_json

CONFIG = TasksConfig(clip_days=30, snapshot_days=90, clip_space_gb=0.01)


@pytest.fixture
def index(tmp_path: Path) -> Iterator[ClipIndex]:
    made = ClipIndex(tmp_path, CONFIG, lambda: NOW)
    yield made
    made.close()


def test_a_clip_is_found_by_what_it_shows_and_when(index: ClipIndex, tmp_path: Path) -> None:
    door = added(index, tmp_path, clip(NOW - 100, place="entrance", people=("guest", "anna")))
    cup = added(index, tmp_path, clip(NOW - 50, thing="cup", duration=20.0, task=9))
    snap = added(index, tmp_path, clip(NOW - 10, "snapshot", thing="cup"))
    assert found(index) == [snap, cup, door], "the newest first"
    assert found(index, person="Anna") == found(index, place="ENTRANCE") == [door]
    assert found(index, thing="cup") == [snap, cup]
    assert found(index, task=9) == found(index, thing="cup", task=9) == [cup]
    assert found(index, since=NOW - 35, until=NOW - 20) == [cup], "a clip that was running then"
    assert found(index, until=NOW - 60) == [door]
    assert found(index, limit=1) == [snap]
    assert found(index, person="ann") == found(index, place="' OR 1=1 --") == []
    info = index.info(door)
    assert (info.people, info.cause, info.service) == (("guest", "anna"), "event-1", "look")


def test_clips_go_after_their_days_snapshots_after_theirs_and_kept_ones_never(
    index: ClipIndex, tmp_path: Path
) -> None:
    old = added(index, tmp_path, clip(NOW - 31 * DAY))
    snap = added(index, tmp_path, clip(NOW - 31 * DAY, "snapshot"))
    kept = added(index, tmp_path, clip(NOW - 400 * DAY))
    young = added(index, tmp_path, clip(NOW - 29 * DAY))
    assert index.keep(kept, "anna").keep_until is None
    assert index.info(young).keep_until == pytest.approx(NOW + DAY)
    assert index.expire(NOW) == (old,)
    assert found(index) == [young, snap, kept]
    assert not (tmp_path / f"{old}.mp4").exists()
    index.keep(kept, "anna", kept=False)
    assert set(index.expire(NOW + 60 * DAY)) == {kept, young, snap}
    assert not list(tmp_path.glob("2*"))


@settings(max_examples=12)
@given(st.lists(st.tuples(st.integers(0, 4_000), st.booleans()), max_size=9))
def test_of_too_much_the_oldest_go_first_until_it_fits(sizes: list[tuple[int, bool]]) -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        config = CONFIG.model_copy(update={"clip_space_gb": 1e-5})
        index = ClipIndex(folder, config, lambda: NOW)
        names = []
        for n, (size, kept) in enumerate(sizes):
            names.append(added(index, folder, clip(NOW - 2 * DAY + n), size))
            if kept:
                index.keep(names[-1], "anna")
        gone = list(index.expire(NOW))
        loose = [n for n, (_, kept) in zip(names, sizes, strict=True) if not kept]
        assert gone == loose[: len(gone)], "the oldest, and never a kept one"
        left = sum(path.stat().st_size for path in folder.glob("*.mp4"))
        assert left <= 10_000 or gone == loose
        if gone:
            last = sizes[names.index(gone[-1])][0]
            assert left + last > 10_000, "no more than needed"
        index.close()


def test_kept_clips_that_take_all_the_space_do_not_push_out_those_of_the_last_day(
    index: ClipIndex, tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    kept = added(index, tmp_path, clip(NOW - 9 * DAY), 11_000_000)
    index.keep(kept, "anna")
    old = added(index, tmp_path, clip(NOW - 2 * DAY), 10)
    first = added(index, tmp_path, clip(NOW - 100), 6_000_000)
    assert index.expire(NOW) == (old,)
    assert "delete some of those that are kept" in caplog.text
    second = added(index, tmp_path, clip(NOW), 6_000_000)
    assert index.expire(NOW) == (first,), "among themselves they stay within the space"
    assert found(index) == [second, kept]


def test_one_file_that_cannot_be_deleted_keeps_no_other(index: ClipIndex, tmp_path: Path) -> None:
    stuck = added(index, tmp_path, clip(NOW - 50 * DAY))
    old = added(index, tmp_path, clip(NOW - 40 * DAY))
    (tmp_path / f"{stuck}.mp4").unlink()
    (tmp_path / f"{stuck}.mp4").mkdir()
    assert index.expire(NOW) == (old,)
    assert found(index) == [stuck], "it is tried again"


def test_who_watched_kept_and_deleted_a_clip_is_known_even_after_it_is_gone(
    index: ClipIndex, tmp_path: Path
) -> None:
    name = added(index, tmp_path, clip(NOW))
    index.log_access(name, "anna")
    index.answer(KeepClip(name, by="ben"))
    answer = index.answer(DeleteClip(name, by="ben"))
    assert [info.id for info in answer.clips] == [name]
    assert not list(tmp_path.glob("*.mp4"))
    assert [(view.who, view.what) for view in index.audit_log(name)] == [
        ("anna", "watched"),
        ("ben", "kept"),
        ("ben", "deleted"),
    ]
    for ask in (
        index.file,
        index.info,
        lambda n: index.log_access(n, "x"),
        lambda n: index.keep(n, "x"),
    ):
        with pytest.raises(TaskError, match="there is no clip"):
            ask(name)


def test_orders_about_clips_cross_the_bus_as_json() -> None:
    for order in (KeepClip("a-1", keep=False, by="anna"), DeleteClip("a-1", by="anna")):
        assert task_question_from_json(task_question_to_json(order)) == order


@pytest.mark.parametrize("name", ["", ".", "../index", "a/b", "index.db", "a\0b", "x" * 61, "%2e"])
def test_a_name_never_leads_out_of_the_folder(index: ClipIndex, name: str) -> None:
    with pytest.raises(TaskError, match="there is no clip"):
        index.file(name)


def test_two_processes_may_have_the_index_open(index: ClipIndex, tmp_path: Path) -> None:
    other = ClipIndex(tmp_path, CONFIG)
    name = added(index, tmp_path, clip(NOW))
    other.log_access(name, "anna")
    assert [view.who for view in index.audit_log(name)] == ["anna"]
    other.close()


def test_an_index_that_cannot_be_opened_says_so(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(StoreError, match="cannot be opened"):
        ClipIndex(tmp_path / "file", CONFIG)


def test_a_broken_index_is_put_aside_and_its_clips_are_taken_up_again(tmp_path: Path) -> None:
    (tmp_path / "index.db").write_bytes(b"this is no database at all" * 100)
    writer = ClipWriter(tmp_path / "20260921-141504-ce1aa0c5.mp4")
    for frame in video(2.0):
        writer.add(frame)
    assert writer.finish() is not None
    index = ClipIndex(tmp_path, CONFIG, lambda: NOW)
    assert found(index) == []
    index.recover()
    (info,) = index.find(ClipsQuestion()).clips
    assert (info.kind, info.duration) == ("clip", pytest.approx(2.0, abs=0.1))
    assert info.keep_until is not None, "it does not lie there for ever"
    assert (tmp_path / "index.broken").exists()
    index.close()


def test_a_clip_whose_row_was_lost_is_kept_for_its_days_from_then_on(
    index: ClipIndex, tmp_path: Path
) -> None:
    file = tmp_path / "20260101-141504-ce1aa0c5.mp4"
    file.write_bytes(b"a clip that somebody kept")
    os.utime(file, (NOW - 200 * DAY, NOW - 200 * DAY))
    index.recover()
    assert index.info(file.stem).keep_until == pytest.approx(NOW + 30 * DAY)
    assert index.expire(NOW + 29 * DAY) == ()
    index.recover()
    assert index.expire(NOW + 31 * DAY) == (file.stem,)


def test_an_index_with_damaged_pages_is_put_aside_too(tmp_path: Path) -> None:
    index = ClipIndex(tmp_path, CONFIG, lambda: NOW)
    for n in range(200):
        index.finish(clip(NOW - n, place="entrance" * 20))
    index.close()
    file = tmp_path / "index.db"
    pages = bytearray(file.read_bytes())
    pages[5 * 4096 : 9 * 4096] = b"?" * 4 * 4096
    file.write_bytes(pages)
    index = ClipIndex(tmp_path, CONFIG, lambda: NOW)
    assert found(index) == []
    assert (tmp_path / "index.broken").exists()
    index.close()


def test_after_a_crash_no_file_is_without_a_row_and_no_row_without_a_file(
    index: ClipIndex, tmp_path: Path
) -> None:
    lost = added(index, tmp_path, clip(NOW))
    (tmp_path / f"{lost}.mp4").unlink()
    index.begin(clip(NOW))
    torn = clip(NOW + 1)
    index.begin(torn)
    (tmp_path / f"{torn.id}.mp4.part").write_bytes(b"")
    (tmp_path / "20260921-1.mp4.part").write_bytes(b"")
    for litter in ("20260921-2.mp4.mended", "20260921-3.jpg.part"):
        (tmp_path / litter).write_bytes(b"litter")
    (tmp_path / "notes.txt").write_text("not ours")
    assert index.recover() == ()
    assert found(index) == []
    left = {path.name for path in tmp_path.iterdir() if not path.name.startswith("index.db")}
    assert left == {"notes.txt"}


def part_of_a_clip(folder: Path, name: str, seconds: float = 2.0) -> Path:
    """Leave what a writer leaves that dies."""
    writer = ClipWriter(folder / f"{name}.mp4")
    for frame in video(seconds):
        writer.add(frame)
    writer.abandon()
    return folder / f"{name}.mp4.part"


def test_a_torn_clip_without_a_row_is_taken_up_again_and_said_to_be_cut_off(
    index: ClipIndex, tmp_path: Path
) -> None:
    part = part_of_a_clip(tmp_path, "20260921-141504-ce1aa0c5")
    assert index.recover() == ("20260921-141504-ce1aa0c5",)
    (info,) = index.find(ClipsQuestion()).clips
    assert info.cut_off
    assert info.duration == pytest.approx(2.0, abs=0.5)
    assert info.keep_until == pytest.approx(NOW + 30 * DAY)
    assert not part.exists()
    with av.open(str(index.file(info.id))) as copy:
        assert sum(1 for _ in copy.decode(video=0)) >= 1.5 * RATE_HZ
    assert index.recover() == (), "once"


@pytest.mark.parametrize("has_row", [False, True])
def test_what_a_crash_left_and_nothing_can_play_is_kept_for_a_day(
    index: ClipIndex, tmp_path: Path, has_row: bool
) -> None:
    row = clip(NOW - 60, place="entrance")
    if has_row:
        index.begin(row)
    (tmp_path / f"{row.id}.mp4.part").write_bytes(b"half an MP4 file")
    assert index.recover() == (row.id,)
    info = index.info(row.id)
    assert (info.cut_off, info.duration) == (True, 0.0)
    assert info.place == ("entrance" if has_row else "")
    assert index.file(row.id).read_bytes() == b"half an MP4 file"
    assert index.expire(NOW + 0.9 * DAY) == ()
    assert index.expire(NOW + 1.1 * DAY) == (row.id,)


def test_an_index_of_an_earlier_version_is_read(tmp_path: Path) -> None:
    index = ClipIndex(tmp_path, CONFIG, lambda: NOW)
    name = added(index, tmp_path, clip(NOW, place="entrance"))
    index.close()
    with contextlib.closing(sqlite3.connect(tmp_path / "index.db")) as old:
        old.execute("ALTER TABLE clips DROP COLUMN cut_off")
        old.execute("DROP TABLE clock")
    index = ClipIndex(tmp_path, CONFIG, lambda: NOW)
    assert (index.info(name).place, index.info(name).cut_off) == ("entrance", False)
    assert index.tidy() == ()
    index.close()


@settings(max_examples=30)
@given(st.lists(st.integers(0, 5), max_size=12), st.integers(1, 5))
def test_every_page_holds_what_is_older_and_together_they_hold_all(
    seconds: list[int], limit: int
) -> None:
    with tempfile.TemporaryDirectory() as name:
        index = ClipIndex(Path(name), CONFIG, lambda: NOW)
        for n in seconds:
            added(index, Path(name), clip(NOW + n))
        pages, before = [], ""
        while page := found(index, limit=limit, before=before):
            pages += page
            before = page[-1]
        assert pages == found(index)
        index.close()


def test_a_page_after_a_clip_that_is_gone_says_so(index: ClipIndex) -> None:
    with pytest.raises(TaskError, match="there is no clip"):
        index.find(ClipsQuestion(before="20260921-141504-ce1aa0c5"))


def test_clips_are_found_by_what_caused_them(index: ClipIndex, tmp_path: Path) -> None:
    bell = added(index, tmp_path, clip(NOW))
    added(index, tmp_path, clip(NOW + 1, cause=""))
    assert found(index, caused_by="event-1") == [bell]


def test_an_export_holds_the_files_what_is_known_and_hashes_that_a_stranger_can_check(
    index: ClipIndex, tmp_path: Path
) -> None:
    folder = tmp_path / "out"
    folder.mkdir()
    row = clip(NOW, place="entrance")
    writer = ClipWriter(tmp_path / f"{row.id}.mp4")
    for frame in video(1.0):
        writer.add(frame)
    written = writer.finish()
    assert written is not None
    index.finish(replace(row, size=written.size, duration=written.duration))
    snap = added(index, tmp_path, clip(NOW, "snapshot"))
    pieces = list(zipped(index.export([row.id, snap, row.id], "anna")))
    assert max(map(len, pieces)) < 2**20, "piece by piece, never as a whole"
    with zipfile.ZipFile(io.BytesIO(b"".join(pieces))) as archive:
        archive.extractall(folder)
    check = subprocess.run(
        ["sha256sum", "--check", "--strict", "SHA256SUMS"], cwd=folder, capture_output=True
    )
    assert check.returncode == 0, check.stdout
    assert check.stdout.count(b": OK") == 3
    known = {one["id"]: one for one in json.loads((folder / "clips.json").read_text())}
    assert known[row.id]["place"] == "entrance"
    assert known[row.id]["views"][-1]["who"] == "anna"
    with av.open(str(folder / known[row.id]["file"])) as copy:
        assert sum(1 for _ in copy.decode(video=0)) == RATE_HZ
    (folder / f"{row.id}.mp4").write_bytes(b"forged")
    check = subprocess.run(["sha256sum", "--check", "SHA256SUMS"], cwd=folder, capture_output=True)
    assert check.returncode != 0
    assert [view.what for view in index.audit_log(snap)] == ["exported"]
    for names in ([], ["nobody"], [row.id] * 1 + [f"c{n}" for n in range(300)]):
        with pytest.raises(TaskError):
            index.export(names, "anna")
    assert [view.what for view in index.audit_log(snap)] == ["exported"], "nothing was exported"


def test_an_export_as_a_folder_is_for_this_user_only_and_can_be_checked(
    index: ClipIndex, tmp_path: Path
) -> None:
    name = added(index, tmp_path, clip(NOW, place="entrance"))
    index.log_access(name, "ben")
    out = tmp_path / "taken" / "away"
    for _ in range(2):
        files = write_folder(index.export([name], "anna"), out, {f"{name}.jpg": b"a picture"})
    assert {path.name for path in files} == {
        *(f"{name}.mp4", f"{name}.jpg", "clips.json", "SHA256SUMS")
    }
    assert {path.stat().st_mode & 0o777 for path in files} == {0o600}
    check = subprocess.run(["sha256sum", "--check", "SHA256SUMS"], cwd=out, capture_output=True)
    assert (check.returncode, check.stdout.count(b": OK")) == (0, 3)
    (known,) = json.loads((out / "clips.json").read_text())
    assert (known["when"], known["cause"]) == ("2026-09-21T14:13:20+00:00", "event-1")
    assert [view["who"] for view in known["views"]] == ["ben", "anna", "anna"]
