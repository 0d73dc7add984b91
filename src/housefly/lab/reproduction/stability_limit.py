"""The largest stable frequency over a fleet: no drone is left out of the mean."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from housefly.lab.experiments.intervals import IntervalEstimate, bootstrap_mean
from housefly.lab.reproduction.edges import FREQUENCIES, Edges


class StabilityLimit(NamedTuple):
    """What one estimator on one stream allows.

    Attributes:
        frequency: mean over all drones with its interval [rad/s]; a drone that rings at every
            frequency tried counts as 0, one that never rings as the highest tried.
        drones: how many flew.
        ringing: how many of them ring at every frequency tried.
        beyond: how many ring at none.
    """

    frequency: IntervalEstimate
    drones: int
    ringing: int
    beyond: int


def stability_limit(edges: Edges, estimator: int, rate: float, latency: float) -> StabilityLimit:
    """Return the limit of an estimator with frames at a rate [Hz] and a latency [s]."""
    return limit_of(edges.of(estimator, rate, latency))


def limit_of(largest: NDArray[np.float64]) -> StabilityLimit:
    """Return the limit of drones with these edges [rad/s], nan for a drone that always rings."""
    ringing = np.isnan(largest)
    return StabilityLimit(
        frequency=bootstrap_mean(np.where(ringing, 0.0, largest)),
        drones=largest.size,
        ringing=int(ringing.sum()),
        beyond=int((largest == FREQUENCIES[-1]).sum()),
    )
