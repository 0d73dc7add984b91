"""The drones of the tables: constants drawn around the identified ones, equal for equal seeds."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from housefly.config.site import Site
from housefly.lab.experiments.cases import BY_NAME


class _Variation(NamedTuple):
    """How one constant varies from drone to drone.

    Attributes:
        relative: one sigma of its logarithm.
        absolute: one sigma added, in the column's unit.
    """

    relative: float = 0.0
    absolute: float = 0.0


_VARIATIONS: dict[str, _Variation] = {
    "lag": _Variation(relative=0.15),
    "gain": _Variation(relative=0.05),
    "drag": _Variation(relative=0.25),
    "delay": _Variation(absolute=0.01),
    "climb_lag": _Variation(relative=0.2),
    "yaw_lag": _Variation(relative=0.2),
    "wind_x": _Variation(absolute=0.05),
    "wind_y": _Variation(absolute=0.05),
}
"""Variations by column, about as large as between published identifications of the AR.Drone."""
_GUST = 0.05
"""One sigma of a push that changes within a second, for all drones [m/s^2]: air is never still."""


def fleet(site: Site, seeds: int) -> dict[str, NDArray[Any]]:
    """Return the columns of ``seeds`` drones around the site's own, each of shape (seeds,)."""
    random = np.random.Generator(np.random.PCG64(site.twin.seed))
    columns: dict[str, NDArray[Any]] = {}
    for name, spread in _VARIATIONS.items():
        parameter = BY_NAME[name]
        centre = parameter.of(site)
        drawn = centre * np.exp(spread.relative * random.standard_normal(seeds))
        drawn += spread.absolute * random.standard_normal(seeds)
        columns[name] = np.clip(drawn, parameter.low, parameter.high)
    columns["gust"] = np.full(seeds, _GUST)
    columns["seed"] = site.twin.seed * 1_000_003 + np.arange(seeds, dtype=np.int64)
    return columns
