"""How fast campaigns fly what the live pilot flies: trajectories, with all that it works out.

``python benchmarks/campaign_in_space.py [DRONES]``
"""

from __future__ import annotations

import sys
import time
from statistics import median
from typing import Any

import numpy as np

from _run import table
from housefly.config.estimation import ONLY_LEVEL_PUSHES
from housefly.config.site import Site, changed
from housefly.lab.experiments.cases import cases
from housefly.lab.experiments.engine import fly_many
from housefly.lab.experiments.flight_plan import FlightPlan
from housefly.lab.experiments.planned_flight import planned_flight
from housefly.pilot.navigator import RoomNavigator
from housefly.sites.loaded_site import open_site, read_site

DURATION, REPEATS = 24.0, 5
"""Of a flight [s], and how often each fleet flies."""
GOAL = 30_000
"""Drone-seconds per core-second."""
PLANNERS = ("space", "grid")
LEVEL: dict[str, Any] = {"estimation": ONLY_LEVEL_PUSHES.model_dump()}
ESTIMATORS: dict[str, dict[str, Any]] = {
    "as shipped": {},
    "without delay": {"estimation__delay_deviation": 0.0},
    "pushes in the plane only": LEVEL,
}


def main() -> None:
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 500
    rows = []
    for planner in PLANNERS:
        site, plan = _service(planner)
        for words, changes in ESTIMATORS.items():
            for rate in (100.0, 30.0):
                speed, rms = _flown(changed(site, **changes), plan, rate, count)
                rows.append(
                    (
                        planner,
                        words,
                        f"{rate:.0f} Hz",
                        f"{speed:,.0f}",
                        f"{speed / GOAL:.2f}",
                        f"{rms:.1f}",
                    )
                )
    print("### Campaigns: drone-seconds per core-second along the way that the pilot flies\n")
    headings = (
        "planner",
        "worked out in flight",
        "tracking",
        "drone-seconds per core-second",
        f"share of {GOAL:,}",
        "off the way [mm rms]",
    )
    print(table(headings, rows))
    print(
        f"\nFrom home to the entrance of B-sen; {count:,} drones on one thread, pilot at 100 Hz,"
        f" 5 % of frames lost, {DURATION:.0f} s each; median of {REPEATS}."
    )


def _service(planner: str) -> tuple[Site, FlightPlan]:
    loaded = open_site(read_site("bsen", map__planner=planner))
    room, height = loaded.room, loaded.site.map.flight_height
    plan = planned_flight(
        RoomNavigator(loaded.site, room, loaded.grid),
        (*room.home, height),
        room.home_yaw,
        room.place("entrance").viewpoint,
        DURATION,
    )
    assert isinstance(plan, FlightPlan), plan
    return loaded.site, plan


def _flown(site: Site, plan: FlightPlan, rate: float, count: int) -> tuple[float, float]:
    """Return drone-seconds per core-second and the median distance from the way [mm]."""
    fleet = cases(site, count, seed=np.arange(count), mocap_rate_hz=rate, mocap_dropout=0.05)
    fly_many(fleet[:8], plan, threads=1)
    speeds = []
    for _ in range(REPEATS):
        begun = time.process_time()
        outcomes = fly_many(fleet, plan, threads=1)
        speeds.append(float(outcomes["ended_at"].sum()) / (time.process_time() - begun))
    return median(speeds), 1000.0 * float(np.median(outcomes["rms_error"]))


if __name__ == "__main__":
    main()
