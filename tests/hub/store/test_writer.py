"""The writer: nobody waits for it, and no fault of disk, lock, server or row stops it."""

from __future__ import annotations

import re
import sqlite3
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from housefly.errors import StoreError
from housefly.hub.store.backlog import Backlog, Dropped
from housefly.hub.store.losses import Losses
from housefly.hub.store.open import open_store
from housefly.hub.store.sql_store import SqlStore
from housefly.hub.store.writer import StoreWriter
from housefly.hub.things.thing import Thing
from housefly.messages import Observation, RoomEvent

BEGIN = time.time() - 60.0
"""Older samples would be thinned and removed."""


def seen(number: int) -> Observation:
    at = BEGIN + number / 1000
    return Observation(
        "cup", "vicon", at, at, (float(number), 0.0, 0.0), facts=(("word", "x" * 100),)
    )


def rang(number: int) -> RoomEvent:
    return RoomEvent("bell pressed", "door", float(number), "bell")


def kept(address: str) -> tuple[int, int]:
    store = open_store(address)
    counts = len(store.trajectory("cup", 0.0, 1e11)), len(store.events(-1.0, 1e9))
    store.close()
    return counts


def until(true: Callable[[], bool], timeout: float = 10.0) -> bool:
    deadline = time.monotonic() + timeout
    while not true() and time.monotonic() < deadline:
        time.sleep(0.02)
    return true()


@contextmanager
def writing(opener: Callable[[], SqlStore], **options: int) -> Iterator[StoreWriter]:
    writer = StoreWriter(opener, **options)
    try:
        yield writer
    finally:
        writer.close(timeout=1.0)


def test_all_that_is_told_is_kept(address: str) -> None:
    with writing(lambda: open_store(address)) as writer:
        writer.write(Thing("cup", "the cup"))
        for number in range(3000):
            writer.write(seen(number))
            if number % 100 == 0:
                writer.write(rang(number))
        assert writer.flush()
        assert writer.report() == ""
    assert kept(address) == (3000, 30)


def test_closing_writes_what_waits(address: str) -> None:
    writer = StoreWriter(lambda: open_store(address))
    writer.write_all(map(seen, range(12_000)))
    writer.close()
    assert kept(address) == (12_000, 0)
    writer.write(seen(1))
    assert writer.dropped() == Dropped(1, 0)


def test_a_full_backlog_drops_the_oldest_samples_and_events_last() -> None:
    backlog = Backlog(10)
    assert backlog.put([rang(0), *map(seen, range(12)), rang(1)]) == Dropped(4, 0)
    assert backlog.put(map(rang, range(2, 12))) == Dropped(8, 2)
    batch = backlog.pop_batch()
    assert (len(batch.samples), [event.at for event in batch.events]) == (
        0,
        [float(number) for number in range(2, 12)],
    )
    assert not backlog.pop_batch()


def test_losses_are_said_in_words_and_forgotten_after_a_minute() -> None:
    losses = Losses()
    assert losses.words(0.0) == ""
    losses.count(Dropped(1000, 0), "disk is full", 10.0)
    losses.count(Dropped(200, 3), "disk is full", 11.0)
    assert (
        losses.words(20.0)
        == "dropped 1 200 poses in the last minute: disk is full, 3 events in the last minute: disk"
        " is full"
    )
    assert losses.words(90.0) == ""


def test_a_full_disk_drops_poses_keeps_events_and_recovers(tmp_path: Path) -> None:
    address = str(tmp_path / "house.db")
    pages = 60

    def on_a_small_disk() -> SqlStore:
        store = open_store(address)
        store._database.query(f"PRAGMA max_page_count = {pages}")
        return store

    with writing(on_a_small_disk, capacity=5000) as writer:
        writer.write_all(map(rang, range(100)))
        assert writer.flush()
        for number in range(12_000):
            writer.write(seen(number))
            if number == 4000:
                assert until(lambda: "disk is full" in writer.report()), writer.report()
        writer.write_all(map(rang, range(100, 200)))
        assert until(lambda: "poses in the last minute: disk is full" in writer.report()), (
            writer.report()
        )
        assert "rows wait: disk is full" in writer.report()
        lost = writer.dropped()
        assert lost.poses > 0 and lost.events == 0
        pages = 100_000
        assert writer.flush(), writer.report()
        assert writer.dropped() == lost, "the batch that was refused was not lost"
    assert kept(address) == (12_000 - lost.poses, 200)


