"""A polygon in convex pieces covers the same floor."""

from __future__ import annotations

from math import cos, pi, sin

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from matplotlib.path import Path as Outline

from housefly.evidence.polygon_pieces import convex_hull, convex_pieces, corner_and_neighbours, turn
from housefly.geometry import Vec2

RADII = st.lists(st.floats(0.5, 5.0), min_size=3, max_size=14)
GRID = np.stack(np.meshgrid(np.linspace(-5, 5, 27), np.linspace(-5, 5, 27)), -1).reshape(-1, 2)


def star(radii: list[float]) -> list[Vec2]:
    """Return a polygon around the origin that does not cross itself."""
    return [
        (r * cos(2 * pi * n / len(radii)), r * sin(2 * pi * n / len(radii)))
        for n, r in enumerate(radii)
    ]


@given(RADII, st.booleans())
def test_the_pieces_are_convex_and_cover_the_polygon_and_nothing_else(
    radii: list[float], clockwise: bool
) -> None:
    polygon = star(radii)[:: -1 if clockwise else 1]
    pieces = convex_pieces(polygon)
    for piece in pieces:
        assert all(turn(*corner_and_neighbours(piece, n)) >= 0 for n in range(len(piece)))
    inside = np.any([Outline(piece).contains_points(GRID, radius=1e-6) for piece in pieces], axis=0)
    sure = Outline(polygon).contains_points(GRID, radius=-1e-4 if clockwise else 1e-4)
    near = Outline(polygon).contains_points(GRID, radius=1e-4 if clockwise else -1e-4)
    assert not (near & sure & ~inside).any()
    assert not (inside & ~near & ~sure).any()


CORNER = st.integers(-5, 5).map(float) | st.floats(-5, 5)


@settings(max_examples=60)
@given(st.lists(st.tuples(CORNER, CORNER), min_size=3, max_size=8))
def test_any_corners_at_all_are_covered(polygon: list[Vec2]) -> None:
    """Also those of a polygon that crosses itself: too much is blank, never too little."""
    pieces = convex_pieces(polygon)
    inside = [(x, y) for x, y in GRID[Outline(polygon).contains_points(GRID)]]
    for x, y in (*polygon, *inside):
        assert any(
            all(
                turn(a, b, (x, y)) >= -1e-6
                for a, b in zip(piece, [*piece[1:], piece[0]], strict=True)
            )
            for piece in pieces
        )


def test_a_convex_polygon_stays_one_piece() -> None:
    square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
    assert len(convex_pieces(square)) == 1
    assert len(convex_hull([*square, (0.5, 0.5)])) == 4
