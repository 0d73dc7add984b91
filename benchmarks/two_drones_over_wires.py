"""Two drones fly a service each through one room over real wires, their ways crossing.

    python benchmarks/two_drones_over_wires.py        20 seeds
    python benchmarks/two_drones_over_wires.py 2      2 seeds

All processes of a run: a pilot and a driver each, one room, one simulated room. Judged on the truth
of the simulated room, and on how late the pilots' loops were (99th percentile, the worse of both).
"""

from __future__ import annotations

import argparse
import tempfile
import threading
import time
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from _run import table
from housefly.app.launcher import Launcher, processes_of
from housefly.app.new_runtime import new_runtime
from housefly.app.readiness import Readiness
from housefly.app.truth_files import take_truth
from housefly.bus.topics import DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.lab.lockstep.service_monitor import ServiceMonitor
from housefly.messages import LinkStatus, Order, OrderKind, PilotStep
from housefly.record.truth import COMPLETED, read_truth
from housefly.sites.loaded_site import LoadedSite, load_site
from two_drones import ANNA, BERT, EAST, LATER_MAX, LOOK_S, SEEDS, WEST

_READY_TIME, _SETTLING_TIME, _SERVICE_TIME = 90.0, 5.0, 180.0
"""Longest wait for everything to answer, pause after it, longest service [s]."""


@dataclass
class Flown:
    """One drone's service: how it goes, what its loop says, what was touched."""

    monitor: ServiceMonitor
    late: list[float] = field(default_factory=list)
    contacts: int = 0
    done: threading.Event = field(default_factory=threading.Event)

    def heard(self, step: PilotStep) -> None:
        """Follow the service."""
        self.monitor = self.monitor.updated(step)
        if self.monitor.outcome:
            self.done.set()

    def told(self, link: LinkStatus) -> None:
        """Note how late the pilot's loop was."""
        self.late.append(link.loop_p99_s)


def pair(seed: int) -> LoadedSite:
    """Return B-sen with two drones, each at an address of its own."""
    drones = (
        {"name": "anna", "pad": ANNA, "address": "127.55.0.1"},
        {"name": "bert", "pad": BERT, "address": "127.55.0.2"},
    )
    return load_site(
        "bsen",
        hub__enabled=False,
        tasks__enabled=False,
        twin__seed=seed,
        twin__video=False,
        drone__has_video=False,
        tracking__address="127.55.0.1",
        drones=drones,
    )


def fly(seed: int) -> dict[str, Flown]:
    """Fly one seed: it decides where to, and how much later the second drone is ordered."""
    random, loaded = np.random.default_rng(seed), pair(seed)
    goals = {"anna": str(random.choice(WEST)), "bert": str(random.choice(EAST))}
    later = float(random.uniform(0.0, LATER_MAX))
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        runtime, truth = new_runtime(loaded.site, folder), folder / "truth.jsonl"
        flown: dict[str, Flown] = {}
        with (
            Launcher(runtime, folder, processes_of(runtime, truth_file=truth)),
            ZenohBus(connect=runtime.bus) as bus,
        ):
            missing = Readiness(runtime.site(), bus, web=False, video=False).wait(_READY_TIME)
            if missing:
                raise SystemExit(f"not ready: {missing}")
            time.sleep(_SETTLING_TIME)
            for drone, place in goals.items():
                topics, now = DroneTopics(drone), time.monotonic()
                home = loaded.for_drone(drone).room.home
                one = flown[drone] = Flown(ServiceMonitor(now, home, _SERVICE_TIME))
                bus.subscribe(topics.step, one.heard)
                bus.subscribe(topics.link, one.told)
                order = Order(
                    OrderKind.SERVICE, place, look_s=LOOK_S, issued_at=now, sender="bench"
                )
                bus.publish(topics.order, order)
                time.sleep(later if drone == "anna" else 0.0)
            for one in flown.values():
                one.done.wait(_SERVICE_TIME + 10.0)
        for drone, one in flown.items():
            own = folder / f"{drone}.jsonl"
            take_truth(truth, drone, own)
            found = read_truth(own)
            one.contacts = -1 if found is None else len(found.contacts)
    return flown


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("seeds", nargs="?", type=int, default=SEEDS, help="how many seeds")
    parser.add_argument("--first", type=int, default=1, help="the first seed")
    options = parser.parse_args()
    rows = []
    for seed in range(options.first, options.first + options.seeds):
        flown = fly(seed)
        late = max(max(one.late, default=0.0) for one in flown.values())
        rows.append(
            [
                seed,
                *(one.monitor.outcome or "no end" for one in flown.values()),
                sum(one.contacts for one in flown.values()),
                f"{1000 * late:.1f} ms",
            ]
        )
        print(*rows[-1], flush=True)
    whole = sum(all(cell == COMPLETED for cell in row[1:3]) and row[3] == 0 for row in rows)
    print(f"\n### Two drones over wires: {whole} of {len(rows)} seeds whole\n")
    print(table(("seed", "anna", "bert", "contacts", "loop late, p99"), rows))


if __name__ == "__main__":
    main()
