"""How stiff the position loop may be before it rings: by way of estimating, tracking rate and
latency, drone by drone.

The loop is the paper's own law (20)-(21) with the acceptor kept in pathTracking, so that nothing
but the estimator differs.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.config.site import Site, changed
from housefly.lab.experiments.cases import (
    DELAY_COMPENSATED,
    FINITE_DIFFERENCE,
    HELD_SAMPLE,
    ON_ARRIVAL,
    cases,
)
from housefly.lab.experiments.engine import fly_many
from housefly.lab.reproduction.fleet import fleet
from housefly.lab.reproduction.routes import step
from housefly.lab.reproduction.streams import LATENCIES, RATES, Landed

ESTIMATORS: dict[int, str] = {
    FINITE_DIFFERENCE: "held sample, finite difference",
    HELD_SAMPLE: "Kalman, fed the held sample",
    ON_ARRIVAL: "Kalman on arrival (paper)",
    DELAY_COMPENSATED: "delay-compensated (ours)",
}
"""From the plainest to ours."""
FREQUENCIES: NDArray[np.float64] = np.geomspace(0.8, 16.0, 26)
"""Natural frequencies tried, critically damped [rad/s]: 13 % apart."""
RINGING = 0.02
"""A step that still swings by more than this after ten seconds does not settle [m]: ten times what
noise and gusts leave.
"""
TRACKING_ALWAYS = {"epsilon_height": 2.0, "epsilon_yaw": 3.2, "epsilon_position": 0.001}
"""Tolerances with which the acceptor never leaves pathTracking."""


@dataclass(frozen=True, slots=True, eq=False)
class Edges:
    """Largest frequency at which each drone still settles.

    Attributes:
        values: [rad/s], shape (estimators, rates, latencies, drones); nan when it settles at none.
        settled: share of all flights that settled, by frequency, shape (estimators, rates,
            latencies, frequencies).
    """

    values: NDArray[np.float64]
    settled: NDArray[np.float64]

    def of(self, estimator: int, rate: float, latency: float) -> NDArray[np.float64]:
        """Return the edges of all drones [rad/s], shape (drones,)."""
        place = list(ESTIMATORS).index(estimator), RATES.index(rate), LATENCIES.index(latency)
        return np.asarray(self.values[place])


def flights(seeds: int) -> int:
    """Return how many flights ``find_edges`` makes."""
    return len(ESTIMATORS) * len(RATES) * len(LATENCIES) * FREQUENCIES.size * seeds


def find_edges(site: Site, seeds: int, on_landed: Landed | None = None, **columns: Any) -> Edges:
    """Fly a step of one cell with every estimator, rate, latency, frequency and drone; ``columns``
    replace a site's values.
    """
    paper = changed(site, mode="paper")
    grid = np.array(list(product(ESTIMATORS, RATES, LATENCIES, FREQUENCIES)))
    estimator, rate, latency, frequency = (np.repeat(column, seeds) for column in grid.T)
    drones = {name: np.tile(values, len(grid)) for name, values in fleet(site, seeds).items()}
    given: dict[str, Any] = {
        "estimator": estimator.astype(np.int64),
        "mocap_rate_hz": rate,
        "mocap_latency": latency,
        "alpha": 2.0 * frequency,
        "beta": frequency**2,
        **TRACKING_ALWAYS,
        **drones,
        **columns,
    }
    outcomes = fly_many(cases(paper, frequency.size, **given), step(paper), on_progress=on_landed)
    shape = (len(ESTIMATORS), len(RATES), len(LATENCIES), FREQUENCIES.size, seeds)
    settled = (outcomes["residual"] < RINGING).reshape(shape)
    return Edges(_largest(settled), settled.mean(axis=-1))


def _largest(settled: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Return the last frequency before the first at which a drone rings."""
    unbroken = np.logical_and.accumulate(settled, axis=-2).sum(axis=-2)
    return np.where(unbroken > 0, FREQUENCIES[np.maximum(unbroken - 1, 0)], np.nan)
