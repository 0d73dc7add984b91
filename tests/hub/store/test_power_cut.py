"""After kill -9 or a power cut at any moment the store opens, and lacks at most the last second."""

from __future__ import annotations

import os
import random
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from power_cut import tear_log

from housefly.hub.store.open import open_store
from housefly.hub.store.sqlite import SqliteDatabase

LOST_MAX = 1.0
"""Most that may be lost [s]."""
_WRITER = """
import sys, time
from housefly.hub.store.open import open_store
from housefly.hub.store.writer import StoreWriter
from housefly.messages import Observation, RoomEvent

begin, number, said = time.time(), 0, open(sys.argv[2], "a", buffering=1)
writer = StoreWriter(lambda: open_store(sys.argv[1]))
while True:
    for _ in range(20):
        at, number = time.time(), number + 1
        place, facts = (float(number), 0.0, 0.0), (("n", "x" * 99),)
        writer.write(Observation("cup", "vicon", at, at, place, facts=facts))
    writer.write(RoomEvent("bell pressed", "door", at, "bell"))
    said.write(f"{number} {at}\\n")
    time.sleep(0.02)
"""


@contextmanager
def writing(folder: Path) -> Iterator[subprocess.Popen[bytes]]:
    """Write a thousand rows a second in a process of its own, from the first row on."""
    command = [sys.executable, "-c", _WRITER, str(folder / "house.db"), str(folder / "said")]
    process = subprocess.Popen(command)
    try:
        deadline = time.monotonic() + 60.0
        while not told(folder) and time.monotonic() < deadline:
            time.sleep(0.01)
        yield process
    finally:
        process.kill()
        process.wait(10.0)


def told(folder: Path) -> list[tuple[int, float]]:
    """Return how many rows had been handed to the writer, and when [s], batch by batch."""
    said = folder / "said"
    # A line that was cut off by the kill was not said.
    lines = said.read_text().split("\n")[:-1] if said.exists() else []
    return [(int(number), float(at)) for number, at in (line.split() for line in lines)]


def kept(file: Path) -> int:
    """Return how many rows the store has; it must be whole."""
    store = open_store(file)
    try:
        assert store.notices == ()
        assert list(store._database.query("PRAGMA integrity_check")) == [("ok",)]
        rows = store.trajectory("cup", 0.0, 1e11)
        # Rows are written in order: those that are there are the first ones, without a gap.
        assert [round(row[1]) for row in rows] == list(range(1, len(rows) + 1))
        return len(rows)
    finally:
        store.close()


def check_kept(file: Path, told_before: list[tuple[int, float]]) -> None:
    """Compare a store with what had been told to its writer."""
    count = kept(file)
    # From the first lost row on: before the first commit nothing is kept, and that is no loss yet.
    lost = [at for number, at in told_before if number > count]
    span = lost[-1] - lost[0] if lost else 0.0
    assert span < LOST_MAX, f"{span:.2f} s are lost, {told_before[-1][0] - count} rows"


def killed(folder: Path, after: float) -> None:
    """Kill the writer after a while and look at what it kept."""
    folder.mkdir()
    with writing(folder) as process:
        time.sleep(after)
        os.kill(process.pid, signal.SIGKILL)
        process.wait(10.0)
    check_kept(folder / "house.db", told(folder))


def cut_power(
    folder: Path, process: subprocess.Popen[bytes], to: Path, chance: random.Random
) -> None:
    """Copy what a power cut would leave at this instant."""
    to.mkdir()
    os.kill(process.pid, signal.SIGSTOP)
    try:
        os.waitid(os.P_PID, process.pid, os.WSTOPPED)
        before = told(folder)
        for ending in ("", "-wal"):
            if (source := folder / f"house.db{ending}").exists():
                shutil.copy(source, to / source.name)
    finally:
        os.kill(process.pid, signal.SIGCONT)
    if (log := to / "house.db-wal").exists():
        tear_log(log, chance)
    check_kept(to / "house.db", before)


@pytest.mark.parametrize("number", range(3))
def test_after_kill_9_the_store_opens_and_lacks_at_most_a_second(
    tmp_path: Path, number: int
) -> None:
    killed(tmp_path / "a", random.Random(number).uniform(0.1, 1.5))


@pytest.mark.safety
@pytest.mark.timeout(1800)
def test_after_kill_9_at_a_hundred_moments_likewise(tmp_path: Path) -> None:
    moments = random.Random(9)
    for number in range(100):
        killed(tmp_path / str(number), moments.uniform(0.0, 2.0))


def cut_at_random_moments(folder: Path, number: int, seconds: float) -> None:
    chance = random.Random(number)
    with writing(folder) as process:
        for cut in range(number):
            time.sleep(chance.uniform(0.0, 2.0 * seconds / number))
            cut_power(folder, process, folder / f"cut-{cut}", chance)


def test_after_a_power_cut_the_store_opens_and_has_what_came_first(tmp_path: Path) -> None:
    cut_at_random_moments(tmp_path, 10, 2.0)


@pytest.mark.safety
@pytest.mark.timeout(1800)
def test_after_a_power_cut_at_a_hundred_moments_likewise(tmp_path: Path) -> None:
    cut_at_random_moments(tmp_path, 100, 30.0)


def test_what_is_kept_is_on_the_disk_at_once_so_that_a_power_cut_loses_a_tenth_of_a_second(
    tmp_path: Path,
) -> None:
    """No test can cut the power; that every commit waits for the disk can be read."""
    database = SqliteDatabase(tmp_path / "house.db")
    full = 2
    assert list(database.query("PRAGMA synchronous")) == [(full,)]
    assert list(database.query("PRAGMA journal_mode")) == [("wal",)]
    database.close()
