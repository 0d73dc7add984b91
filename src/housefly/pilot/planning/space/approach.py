"""How near a drone may come to somebody, by the side that it comes from.

Who walks wants more room ahead than behind. The distance is a disc around a point before them: all
of the comfort distance ahead, less beside, and least behind; never less than the smallest distance.
"""

from __future__ import annotations

from math import hypot

from housefly.numeric import FloatArray

BEHIND = 0.6
"""Behind somebody who walks this share of the comfort distance is enough."""


def approach_distances(comfort: float, least: float) -> tuple[float, float]:
    """Return how far before a person the middle of their disc is, and its radius beside a body [m].

    Args:
        comfort: to keep ahead of somebody [m].
        least: never less [m].
    """
    behind = min(comfort, max(BEHIND * comfort, least))
    return 0.5 * (comfort - behind), 0.5 * (comfort + behind)


def with_approach(rows: FloatArray, comfort: float, least: float) -> FloatArray:
    """Return rows of people who walk, grown by ``comfort`` all around, with less room behind.

    Args:
        rows: as ``solid_rows.live_rows`` makes them, of people, shape (n, 11).
        comfort: by which they have grown [m].
        least: never less [m].
    """
    ahead, radius = approach_distances(comfort, least)
    changed = rows.copy()
    for row in changed:
        way = hypot(row[7], row[8])
        if way > 0.0:
            row[:2] += ahead * row[7:9] / way
            row[6] -= comfort - radius
    return changed
