"""A hundred services in the lively room, in lock step: contacts, and how near people came.

    python benchmarks/lively_services.py        100 services, about 20 minutes on a core
    python benchmarks/lively_services.py 4      four rooms of five services

Each room's day is kept in lively-services.jsonl; the same command goes on, at the lowest priority.
Judged on the truth of the simulated room, not on what the pilot believed.
"""

from __future__ import annotations

import argparse
import os
from collections import Counter
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from _pieces import lines_kept, pieces_done
from _run import table
from housefly.config.site import changed
from housefly.lab.lockstep.simulation import Simulation
from housefly.lab.safety_case.oracle import Oracle
from housefly.messages import DroneStatus, EventCode, Order, OrderKind, Phase, PilotStep
from housefly.sites.loaded_site import LoadedSite, load_site
from housefly.twin.demo_site import demo_changes

ROOMS, SERVICES = 20, 5
LOOK_S = 3.0
LONGEST_S = 600.0
"""A service that takes longer than this has failed."""
ANSWER_S = 2.0
"""An order that has not left the ground after this was refused."""


@dataclass
class RoomDay:
    """What happened in one room with its services."""

    flown: int = 0
    refused: Counter[str] = field(default_factory=Counter)
    violations: tuple[str, ...] = ()
    walked_into: str = ""
    person_clearance: float = 9.0
    durations: list[float] = field(default_factory=list)
    told: Counter[str] = field(default_factory=Counter)


def loaded_lively() -> LoadedSite:
    """Return the lively room without its broker, which lock step does not need."""
    changes = {k: v for k, v in demo_changes().items() if not k.startswith("mqtt__")}
    return load_site("bsen", hub__enabled=False, **changes)


def has_ended(step: PilotStep) -> bool:
    """Return whether nothing is going on and the drone stands."""
    telemetry = step.inputs.telemetry
    stands = telemetry is not None and telemetry.status in (
        DroneStatus.LANDED,
        DroneStatus.EMERGENCY,
    )
    return stands and step.outputs.phase is Phase.IDLE


def spend_day(seed: int) -> RoomDay:
    """Let somebody ask for services at odd moments while people live their lives."""
    loaded, rng, day = loaded_lively(), np.random.default_rng(seed), RoomDay()
    loaded = replace(loaded, site=changed(loaded.site, twin__seed=1 + seed))
    simulation = Simulation(loaded)
    oracle = Oracle(simulation.world, loaded.site, loaded.room, faulty_since=0.0)
    places = [place.name for place in loaded.room.places if place.name != "home"]
    due, since, asked = float(rng.uniform(0.5, 60.0)), None, 0
    while asked < SERVICES or since is not None:
        simulation.advance()
        orders: tuple[Order, ...] = ()
        if since is None and simulation.now >= due:
            place = places[int(rng.integers(len(places)))]
            orders = (Order(OrderKind.SERVICE, place=place, look_s=LOOK_S, sender="benchmark"),)
            since, asked = simulation.now, asked + 1
            oracle.orders = asked
        step = simulation.step(simulation.inputs(*orders))
        oracle.watch(step)
        for event in step.outputs.events:
            day.told[event.code] += 1
            if event.code is EventCode.ORDER_REFUSED:
                day.refused[event.text] += 1
        if since is None or simulation.now - since < ANSWER_S:
            continue
        took = simulation.now - since
        if has_ended(step) or took > LONGEST_S:
            if took > 2.0 * ANSWER_S:
                day.flown += 1
                day.durations.append(took)
            since, due = None, simulation.now + float(rng.uniform(1.0, 40.0))
    day.violations = tuple(oracle.violations.values())
    day.walked_into = oracle.walked_into
    day.person_clearance = oracle.person_clearance
    return day


def days_kept(path: Path) -> dict[int, RoomDay]:
    """Return the days that a file holds, by seed."""
    days = {}
    for kept in lines_kept(path):
        day = RoomDay(**kept["day"])
        day.refused, day.told = Counter(day.refused), Counter(day.told)
        days[kept["seed"]] = day
    return days


def days_spent(rooms: int, path: Path, workers: int) -> list[RoomDay]:
    """Return the days of so many rooms; those that the file lacks are spent now."""
    return pieces_done(
        rooms, days_kept(path), spend_day, lambda seed, day: {"seed": seed, "day": vars(day)},
        lambda day: "; ".join(day.violations) or "nothing broken", path, workers,
    )  # fmt: skip


def main() -> None:
    """Spend the days, and print what came of them."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("rooms", type=int, nargs="?", default=ROOMS)
    parser.add_argument("--out", type=Path, default=Path("lively-services.jsonl"))
    parser.add_argument("--workers", type=int, default=os.cpu_count())
    options = parser.parse_args()
    days = days_spent(options.rooms, options.out, options.workers)
    print("## A hundred services among people\n")
    durations = sorted(t for day in days for t in day.durations)
    refused = sum((day.refused for day in days), Counter())
    touched = [words for day in days for words in day.violations]
    walked = [day.walked_into for day in days if day.walked_into]
    given_up = [day.told["take_off_given_up"] for day in days]
    rows = [
        ("services flown", sum(day.flown for day in days)),
        ("refused before take-off", sum(refused.values())),
        ("given up at the floor, because somebody came", sum(given_up)),
        ("contacts, or another invariant broken", len(touched)),
        ("walked into during its own take-off", len(walked)),
        ("nearest a person came to the hull", f"{min(d.person_clearance for d in days):.2f} m"),
        ("median duration", f"{durations[len(durations) // 2]:.0f} s"),
        ("longest", f"{durations[-1]:.0f} s"),
    ]
    print(table(["what", "figure"], rows))
    for words, count in refused.most_common():
        print(f"\nRefused {count} times: {words}.")
    for words in (*touched, *walked):
        print(f"\nBroken: {words}.")


if __name__ == "__main__":
    main()
