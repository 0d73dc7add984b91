"""Y up and z up: the same room, told with other axes."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.geometry import Quaternion, Vec3, normalized, rotate
from housefly.wires.axes import y_up_orientation, y_up_position, z_up_orientation, z_up_position

quaternion = (
    st.tuples(*[st.floats(-1, 1)] * 4)
    .filter(lambda q: sum(v * v for v in q) > 1e-3)
    .map(normalized)
)
point = st.tuples(*[st.floats(-100, 100)] * 3)


@given(point, quaternion)
def test_turning_the_axes_up_and_back_changes_nothing(
    position: Vec3, orientation: Quaternion
) -> None:
    assert z_up_position(y_up_position(position)) == position
    assert z_up_orientation(y_up_orientation(orientation)) == orientation


@given(point, quaternion)
def test_a_turned_body_points_where_it_pointed(arm: Vec3, orientation: Quaternion) -> None:
    there = y_up_position(rotate(orientation, arm))
    assert rotate(y_up_orientation(orientation), y_up_position(arm)) == pytest.approx(
        there, abs=1e-9
    )


def test_up_is_up() -> None:
    assert z_up_position((0.0, 1.0, 0.0)) == (0.0, 0.0, 1.0)
    assert y_up_position((0.0, 0.0, 1.0)) == (0.0, 1.0, 0.0)
