"""Ten simulated hours in the air without a fault: every warning or worse is a false alarm.

    python benchmarks/false_alarms.py           ten hours, about half an hour on a core
    python benchmarks/false_alarms.py 1         one hour

A quarter each with tracking at 100, 30 and 10 Hz, and at 10 Hz with 30 % of the frames lost. What
was flown is kept in false-alarms.jsonl; the same command goes on, at the lowest priority. Contacts
are those of the simulated room, not what the pilot believed. Two frames lost in a row at 10 Hz
leave a pose that truly is older than 0.25 s: that is told, and counted by itself.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections import Counter
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from _pieces import lines_kept, pieces_done
from _run import table
from housefly.config.site import changed
from housefly.lab.lockstep.simulation import Simulation
from housefly.lab.safety_case.oracle import Oracle
from housefly.messages import EventCode, Order, OrderKind, Severity
from housefly.sites.loaded_site import LoadedSite, load_site

TRACKING = ((100.0, 0.0), (30.0, 0.0), (10.0, 0.0), (10.0, 0.3))
"""Rate [Hz] and share of frames lost."""
UNIT_S = 900.0
"""Time in the air of what is flown in one piece [s]."""
LOOK_S = 3.0
LONGEST_S = 240.0
"""A service that takes longer than this has failed."""


@dataclass
class CalmFlights:
    """What happened in some flights without a fault."""

    tracking: int
    flights: int = 0
    airborne_s: float = 0.0
    alarms: Counter[str] = field(default_factory=Counter)
    poses_old: int = 0
    violations: tuple[str, ...] = ()
    room_clearance: float = 9.0


def fly_calm(unit: int) -> CalmFlights:
    """Fly services to places drawn from the unit's number until its time in the air is over."""
    loaded, flown = load_site("bsen", hub__enabled=False), CalmFlights(unit % len(TRACKING))
    rate, lost = TRACKING[flown.tracking]
    rng = np.random.default_rng(unit)
    places = [place.name for place in loaded.room.places if place.name != "home"]
    while flown.airborne_s < UNIT_S:
        seed = int(rng.integers(1, 2**31 - 1))
        site = changed(
            loaded.site, twin__seed=seed, twin__mocap_rate_hz=rate, twin__mocap_dropout=lost
        )
        fly_service(replace(loaded, site=site), str(rng.choice(places)), flown)
    return flown


def fly_service(loaded: LoadedSite, place: str, flown: CalmFlights) -> None:
    """Fly one service, and add what happened."""
    simulation = Simulation(loaded)
    oracle = Oracle(simulation.world, loaded.site, loaded.room, faulty_since=0.0)
    orders: tuple[Order, ...] = (
        Order(OrderKind.SERVICE, place=place, look_s=LOOK_S, sender="benchmark"),
    )
    period = 1.0 / loaded.site.control.rate_hz
    while True:
        simulation.advance()
        step = simulation.step(simulation.inputs(*(orders if simulation.now > 0.5 else ())))
        orders = () if simulation.now > 0.5 else orders
        oracle.watch(step)
        for event in step.outputs.events:
            if (
                event.code in (EventCode.TRACKING_OLD, EventCode.TRACKING_GAP)
                or "limits.pose_age_level" in event.text
            ):
                flown.poses_old += 1
            elif event.severity is not Severity.INFO:
                flown.alarms[event.text] += 1
        if simulation.world.onboard().flight.airborne:
            flown.airborne_s += period
        is_late = simulation.now > LONGEST_S
        if is_late or (simulation.now > 3.0 and oracle.ended(step)):
            break
    oracle.conclude(step, is_late)
    flown.flights += 1
    flown.violations += tuple(oracle.violations.values())
    flown.room_clearance = min(flown.room_clearance, oracle.room_clearance)


def flown_before(path: Path) -> dict[int, CalmFlights]:
    """Return the units that a file holds."""
    units = {}
    for plain in lines_kept(path):
        number, flown = plain.pop("unit"), CalmFlights(**plain)
        flown.alarms = Counter(flown.alarms)
        units[number] = flown
    return units


def flown_units(wanted: int, path: Path, workers: int) -> list[CalmFlights]:
    """Return so many units; those that the file lacks are flown now."""
    return pieces_done(
        wanted, flown_before(path), fly_calm, lambda n, unit: {"unit": n, **vars(unit)},
        lambda unit: "; ".join((*unit.alarms, *unit.violations)) or "no alarm", path, workers,
    )  # fmt: skip


def main() -> None:
    """Fly, and print what was told."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("hours", type=float, nargs="?", default=10.0)
    parser.add_argument("--out", type=Path, default=Path("false-alarms.jsonl"))
    parser.add_argument("--workers", type=int, default=os.cpu_count())
    options = parser.parse_args()
    wanted = max(1, round(3600.0 * options.hours / UNIT_S))
    print(f"{wanted} pieces of {UNIT_S / 60:.0f} min ...", file=sys.stderr, flush=True)
    units = flown_units(wanted, options.out, options.workers)
    print("## Without a fault\n")
    rows = []
    for number, (rate, lost) in enumerate(TRACKING):
        own = [unit for unit in units if unit.tracking == number]
        rows.append(
            (
                f"{rate:.0f} Hz" + (f", {100 * lost:.0f} % lost" if lost else ""),
                f"{sum(unit.airborne_s for unit in own) / 3600:.1f} h",
                sum(unit.flights for unit in own),
                sum(unit.alarms.total() for unit in own),
                sum(unit.poses_old for unit in own),
                sum(len(unit.violations) for unit in own),
                f"{min((unit.room_clearance for unit in own), default=0.0):.2f} m",
            )
        )
    head = [
        "tracking", "in the air", "services", "false alarms", "poses truly old",
        "invariants broken", "clearance",
    ]  # fmt: skip
    print(table(head, rows))
    for words in (w for unit in units for w in (*unit.alarms, *unit.violations)):
        print(f"\nTold: {words}.")


if __name__ == "__main__":
    main()