LIMITED = """
import resource, sys, time
from housefly.messages import Observation
from housefly.hub.store.open import open_store
from housefly.hub.store.writer import StoreWriter
writer = StoreWriter(lambda: open_store(sys.argv[1]))
hard = resource.getrlimit(resource.RLIMIT_FSIZE)[1]
resource.setrlimit(resource.RLIMIT_FSIZE, (300_000, hard))
begin = time.time() - 60
for number in range(8000):
    at = begin + number / 1000
    writer.write(Observation("cup", "vicon", at, at, (float(number), 0.0, 0.0)))
while "rows wait" not in writer.report():
    time.sleep(0.02)
print(writer.report())
resource.setrlimit(resource.RLIMIT_FSIZE, (hard, hard))
print(writer.flush(), writer.dropped().poses)
writer.close()
"""


@pytest.mark.slow
def test_a_file_that_may_not_grow_recovers_when_it_may(tmp_path: Path) -> None:
    address = str(tmp_path / "house.db")
    done = subprocess.run(
        [sys.executable, "-c", LIMITED, address],
        capture_output=True,
        text=True,
        timeout=60,
        check=True,
    )
    refused, recovered = done.stdout.splitlines()
    assert re.fullmatch(
        r"\d \d{3} rows wait: (disk refuses \(input/output error\)|disk is full)", refused
    )
    assert recovered == "True 0"
    assert kept(address) == (8000, 0)


HOLDER = """
import sqlite3, sys, time
connection = sqlite3.connect(sys.argv[1])
connection.execute("BEGIN EXCLUSIVE")
print("held", flush=True)
time.sleep(3)
"""


@pytest.mark.slow
def test_a_database_that_another_process_holds_for_three_seconds_loses_nothing(
    tmp_path: Path,
) -> None:
    address = str(tmp_path / "house.db")
    with writing(lambda: open_store(address)) as writer:
        holder = subprocess.Popen(
            [sys.executable, "-c", HOLDER, address], stdout=subprocess.PIPE, text=True
        )
        assert holder.stdout is not None and holder.stdout.readline() == "held\n"
        for number in range(4000):
            writer.write(seen(number))
            if number % 4 == 0:
                time.sleep(0.001)
        assert until(lambda: "rows wait: another process holds the database" in writer.report()), (
            writer.report()
        )
        holder.wait()
        holder.stdout.close()
        assert writer.flush(), writer.report()
        assert writer.dropped() == Dropped(0, 0)
    assert kept(address) == (4000, 0)


CHILD = """
import sys, time
from housefly.messages import Observation
from housefly.hub.store.open import open_store
from housefly.hub.store.writer import StoreWriter
writer = StoreWriter(lambda: open_store(sys.argv[1]))
for number in range(10**9):
    now = time.time()
    place = (float(number), 0.0, 0.0)
    writer.write(*(Observation(f"thing-{k}", "vicon", now, now, place) for k in range(20)))
    if number % 10 == 0:
        print(now, flush=True)
    time.sleep(0.01)
"""


@pytest.mark.slow
@pytest.mark.parametrize("after", [1.03, 1.57])
def test_a_writer_that_is_killed_loses_less_than_a_second(tmp_path: Path, after: float) -> None:
    address = tmp_path / "house.db"
    child = subprocess.Popen(
        [sys.executable, "-c", CHILD, str(address)], stdout=subprocess.PIPE, text=True
    )
    assert child.stdout is not None
    child.stdout.readline()
    time.sleep(after)
    child.kill()
    told = float(child.stdout.read().split()[-1])
    child.stdout.close()
    child.wait()
    store = open_store(address)
    assert [row[0] for row in store._database.query("PRAGMA integrity_check")] == ["ok"]
    newest = [sample.captured_at for sample in store.latest()]
    assert len(newest) == 20
    assert min(newest) > told - 1.0
    store.write([seen(1)])
    store.close()


