"""How far a place lies from a path."""

from __future__ import annotations

from itertools import pairwise
from math import hypot

from housefly.geometry import Vec2, distance


def distance_to_path(place: Vec2, waypoints: tuple[Vec2, ...]) -> float:
    """Return the distance of a place from a path in the plane [m]."""
    if len(waypoints) == 1:
        return distance(place, waypoints[0])
    return min(_distance_to_leg(place, a, b) for a, b in pairwise(waypoints))


def _distance_to_leg(place: Vec2, a: Vec2, b: Vec2) -> float:
    (px, py), (ax, ay), (bx, by) = place, a, b
    dx, dy = bx - ax, by - ay
    squared = dx * dx + dy * dy
    along = 0.0 if squared == 0.0 else ((px - ax) * dx + (py - ay) * dy) / squared
    along = min(max(along, 0.0), 1.0)
    return hypot(px - ax - along * dx, py - ay - along * dy)
