"""What a row of the gate came to, as plain numbers that can be kept and drawn."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from math import nan
from typing import Any

import numpy as np

from housefly.geometry import Vec2
from housefly.numeric import FloatArray
from quality_gate.leg_measures import LegMeasures

_DRAWN_EVERY = 10
"""Of the pilot's steps, for plots."""


@dataclass(frozen=True, slots=True)
class FlownLeg:
    """One errand, landing or round.

    Attributes:
        goal: [m].
        bound: shortest time for the way that its reference went [s]; 0 for one that ends on the
            floor.
        measures: how well.
        outcome: "" for well, else what went wrong, in words.
        course: every tenth row of ``flown_track.COLUMNS``.
    """

    goal: Vec2
    bound: float
    measures: LegMeasures
    outcome: str
    course: tuple[tuple[float, ...], ...]


@dataclass(frozen=True, slots=True)
class RowMeasures:
    """A row in numbers; lengths in metres, times in seconds, not a number where there is none.

    Attributes:
        time: told by the pilot, summed over the legs that end in the air; infinite when one did
            not arrive.
        bound: the shortest possible.
        ratio: time over bound.
        clearance: smallest, from the drone's middle to a solid.
        gap: smallest, from the hull as it was turned to a solid.
        reference_rms, reference_max: off the moving reference.
        path_rms, path_max: off the line that it draws.
        height_max, height_end: off the wanted height: largest, and largest at the end of a leg.
        overshoot, off_goal: largest.
        whole: longest, from the order to the floor.
        touchdown: off the pad, largest.
        arrived, legs: how many.
        contacts: things touched.
        top_speed: [m/s].
    """

    time: float = nan
    bound: float = nan
    ratio: float = nan
    clearance: float = nan
    gap: float = nan
    reference_rms: float = nan
    reference_max: float = nan
    path_rms: float = nan
    path_max: float = nan
    height_max: float = nan
    height_end: float = nan
    overshoot: float = nan
    off_goal: float = nan
    whole: float = nan
    touchdown: float = nan
    arrived: float = 0.0
    legs: float = 0.0
    contacts: float = 0.0
    top_speed: float = nan


@dataclass(frozen=True, slots=True)
class FlownRow:
    """A row as one way of flying flew it.

    Attributes:
        row, way, key: which; the key names tree and changes, too.
        measures: in numbers.
        legs: one by one.
        outcome: "" when everything arrived, else the first thing that went wrong.
        processor_s: what it took [s].
    """

    row: str
    way: str
    key: str
    measures: RowMeasures
    legs: tuple[FlownLeg, ...]
    outcome: str
    processor_s: float

    def to_json(self) -> dict[str, Any]:
        """Return plain values."""
        return asdict(self)


def row_from_json(plain: dict[str, Any]) -> FlownRow:
    """Return the row that ``to_json`` gave; raises KeyError or TypeError for anything else."""
    legs = tuple(
        FlownLeg(
            goal=(leg["goal"][0], leg["goal"][1]),
            bound=leg["bound"],
            measures=LegMeasures(**leg["measures"]),
            outcome=leg["outcome"],
            course=tuple(tuple(row) for row in leg["course"]),
        )
        for leg in plain["legs"]
    )
    return FlownRow(**{**plain, "measures": RowMeasures(**plain["measures"]), "legs": legs})


def drawn(course: FloatArray) -> tuple[tuple[float, ...], ...]:
    """Return every tenth row of a course, rounded to what a plot shows."""
    return tuple(tuple(round(v, 4) for v in row) for row in course[::_DRAWN_EVERY].tolist())


def row_measures(legs: tuple[FlownLeg, ...], contacts: int) -> RowMeasures:
    """Return a row in numbers."""
    if not legs:
        return RowMeasures(contacts=float(contacts))
    ways = [leg.measures for leg in legs if leg.bound > 0.0]
    landings = [leg.measures for leg in legs if leg.bound <= 0.0]

    def column(name: str, of: list[LegMeasures] = ways) -> FloatArray:
        return np.array([getattr(measures, name) for measures in of], dtype=np.float64)

    seconds = np.minimum(column("told_after"), 1000.0)
    time, bound = float(column("told_after").sum()), sum(leg.bound for leg in legs)
    return RowMeasures(
        time=time if ways else nan,
        bound=bound,
        ratio=time / bound if bound > 0.0 else nan,
        clearance=_least(column("clearance")),
        gap=_least(column("gap")),
        reference_rms=_mean_square(column("reference_rms"), seconds),
        reference_max=_most(column("reference_max")),
        path_rms=_mean_square(column("path_rms"), seconds),
        path_max=_most(column("path_max")),
        height_max=_most(column("height_max")),
        height_end=_most(column("height_end")),
        overshoot=_most(column("overshoot")),
        off_goal=_most(column("off_goal")),
        whole=_most(column("told_after", landings)),
        touchdown=_most(column("off_goal", landings)),
        arrived=float(sum(not leg.outcome for leg in legs)),
        legs=float(len(legs)),
        contacts=float(contacts),
        top_speed=_most(column("top_speed")),
    )


def _most(values: FloatArray) -> float:
    known = values[~np.isnan(values)]
    return float(known.max()) if len(known) else nan


def _least(values: FloatArray) -> float:
    known = values[~np.isnan(values)]
    return float(known.min()) if len(known) else nan


def _mean_square(values: FloatArray, weights: FloatArray) -> float:
    known = ~np.isnan(values)
    if not known.any() or weights[known].sum() <= 0.0:
        return nan
    return float(np.sqrt(np.average(values[known] ** 2, weights=weights[known])))
