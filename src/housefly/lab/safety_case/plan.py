"""Which flights the safety case is made of."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import combinations

from housefly.lab.safety_case.trial import PersonOrder, TrialKey
from housefly.twin.faults.catalogue import FAULT_CATALOGUE
from housefly.twin.faults.fault_row import FaultRow

FAULT_FREE = ""
"""The row without a fault: every word in it is a false alarm."""
COURSES = 24
"""Seeds of crossed flights are below this, each phase at each tracking rate: alike flights are
flown once until their faults begin.
"""
_V_STEP, _O_STEP = 7, 11
"""Cells beside each other begin at other courses: numbers without a common factor with those."""


@dataclass(frozen=True, slots=True)
class SafetyPlan:
    """How many flights of what.

    Attributes:
        seeds: flights of each row, shared out among its variants.
        controls: flights of each harmful row without guards.
        pairs: flights of each pair of rows.
        fault_free: flights without a fault.
        crossed: flights of each row that is crossed with a person's orders.
        rows: only these rows; all when empty.
        model: of the drone; "" is the room's own.
    """

    seeds: int = 300
    controls: int = 24
    pairs: int = 1
    fault_free: int = 300
    crossed: int = 50
    rows: tuple[str, ...] = ()
    model: str = ""

    def keys(self) -> list[TrialKey]:
        """Return every flight, those that tell most first."""
        return [replace(key, model=self.model) for key in self._keys()]

    def _keys(self) -> list[TrialKey]:
        rows = [row for row in flown_rows() if not self.rows or row.number in self.rows]
        keys = [
            TrialKey(name, seed)
            for row in rows
            if not row.crossed
            for name, seed in shared_out(variants_flown(row), self.seeds)
        ]
        keys += [
            key
            for row in rows
            if row.crossed
            for key in crossed_out(variants_flown(row), self.crossed)
        ]
        keys += [
            TrialKey(name, seed, guarded=False)
            for row in rows
            if row.harmful
            for name, seed in shared_out(variants_flown(row), self.controls)
        ]
        if not self.rows:
            keys += [TrialKey(FAULT_FREE, seed) for seed in range(self.fault_free)]
            single = [row for row in rows if not row.crossed]
            keys += [
                TrialKey(f"{a.number}+{b.number}", seed)
                for a, b in combinations(single, 2)
                for seed in range(self.pairs)
            ]
        return keys


def flown_rows() -> tuple[FaultRow, ...]:
    """Return the rows that can be flown in lock step."""
    return tuple(row for row in FAULT_CATALOGUE if variants_flown(row))


def variants_flown(row: FaultRow) -> tuple[str, ...]:
    """Return the names of a row's variants that are flown in lock step."""
    return tuple(
        f"{row.number}/{v.name}" for v in row.variants if not (v.wires_only or v.is_extreme)
    )


def shared_out(names: tuple[str, ...], flights: int) -> list[tuple[str, int]]:
    """Return so many flights as names and seeds, shared out among the names in turn."""
    count = len(names)
    return [(names[n % count], n // count) for n in range(flights)] if names else []


def crossed_out(names: tuple[str, ...], flights: int) -> list[TrialKey]:
    """Return so many flights, shared out among the names, a person's orders, phases and rates."""
    orders = tuple(PersonOrder)
    cells = [(v, o) for o in range(len(orders)) for v in range(len(names))]
    return [
        TrialKey(names[v], (_V_STEP * v + _O_STEP * o + lap) % COURSES, order=orders[o])
        for lap in range(flights // max(len(cells), 1) + 1)
        for v, o in cells
    ][:flights]
