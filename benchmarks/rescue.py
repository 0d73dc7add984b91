"""What becomes of flights whose sensors fail and whose person then orders something.

``python benchmarks/rescue.py --rows F46 F51 --flights 100`` flies the crossed rows of the fault
matrix on one core, and prints unsafe flights of all, by variant and by order.
"""

from __future__ import annotations

import argparse
from collections import Counter

from housefly.lab.safety_case.campaign import alike, fly_alike
from housefly.lab.safety_case.plan import crossed_out, flown_rows, variants_flown
from housefly.lab.safety_case.trial import PersonOrder, TrialKey, TrialResult


def main() -> None:
    """Fly and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rows", nargs="+", default=[], help="of the matrix (default: crossed)")
    parser.add_argument("--flights", type=int, default=100, help="of each row (default: 100)")
    options = parser.parse_args()
    rows = [row for row in flown_rows() if row.crossed]
    rows = [row for row in rows if not options.rows or row.number in options.rows]
    flown: list[TrialResult] = []
    for row in rows:
        keys = crossed_out(variants_flown(row), options.flights)
        for group in alike(keys):
            for result in fly_alike(group):
                flown.append(result)
                if result.unsafe:
                    print(_line(result), flush=True)
    _summary(flown)


def _line(result: TrialResult) -> str:
    key = result.key
    what = f"{key.row} {key.order.value} --seed {key.seed} {result.phase.value}"
    return f"UNSAFE {what}: {'; '.join(result.violations)}; {result.told}"


def _summary(flown: list[TrialResult]) -> None:
    of_all: Counter[tuple[str, PersonOrder]] = Counter(_cell(r.key) for r in flown)
    unsafe = Counter(_cell(r.key) for r in flown if r.unsafe)
    names = dict.fromkeys(name for name, _ in of_all)
    print(" ".join([f"{'':24}", *(f"{order.value:>12}" for order in PersonOrder)]))
    for name in names:
        cells = (f"{unsafe[name, o]}/{of_all[name, o]}" for o in PersonOrder)
        print(" ".join([f"{name:24}", *(f"{cell:>12}" for cell in cells)]))
    print(f"{sum(unsafe.values())} of {len(flown)} flights unsafe")


def _cell(key: TrialKey) -> tuple[str, PersonOrder]:
    return key.row, key.order


if __name__ == "__main__":
    main()
