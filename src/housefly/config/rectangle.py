"""An axis-aligned rectangle on the floor plan."""

from __future__ import annotations

from housefly.messages.words import Words, figure

Rectangle = tuple[float, float, float, float]
"""x_min, y_min, x_max, y_max, world [m]."""
THE_FLOOR = Words("the floor")
FLOOR_SIDE_MAX = 200.0
"""Longest side of a floor [m]."""


def check_rectangle(rectangle: Rectangle) -> None:
    """Raise ValueError for a rectangle without area."""
    x_min, y_min, x_max, y_max = rectangle
    if not (x_min < x_max and y_min < y_max):
        raise ValueError(
            Words(
                "a rectangle is x_min, y_min, x_max, y_max [m] with x_min < x_max and y_min < y_max"
            )
        )


def check_floor(floor: Rectangle, name: str = THE_FLOOR) -> None:
    """Raise ValueError for a floor whose map no memory would hold."""
    length, width = floor[2] - floor[0], floor[3] - floor[1]
    if not max(length, width) <= FLOOR_SIDE_MAX:
        raise ValueError(
            Words(
                "{name} is {a} m by {b} m; allowed: up to {c} m along each side",
                name=name,
                a=figure(length, "g"),
                b=figure(width, "g"),
                c=figure(FLOOR_SIDE_MAX, "g"),
            )
        )
