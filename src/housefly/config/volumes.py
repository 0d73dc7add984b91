"""The volumes of a site: polygons with heights to keep out of, to keep in, to fly slowly in."""

from __future__ import annotations

from itertools import combinations
from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from housefly.config.section import Section, quantity

Corner = tuple[float, float]
Metres = Annotated[float, Field(ge=-1000.0, le=1000.0, allow_inf_nan=False)]
_AREA_MIN = 1e-4
"""A polygon with less holds no middle of a drone [m^2]."""


class VolumeConfig(Section):
    """A part of the room for the middle of the drone; what keeps in leaves nothing else to fly."""

    kind: Literal["keep_out", "keep_in", "slow"] = Field(
        description="keep_out and keep_in for either planner; slow for planner space"
    )
    polygon: tuple[tuple[Metres, Metres], ...] = Field(
        min_length=3,
        max_length=40,
        description="corners on the floor plan, either way round: x, y [m]",
    )
    bottom: float = quantity(0.0, 0.0, 10.0, "m", "height that it begins at")
    top: float = quantity(10.0, 0.0, 10.0, "m", "height that it ends at")
    speed: float | None = Field(
        default=None,
        ge=0.05,
        le=2.0,
        allow_inf_nan=False,
        description="highest speed in it; for slow, and only there",
        json_schema_extra={"unit": "m/s"},
    )
    reason: str = Field(default="", max_length=60, description="shown on the map")

    @model_validator(mode="after")
    def _makes_sense(self) -> Self:
        if self.bottom >= self.top:
            raise ValueError(f"bottom ({self.bottom} m) must be below top ({self.top} m)")
        if (self.speed is None) == (self.kind == "slow"):
            raise ValueError(
                "a volume of kind slow needs a speed; allowed: a number from 0.05 to 2 m/s"
                if self.speed is None
                else f"speed is for kind slow, and this is {self.kind}; leave it out"
            )
        _check_polygon(self.polygon)
        return self


def _check_polygon(polygon: tuple[Corner, ...]) -> None:
    """Raise ValueError for a polygon without area, or one whose edges cross or touch."""
    edges = list(zip(polygon, polygon[1:] + polygon[:1], strict=True))
    area = 0.5 * abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in edges))
    if area < _AREA_MIN:
        raise ValueError(
            f"polygon has an area of {area:.2g} m^2; allowed: corners that go around some floor"
        )
    for (m, one), (n, other) in combinations(enumerate(edges), 2):
        is_next = n == m + 1 or (m == 0 and n == len(edges) - 1)
        if not is_next and _touch(*one, *other):
            raise ValueError(
                f"polygon crosses itself between corners {m + 1} and {n + 1}; allowed: corners in"
                " their order along its edge"
            )


def _touch(a: Corner, b: Corner, c: Corner, d: Corner) -> bool:
    """Return whether two closed segments have a point in common."""
    sides = _side(a, b, c), _side(a, b, d), _side(c, d, a), _side(c, d, b)
    if sides[0] * sides[1] < 0.0 and sides[2] * sides[3] < 0.0:
        return True
    ends = ((a, b, c), (a, b, d), (c, d, a), (c, d, b))
    return any(
        side == 0.0
        and min(p[0], q[0]) <= r[0] <= max(p[0], q[0])
        and min(p[1], q[1]) <= r[1] <= max(p[1], q[1])
        for side, (p, q, r) in zip(sides, ends, strict=True)
    )


def _side(a: Corner, b: Corner, c: Corner) -> float:
    """Return on which side of a line through a and b a point c is: left is positive, 0 on it."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
