"""How strong gusts may be: whole services from a pad 0.5 m beside a wall, scored on the truth.

    python benchmarks/gusts_beside_a_wall.py           60 flights of each strength, about 5 minutes
    python benchmarks/gusts_beside_a_wall.py 10        ten of each

The gusts begin in every phase of a flight, before the take-off too, and blow until its end. Safe is
who touches nothing but the floor and does not fall.
"""

from __future__ import annotations

import sys
from concurrent.futures import ProcessPoolExecutor
from itertools import repeat

from _run import table
from housefly.lab.safety_case.faulty_flight import FaultyFlight, course_of, onset_of
from housefly.lab.safety_case.trial import TrialKey, TrialResult
from housefly.twin.faults.fault import Fault
from housefly.twin.faults.vocabulary import FaultComponent, FaultKind

STRENGTHS = (0.3, 0.5, 0.6, 0.8, 1.0)
"""One sigma of the gusts [m/s]."""
ROW = "F23/gusts"


def fly_in_gusts(strength: float, seed: int) -> TrialResult:
    """Fly one service in gusts of a strength [m/s], and return how it ended."""
    key = TrialKey(ROW, seed)
    gusts = Fault(FaultComponent.WIND, FaultKind.WRONG, "gust", magnitude=strength, seed=1 + seed)
    flight, onset = FaultyFlight(course_of(key)), onset_of(key)
    while not flight.is_over:
        flight.advance()
        if flight.is_due(onset):
            return flight.finish(key, (gusts,))
    return flight.result(key)


def main(flights: int = 60) -> None:
    """Fly all strengths and print the table."""
    rows = []
    with ProcessPoolExecutor() as processes:
        for strength in STRENGTHS:
            flown = list(processes.map(fly_in_gusts, repeat(strength), range(flights)))
            unsafe = [result for result in flown if result.unsafe]
            told = sum(bool(result.told) for result in flown)
            nearest = min(result.room_clearance or 0.0 for result in flown)
            rows.append(
                (f"{strength:g}", f"{len(unsafe)} of {flights}", f"{told}", f"{nearest:.2f}")
            )
            print(f"{strength:g} m/s: {len(unsafe)} of {flights} unsafe", file=sys.stderr)
    print(table(("gusts, one sigma [m/s]", "unsafe", "told", "nearest [m]"), rows))


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
