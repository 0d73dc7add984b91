from __future__ import annotations

from math import pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.geometry import distance
from housefly.room.model import Shape, Solid
from housefly.room.outline import outline

places = st.tuples(st.floats(-20.0, 20.0), st.floats(-20.0, 20.0), st.just(0.5))
sizes = st.tuples(st.floats(0.01, 5.0), st.floats(0.01, 5.0), st.just(1.0))


def area(corners: tuple[tuple[float, float], ...]) -> float:
    """Signed area [m^2]; positive when the corners run counterclockwise."""
    following = (*corners[1:], corners[0])
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(corners, following, strict=True)) / 2.0


@given(places, sizes, st.floats(-pi, pi))
def test_a_box_keeps_its_area_and_its_middle_however_it_is_turned(place, size, yaw):
    corners = outline(Solid("box", "box", Shape.BOX, place, size, yaw))
    assert len(corners) == 4
    assert area(corners) == pytest.approx(size[0] * size[1], abs=1e-9)
    assert (sum(x for x, _ in corners) / 4, sum(y for _, y in corners) / 4) == pytest.approx(
        place[:2], abs=1e-9
    )


@given(places, st.floats(0.01, 5.0), st.floats(-pi, pi))
def test_the_corners_of_a_cylinder_lie_on_its_circle(place, diameter, yaw):
    corners = outline(Solid("drum", "drum", Shape.CYLINDER, place, (diameter, diameter, 1.0), yaw))
    assert [distance(corner, place[:2]) for corner in corners] == pytest.approx([diameter / 2] * 24)
    assert area(corners) > 0.98 * pi * diameter**2 / 4


def test_a_quarter_turn_is_counterclockwise():
    corners = outline(Solid("box", "box", Shape.BOX, (1.0, 2.0, 0.0), (4.0, 2.0, 1.0), pi / 2))
    assert corners[0] == pytest.approx((2.0, 0.0)) and corners[2] == pytest.approx((0.0, 4.0))
