"""A polygon on the floor, cut into convex pieces."""

from __future__ import annotations

from collections.abc import Sequence

from housefly.geometry import Vec2

ConvexPolygon = tuple[Vec2, ...]
"""Corners counter-clockwise."""


def convex_pieces(polygon: Sequence[Vec2]) -> tuple[ConvexPolygon, ...]:
    """Return convex polygons that cover a polygon and nothing else.

    One that crosses itself is covered, and perhaps a little more: cutting off an ear leaves the
    windings around every other point as they are.

    Args:
        polygon: corners in either sense, world xy [m].
    """
    corners = list(polygon)
    if _area(corners) < 0:
        corners.reverse()
    triangles: list[ConvexPolygon] = []
    while any(turn(*corner_and_neighbours(corners, n)) < 0 for n in range(len(corners))):
        ear = next((n for n in range(len(corners)) if _is_ear(corners, n)), None)
        if ear is None:
            return (convex_hull(polygon),)
        triangles.append(corner_and_neighbours(corners, ear))
        del corners[ear]
    return (*triangles, convex_hull(corners))


def convex_hull(points: Sequence[Vec2]) -> ConvexPolygon:
    """Return the corners of the convex hull of points, counter-clockwise."""
    ordered = sorted(set(points))
    if len(ordered) < 3:
        return tuple(ordered)
    lower, upper = _chain(ordered), _chain(ordered[::-1])
    return tuple(lower[:-1] + upper[:-1])


def turn(a: Vec2, b: Vec2, c: Vec2) -> float:
    """Return twice the area of a triangle, positive when it runs counter-clockwise."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def corner_and_neighbours(corners: Sequence[Vec2], n: int) -> tuple[Vec2, Vec2, Vec2]:
    """Return a corner between its neighbours."""
    return corners[n - 1], corners[n], corners[(n + 1) % len(corners)]


def _chain(ordered: Sequence[Vec2]) -> list[Vec2]:
    chain: list[Vec2] = []
    for point in ordered:
        while len(chain) > 1 and turn(chain[-2], chain[-1], point) <= 0:
            chain.pop()
        chain.append(point)
    return chain


def _is_ear(corners: Sequence[Vec2], n: int) -> bool:
    a, b, c = corner_and_neighbours(corners, n)
    if turn(a, b, c) <= 0:
        return False
    others = (point for point in corners if point not in (a, b, c))
    return not any(
        turn(a, b, point) >= 0 and turn(b, c, point) >= 0 and turn(c, a, point) >= 0
        for point in others
    )


def _area(corners: Sequence[Vec2]) -> float:
    pairs = zip(corners, [*corners[1:], corners[0]], strict=True)
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in pairs) / 2
