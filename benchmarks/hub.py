"""The room's memory beside a flight: what an answer takes, how fast news travel, and what all that
costs the pilot.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import psutil

from _run import Running, bench_site, percentile, running, table
from housefly.app.new_runtime import discovery_entry
from housefly.bus.topics import HUB_QUERY
from housefly.config.site import Site, changed
from housefly.hub.api.answers import SensorsAnswer
from housefly.hub.api.json import answer_from_json, question_to_json
from housefly.hub.api.questions import SensorsQuestion
from housefly.hub.client.discovery import announced
from housefly.messages import LinkStatus, OrderKind, Phase

ASKS = 2000
HOVER_S = 20.0
WINDOW_S = 11.0
"""LINK tells of the last ten seconds: so long after the start they hold nothing of it."""
LISTEN_S = 15.0
SITE = "hub benchmark"
SEAT = Path(__file__).with_name("_hub_seat.py")


@dataclass
class Hover:
    """What one run showed."""

    links: list[LinkStatus] = field(default_factory=list)
    cores: dict[str, float] = field(default_factory=dict)
    memory: dict[str, tuple[float, float]] = field(default_factory=dict)
    bus: dict[str, list[float]] = field(default_factory=dict)
    connected: list[float] = field(default_factory=list)
    http: list[float] = field(default_factory=list)
    ages: dict[str, list[float]] = field(default_factory=dict)
    report: str = ""
    devices: int = 0


def site_of(folder: Path, *, hub: bool) -> Site:
    """Return the demo with people and devices, and with a memory of its own or none."""
    lively = {
        "twin__scene": "bsen",
        "mqtt__broker": "127.0.0.1",
        "mqtt__start": True,
        "mqtt__port": 0,
    }
    site = bench_site("127.9.6.1", hub__enabled=hub, hub__store=str(folder / "room.db"), **lively)
    return changed(site, name=SITE)


def seat(*arguments: object) -> Any:
    """Run a seat in a process of its own and return what it says."""
    command = [sys.executable, str(SEAT), *map(str, arguments)]
    return json.loads(
        subprocess.run(command, stdout=subprocess.PIPE, check=True, timeout=240).stdout
    )


def processes(state: Running) -> dict[str, psutil.Process]:
    """Return pilot and hub."""
    return {
        part.name: psutil.Process(state.launcher.pid(part.name))
        for part in state.launcher.processes
        if part.name in _MEASURED
    }


_MEASURED = ("pilot", "hub")


def seconds(process: psutil.Process) -> float:
    """Return the processor time used so far [s]."""
    times = process.cpu_times()
    return float(times.user + times.system)


def hover(state: Running, found: Hover) -> None:
    """Take off, hover, and note lateness, processor time and memory."""
    state.order(OrderKind.TAKE_OFF)
    state.wait_for(Phase.HOLDING, 20.0)
    time.sleep(WINDOW_S)
    parts = processes(state)
    state.links.clear()
    before, begin = {name: seconds(process) for name, process in parts.items()}, time.monotonic()
    time.sleep(HOVER_S)
    elapsed = time.monotonic() - begin
    found.links = list(state.links)
    found.cores = {
        name: (seconds(process) - before[name]) / elapsed for name, process in parts.items()
    }
    for name, process in parts.items():
        used = process.memory_full_info()
        found.memory[name] = used.uss / 2**20, used.rss / 2**20


def asked_on_the_bus(endpoint: str) -> dict[str, list[float]]:
    """Return how long hub and echo took to answer, asked in turn [s]."""
    with subprocess.Popen([sys.executable, str(SEAT), "echo", endpoint], stdin=subprocess.PIPE):
        found: dict[str, list[float]] = seat("bus", endpoint, ASKS)
    return found


def question(state: Running, found: Hover) -> None:
    """Ask and listen from other processes, one after the other, while the drone hovers."""
    found.ages = seat("listen", state.runtime.bus, state.runtime.site().tracking.body, LISTEN_S)
    found.bus = asked_on_the_bus(state.runtime.bus)
    with announced(discovery_entry(state.runtime)):
        found.connected = seat("connected", SITE, ASKS)
        found.http = seat("http", SITE, ASKS)
    answer = answer_from_json(
        SensorsQuestion(), state.bus.ask(HUB_QUERY, question_to_json(SensorsQuestion()))
    )
    assert isinstance(answer, SensorsAnswer)
    found.report = answer.memory
    found.devices = sum(
        sensor.connected
        for sensor in answer.sensors
        if sensor.kind not in ("mocap", "drone", "mqtt")
    )


def run(*, hub: bool) -> Hover:
    """Start everything, hover, ask, land."""
    found = Hover()
    with tempfile.TemporaryDirectory() as folder, running(site_of(Path(folder), hub=hub)) as state:
        hover(state, found)
        if hub:
            question(state, found)
        state.order(OrderKind.LAND)
        state.wait_for(Phase.IDLE, 20.0)
    return found


def figures(values: Sequence[float]) -> list[str]:
    """Return p50, p99 and maximum [ms]."""
    return [f"{1e3 * percentile(values, share):.2f}" for share in (0.5, 0.99, 1.0)]


def asking(found: Hover) -> str:
    """Return how long answers took."""
    rows = [
        [
            "`housefly.connect().where(...)`",
            len(found.connected),
            *figures(found.connected),
            "p99 2",
        ],
        ["on the bus", len(found.bus["hub"]), *figures(found.bus["hub"]), ""],
        [
            "(an echo on the same bus that does nothing, in turn)",
            len(found.bus["echo"]),
            *figures(found.bus["echo"]),
            "",
        ],
        ["over HTTP, as from another machine", len(found.http), *figures(found.http), ""],
    ]
    times = found.bus
    half, most = (
        percentile(times["hub"], share) / percentile(times["echo"], share) for share in (0.5, 0.99)
    )
    headings = [
        "where is X, asked from another process",
        "asked",
        "p50 [ms]",
        "p99 [ms]",
        "max [ms]",
        "limit [ms]",
    ]
    words = (
        f"On the bus the hub takes {half:.2f} times the echo at the median, {most:.2f} times at"
        " p99."
    )
    return f"{table(headings, rows)}\n\n{words}"


def travelling(ages: dict[str, list[float]]) -> str:
    """Return how fast a frame reaches whoever listens."""
    named = (
        ("frame reached the pilot -> FRAME in another process", "frame", "p99 3"),
        ("pilot steps -> STEP in another process", "stepped", ""),
        ("frame reached the pilot -> the pilot's next tick (100 Hz)", "waited", ""),
        ("frame reached the pilot -> STEP in another process", "step", ""),
        ("frame captured -> STEP in another process", "captured", ""),
        ("hub tells -> ROOM_NEWS in another process", "news_way", ""),
        ("frame captured -> ROOM_NEWS in another process (told 5 times a second)", "news", ""),
    )
    rows = [[words, len(ages[key]), *figures(ages[key]), limit] for words, key, limit in named]
    return table(
        ["Vicon at 100 Hz", "heard", "p50 [ms]", "p99 [ms]", "max [ms]", "limit [ms]"], rows
    )


def punctuality(with_hub: Hover, without: Hover) -> str:
    """Return the lateness of the pilot's ticks with and without the hub."""
    rows = []
    for words, found in (("with the hub", with_hub), ("without", without)):
        late = (
            percentile([link.loop_p50_s for link in found.links], 0.5),
            max(link.loop_p99_s for link in found.links),
            max(link.loop_max_s for link in found.links),
        )
        missed = found.links[-1].missed_ticks - found.links[0].missed_ticks
        rows.append(
            [
                words,
                *(f"{1e3 * value:.2f}" for value in late),
                missed,
                f"{found.cores['pilot']:.2f}",
            ]
        )
    headings = [
        "pilot loop",
        "p50 late [ms]",
        "p99 (worst ten seconds) [ms]",
        "max [ms]",
        "ticks missed",
        "pilot's cores",
    ]
    return table(headings, rows)


def main() -> None:
    """Print what was measured."""
    with_hub, without = run(hub=True), run(hub=False)
    print("### The room's memory beside a flight\n")
    print(
        f"The lively demo (people, {with_hub.devices} devices over MQTT, console, video), the drone"
        " hovering.\n"
    )
    print(asking(with_hub))
    print()
    print(travelling(with_hub.ages))
    print(
        "\nThe pilot steps on its own clock: a frame waits for the next tick, 5 ms on average,"
        " before anybody hears of a step."
    )
    print(f"\nTwo runs of {HOVER_S:.0f} s hovering, nobody asking:\n")
    print(punctuality(with_hub, without))
    own, whole = with_hub.memory["hub"]
    share = 100 * with_hub.cores["hub"]
    print(
        f"\nThe hub takes {share:.0f} % of a core and {own:.0f} MiB of its own ({whole:.0f} MiB"
        " with what it shares)."
    )
    load = os.getloadavg()[1]
    print(f"Load of the machine meanwhile: {load:.1f} on {os.cpu_count()} cores;", end=" ")
    print("the echo and the run without the hub show what it does.")
    print(f'It says of its store: "{with_hub.report}".')


if __name__ == "__main__":
    main()
