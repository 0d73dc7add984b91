"""How the stream of sightings is: its rate, its latency, and whether the filter expects it.

The normalized innovation squared (NIS) is one on average where the filter's own variance tells the
truth: far above, the model or the noise is worse than believed; far below, better.
"""

from __future__ import annotations

from math import isfinite
from typing import NamedTuple

from housefly.numeric import compiled

HEALTH_TIME = 3.0
"""Time over which the stream is averaged [s]."""


class StreamHealth(NamedTuple):
    """Averages over the accepted sightings; all nan before the second.

    Attributes:
        interval: between two captures [s].
        latency: from capture to the estimator, by the stamps [s].
        nis: normalized innovation squared in the plane, per axis.
        height_nis: of the height.
    """

    interval: float
    latency: float
    nis: float
    height_nis: float


@compiled
def health_updated(
    h: StreamHealth, interval: float, latency: float, nis: float, height_nis: float
) -> StreamHealth:
    """Return the averages after one more sighting."""
    if not isfinite(h.interval):
        return StreamHealth(interval, latency, nis, height_nis)
    share = min(interval / HEALTH_TIME, 1.0)
    return StreamHealth(
        h.interval + share * (interval - h.interval),
        h.latency + share * (latency - h.latency),
        h.nis + share * (nis - h.nis),
        h.height_nis + share * (height_nis - h.height_nis),
    )
