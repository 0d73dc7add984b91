"""The stiffest position loop that does not ring, by estimator, tracking rate, latency and drone.

The loop is the paper's law (20)-(21) with the acceptor held in pathTracking, so that only the
estimator differs. The air is still: what gusts move is no sign of a loop that rings.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.config.site import Site, changed
from housefly.lab.experiments.cases import cases
from housefly.lab.experiments.engine import Progress, fly_many
from housefly.lab.reproduction.fleet import fleet
from housefly.lab.reproduction.kept_flights import FlyBatch
from housefly.lab.reproduction.routes import step_plan
from housefly.lab.reproduction.streams import LATENCIES, RATES
from housefly.pilot.estimation.estimator_state import EstimatorKind

ESTIMATORS: dict[int, str] = {
    EstimatorKind.FINITE_DIFFERENCE: "held sample, finite difference",
    EstimatorKind.HELD_SAMPLE: "Kalman, fed the held sample",
    EstimatorKind.ON_ARRIVAL: "Kalman on arrival (paper)",
    EstimatorKind.DELAY_COMPENSATED: "delay-compensated (ours)",
}
"""From the plainest to ours."""
FREQUENCIES: NDArray[np.float64] = np.geomspace(0.8, 22.0, 29)
"""Natural frequencies tried, critically damped [rad/s]: 13 % apart."""
RINGING = 0.025
"""A step of one cell that still swings by more than a twentieth of it after ten seconds rings [m].

In still air the noise of the tracking leaves less: up to 2 cm where frames are differentiated 100
times a second, a few millimetres with a filter.
"""
STILL_AIR = {"gust": 0.0, "wind_x": 0.0, "wind_y": 0.0}
"""Air that pushes nothing."""
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
    return len(ESTIMATORS) * len(RATES) * len(LATENCIES) * FREQUENCIES.size * seeds


def find_edges(
    site: Site,
    seeds: int,
    on_landed: Progress | None = None,
    *,
    fly: FlyBatch = fly_many,
    **columns: Any,
) -> Edges:
    """Fly a step of one cell with every estimator, rate, latency, frequency and drone.

    ``columns`` replace values of the site.
    """
    estimator, rate, latency = np.array(list(product(ESTIMATORS, RATES, LATENCIES))).T
    streams = {"estimator": estimator, "mocap_rate_hz": rate, "mocap_latency": latency}
    settled = settled_steps(site, seeds, streams, on_landed, fly=fly, **columns).reshape(
        len(ESTIMATORS), len(RATES), len(LATENCIES), FREQUENCIES.size, seeds
    )
    return Edges(largest_settling(settled), settled.mean(axis=-1))


def settled_steps(
    site: Site,
    seeds: int,
    combinations: Mapping[str, NDArray[Any]],
    on_landed: Progress | None = None,
    *,
    fly: FlyBatch = fly_many,
    **columns: Any,
) -> NDArray[np.bool_]:
    """Return whether each drone settles, shape (combinations, frequencies, drones).

    Args:
        site: whose drone, room and stream are meant; flown in mode paper.
        seeds: drones.
        combinations: columns, each of shape (combinations,).
        on_landed: called with the number of flights that have just ended.
        fly: flies a batch.
        columns: replace values of all flights.
    """
    paper = changed(site, mode="paper")
    count = len(next(iter(combinations.values())))
    frequency = np.tile(np.repeat(FREQUENCIES, seeds), count)
    each = FREQUENCIES.size * seeds
    drones = {n: np.tile(v, count * FREQUENCIES.size) for n, v in fleet(site, seeds).items()}
    given: dict[str, Any] = {
        "alpha": 2.0 * frequency,
        "beta": frequency**2,
        **TRACKING_ALWAYS,
        **drones,
        **STILL_AIR,
        **{name: np.repeat(values, each) for name, values in combinations.items()},
        **columns,
    }
    flown = cases(paper, frequency.size, **given)
    outcomes = fly(flown, step_plan(paper), on_progress=on_landed)
    return np.asarray((outcomes["residual"] < RINGING).reshape(count, FREQUENCIES.size, seeds))


def largest_settling(settled: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Return the last frequency before the first at which a drone rings [rad/s]; nan: at all."""
    unbroken = np.logical_and.accumulate(settled, axis=-2).sum(axis=-2)
    return np.where(unbroken > 0, FREQUENCIES[np.maximum(unbroken - 1, 0)], np.nan)
