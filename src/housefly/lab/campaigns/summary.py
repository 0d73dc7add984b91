"""Means and shares over seeds with 95 % intervals, for each point of the grid."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from itertools import pairwise, product
from math import floor, log10
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.errors import MissingPartError, RecordingError
from housefly.lab.campaigns.spec import COLUMN_WORDS, CampaignSpec
from housefly.lab.experiments.intervals import IntervalEstimate, mean, share
from housefly.lab.experiments.outcomes import ARRIVED, MEASURES, SUMMARY_MEASURES

try:
    import pyarrow.parquet as pq
except ImportError as error:
    raise MissingPartError("pyarrow (results as Parquet)", "pip install 'housefly[lab]'") from error

SHARES = ("stable", ARRIVED.name)
"""Measures that are 0 or 1."""


@dataclass(frozen=True, slots=True)
class GridPoint:
    """One point of the grid.

    Attributes:
        values: of the grid's columns.
        drones: how many flew there.
        estimates: by measure.
    """

    values: tuple[float, ...]
    drones: int
    estimates: dict[str, IntervalEstimate]


def summarize_campaign(spec: CampaignSpec, results: Path) -> tuple[GridPoint, ...]:
    """Return the grid points of a campaign's ``results.parquet`` in grid order.

    One column is in memory at a time. Errors of a flight that diverged mean nothing, so means are
    taken over the stable flights; ``stable`` is their share. A flight that never arrives has no
    arrival time: ``arrived`` is the share of all flights that have one.
    """
    cells = _column(results, "cell")
    order = np.argsort(cells, kind="stable")
    bounds = np.searchsorted(cells[order], np.arange(spec.points + 1))
    stable = _column(results, "stable")[order] == 1.0
    estimates: list[dict[str, IntervalEstimate]] = [{} for _ in range(spec.points)]
    for measure in MEASURES:
        numbers = _column(results, measure.name)[order]
        for cell, (first, last) in enumerate(pairwise(bounds)):
            own = stable[first:last]
            estimates[cell][measure.name] = (
                share(own) if measure.name in SHARES else mean(numbers[first:last][own])
            )
    arrived = np.isfinite(_column(results, "arrival_time")[order])
    for own_estimates, (first, last) in zip(estimates, pairwise(bounds), strict=True):
        own_estimates[ARRIVED.name] = share(arrived[first:last])
    points = product(*spec.grid.values())
    return tuple(
        GridPoint(tuple(float(value) for value in point), int(last - first), found)
        for point, (first, last), found in zip(points, pairwise(bounds), estimates, strict=True)
    )


def _column(results: Path, name: str) -> NDArray[Any]:
    values: NDArray[Any] = pq.read_table(results, columns=[name]).column(name).to_numpy()
    return values


def value_text(column: str, value: float) -> str:
    """Return a value of a grid column as people write it."""
    words = {number: word for word, number in COLUMN_WORDS.get(column, {}).items()}
    return words[int(value)] if words else f"{value:g}"


def estimate_text(measure: str, estimate: IntervalEstimate) -> str:
    """Return an estimate with its interval as people write it."""
    value, low, high = estimate
    if not np.isfinite(value):
        return "-"
    if measure in SHARES:
        return f"{100 * value:.0f} % ({100 * low:.0f} to {100 * high:.0f})"
    if not np.isfinite(estimate.half):
        return f"{value:.3g}"
    decimals = min(max(1 - floor(log10(estimate.half)), 0), 6) if estimate.half > 0.0 else 3
    return f"{value:.{decimals}f} ± {estimate.half:.{decimals}f}"


def write_summary(path: Path, spec: CampaignSpec, cells: tuple[GridPoint, ...]) -> None:
    """Write a CSV with one row per grid point and three columns per measure.

    Raises RecordingError when that fails.
    """
    names = [measure.name for measure in SUMMARY_MEASURES]
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
                    value_text(column, value)
                    for column, value in zip(spec.grid, cell.values, strict=True)
                )
                writer.writerow([*values, cell.drones, *numbers])
    except OSError as error:
        raise RecordingError(f"{path} cannot be written: {error.strerror}") from error
