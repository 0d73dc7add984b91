from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.linalg import expm

from housefly.pilot.estimation.lagged_axis import (
    HOVER_VARIANCE_FACTOR,
    AxisCovariance,
    AxisModel,
    AxisState,
    predicted_axis,
    predicted_covariance,
    transition,
    updated_axis,
    updated_covariance,
)

MODEL = AxisModel(lag=7.0, gain=0.9, drag=0.58, hover_drag=2.0, noise=0.5, wander=0.2)
numbers = st.floats(-3.0, 3.0)
axes = st.builds(AxisState, numbers, numbers, numbers, st.floats(-0.5, 0.5))


def matrix(p: AxisCovariance) -> np.ndarray:
    upper = np.zeros((4, 4))
    upper[np.triu_indices(4)] = p
    return upper + np.triu(upper, 1).T


@st.composite
def covariances(draw: st.DrawFn) -> AxisCovariance:
    root = np.array(draw(st.lists(st.floats(-1.0, 1.0), min_size=16, max_size=16))).reshape(4, 4)
    full = root @ root.T + 1e-3 * np.eye(4)
    return AxisCovariance(*full[np.triu_indices(4)])


def matrix_of(flown: bool, dt: float) -> np.ndarray:
    """The same discrete transition, written as a matrix."""
    drag = MODEL.drag if flown else MODEL.hover_drag
    decay, reach = np.exp(-MODEL.lag * dt), dt * (1.0 - 0.5 * drag * dt)
    velocity = np.array(
        [0.0, 1.0 - drag * reach, 0.5 * (1.0 + decay) * reach, reach if flown else 0.0]
    )
    position = np.array([1.0, 0.5 * dt, 0.0, 0.0]) + 0.5 * dt * velocity
    return np.array([position, velocity, [0.0, 0.0, decay, 0.0], [0.0, 0.0, 0.0, 1.0]])


@given(axes, st.floats(-2.0, 2.0), st.booleans(), st.floats(0.0005, 0.02))
def test_prediction_agrees_with_the_exact_solution(
    axis: AxisState, u: float, flown: bool, dt: float
) -> None:
    drag = MODEL.drag if flown else MODEL.hover_drag
    pull = 1.0 if flown else 0.0
    system = np.array(
        [
            [0.0, 1.0, 0.0, 0.0, 0.0],
            [0.0, -drag, 1.0, pull, 0.0],
            [0.0, 0.0, -MODEL.lag, 0.0, MODEL.lag * MODEL.gain * u * pull],
            [0.0, 0.0, 0.0, 0.0, 0.0],
            [0.0, 0.0, 0.0, 0.0, 0.0],
        ]
    )
    exact = expm(system * dt) @ np.array([*axis, 1.0])
    assert tuple(predicted_axis(axis, u, transition(MODEL, flown, dt))) == pytest.approx(
        tuple(exact[:4]), abs=3e-4
    )


@given(axes, st.booleans(), st.floats(0.0, 0.02))
def test_prediction_matches_its_matrix_twin(axis: AxisState, flown: bool, dt: float) -> None:
    twin = matrix_of(flown, dt) @ np.array(axis)
    assert tuple(predicted_axis(axis, 0.0, transition(MODEL, flown, dt))) == pytest.approx(
        tuple(twin), abs=1e-12
    )


@given(covariances(), st.booleans(), st.floats(0.0, 0.02))
def test_covariance_matches_f_p_f_transposed_plus_q(
    p: AxisCovariance, flown: bool, dt: float
) -> None:
    f = matrix_of(flown, dt)
    q = np.zeros((4, 4))
    q[2, 2] = (
        MODEL.noise**2
        * (1.0 if flown else HOVER_VARIANCE_FACTOR)
        * (1.0 - np.exp(-2.0 * MODEL.lag * dt))
    )
    q[3, 3] = MODEL.wander**2 * dt if flown else 0.0
    assert matrix(predicted_covariance(p, transition(MODEL, flown, dt))) == pytest.approx(
        f @ matrix(p) @ f.T + q, abs=1e-10
    )


@given(axes, covariances(), numbers, st.floats(1e-6, 1e-2))
def test_correction_matches_the_joseph_form(
    axis: AxisState, p: AxisCovariance, seen: float, r: float
) -> None:
    full, h = matrix(p), np.array([[1.0, 0.0, 0.0, 0.0]])
    gain = full @ h.T / (h @ full @ h.T + r)
    keep = np.eye(4) - gain @ h
    assert matrix(updated_covariance(p, r)) == pytest.approx(
        keep @ full @ keep.T + r * gain @ gain.T, abs=1e-9
    )
    twin = np.array(axis) + gain[:, 0] * (seen - axis.x)
    twin[3] = np.clip(twin[3], -1.0, 1.0)
    assert tuple(updated_axis(axis, p, seen, r)) == pytest.approx(tuple(twin), rel=1e-9, abs=1e-9)


@given(
    covariances(),
    st.lists(st.tuples(st.booleans(), st.booleans(), st.floats(0.001, 0.02)), max_size=60),
)
def test_covariance_stays_positive_through_any_series_of_steps(
    p: AxisCovariance, series: list[tuple[bool, bool, float]]
) -> None:
    for measured, flown, dt in series:
        p = predicted_covariance(p, transition(MODEL, flown, dt))
        p = updated_covariance(p, 1e-5) if measured else p
        assert np.linalg.eigvalsh(matrix(p)).min() > -1e-9
