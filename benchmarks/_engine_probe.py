"""Flies fleets with the engine of whichever tree is on the path, one line of JSON a round.

``python benchmarks/_engine_probe.py`` reads a line for each round on standard input.
"""

# mypy: ignore-errors
# The tree on the path may be an old one, with other modules.

from __future__ import annotations

import json
import sys
import time
from hashlib import sha256

import numpy as np

try:
    from housefly.config.site import Site
    from housefly.lab.experiments.cases import cases
    from housefly.lab.experiments.engine import fly_many
    from housefly.lab.experiments.flight_plan import FlightPlan, Task
except ImportError:  # release 0.1.0
    from housefly.experiments.cases import cases
    from housefly.experiments.engine import fly_many
    from housefly.experiments.mission import Mission as FlightPlan
    from housefly.experiments.mission import Task

    from housefly.config import Site

try:
    from housefly.config.estimation import ONLY_LEVEL_PUSHES
    from housefly.config.site import changed

    SITE = changed(Site(), estimation=ONLY_LEVEL_PUSHES.model_dump())
except ImportError:  # before anything else was worked out in flight
    SITE = Site()

PLAN = FlightPlan(Task.PATH, ((0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (6.0, 2.0)), 20.0)
MODES = {"default": {"mode": 0, "estimator": 0}, "paper": {"mode": 1, "estimator": 1}}


def main() -> None:
    count = int(sys.argv[1])
    fleets = {
        f"{mode}, {rate:.0f} Hz": cases(
            SITE,
            count,
            seed=np.arange(count),
            mocap_rate_hz=rate,
            mocap_dropout=0.05,
            **columns,
        )
        for mode, columns in MODES.items()
        for rate in (100.0, 30.0)
    }
    for fleet in fleets.values():
        fly_many(fleet[:64], PLAN, threads=1)
    print("ready", flush=True)
    for line in sys.stdin:
        start = time.process_time()
        outcomes = fly_many(fleets[line.strip()], PLAN, threads=1)
        seconds = time.process_time() - start
        rate = float(outcomes["ended_at"].sum()) / seconds
        digest = sha256(outcomes.tobytes()).hexdigest()
        print(json.dumps({"rate": rate, "digest": digest}), flush=True)


if __name__ == "__main__":
    main()
