"""The room's memory: writing, "where is X" and the way of X, beside the limits that we set
ourselves.
"""

from __future__ import annotations

import math
import os
import resource
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Sequence
from pathlib import Path

from _run import percentile, table
from housefly.hub.store.open import open_store
from housefly.hub.store.sql_store import SqlStore
from housefly.hub.store.writer import StoreWriter
from housefly.hub.things.thing import Thing, ThingKind
from housefly.hub.things.world_model import WorldModel
from housefly.messages import Observation

SECONDS = 30.0
THINGS, RATE = 20, 100.0
HOUR, DAY = 3600.0, 86_400.0
FULL_RATE, THIN_RATE = 100.0, 10.0
READER = """
import sys, time
from housefly.hub.store.open import open_store
from housefly.hub.things.world_model import WorldModel
store = open_store(sys.argv[1])
end = time.monotonic() + float(sys.argv[2])
while time.monotonic() < end:
    begin = time.perf_counter()
    world = WorldModel()
    for sample in store.latest_at(time.time(), "thing-7"):
        world.observe(sample)
    found = world.where("thing-7")
    print(1e3 * (time.perf_counter() - begin), found.position is not None)
    time.sleep(0.005)
"""


def sample(number: int, at: float) -> Observation:
    """Return a thing that walks in a circle, as a motion capture system sees it."""
    angle = 0.5 * at + number
    turned = (math.cos(angle / 2), 0.0, 0.0, math.sin(angle / 2))
    return Observation(
        f"thing-{number}",
        "vicon",
        at,
        at + 0.004,
        (3 * math.cos(angle), 3 * math.sin(angle), 1.0),
        turned,
    )


def tell(writer: StoreWriter, seconds: float) -> int:
    """Write a frame every 10 ms, as tracking does, and return the number of samples."""
    begin, frames = time.monotonic(), 0
    while frames < seconds * RATE:
        now = time.time()
        writer.write_all([sample(number, now) for number in range(THINGS)])
        frames += 1
        time.sleep(max(0.0, begin + frames / RATE - time.monotonic()))
    return frames * THINGS


def cpu() -> float:
    """Return the processor time that this process has used [s]."""
    used = resource.getrusage(resource.RUSAGE_SELF)
    return used.ru_utime + used.ru_stime


def baseline(seconds: float) -> float:
    """Return the share of a core that making the samples costs by itself."""
    begin, frames, used = time.monotonic(), 0, cpu()
    while frames < seconds * RATE:
        now = time.time()
        assert [sample(number, now) for number in range(THINGS)]
        frames += 1
        time.sleep(max(0.0, begin + frames / RATE - time.monotonic()))
    return (cpu() - used) / seconds


def writing(folder: Path) -> list[list[object]]:
    """Write 2000 samples a second while another process asks where a thing is."""
    address = folder / "house.db"
    making = baseline(5.0)
    writer = StoreWriter(lambda: open_store(address))
    writer.write(*(Thing(f"thing-{number}", f"thing {number}") for number in range(THINGS)))
    assert writer.flush()
    used = cpu()
    told = tell(writer, SECONDS)
    share = (cpu() - used) / SECONDS - making
    assert writer.flush()
    lost = writer.dropped()
    reader = subprocess.Popen(
        [sys.executable, "-c", READER, str(address), "5"], stdout=subprocess.PIPE, text=True
    )
    tell(writer, 7.0)
    assert reader.stdout is not None
    answers = [line.split() for line in reader.stdout]
    reader.wait()
    writer.close()
    assert all(found == "True" for _, found in answers)
    asked = [float(ms) for ms, _ in answers]
    store = open_store(address)
    kept = next(
        iter(
            store._database.query(
                "SELECT count(*) FROM sighting WHERE captured_at < ?", (time.time(),)
            )
        )
    )[0]
    store.close()
    size = address.stat().st_size / kept
    return [
        [
            "2000 samples/s for 30 s: share of a core, samples made elsewhere",
            f"{100 * share:.1f} %",
            "10 %",
        ],
        [
            "rows told, dropped",
            f"{told:,}, {lost.poses + lost.events}".replace(",", " ", 1),
            "0 dropped",
        ],
        ["size of a row in the file", f"{size:.0f} B", ""],
        [
            f"where is X, fused, from another process meanwhile ({len(asked)} questions): p50",
            f"{percentile(asked, 0.5):.2f} ms",
            "",
        ],
        ["p99", f"{percentile(asked, 0.99):.2f} ms", "2 ms"],
        ["max", f"{max(asked):.2f} ms", ""],
    ]


