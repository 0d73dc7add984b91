"""What the console's page keeps in a long flight with 30 pictures a second, in real Chromium.

``MINUTES`` of flight (30 by default). The garbage is collected before each figure. The process
holds the worker, too; decoded pictures that Chromium may drop at any time are not counted.
"""

from __future__ import annotations

import asyncio
import os
import re
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from _chromium import headless_chromium
from console_scene import Scene, fly, kept_flight, row, scene
from housefly.messages import DroneStatus, Phase

MINUTES = int(os.environ.get("MINUTES", "30"))
MINUTE = 60.0
LEVEL = 1.0
"""A heap that is level grows by less than this in an hour, by the trend of the second half [MB]:
by then the log has as many lines as are shown.
"""
SHOWN = 5
"""Every so many minutes a row is printed."""


@dataclass(frozen=True)
class Kept:
    """What the page holds after a collection."""

    heap: float
    """[MB]."""
    nodes: int
    listeners: int
    process: float
    """Memory that only the page's process has [MB]."""


async def kept(one: Scene) -> Kept:
    """Collect the garbage, and count."""
    await one.devtools.send("HeapProfiler.collectGarbage")
    used = await one.devtools.send("Runtime.getHeapUsage")
    found = await one.devtools.send("Memory.getDOMCounters")
    processes = (await one.browser.send("SystemInfo.getProcessInfo"))["processInfo"]
    pages = [each["id"] for each in processes if each["type"] == "renderer"]
    own = sum(map(own_kb, pages)) / 1e3
    return Kept(used["usedSize"] / 1e6, found["nodes"], found["jsEventListeners"], own)


def own_kb(process: int) -> int:
    """Return the resident memory of a process that it shares with none [kB]."""
    status = Path(f"/proc/{process}/status").read_text(encoding="utf-8")
    found = re.search(r"RssAnon:\s+(\d+) kB", status)
    return int(found[1]) if found else 0


def trend(values: list[float]) -> float:
    """Return by how much values of one a minute grow in an hour."""
    return 60.0 * float(np.polyfit(np.arange(len(values)), values, 1)[0])


def told(minute: int, now: Kept) -> None:
    """Print a row of the table."""
    row(str(minute), f"{now.heap:.2f} | {now.nodes} | {now.listeners}", f"{now.process:.0f}")


async def watch(one: Scene) -> list[Kept]:
    """Fly, and count every minute; return what was counted, from the start on."""
    one.pilot.status, one.pilot.phase, one.pilot.height = DroneStatus.FLYING, Phase.HOLDING, 1.1
    flying = asyncio.create_task(fly(one))
    found = [await kept(one)]
    told(0, found[0])
    for minute in range(1, MINUTES + 1):
        await asyncio.sleep(MINUTE)
        found.append(await kept(one))
        if minute % SHOWN == 0 or minute == MINUTES:
            told(minute, found[-1])
        sys.stdout.flush()
    flying.cancel()
    return found


async def main() -> None:
    """Print the table; exit with 1 where the heap is not level."""
    print("### Console: what the page keeps\n")
    print("| minute | heap MB | DOM nodes | listeners | process MB |\n|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        kept_flight(Path(folder) / "flights")
        async with (
            headless_chromium() as browser,
            scene(browser, Path(folder) / "flights") as one,
        ):
            found = await watch(one)
    settled = found[MINUTES // 2 :]
    rise = trend([each.heap for each in settled])
    nodes = trend([each.nodes for each in settled])
    print(f"\nTrend of the second half: heap {rise:+.2f} MB, {nodes:+.0f} nodes an hour.")
    if rise > LEVEL:
        sys.exit(f"the heap is not level: {rise:.2f} MB an hour")


if __name__ == "__main__":
    asyncio.run(main())
