"""Two drones fly a service each through one room, their ways crossing, in lock step.

    python benchmarks/two_drones.py              20 seeds, and each again with both blind
    python benchmarks/two_drones.py 4            4 seeds
    python benchmarks/two_drones.py 4 --wires    4 seeds over real wires, in real time

Judged on the truth of the simulated room: what was touched, how near the hulls came. Flown again
with the other drone taken out of what each pilot hears, the same flights must come to harm.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from math import inf
from pathlib import Path
from typing import Any

import numpy as np

from _run import table
from housefly.lab.lockstep.simulation import Simulation
from housefly.messages import Order, OrderKind
from housefly.record.truth import COMPLETED
from housefly.sites.loaded_site import LoadedSite, load_site
from scores.fleet_flight import FlownService, fly_services_lockstep, without_others
from scores.fleet_wires import fly_services_over_wires

SEEDS = 20
LOOK_S = 2.0
LATER_MAX = 4.0
"""The second drone is ordered up to so much later [s]."""
PATIENCE = 200.0
"""Over wires, the whole may take so long [s]."""
NEAR_MISS = 0.3
"""Hulls nearer to each other than this in the air have missed each other by luck [m]."""
ANNA, BERT = (10.55, 1.25, 3.1416), (8.05, 1.25, 0.0)
"""Pads: x, y [m] and heading [rad]. Each has its goals behind the other's pad."""
WEST, EAST = ("entrance", "table", "bed"), ("sofa", "tv", "window", "desk")
_RATES = {"control__rate_hz": 50, "twin__mocap_rate_hz": 50}


def loaded_pair(seed: int, **changes: Any) -> LoadedSite:
    """Return B-sen with two drones."""
    drones = (
        {"name": "anna", "pad": ANNA},
        {"name": "bert", "pad": BERT, "address": "127.0.0.2"},
    )
    return load_site("bsen", hub__enabled=False, twin__seed=seed, drones=drones, **changes)


def asked(seed: int) -> tuple[dict[str, Order], dict[str, float]]:
    """Return what a seed has the drones do, and how much later the second is ordered [s]."""
    random = np.random.default_rng(seed)
    orders = {
        name: Order(OrderKind.SERVICE, str(random.choice(places)), look_s=LOOK_S)
        for name, places in (("anna", WEST), ("bert", EAST))
    }
    return orders, {"bert": float(random.uniform(0.0, LATER_MAX))}


def fly(seed: int, *, blind: bool = False) -> dict[str, FlownService]:
    """Fly one seed in lock step."""
    orders, after = asked(seed)
    simulation = Simulation(loaded_pair(seed, **_RATES))
    if not blind:
        return fly_services_lockstep(simulation, orders, after=after)
    return fly_services_lockstep(simulation, orders, after=after, hear=without_others(simulation))


def fly_wired(seed: int) -> dict[str, FlownService]:
    """Fly one seed over real wires, at the rates as shipped."""
    orders, after = asked(seed)
    loaded = loaded_pair(seed, tasks__enabled=False, twin__video=False)
    wired = fly_services_over_wires(loaded, orders, after, PATIENCE)
    late = ", ".join(f"{name} {1000.0 * at:.1f} ms" for name, at in wired.late.items())
    print(f"seed {seed}: steps late, 99th percentile: {late}", flush=True)
    return wired.flown


def is_harmed(flown: dict[str, FlownService]) -> bool:
    """Return whether anything was touched, or two hulls nearly."""
    return any(one.contacts or one.nearest_drone < NEAR_MISS for one in flown.values())


def summary(flights: Sequence[dict[str, FlownService]]) -> list[object]:
    """Return the cells of a row about some flights."""
    flown = [one for flight in flights for one in flight.values()]
    nearest = min((one.nearest_drone for one in flown), default=inf)
    return [
        f"{sum(one.outcome == COMPLETED for one in flown)} of {len(flown)}",
        sum(len(one.contacts) for one in flown),
        f"{sum(map(is_harmed, flights))} of {len(flights)}",
        f"{nearest:.2f} m",
        f"{np.median([one.duration for one in flown]):.1f} s",
    ]


IN_LOCK_STEP: dict[str, Callable[[int], dict[str, FlownService]]] = {
    "as they fly": fly,
    "blind for each other": lambda seed: fly(seed, blind=True),
}
WIRED: dict[str, Callable[[int], dict[str, FlownService]]] = {"over wires": fly_wired}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("seeds", nargs="?", type=int, default=SEEDS, help="how many seeds")
    parser.add_argument("--first", type=int, default=1, help="the first seed")
    parser.add_argument("--log", type=Path, help="file for a line about each flight")
    parser.add_argument("--wires", action="store_true", help="over real wires, in real time")
    options = parser.parse_args()
    rows, ways = [], WIRED if options.wires else IN_LOCK_STEP
    for who, flown in ways.items():
        flights = []
        for seed in range(options.first, options.first + options.seeds):
            flights.append(flown(seed))
            if options.log:
                with options.log.open("a", encoding="utf-8") as log:
                    print(who, seed, flights[-1], file=log, flush=True)
        rows.append([who, *summary(flights)])
    print("### Two drones in one room\n")
    print(
        table(
            ("", "completed", "contacts", f"touched, or under {NEAR_MISS} m", "nearest", "median"),
            rows,
        )
    )


if __name__ == "__main__":
    main()
