"""What a campaign says: for each point of the grid, means and shares over seeds with their 95 %
intervals.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass
from itertools import pairwise, product
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.errors import MissingPartError, RecordingError
from housefly.lab.campaigns.spec import WORDS, Spec
from housefly.lab.experiments.intervals import Estimate, mean, share
from housefly.lab.experiments.outcomes import MEASURES

try:
    import pyarrow.parquet as pq
except ImportError as error:
    raise MissingPartError("pyarrow (results as Parquet)", "pip install 'housefly[lab]'") from error

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


def summarize(spec: Spec, results: Path) -> tuple[Cell, ...]:
    """Return the cells of a campaign's ``results.parquet`` in the order of the grid; one column is
    in memory at a time.

    Distances of a flight that diverged say nothing, so they are averaged over the stable ones;
    ``stable`` tells their share.
    """
    cells = _column(results, "cell")
    order = np.argsort(cells, kind="stable")
    bounds = np.searchsorted(cells[order], np.arange(spec.points + 1))
    stable = _column(results, "stable")[order] == 1.0
    estimates: list[dict[str, Estimate]] = [{} for _ in range(spec.points)]
    for measure in MEASURES:
        numbers = _column(results, measure.name)[order]
        for cell, (first, last) in enumerate(pairwise(bounds)):
            own = stable[first:last]
            estimates[cell][measure.name] = (
                share(own) if measure.name in SHARES else mean(numbers[first:last][own])
            )
    points = product(*spec.grid.values())
    return tuple(
        Cell(tuple(float(value) for value in point), int(last - first), found)
        for point, (first, last), found in zip(points, pairwise(bounds), estimates, strict=True)
    )


def _column(results: Path, name: str) -> NDArray[Any]:
    values: NDArray[Any] = pq.read_table(results, columns=[name]).column(name).to_numpy()
    return values


def shown(column: str, value: float) -> str:
    """Return a value of a grid column as a person writes it."""
    words = {number: word for word, number in WORDS.get(column, {}).items()}
    return words[int(value)] if words else f"{value:g}"


def told(measure: str, estimate: Estimate) -> str:
    """Return an estimate with its interval as a person writes it."""
    value, low, high = estimate
    if not np.isfinite(value):
        return "-"
    if measure in SHARES:
        return f"{100 * value:.0f} % ({100 * low:.0f} to {100 * high:.0f})"
    if not np.isfinite(estimate.half):
        return f"{value:.3g}"
    decimals = (
        min(max(1 - int(np.floor(np.log10(estimate.half))), 0), 6) if estimate.half > 0.0 else 3
    )
    return f"{value:.{decimals}f} ± {estimate.half:.{decimals}f}"


def write_summary(path: Path, spec: Spec, cells: tuple[Cell, ...]) -> None:
    """Write one row a cell and three columns a measure as CSV; raises RecordingError when the disk
    does not take it.
    """
    names = [measure.name for measure in MEASURES]
    try:
        with path.open("w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(
                [
                    *spec.grid,
                    "drones",
                    *(f"{name}{end}" for name in names for end in ("", "_low", "_high")),
                ]
            )
            for cell in cells:
                numbers = [f"{number:.6g}" for name in names for number in cell.estimates[name]]
                values = (
                    shown(column, value)
                    for column, value in zip(spec.grid, cell.values, strict=True)
                )
                writer.writerow([*values, cell.drones, *numbers])
    except OSError as error:
        raise RecordingError(f"{path} cannot be written: {error.strerror}") from error
