"""The one place of NED and FRD: what is up stays up, and every way back is the same."""

from __future__ import annotations

from math import pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.geometry import (
    IDENTITY,
    Quaternion,
    Vec3,
    euler_from_quaternion,
    normalized,
    quaternion_from_euler,
    rotate,
)
from housefly.wires.mavlink.frames import (
    across_attitude,
    across_body,
    across_heading,
    across_orientation,
    across_world,
)

numbers = st.floats(-100.0, 100.0)
vectors = st.tuples(numbers, numbers, numbers)
angles = st.floats(-3.1, 3.1)
tilts = st.floats(-1.3, 1.3)
orientations = st.tuples(tilts, tilts, angles).map(lambda one: quaternion_from_euler(*one))


@given(vectors)
def test_each_way_back_is_the_same_function(vector: Vec3) -> None:
    assert across_world(across_world(vector)) == vector
    assert across_body(across_body(vector)) == vector


@given(vectors, orientations)
def test_a_vector_of_the_body_is_the_same_one_in_both_worlds(
    vector: Vec3, orientation: Quaternion
) -> None:
    ours = across_world(rotate(orientation, vector))
    theirs = rotate(across_orientation(orientation), across_body(vector))
    assert theirs == pytest.approx(ours, abs=1e-9)


@given(orientations)
def test_an_orientation_comes_back_and_stays_a_unit(orientation: Quaternion) -> None:
    there = across_orientation(orientation)
    assert normalized(there) == pytest.approx(there)
    assert across_orientation(there) == pytest.approx(orientation, abs=1e-12)


@given(orientations)
def test_angles_and_quaternions_tell_the_same_attitude(orientation: Quaternion) -> None:
    ours = euler_from_quaternion(orientation)
    theirs = euler_from_quaternion(across_orientation(orientation))
    assert across_attitude(theirs) == pytest.approx(ours, abs=1e-6)
    assert across_attitude(across_attitude(ours)) == pytest.approx(ours, abs=1e-12)


def test_x_is_east_y_is_north_and_a_nose_that_sinks_is_a_negative_pitch_there() -> None:
    assert across_world((1.0, 2.0, 3.0)) == (2.0, 1.0, -3.0)
    assert across_heading(0.0) == pytest.approx(pi / 2)
    assert euler_from_quaternion(across_orientation(IDENTITY))[2] == pytest.approx(pi / 2)
    assert across_attitude((0.1, 0.2, pi / 2)) == pytest.approx((0.1, -0.2, 0.0))
