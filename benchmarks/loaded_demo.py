"""The demo on a machine that is loaded four times over: whole services, scored on the truth.

    python benchmarks/loaded_demo.py            20 services, about half an hour
    python benchmarks/loaded_demo.py 3          three of them
    python benchmarks/loaded_demo.py 3 --load 0 three on a machine that does nothing else

Each service is flown in a demo of its own, with console, camera, people and devices, beside four
processes per core that never rest, at the demo's own priority. What was told, whether it came home,
and every touch are of the simulated room's record.
"""

from __future__ import annotations

import argparse
import multiprocessing
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path

import psutil

from _run import table
from housefly.bus.topics import DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.lab.safety_case.oracle import HARD_LANDING, STANDING
from housefly.messages import Order, OrderKind, Phase, PilotStep, SafetyMode, Severity
from housefly.record.truth import TRUTH_FILE, read_truth

TOPICS = DroneTopics()

PLACE, LOOK_S = "table", 3.0
READY_S, ASK_EVERY_S, TAKE_OFF_S, FLIGHT_S = 120.0, 5.0, 60.0, 180.0
"""How long a loaded demo may take to be ready, to leave the floor, and to be back [s]."""
BUS = re.compile(rb"^bus: +(\S+)", re.MULTILINE)


@dataclass
class Heard:
    """What the pilot said during one service."""

    step: PilotStep | None = None
    flew: bool = False
    over: bool = False
    modes: set[SafetyMode] = field(default_factory=set)
    words: list[str] = field(default_factory=list)
    looked: bool = False

    def take(self, step: PilotStep) -> None:
        """Take in one step."""
        self.step, out = step, step.outputs
        self.flew |= out.phase not in (Phase.IDLE,)
        self.over = self.flew and out.phase is Phase.IDLE
        self.looked |= out.phase is Phase.LOOKING
        if self.flew and not self.over:
            self.modes.add(out.safety)
        told = [event.text for event in out.events if event.severity is not Severity.INFO]
        self.words += [word for word in (*told, *out.warnings) if word not in self.words]


@dataclass(frozen=True)
class Loaded:
    """How one service ended."""

    outcome: str
    harm: tuple[str, ...]
    modes: tuple[str, ...]
    words: tuple[str, ...]
    load: float


@contextmanager
def burning(processes: int) -> Iterator[None]:
    """Keep so many processes busy until the block ends."""
    context = multiprocessing.get_context("spawn")
    burners = [context.Process(target=_burn, daemon=True) for _ in range(processes)]
    for burner in burners:
        burner.start()
    try:
        yield
    finally:
        for burner in burners:
            burner.kill()


def _burn() -> None:
    while True:
        sum(range(100_000))


def fly_demo(seed: int, folder: Path) -> Loaded:
    """Start a demo, fly one service in it, end it, and judge it on the truth."""
    command = [
        *(sys.executable, "-m", "housefly.cli", "demo", "--port", "0"),
        *("--seed", str(seed), "--record", str(folder)),
    ]
    folder.parent.mkdir(parents=True, exist_ok=True)
    printed = folder.with_suffix(".txt")
    with printed.open("wb") as out:
        demo = subprocess.Popen(command, stdout=out, stderr=subprocess.STDOUT)
    heard = Heard()
    try:
        address = _bus_of(demo, printed)
        with ZenohBus(connect=address) as bus:
            bus.subscribe(TOPICS.step, heard.take)
            _fly(bus, heard)
        load = os.getloadavg()[0]
    finally:
        if demo.poll() is None:
            demo.send_signal(signal.SIGINT)
        with suppress(subprocess.TimeoutExpired):
            demo.wait(120.0)
        _end_all(demo)
    return _judged(heard, folder, load)


