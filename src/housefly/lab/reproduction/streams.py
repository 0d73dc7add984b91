"""The service on every tracking stream, with gains from cautious to the edge, in both modes."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.config.site import Mode, Site
from housefly.lab.experiments.cases import Cases, cases
from housefly.lab.experiments.engine import Progress, fly_many
from housefly.lab.experiments.outcomes import Outcomes
from housefly.lab.reproduction.fleet import fleet
from housefly.lab.reproduction.kept_flights import FlyBatch
from housefly.lab.reproduction.routes import MODES, mapped_site, service_plan

RATES = (10.0, 20.0, 30.0, 50.0, 100.0)
"""Frames per second of the tracking [Hz]: the paper's range."""
LATENCIES = (0.0, 0.05, 0.1)
"""From exposure to arrival [s]."""
LOSSES = (0.0, 0.2)
"""Share of frames lost."""
LOOP_FREQUENCIES = (0.9, 1.3, 1.8, 2.5, 3.5, 5.0)
"""Natural frequencies of the position loop, critically damped, cautious to unstable [rad/s]."""
OWN_FREQUENCY = 1.8
"""The site's default: alpha 3.6 1/s, beta 3.24 1/s^2."""
TYPICAL_RATE, TYPICAL_LATENCY, TYPICAL_LOSS = 30.0, 0.05, 0.0
"""The stream on which gains are compared."""


@dataclass(frozen=True, slots=True, eq=False)
class Streams:
    """All flights of both modes, row by row.

    Attributes:
        cases: what was flown, shape (n,).
        outcomes: what was measured, shape (n,).
        frequency: natural frequency of the gains [rad/s], shape (n,).
    """

    cases: Cases
    outcomes: Outcomes
    frequency: NDArray[np.float64]

    def where(
        self, *, frequency: float = OWN_FREQUENCY, mode: Mode | None = None, **columns: float
    ) -> Outcomes:
        """Return the outcomes of the flights whose columns have these values."""
        chosen = self.frequency == frequency
        if mode is not None:
            chosen &= self.cases["mode"] == MODES.index(mode)
        for name, value in columns.items():
            chosen &= self.cases[name] == value
        found: Outcomes = self.outcomes[chosen]
        return found


def stream_flights(seeds: int) -> int:
    """Return how many flights ``fly_streams`` makes."""
    return len(MODES) * len(RATES) * len(LATENCIES) * len(LOSSES) * len(LOOP_FREQUENCIES) * seeds


def fly_streams(
    site: Site, seeds: int, on_landed: Progress | None = None, *, fly: FlyBatch = fly_many
) -> Streams:
    """Fly every combination with the same ``seeds`` drones."""
    rows, measured = [], []
    for mode in MODES:
        here = mapped_site(site, mode)
        table = _combinations(here.site, seeds)
        rows.append(table)
        measured.append(fly(table, service_plan(here), on_progress=on_landed))
    flown = np.concatenate(rows)
    return Streams(flown, np.concatenate(measured), 0.5 * flown["alpha"])


def _combinations(site: Site, seeds: int) -> Cases:
    grid = list(product(RATES, LATENCIES, LOSSES, LOOP_FREQUENCIES))
    drones: dict[str, NDArray[Any]] = {
        name: np.tile(values, len(grid)) for name, values in fleet(site, seeds).items()
    }
    rate, latency, loss, frequency = (np.repeat(column, seeds) for column in np.array(grid).T)
    alpha, beta = 2.0 * frequency, frequency**2
    return cases(
        site,
        len(grid) * seeds,
        mocap_rate_hz=rate,
        mocap_latency=latency,
        mocap_dropout=loss,
        alpha=alpha,
        beta=beta,
        **drones,
    )
