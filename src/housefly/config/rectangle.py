"""An axis-aligned rectangle on the floor plan."""

from __future__ import annotations

Rectangle = tuple[float, float, float, float]
"""x_min, y_min, x_max, y_max, world [m]."""


def check_rectangle(rectangle: Rectangle) -> None:
    """Raise ValueError for a rectangle without area."""
    x_min, y_min, x_max, y_max = rectangle
    if not (x_min < x_max and y_min < y_max):
        raise ValueError(
            "a rectangle is x_min, y_min, x_max, y_max [m] with x_min < x_max and y_min < y_max"
        )
