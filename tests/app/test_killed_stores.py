"""After kill -9 or a power cut at any moment every store opens, whole, and lacks little.

At most the last second; where a person was told that it is saved, nothing. The room's own memory
is in ``hub/store/test_power_cut.py``.
"""

from __future__ import annotations

import random
import shutil
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from crash_nursery import CrashNursery
from crashing_stores import STORES
from power_cut import power_cut

from housefly.evidence.clip_store import ClipTable
from housefly.tasks.scheduler.task_store import TaskStore

pytestmark = pytest.mark.slow

LOST_MAX = 1.0
"""Most that may be lost [s]."""
ALL = sorted(STORES)
POWERED = [name for name in ALL if STORES[name].outlives_power]
HEARD = [name for name in POWERED if not STORES[name].is_synced_in_c]
ALWAYS = ("commands", "mode and rules")
"""Negative controls of `make test`; the others take a second each."""


@pytest.fixture(scope="module")
def nursery() -> Iterator[CrashNursery]:
    with CrashNursery() as nursery:
        yield nursery


def told(folder: Path) -> list[tuple[int, float]]:
    """Return what was handed to a store, and when [s]; a line cut off by a kill was not said."""
    said = folder / "said"
    lines = said.read_text().split("\n")[:-1] if said.exists() else []
    return [(int(number), float(at)) for number, at in (line.split() for line in lines)]


def failure(folder: Path) -> str:
    """Return what a writer complained of."""
    errors = folder / "errors"
    return errors.read_text() if errors.exists() else ""


def begun(nursery: CrashNursery, name: str, folder: Path, *, lies: bool = False) -> int:
    """Start a writer and wait until it has written."""
    writer = nursery.start(name, folder, lies=lies)
    deadline = time.monotonic() + 60.0
    while not told(folder) and not failure(folder) and time.monotonic() < deadline:
        time.sleep(0.005)
    assert told(folder), failure(folder)
    return writer


def check(name: str, disk: Path, before: list[tuple[int, float]], *, spared: int = 0) -> None:
    """Compare a store with what had been told to it; ``spared`` may lack although it was said."""
    disk.mkdir(parents=True, exist_ok=True)
    store = STORES[name]
    count = store.kept(disk)
    lost = [at for number, at in before if number > count]
    if store.is_acknowledged:
        assert len(lost) <= spared, f"{len(lost)} of {len(before)} that were said are lost"
    span = lost[-1] - lost[0] if lost else 0.0
    assert span < LOST_MAX, f"{span:.2f} s are lost, {len(lost)} of {len(before)}"


def kill(nursery: CrashNursery, name: str, folder: Path, after: float) -> None:
    """Kill a writer after a while and look at what it kept."""
    writer = begun(nursery, name, folder)
    time.sleep(after)
    nursery.kill(writer)
    check(name, folder / "disk", told(folder))
    shutil.rmtree(folder)


def cut(nursery: CrashNursery, name: str, folder: Path, pauses: list[float], seed: int) -> None:
    """Cut the power of a writer again and again, each time of a copy."""
    chance = random.Random(seed)
    writer = begun(nursery, name, folder)
    # The last commit of a database may be on its way when its writer stands still.
    spared = int(STORES[name].is_synced_in_c)
    try:
        for number, pause in enumerate(pauses):
            time.sleep(pause)
            nursery.stop(writer)
            try:
                before = told(folder)
                power_cut(folder / "disk", folder / "notes", folder / f"cut-{number}", chance)
            finally:
                nursery.go_on(writer)
            check(name, folder / f"cut-{number}", before, spared=spared)
            shutil.rmtree(folder / f"cut-{number}")
    finally:
        nursery.kill(writer)
    assert failure(folder) == ""


@pytest.mark.parametrize("name", ALL)
def test_after_kill_9_it_opens_whole_and_lacks_at_most_a_second(
    nursery: CrashNursery, tmp_path: Path, name: str
) -> None:
    moments = random.Random(name)
    for number in range(2):
        kill(nursery, name, tmp_path / str(number), moments.uniform(0.0, 0.2))


@pytest.mark.parametrize("name", POWERED)
def test_after_a_power_cut_it_opens_whole_and_lacks_at_most_a_second(
    nursery: CrashNursery, tmp_path: Path, name: str
) -> None:
    cut(nursery, name, tmp_path / "one", [0.0, 0.1, 0.1, 0.1], 3)


@pytest.mark.safety
@pytest.mark.timeout(1800)
@pytest.mark.parametrize("name", ALL)
def test_after_kill_9_at_a_hundred_moments_likewise(
    nursery: CrashNursery, tmp_path: Path, name: str
) -> None:
    moments = random.Random(f"{name} 100")
    for number in range(100):
        kill(nursery, name, tmp_path / str(number), moments.uniform(0.0, 1.5))


@pytest.mark.safety
@pytest.mark.timeout(1800)
@pytest.mark.parametrize("name", POWERED)
def test_after_a_power_cut_at_a_hundred_moments_likewise(
    nursery: CrashNursery, tmp_path: Path, name: str
) -> None:
    moments = random.Random(f"{name} cut")
    for number in range(10):
        pauses = [moments.uniform(0.0, 0.6) for _ in range(10)]
        cut(nursery, name, tmp_path / str(number), pauses, number)


@pytest.mark.parametrize(
    "name", [pytest.param(one, marks=[] if one in ALWAYS else pytest.mark.safety) for one in HEARD]
)
def test_a_store_whose_disk_keeps_nothing_is_found_out(
    nursery: CrashNursery, tmp_path: Path, name: str
) -> None:
    """A negative control: the disk says yes and has nothing."""
    writer = begun(nursery, name, tmp_path / "one", lies=True)
    found = False
    deadline = time.monotonic() + 20.0
    for number in range(100):
        time.sleep(0.4)
        nursery.stop(writer)
        before, to = told(tmp_path / "one"), tmp_path / str(number)
        power_cut(tmp_path / "one" / "disk", tmp_path / "one" / "notes", to, random.Random(number))
        nursery.go_on(writer)
        try:
            check(name, to, before)
        except Exception:
            found = True
        if found or time.monotonic() > deadline:
            break
    nursery.kill(writer)
    assert found


def test_queue_and_index_of_the_clips_wait_for_the_disk_with_every_commit(tmp_path: Path) -> None:
    """No witness hears it: it is done in C."""
    store, table = TaskStore(tmp_path / "tasks.db"), ClipTable(tmp_path)
    for setting, value in (("synchronous", 2), ("journal_mode", "wal")):
        assert list(store._database.query(f"PRAGMA {setting}")) == [(value,)]
        assert tuple(table._database.execute(f"PRAGMA {setting}").fetchone()) == (value,)
    store.close()
    table.close()
