"""What is measured of every drone of an experiment; truth, not the pilot's belief."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray


class Measure(NamedTuple):
    """One column of the results."""

    name: str
    unit: str
    meaning: str


MEASURES: tuple[Measure, ...] = (
    Measure(
        "rms_error",
        "m",
        "distance from the path from the start of the task until arrival, root of the mean square",
    ),
    Measure("max_error", "m", "the same, largest"),
    Measure("reference_rms", "m", "distance from the moving reference, root of the mean square"),
    Measure(
        "arrival_time",
        "s",
        "from the start of the task until the drone is, and stays, within eps3 of the goal; nan:"
        " never",
    ),
    Measure("arrival_error", "m", "mean distance from the goal over the last 2 s"),
    Measure("overshoot", "m", "how far past the goal along the last leg"),
    Measure(
        "residual",
        "m",
        "largest distance from its mean place over the last 2 s, per axis: what still oscillates",
    ),
    Measure("switches_per_s", "1/s", "changes of the acceptor's state"),
    Measure("saturated", "1", "share of the time in which the wanted tilt exceeds the limit"),
    Measure("height_error", "m", "largest distance from z_ref"),
    Measure(
        "estimate_rms",
        "m",
        "distance of the estimated from the true place, root of the mean square",
    ),
    Measure(
        "levelled",
        "1",
        "share of the time in which the gate let the drone hold itself because the pose was old",
    ),
    Measure(
        "ended_at",
        "s",
        "when the flight ended: the duration, or when the gate landed it, or when it was lost",
    ),
    Measure(
        "stable",
        "1",
        "1 when it flew to the end, never further than 1 m from the path, and ended with a residual"
        " below 0.1 m",
    ),
)
ARRIVED = Measure("arrived", "1", "share of all flights that have an arrival time")
"""What a summary counts beside the means, which leave out a flight without an arrival time."""
SUMMARY_MEASURES = (*MEASURES, ARRIVED)
OUTCOME = np.dtype([(measure.name, np.float64) for measure in MEASURES])
"""One drone's results."""

Outcomes = NDArray[Any]
"""Structured array of dtype ``OUTCOME``."""
