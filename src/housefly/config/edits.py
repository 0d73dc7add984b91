"""Places and no-fly zones that people changed in the console, on top of room and site file."""

from __future__ import annotations

from typing import Annotated, Self

from pydantic import Field, StringConstraints, model_validator

from housefly.config.rectangle import check_rectangle
from housefly.config.section import Section

PLACES_MAX, ZONES_MAX = 40, 40
NAME_MAX, TITLE_MAX, REASON_MAX = 40, 40, 60
NAME = r"^[a-z0-9][a-z0-9 _-]*$"

Title = Annotated[
    str,
    StringConstraints(strip_whitespace=True, max_length=TITLE_MAX, pattern=r"^[^\x00-\x1f\x7f]*$"),
]
Reason = Annotated[
    str,
    StringConstraints(
        strip_whitespace=True, min_length=1, max_length=REASON_MAX, pattern=r"^[^\x00-\x1f\x7f]*$"
    ),
]
Metres = Annotated[
    float, Field(ge=-1000.0, le=1000.0, allow_inf_nan=False, json_schema_extra={"unit": "m"})
]


class PlaceEdit(Section):
    """A place that is new, or that stands for the room's own place of the same name."""

    name: str = Field(
        min_length=1,
        max_length=NAME_MAX,
        pattern=NAME,
        description='short lower-case name ("coffee corner")',
    )
    title: Title = Field(default="", description="shown to people")
    viewpoint: tuple[Metres, Metres] = Field(description="where to hover: x, y [m]")
    look_at: tuple[Metres, Metres, Metres] = Field(description="what to look at: x, y, z [m]")


class NoFlyZone(Section):
    """A rectangle that the drone must not enter, and why."""

    rectangle: tuple[Metres, Metres, Metres, Metres] = Field(
        description="x_min, y_min, x_max, y_max [m]"
    )
    reason: Reason = Field(description="shown on the map")

    @model_validator(mode="after")
    def _ordered(self) -> Self:
        check_rectangle(self.rectangle)
        return self


class Edits(Section):
    """What people changed in the console, in mode default.

    A start fills it in from the newest version that was saved.
    """

    places: tuple[PlaceEdit, ...] = Field(
        default=(),
        max_length=PLACES_MAX,
        description="places that are new or changed: name, title, viewpoint [m], look_at [m]",
    )
    removed: tuple[Annotated[str, Field(min_length=1, max_length=60)], ...] = Field(
        default=(),
        max_length=PLACES_MAX,
        description="names of the room's own places that are gone; never home",
    )
    zones: tuple[NoFlyZone, ...] = Field(
        default=(),
        max_length=ZONES_MAX,
        description="no-fly zones: rectangle x_min, y_min, x_max, y_max [m], and reason",
    )