def _end_all(demo: subprocess.Popen[bytes]) -> None:
    """End what a demo that did not end left behind."""
    if demo.poll() is None:
        for part in (*psutil.Process(demo.pid).children(recursive=True), demo):
            with suppress(psutil.NoSuchProcess):
                part.kill()
        demo.wait()


def _bus_of(demo: subprocess.Popen[bytes], printed: Path) -> str:
    deadline = time.monotonic() + READY_S
    while b"ready after" not in printed.read_bytes():
        if demo.poll() is not None or time.monotonic() > deadline:
            sys.exit(f"the demo did not get ready:\n{printed.read_text()}")
        time.sleep(0.2)
    found = BUS.search(printed.read_bytes())
    return found.group(1).decode() if found else sys.exit(printed.read_text())


def _fly(bus: ZenohBus, heard: Heard) -> None:
    """Order the service until it is begun, then wait for its end."""
    start = time.monotonic()
    while not heard.flew and time.monotonic() - start < TAKE_OFF_S:
        order = Order(
            OrderKind.SERVICE, PLACE, look_s=LOOK_S, issued_at=time.monotonic(), sender="benchmark"
        )
        bus.publish(TOPICS.order, order)
        waited = time.monotonic() + ASK_EVERY_S
        while not heard.flew and time.monotonic() < waited:
            time.sleep(0.1)
    start = time.monotonic()
    while heard.flew and not heard.over and time.monotonic() - start < FLIGHT_S:
        time.sleep(0.1)


def _judged(heard: Heard, folder: Path, load: float) -> Loaded:
    truth = read_truth(next(iter(folder.rglob(TRUTH_FILE)), folder / TRUTH_FILE))
    if truth is None:
        return Loaded("no record", ("no record of it",), (), tuple(heard.words), load)
    harm = sorted({f"touched {c.kind} {c.name} at {c.speed:.1f} m/s" for c in truth.contacts})
    falls = [
        (below - above) / (then - now)
        for now, then, above, below in zip(
            truth.time, truth.time[1:], truth.position[1:, 2], truth.position[:-1, 2], strict=False
        )
        if then > now
    ]
    if falls and max(falls) > HARD_LANDING:
        harm.append(f"fell at {max(falls):.1f} m/s")
    if truth.airborne[-1] or truth.position[-1][2] > STANDING:
        harm.append(f"left at {truth.position[-1][2]:.1f} m")
    outcome = "stayed on the floor"
    if heard.flew:
        outcome = "came home" if heard.looked and heard.over else "landed early"
    modes = tuple(mode.value for mode in SafetyMode if mode in heard.modes)
    return Loaded(outcome, tuple(harm), modes, tuple(heard.words), load)


def main() -> int:
    """Fly, and print how each service ended; 0 when none did harm."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("services", type=int, nargs="?", default=20)
    parser.add_argument("--load", type=int, default=4, help="busy processes per core (default: 4)")
    parser.add_argument("--out", type=Path, help="keep the recordings here")
    options = parser.parse_args()
    busy = options.load * (os.cpu_count() or 1)
    rows = []
    with tempfile.TemporaryDirectory() as place, burning(busy):
        for number in range(options.services):
            flown = fly_demo(number + 1, (options.out or Path(place)) / f"flight-{number + 1}")
            rows.append(
                (
                    number + 1,
                    f"{flown.load:.0f}",
                    flown.outcome,
                    "; ".join(flown.harm) or "-",
                    ", ".join(flown.modes),
                    "; ".join(flown.words[:2]) or "-",
                )
            )
            print(*rows[-1], sep=" | ", file=sys.stderr, flush=True)
    print(f"## The demo on a machine with {busy} busy processes on {os.cpu_count()} cores\n")
    print(table(["seed", "load", "outcome", "harm", "gate", "told, the first two"], rows))
    harmed = sum(row[3] != "-" for row in rows)
    print(f"\n{harmed} of {len(rows)} did harm.")
    return 1 if harmed else 0


if __name__ == "__main__":
    sys.exit(main())
