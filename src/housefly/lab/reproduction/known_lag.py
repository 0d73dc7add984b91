"""What it is worth to a filter to know lambda of eq. (22): how stiff a loop settles with it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from housefly.config.site import Site
from housefly.lab.experiments.engine import Progress, fly_many
from housefly.lab.experiments.intervals import IntervalEstimate, share
from housefly.lab.reproduction.edges import FREQUENCIES, largest_settling, settled_steps
from housefly.lab.reproduction.kept_flights import FlyBatch
from housefly.lab.reproduction.stability_limit import StabilityLimit, limit_of
from housefly.lab.reproduction.streams import TYPICAL_LATENCY, TYPICAL_RATE
from housefly.pilot.estimation.estimator_state import EstimatorKind

UNKNOWN_LAG = 50.0
"""Lambda of a filter that takes the angles for reached at once [1/s]: the largest accepted."""
_FILTERS = (EstimatorKind.DELAY_COMPENSATED, EstimatorKind.ON_ARRIVAL)
"""Ours has the angle among its states, the paper's has not."""


@dataclass(frozen=True, slots=True, eq=False)
class KnownLag:
    """Which steps settle with lambda known and unknown.

    Attributes:
        settled: shape (filters, known or not, frequencies, drones): of ``FREQUENCIES``.
    """

    settled: NDArray[np.bool_]

    def limit(self, estimator: EstimatorKind, known: bool) -> StabilityLimit:
        """Return the largest frequency at which drones settle with this filter."""
        return limit_of(largest_settling(self._of(estimator, known)))

    def share_at(self, frequency: float, estimator: EstimatorKind, known: bool) -> IntervalEstimate:
        """Return the share of drones that settle at the tried frequency next to this [rad/s]."""
        place = int(np.argmin(np.abs(FREQUENCIES - frequency)))
        return share(self._of(estimator, known)[place])

    def _of(self, estimator: EstimatorKind, known: bool) -> NDArray[np.bool_]:
        return np.asarray(self.settled[_FILTERS.index(estimator), 0 if known else 1])


def known_lag_flights(seeds: int) -> int:
    """Return how many flights ``fly_known_lag`` makes."""
    return 2 * len(_FILTERS) * FREQUENCIES.size * seeds


def fly_known_lag(
    site: Site, seeds: int, on_landed: Progress | None = None, *, fly: FlyBatch = fly_many
) -> KnownLag:
    """Fly a step of one cell with either filter, at every frequency, with lambda known or not."""
    beliefs = (site.drone.attitude_lag, UNKNOWN_LAG)
    settled = settled_steps(
        site,
        seeds,
        {
            "estimator": np.repeat(_FILTERS, len(beliefs)),
            "model_lag": np.tile(beliefs, len(_FILTERS)),
        },
        on_landed,
        fly=fly,
        mocap_rate_hz=TYPICAL_RATE,
        mocap_latency=TYPICAL_LATENCY,
    )
    return KnownLag(settled.reshape(len(_FILTERS), len(beliefs), FREQUENCIES.size, seeds))
