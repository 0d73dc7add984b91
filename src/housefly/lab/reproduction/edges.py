"""The stiffest position loop that does not ring, by estimator, tracking rate, latency and drone.

The loop is the paper's law (20)-(21) with the acceptor held in pathTracking, so that only the
estimator differs.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.config.site import Site, changed
from housefly.lab.experiments.cases import cases
from housefly.lab.experiments.engine import Progress, fly_many
from housefly.lab.reproduction.fleet import fleet
from housefly.lab.reproduction.routes import step_plan
from housefly.lab.reproduction.streams import LATENCIES, RATES
from housefly.pilot.estimation.estimator import EstimatorKind

ESTIMATORS: dict[int, str] = {
    EstimatorKind.FINITE_DIFFERENCE: "held sample, finite difference",
    EstimatorKind.HELD_SAMPLE: "Kalman, fed the held sample",
    EstimatorKind.ON_ARRIVAL: "Kalman on arrival (paper)",
    EstimatorKind.DELAY_COMPENSATED: "delay-compensated (ours)",
}
"""From the plainest to ours."""
_FREQUENCIES: NDArray[np.float64] = np.geomspace(0.8, 16.0, 26)
"""Natural frequencies tried, critically damped [rad/s]: 13 % apart."""
_RINGING = 0.02
"""A step that still oscillates by more than this after ten seconds does not settle [m].

This is ten times what noise and gusts leave.
"""
TRACKING_ALWAYS = {"epsilon_height": 2.0, "epsilon_yaw": 3.2, "epsilon_position": 0.001}
"""Tolerances with which the acceptor never leaves pathTracking."""


@dataclass(frozen=True, slots=True, eq=False)
class Edges:
    """The largest frequency at which each drone still settles.

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


def edge_flights(seeds: int) -> int:
    """Return how many flights ``find_edges`` makes."""
    return len(ESTIMATORS) * len(RATES) * len(LATENCIES) * _FREQUENCIES.size * seeds


def find_edges(site: Site, seeds: int, on_landed: Progress | None = None, **columns: Any) -> Edges:
    """Fly a step of one cell with every estimator, rate, latency, frequency and drone.

    ``columns`` replace values of the site.
    """
    paper = changed(site, mode="paper")
    grid = np.array(list(product(ESTIMATORS, RATES, LATENCIES, _FREQUENCIES)))
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
    outcomes = fly_many(
        cases(paper, frequency.size, **given), step_plan(paper), on_progress=on_landed
    )
    shape = (len(ESTIMATORS), len(RATES), len(LATENCIES), _FREQUENCIES.size, seeds)
    settled = (outcomes["residual"] < _RINGING).reshape(shape)
    return Edges(_largest(settled), settled.mean(axis=-1))


def _largest(settled: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Return the last frequency before the first at which a drone rings."""
    unbroken = np.logical_and.accumulate(settled, axis=-2).sum(axis=-2)
    return np.where(unbroken > 0, _FREQUENCIES[np.maximum(unbroken - 1, 0)], np.nan)
