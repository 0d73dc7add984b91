"""How the drone keeps away from people."""

from __future__ import annotations

from typing import Self

from pydantic import Field, model_validator

from housefly.config.section import Section, quantity


class PeopleConfig(Section):
    """Distances from people, all from the drone's hull to somebody's body."""

    bodies: tuple[str, ...] = Field(
        default=(),
        description=(
            "names of people among the tracked bodies, besides tracking.visitor; any other tracked"
            " body that the site does not name is in the way, too"
        ),
    )
    body_radius: float = quantity(
        0.25, 0.1, 1.0, "m", "of a person, or of an unknown body, around the tracked place"
    )
    slow_distance: float = quantity(
        1.5, 0.0, 5.0, "m", "nearer than this the drone flies slower, the nearer the slower"
    )
    comfort_distance: float = quantity(
        1.0, 0.0, 3.0, "m", "paths keep this where there is room; who comes nearer is made way for"
    )
    min_distance: float = quantity(
        0.5, 0.0, 2.0, "m", "the drone never comes nearer than this; it waits"
    )
    yield_speed: float = quantity(
        0.8, 0.1, 1.5, "m/s", "highest speed of making way; 1.2 m/s where somebody would touch it"
    )

    @model_validator(mode="after")
    def _ordered(self) -> Self:
        if not self.min_distance <= self.comfort_distance <= self.slow_distance:
            raise ValueError(
                f"min_distance ({self.min_distance} m), comfort_distance"
                f" ({self.comfort_distance} m) and slow_distance ({self.slow_distance} m) must not"
                " decrease in this order"
            )
        return self
