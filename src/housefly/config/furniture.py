"""The furniture of a site that the tracking system sees."""

from __future__ import annotations

from typing import Self

from pydantic import Field, model_validator

from housefly.config.section import Section, quantity


class FurnitureConfig(Section):
    """A thing with markers on it: wherever tracking sees its body, its footprint is in the way."""

    name: str = Field(min_length=1, max_length=40, description="what people call it")
    body: str = Field(
        min_length=1, max_length=100, description="name of its body in the tracking system"
    )
    model: str = Field(
        default="",
        max_length=100,
        description=(
            'the same thing in the room model ("sofa"), or how the names of its solids begin; ""'
            " when it is not there"
        ),
    )
    length: float = quantity(0.5, 0.02, 5.0, "m", "of its footprint")
    width: float = quantity(0.5, 0.02, 5.0, "m", "of its footprint")
    bottom: float = quantity(0.0, 0.0, 5.0, "m", "height above the floor that it begins at")
    top: float = quantity(2.0, 0.0, 5.0, "m", "height above the floor that it ends at")
    x: float = quantity(
        0.0,
        -5.0,
        5.0,
        "m",
        "middle of its footprint seen from the body, along the body's forward axis",
    )
    y: float = quantity(0.0, -5.0, 5.0, "m", "likewise, to the body's left")
    yaw: float = quantity(
        0.0, -3.1416, 3.1416, "rad", "direction of its length seen from the body's forward axis"
    )
    remembered: float = quantity(
        60.0, 2.0, 86400.0, "s", "how long it is taken to stand where it was last seen"
    )

    @model_validator(mode="after")
    def _ordered(self) -> Self:
        if self.bottom >= self.top:
            raise ValueError(f"bottom ({self.bottom} m) must be below top ({self.top} m)")
        return self


def check_furniture(furniture: tuple[FurnitureConfig, ...], others: tuple[str, ...]) -> None:
    """Raise ValueError when two pieces share a name, body or model, or one has another's body."""
    if len({piece.name for piece in furniture}) < len(furniture):
        raise ValueError("furniture: two things have the same name")
    if len({piece.body for piece in furniture}) < len(furniture):
        raise ValueError("furniture: two things have the same body")
    models = [piece.model for piece in furniture if piece.model]
    if len(set(models)) < len(models):
        raise ValueError("furniture: two things have the same model")
    for piece in furniture:
        if piece.body in others:
            raise ValueError(
                f"furniture: {piece.name!r} has the body {piece.body!r}, which is the drone or the"
                " visitor"
            )
