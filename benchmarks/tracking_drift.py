"""How far tracking that drifts has come when a person is told: services in space, on the truth.

    python benchmarks/tracking_drift.py           300 services of each rate, about 8 minutes
    python benchmarks/tracking_drift.py 20        twenty of each

The drift begins in every phase of a service. Counted is how far tracking was off when it was told,
for those that begin in the air before the landing; deviation is of all.
"""

from __future__ import annotations

import sys
from concurrent.futures import ProcessPoolExecutor
from itertools import chain

from _run import percentile, table
from housefly.lab.safety_case.campaign import alike, fly_alike
from housefly.lab.safety_case.fault_phase import IN_FLIGHT_FAULT_PHASES, FaultPhase
from housefly.lab.safety_case.trial import TrialKey, TrialResult

RATES = {"F13/2cm": 0.02, "F13/5cm": 0.05}
"""Drift of the rows [m/s]."""
TOLD_WITHIN = 0.1
"""Every drift is to be told before tracking is so far off [m]."""


def row_of_table(rate: float, flown: list[TrialResult]) -> tuple[str, ...]:
    """Return what the services with a drift of a rate [m/s] came to."""
    steered = frozenset(IN_FLIGHT_FAULT_PHASES) - {FaultPhase.LANDING}
    begun = [result for result in flown if result.phase in steered]
    off = [rate * result.told_after for result in begun if result.told_after is not None]
    late = len(begun) - sum(lied <= TOLD_WITHIN for lied in off)
    return (
        f"{100 * rate:g} cm/s",
        f"{len(begun)} of {len(flown)}",
        f"{percentile(off, 0.5):.3f} m",
        f"{percentile(off, 0.99):.3f} m",
        f"{max(off):.3f} m",
        f"{late}",
        f"{max(result.deviation for result in flown):.2f} m",
        f"{sum(result.unsafe for result in flown)}",
    )


def main(flights: int = 300) -> None:
    """Fly all rates and print the table."""
    rows = []
    with ProcessPoolExecutor() as processes:
        for name, rate in RATES.items():
            groups = alike(TrialKey(name, seed) for seed in range(flights))
            flown = list(chain.from_iterable(processes.map(fly_alike, groups)))
            rows.append(row_of_table(rate, flown))
            print(f"{name}: done", file=sys.stderr, flush=True)
    headings = (
        *("drift", "begun in the air", "told at, median", "99 of 100", "farthest"),
        *(f"later than {TOLD_WITHIN} m", "farthest from the path", "unsafe"),
    )
    print("## Tracking that drifts\n")
    print(table(headings, rows))


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
