"""Rectangles on the floor plan, and those of B-sen."""

from __future__ import annotations

from math import cos, hypot, sin

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.hub.situations.furniture import beds_of, entrance_of, seats_of
from housefly.hub.situations.layout import Area
from housefly.room.bsen import bsen

METRES = st.floats(-10.0, 10.0)
SIZES = st.floats(0.1, 3.0)
ANGLES = st.floats(-3.1, 3.1)


@given(METRES, METRES, SIZES, SIZES, ANGLES, st.floats(-1.0, 1.0), st.floats(-1.0, 1.0))
def test_points_within_a_turned_rectangle_are_no_distance_away(
    x: float, y: float, length: float, width: float, yaw: float, along: float, across: float
) -> None:
    dx, dy = along * length / 2 * 0.999, across * width / 2 * 0.999
    point = (x + dx * cos(yaw) - dy * sin(yaw), y + dx * sin(yaw) + dy * cos(yaw))
    assert Area("a", (x, y), (length, width), yaw).distance(point) == pytest.approx(0.0, abs=1e-9)


@given(METRES, METRES, SIZES, SIZES, ANGLES, METRES, METRES)
def test_the_distance_is_at_most_that_of_the_centre(
    x: float, y: float, length: float, width: float, yaw: float, px: float, py: float
) -> None:
    away = hypot(px - x, py - y)
    assert (
        away - hypot(length, width) / 2 - 1e-9
        <= Area("a", (x, y), (length, width), yaw).distance((px, py))
        <= away + 1e-9
    )


def test_bsen_has_eight_seats_one_bed_and_an_entrance() -> None:
    names = [seat.name for seat in seats_of(bsen())]
    assert sorted(names) == sorted(
        [
            "work chair seat",
            *(f"sofa seat {n}" for n in range(3)),
            *(f"meeting chair {w} seat" for w in ("north", "west", "south", "east")),
        ]
    )
    (bed,) = beds_of(bsen())
    assert bed.distance((10.35, 2.70)) == 0.0
    entrance = entrance_of(bsen())
    assert entrance is not None and entrance.distance((0.85, 4.20)) == 0.0
