"""Whether any process grows: half an hour of the lively demo in real time, a browser watching, a
service every three minutes.

``python benchmarks/soak.py [MINUTES]``; memory.py shows in five minutes what needs no wires.
"""

from __future__ import annotations

import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import psutil
from playwright.sync_api import sync_playwright

from _run import Running, bench_site, running, table
from housefly.app.browser_video import chromium_path
from housefly.messages import OrderKind, Phase

MINUTES = 30
SETTLED = 5
"""Minutes after which nothing may grow any more."""
SERVICE_EVERY = 3
"""Minutes; a battery lasts for about ten services."""
SAMPLE_PERIOD = 5.0
"""Between two looks at the memory [s]."""
GROWTH_LIMIT = 0.05
FLAGS = ["--no-sandbox", "--disable-gpu"]


def processes(state: Running) -> dict[str, psutil.Process]:
    """Return every process of the run by what it is."""
    found = {
        part.name: psutil.Process(state.launcher.pid(part.name))
        for part in state.launcher.processes
    }
    for child in found["twin"].children(recursive=True):
        found["twin's camera"] = child
    return found


def memory(process: psutil.Process) -> float:
    """Return what a process has of its own [MiB]."""
    return float(process.memory_full_info().uss) / 2**20


def minutes(count: int, work: Callable[[], None]) -> Iterator[int]:
    """Count minutes of real time, working in between."""
    begin = time.monotonic()
    for minute in range(1, count + 1):
        while time.monotonic() < begin + 60.0 * minute:
            work()
        print(f"minute {minute} of {count}", file=sys.stderr, flush=True)
        yield minute


def soak(state: Running, count: int) -> tuple[dict[str, list[list[float]]], int]:
    """Return each process's samples [MiB], a list a minute, and the number of services."""
    parts = processes(state)
    samples: dict[str, list[list[float]]] = {name: [[]] for name in parts}
    services = 0

    def look() -> None:
        time.sleep(SAMPLE_PERIOD)
        for name, process in parts.items():
            samples[name][-1].append(memory(process))

    for minute in minutes(count, look):
        for values in samples.values():
            values.append([])
        idle = state.step is not None and state.step.outputs.phase is Phase.IDLE
        if minute % SERVICE_EVERY == 1 and minute < count - 1 and idle:
            state.order(OrderKind.SERVICE, "entrance")
            services += 1
    return {name: values[:-1] for name, values in samples.items()}, services


def rows_of(samples: dict[str, list[list[float]]]) -> list[list[object]]:
    """Return a table row a process: its median of some minutes, and the line through all that are
    settled.
    """
    rows: list[list[object]] = []
    for name, by_minute in samples.items():
        medians = [float(np.median(values)) for values in by_minute]
        settled = np.array(medians[SETTLED:])
        slope = float(np.polyfit(np.arange(len(settled)), settled, 1)[0])
        growth = slope * len(settled) / settled[0]
        cells = (medians[0], medians[SETTLED], medians[-1])
        rows.append(
            [
                name,
                *(f"{value:.1f}" for value in cells),
                f"{1024 * slope:+.1f}",
                f"{100 * growth:+.1f} %",
            ]
        )
    return rows


def main() -> None:
    """Print what each process holds over time."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else MINUTES
    if count <= SETTLED + 1:
        sys.exit(
            f"give more than {SETTLED + 1} minutes: what a process holds settles for {SETTLED}"
        )
    lively = {
        "twin__scene": "bsen",
        "mqtt__broker": "127.0.0.1",
        "mqtt__start": True,
        "mqtt__port": 0,
    }
    with tempfile.TemporaryDirectory() as folder:
        site = bench_site("127.9.8.1", hub__store=str(Path(folder) / "room.db"), **lively)
        with running(site) as state, sync_playwright() as play:
            browser = play.chromium.launch(executable_path=chromium_path(), args=FLAGS)
            page = browser.new_page(viewport={"width": 1280, "height": 800})
            web = state.runtime.site().web
            page.goto(f"http://{web.host}:{web.port}/?token={state.runtime.token}")
            page.locator(".headline").filter(has_text="Your drone is home").wait_for()
            samples, services = soak(state, count)
            restarts = sum(state.launcher.restarts(part.name) for part in state.launcher.processes)
            browser.close()
    print(f"### Memory of every process over {count} minutes of real time\n")
    headings = [
        "of its own [MiB]",
        "minute 1",
        f"minute {SETTLED + 1}",
        f"minute {count}",
        "slope [KiB/min]",
        "growth",
    ]
    print(table(headings, rows_of(samples)))
    print(
        f"\nThe lively demo with a browser on the console, {services} services flown, {restarts}"
        " processes started again.",
        end=" ",
    )
    print(
        f"Medians of a minute; slope and growth from minute {SETTLED + 1} on; limit"
        f" {100 * GROWTH_LIMIT:.0f} %."
    )


if __name__ == "__main__":
    main()
