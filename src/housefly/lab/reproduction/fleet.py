"""The drones that the tables fly: constants drawn at random around the identified ones, the same
for the same seed.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from housefly.config.site import Site
from housefly.lab.experiments.cases import BY_NAME


class Spread(NamedTuple):
    """How one constant differs from drone to drone.

    Attributes:
        relative: one sigma of its logarithm.
        absolute: one sigma added, in the column's unit.
    """

    relative: float = 0.0
    absolute: float = 0.0


SPREADS: dict[str, Spread] = {
    "lag": Spread(relative=0.15),
    "gain": Spread(relative=0.05),
    "drag": Spread(relative=0.25),
    "delay": Spread(absolute=0.01),
    "climb_lag": Spread(relative=0.2),
    "yaw_lag": Spread(relative=0.2),
    "wind_x": Spread(absolute=0.05),
    "wind_y": Spread(absolute=0.05),
}
"""By column. Identifications of the AR.Drone by others differ from one another about as much as
this.
"""
GUST = 0.05
"""One sigma of a push that changes within a second, the same for all drones [m/s^2]: air in a room
is never still.
"""


def fleet(site: Site, seeds: int) -> dict[str, NDArray[Any]]:
    """Return the columns of ``seeds`` drones around the site's own, one seed each, shape (seeds,)."""
    random = np.random.Generator(np.random.PCG64(site.twin.seed))
    columns: dict[str, NDArray[Any]] = {}
    for name, spread in SPREADS.items():
        parameter = BY_NAME[name]
        centre = parameter.of(site)
        drawn = centre * np.exp(spread.relative * random.standard_normal(seeds))
        drawn += spread.absolute * random.standard_normal(seeds)
        columns[name] = np.clip(drawn, parameter.low, parameter.high)
    columns["gust"] = np.full(seeds, GUST)
    columns["seed"] = site.twin.seed * 1_000_003 + np.arange(seeds, dtype=np.int64)
    return columns
