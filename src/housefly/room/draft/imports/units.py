"""Which unit a file without one is in: the one in which it is most like a room."""

from __future__ import annotations

from collections.abc import Iterable
from math import log

_SIDE, _HEIGHT = 7.0, 2.6
"""Of a usual room that is flown in [m]; a hall and a cupboard are as far from it as each other."""
_HEIGHT_WEIGHT = 2.0
"""Heights of rooms differ less than their sides."""
_RARE = {0.0254: 1.0, 0.3048: 1.0}
"""Plans and scans in inches and feet are rarer than those in metric units."""


def likely_units(
    units: Iterable[float],
    sides: tuple[float, float],
    allowed: tuple[float, float],
    height: float | None = None,
    heights: tuple[float, float] = (0.0, 0.0),
) -> tuple[float, ...]:
    """Return the units in which something may be a room, the likeliest first.

    Args:
        units: metres per unit that come into question.
        sides: length and width in the unit of the file.
        allowed: shortest and longest side [m].
        height: in the unit of the file, None where it has none.
        heights: lowest and highest [m].
    """

    def unlikeness(unit: float) -> float:
        flat = abs(log((sides[0] * sides[1]) ** 0.5 * unit / _SIDE)) + _RARE.get(unit, 0.0)
        return flat if height is None else flat + _HEIGHT_WEIGHT * abs(log(height * unit / _HEIGHT))

    fitting = [
        unit
        for unit in units
        if all(allowed[0] <= unit * side <= allowed[1] for side in sides)
        and (height is None or heights[0] <= unit * height <= heights[1])
    ]
    return tuple(sorted(fitting, key=unlikeness))