def test_a_damaged_file_is_moved_aside_with_words_and_a_new_one_begun(tmp_path: Path) -> None:
    address = tmp_path / "house.db"
    content = b"SQLite format 3\0" + b"\xff" * 4096
    address.write_bytes(content)
    store = open_store(address)
    aside = [file for file in tmp_path.iterdir() if "damaged" in file.name]
    assert [file.read_bytes() for file in aside] == [content]
    assert store.notices == (
        f"{address} was damaged: it is kept as {aside[0].name}, a new one was begun",
    )
    store.write([seen(1)])
    store.close()
    with writing(lambda: open_store(address)) as writer:  # the next start says so, too
        assert writer.report().startswith(f"{address} was damaged before: {aside[0].name} has")


def test_a_file_that_is_damaged_while_it_is_written_is_moved_aside_and_writing_goes_on(
    tmp_path: Path,
) -> None:
    address = tmp_path / "house.db"
    store = open_store(address)
    store.write([seen(number) for number in range(5000)])
    store.close()
    with address.open("r+b") as file:
        file.seek(4096 * 2)
        file.write(b"\xff" * 4096 * 30)
    with writing(lambda: open_store(address)) as writer:
        writer.write_all(map(seen, range(5000, 6000)))
        writer.write(rang(1))
        assert writer.flush(), writer.report()
        assert "was damaged: it is kept as house.db.damaged-" in writer.report()
    assert kept(str(address)) == (1000, 1)
    assert any("damaged" in file.name for file in tmp_path.iterdir())


def test_a_row_that_no_database_takes_is_dropped_alone_and_named(address: str) -> None:
    with writing(lambda: open_store(address)) as writer:
        writer.write(seen(1), Observation("\ud800", "vicon", 1.0, 1.0), seen(2), rang(1))
        assert writer.flush()
        assert "dropped 1 poses in the last minute: the database cannot hold it" in writer.report()
    assert kept(address) == (2, 1)


def test_a_store_that_cannot_be_opened_is_refused_at_the_begin(tmp_path: Path) -> None:
    with pytest.raises(StoreError, match="cannot be opened"):
        StoreWriter(lambda: open_store(tmp_path / "no" / "folder" / "house.db"))


@pytest.mark.wire
@pytest.mark.slow
def test_a_server_that_goes_away_and_comes_back_loses_nothing(own_server: Any) -> None:
    url = own_server.url()
    with writing(lambda: open_store(url)) as writer:
        writer.write_all(map(seen, range(1000)))
        assert writer.flush()
        own_server.stop()
        writer.write_all(map(seen, range(1000, 2000)))
        assert until(
            lambda: "1 000 rows wait: the database server does not answer" in writer.report()
        ), writer.report()
        own_server.start()
        assert writer.flush(), writer.report()
        assert writer.dropped() == Dropped(0, 0)
    assert kept(url) == (2000, 0)


def test_a_reader_in_another_process_sees_what_is_written(tmp_path: Path) -> None:
    address = tmp_path / "house.db"
    with writing(lambda: open_store(address)) as writer:
        writer.write(seen(7))
        assert writer.flush()
        asked = (
            "import sqlite3, sys; print(sqlite3.connect(sys.argv[1]).execute('SELECT x FROM"
            " latest').fetchall())"
        )
        answer = subprocess.run(
            [sys.executable, "-c", asked, address], capture_output=True, text=True, check=True
        )
    assert answer.stdout == "[(7.0,)]\n"
    assert sqlite3.connect(address).execute("PRAGMA journal_mode").fetchone() == ("wal",)
