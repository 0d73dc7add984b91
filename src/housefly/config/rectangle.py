"""An axis-aligned rectangle on the floor plan."""

from __future__ import annotations

Rectangle = tuple[float, float, float, float]
"""x_min, y_min, x_max, y_max, world [m]."""
FLOOR_SIDE_MAX = 200.0
"""Longest side of a floor [m]."""


def check_rectangle(rectangle: Rectangle) -> None:
    """Raise ValueError for a rectangle without area."""
    x_min, y_min, x_max, y_max = rectangle
    if not (x_min < x_max and y_min < y_max):
        raise ValueError(
            "a rectangle is x_min, y_min, x_max, y_max [m] with x_min < x_max and y_min < y_max"
        )


def check_floor(floor: Rectangle, name: str = "the floor") -> None:
    """Raise ValueError for a floor whose map no memory would hold."""
    length, width = floor[2] - floor[0], floor[3] - floor[1]
    if not max(length, width) <= FLOOR_SIDE_MAX:
        raise ValueError(
            f"{name} is {length:g} m by {width:g} m; allowed: up to {FLOOR_SIDE_MAX:g} m along"
            " each side"
        )
