"""The weighted mean of measured positions."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.geometry import Vec3
from housefly.hub.things.fusion import fused_position, inflated, inverse
from housefly.messages import Covariance

entries = st.floats(-2.0, 2.0)


def matrix(upper: Covariance) -> np.ndarray:
    xx, xy, xz, yy, yz, zz = upper
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


@st.composite
def covariances(draw: st.DrawFn) -> Covariance:
    root = np.array([[draw(entries) for _ in range(3)] for _ in range(3)])
    m = root @ root.T + 0.1 * np.eye(3)
    return m[0, 0], m[0, 1], m[0, 2], m[1, 1], m[1, 2], m[2, 2]


points = st.tuples(entries, entries, entries)


@given(covariances())
def test_the_inverse_is_the_inverse(covariance: Covariance) -> None:
    found = inverse(covariance)
    assert found is not None
    assert matrix(found) @ matrix(covariance) == pytest.approx(np.eye(3), abs=1e-8)


@given(st.lists(st.tuples(points, covariances()), min_size=1, max_size=4))
def test_the_weighted_mean_is_that_of_linear_algebra(
    measured: list[tuple[Vec3, Covariance]],
) -> None:
    found = fused_position(measured)
    assert found is not None
    weights = [np.linalg.inv(matrix(covariance)) for _, covariance in measured]
    joint = np.linalg.inv(sum(weights))
    assert matrix(found[1]) == pytest.approx(joint, abs=1e-8)
    assert found[0] == pytest.approx(
        joint @ sum(w @ np.array(p) for w, (p, _) in zip(weights, measured, strict=True)), abs=1e-7
    )


@pytest.mark.parametrize(
    "flat",
    [
        (0.0,) * 6,
        (1.0, 1.0, 0.0, 1.0, 0.0, 1.0),
        (-1.0, 0.0, 0.0, 1.0, 0.0, 1.0),
        (float("nan"),) * 6,
    ],
)
def test_what_is_no_covariance_is_not_weighed(flat: Covariance) -> None:
    assert inverse(flat) is None
    assert fused_position([((1.0, 2.0, 3.0), flat)]) is None
    assert fused_position([]) is None


def test_a_covariance_grows_on_its_diagonal() -> None:
    assert inflated((1.0, 0.1, 0.2, 2.0, 0.3, 3.0), 0.5) == (1.5, 0.1, 0.2, 2.5, 0.3, 3.5)
