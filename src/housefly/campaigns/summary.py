"""What a campaign says: for each point of the grid, means and shares over seeds with their 95 % intervals."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from housefly.campaigns.spec import WORDS, Spec
from housefly.experiments.intervals import Estimate, mean, share
from housefly.experiments.outcomes import MEASURES

SHARES = ("stable",)
"""Measures that are yes or no."""


@dataclass(frozen=True, slots=True)
class Cell:
    """One point of the grid.

    Attributes:
        values: of the grid's columns.
        drones: how many flew there.
        estimates: by measure.
    """

    values: tuple[float, ...]
    drones: int
    estimates: dict[str, Estimate]


def summarize(spec: Spec, table: Any) -> tuple[Cell, ...]:
    """Return the cells of a campaign's results (a pyarrow table), in the order of the grid.

    Distances of a flight that diverged say nothing, so they are averaged over the stable ones; ``stable`` tells their share.
    """
    columns = {name: table.column(name).to_numpy() for name in table.column_names}
    order = np.argsort(columns["cell"], kind="stable")
    bounds = np.searchsorted(columns["cell"][order], np.arange(spec.points + 1))
    cells = []
    for first, last in pairwise(bounds):
        rows = order[first:last]
        stable = columns["stable"][rows] == 1.0
        estimates = {
            measure.name: share(stable) if measure.name in SHARES else mean(columns[measure.name][rows][stable])
            for measure in MEASURES
        }
        values = tuple(float(columns[name][rows[0]]) for name in spec.grid)
        cells.append(Cell(values, len(rows), estimates))
    return tuple(cells)


def shown(column: str, value: float) -> str:
    """Return a value of a grid column as a person writes it."""
    words = {number: word for word, number in WORDS.get(column, {}).items()}
    return words.get(int(value), f"{value:g}") if words else f"{value:g}"


def write_summary(path: Path, spec: Spec, cells: tuple[Cell, ...]) -> None:
    """Write one row a cell and three columns a measure as CSV."""
    names = [measure.name for measure in MEASURES]
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow([*spec.grid, "drones", *(f"{name}{end}" for name in names for end in ("", "_low", "_high"))])
        for cell in cells:
            numbers = [f"{number:.6g}" for name in names for number in cell.estimates[name]]
            values = (shown(column, value) for column, value in zip(spec.grid, cell.values, strict=True))
            writer.writerow([*values, cell.drones, *numbers])
