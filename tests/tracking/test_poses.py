"""Poses are checked before anybody steers by them."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import WireError
from housefly.geometry import Quaternion, Vec3, normalized
from housefly.tracking.poses import POSITION_MAX, checked_pose

place = st.tuples(*[st.floats(-POSITION_MAX, POSITION_MAX)] * 3)
quaternion = (
    st.tuples(*[st.floats(-1, 1)] * 4)
    .filter(lambda q: sum(v * v for v in q) > 1e-3)
    .map(normalized)
)


@given(place, quaternion)
def test_a_sane_pose_stays_itself_with_w_positive(position: Vec3, orientation: Quaternion) -> None:
    pose = checked_pose(position, orientation, y_up=False)
    assert pose.position == position
    assert pose.orientation[0] >= 0
    assert abs(
        sum(a * b for a, b in zip(pose.orientation, orientation, strict=True))
    ) == pytest.approx(1.0)


@given(place, quaternion)
def test_with_y_up_height_comes_from_y(position: Vec3, orientation: Quaternion) -> None:
    assert checked_pose(position, orientation, y_up=True).position[2] == position[1]


@pytest.mark.parametrize("value", [float("nan"), float("inf"), 1001.0, -1e30])
def test_a_place_that_cannot_be_is_refused(value: float) -> None:
    with pytest.raises(WireError, match="kilometre"):
        checked_pose((0.0, value, 0.0), (1.0, 0.0, 0.0, 0.0), y_up=False)


@pytest.mark.parametrize(
    "q", [(0.0,) * 4, (2.0, 0.0, 0.0, 0.0), (float("nan"), 0.0, 0.0, 1.0), (float("inf"),) * 4]
)
def test_an_orientation_that_is_none_is_refused(q: Quaternion) -> None:
    with pytest.raises(WireError, match="unit quaternion"):
        checked_pose((0.0, 0.0, 0.0), q, y_up=False)
