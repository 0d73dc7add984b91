"""What the benchmarks share: a running site, percentiles, tables."""

from __future__ import annotations

import sys
import tempfile
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

from housefly.app.launcher import Launcher, processes_of
from housefly.app.new_runtime import new_runtime
from housefly.app.readiness import Readiness
from housefly.app.runtime import Runtime
from housefly.bus.topics import DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.site import Site
from housefly.messages import LinkStatus, Order, OrderKind, Phase, PilotStep
from housefly.sites.loaded_site import read_site

TOPICS = DroneTopics()


def percentile(values: Sequence[float], share: float) -> float:
    """Return the value below which this share of the values lies."""
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, round(share * (len(ordered) - 1)))]


def row(*cells: object) -> str:
    """Return one row of a Markdown table."""
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def table(headings: Sequence[str], rows: Sequence[Sequence[object]]) -> str:
    """Return a Markdown table."""
    return "\n".join(
        [row(*headings), row(*("---" for _ in headings)), *(row(*cells) for cells in rows)]
    )


@dataclass
class Running:
    """A site that runs: its launcher, a seat on its bus, and what was heard last."""

    runtime: Runtime
    launcher: Launcher
    bus: ZenohBus
    ready_after: float
    links: list[LinkStatus] = field(default_factory=list)
    step: PilotStep | None = None

    def order(self, kind: OrderKind, place: str = "", look_s: float = 3.0) -> None:
        """Give an order."""
        self.bus.publish(
            TOPICS.order,
            Order(kind, place, look_s=look_s, issued_at=time.monotonic(), sender="benchmark"),
        )

    def wait_for(self, phase: Phase, timeout: float) -> None:
        """Wait until the pilot is in a phase."""
        deadline = time.monotonic() + timeout
        while self.step is None or self.step.outputs.phase is not phase:
            if time.monotonic() > deadline:
                sys.exit(f"the pilot did not reach {phase.value} within {timeout:.0f} s")
            time.sleep(0.02)


@contextmanager
def running(site: Site, *, web: bool = True) -> Iterator[Running]:
    """Run a site as the launcher does, until the block ends."""
    with tempfile.TemporaryDirectory() as folder:
        start = time.monotonic()
        runtime = new_runtime(site, Path(folder), web=web)
        with (
            Launcher(runtime, Path(folder), processes_of(runtime)) as launcher,
            ZenohBus(connect=runtime.bus) as bus,
        ):
            video = site.drone.has_video and site.twin.video
            missing = Readiness(runtime.site(), bus, web=web, video=video).wait(60.0)
            if missing:
                logs = "\n".join(
                    f"{log.name}: {log.read_text()}" for log in Path(folder).glob("*.log")
                )
                sys.exit(f"not ready: {missing}\n{logs}")
            state = Running(runtime, launcher, bus, time.monotonic() - start)
            lock = threading.Lock()

            def heard(step: PilotStep) -> None:
                with lock:
                    state.step = step

            bus.subscribe(TOPICS.step, heard)
            bus.subscribe(TOPICS.link, state.links.append)
            yield state


def bench_site(address: str, **changes: object) -> Site:
    """Return the shipped demo site on a loopback address of its own."""
    return read_site(
        "bsen", drone__address=address, tracking__address=address, web__port=0, **changes
    )