def asking() -> list[list[object]]:
    """Ask a world of 1000 things, four sources each telling as it goes."""
    world = WorldModel(
        Thing(
            f"thing-{k}",
            f"thing number {k}",
            ThingKind.OBJECT,
            (f"alias {k}",),
            inside=f"thing-{k // 10}" if k >= 10 else "",
        )
        for k in range(1000)
    )
    size = (0.01, 0.0, 0.0, 0.01, 0.0, 0.01)
    times, told = [], []
    for k in range(20_000):
        now, number = 0.001 * k, (k * 7919) % 1000
        begin = time.perf_counter()
        point = (float(number), 0.0, 0.0) if number % 3 else None
        world.observe(
            Observation(f"thing-{number}", f"source-{k % 4}", now, now, point, covariance=size)
        )
        told.append(1e6 * (time.perf_counter() - begin))
        begin = time.perf_counter()
        found = world.where(world.find(f"Thing Number {(k * 104_729) % 1000}").id)
        times.append(1e6 * (time.perf_counter() - begin))
        assert found
    return [
        [
            "where is X, by its name, in process, 1000 things of 4 sources: p50",
            f"{percentile(times, 0.5):.1f} us",
            "",
        ],
        ["p99", f"{percentile(times, 0.99):.1f} us", "100 us"],
        ["telling the world model of a sample: p50", f"{percentile(told, 0.5):.1f} us", ""],
        ["p99", f"{percentile(told, 0.99):.1f} us", ""],
    ]


FILL = """WITH RECURSIVE step(k) AS (SELECT 0 UNION ALL SELECT k + 1 FROM step WHERE k < ?)
    INSERT INTO sighting SELECT ?, 'vicon', ? + k / ?, ? + k / ?, 1, ? + k / ?,
        (k % 6007) * 0.001, (k % 4001) * 0.001, 1.0, 0.8, 0.0, 0.0, 0.6, '', '', '' FROM step"""


def fill(store: SqlStore, thing: str, begin: float, seconds: float, rate: float) -> None:
    """Put in the history of one thing in bulk."""
    times = (begin, rate) * 3
    store._database.query(FILL, (int(seconds * rate) - 1, thing, *times))


def remembering(folder: Path) -> list[list[str]]:
    """Ask for one hour of one thing, of a day of 20 things at 10 Hz, the last hour at 100 Hz."""
    store = open_store(folder / "day.db")
    for number in range(THINGS):
        fill(store, f"thing-{number}", 0.0, DAY - HOUR, THIN_RATE)
        fill(store, f"thing-{number}", DAY - HOUR, HOUR, FULL_RATE)
        store.write([sample(number, DAY)])
    os.sync()  # or the bulk on its way to the disk is measured
    rows = []
    for words, since, every in (
        ("an hour of yesterday's", 10 * HOUR, 0.0),
        ("the last hour's at full rate", DAY - HOUR, 0.0),
        ("the last hour's at 10 Hz", DAY - HOUR, 0.1),
    ):
        begin = time.perf_counter()
        path = store.trajectory("thing-7", since, since + HOUR, every=every)
        took = time.perf_counter() - begin
        count = f"{len(path):,}".replace(",", " ")
        rows.append([f"the way of X, {words}: {count} points", f"{took:.3f} s", "0.3 s"])
    begin = time.perf_counter()
    assert len(store.latest_at(DAY / 2)) == THINGS
    rows.append(
        ["where was everything at noon", f"{1e3 * (time.perf_counter() - begin):.2f} ms", ""]
    )
    slowest, steps = 0.0, 0
    while steps < 60:
        begin = time.perf_counter()
        if not store.prune(DAY + HOUR):
            break
        slowest, steps = max(slowest, time.perf_counter() - begin), steps + 1
    rows.append([f"one step of tidying, slowest of {steps}", f"{1e3 * slowest:.0f} ms", ""])
    size = (folder / "day.db").stat().st_size
    store.close()
    rows.append(["the file of that day", f"{size / 1e9:.2f} GB", ""])
    return rows


def main() -> None:
    assert threading.active_count() == 1
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        rows: list[Sequence[object]] = [*asking(), *writing(folder), *remembering(folder)]
    print("### The room's memory (SQLite)")
    print()
    print(table(["what", "measured", "limit"], rows))
    print()
    print(
        "20 things, each with position and orientation. The day is generated in bulk: 23 hours at"
        " 10 Hz, the last at 100 Hz."
    )


if __name__ == "__main__":
    main()
