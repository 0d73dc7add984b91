from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.pilot.estimation.constant_velocity import ConstantVelocity, cv_predicted, cv_updated

states = st.builds(
    lambda x, v, a, b, c: ConstantVelocity(x, v, a * a + 1e-3, a * b, b * b + c * c + 1e-3),
    *[st.floats(-2.0, 2.0)] * 5,
)


def matrix(s: ConstantVelocity) -> np.ndarray:
    return np.array([[s.xx, s.xv], [s.xv, s.vv]])


@given(states, st.floats(-2.0, 2.0), st.floats(0.0, 3.0), st.floats(0.0, 1.0))
def test_prediction_matches_its_matrix_twin(
    s: ConstantVelocity, a: float, noise: float, dt: float
) -> None:
    f = np.array([[1.0, dt], [0.0, 1.0]])
    q = noise**2 * np.array([[dt**3 / 3.0, dt**2 / 2.0], [dt**2 / 2.0, dt]])
    after = ConstantVelocity(*cv_predicted(s, a, noise, dt))
    assert (after.x, after.v) == pytest.approx(
        tuple(f @ [s.x, s.v] + a * np.array([dt**2 / 2.0, dt])), abs=1e-9
    )
    assert matrix(after) == pytest.approx(f @ matrix(s) @ f.T + q, abs=1e-9)


@given(states, st.floats(-2.0, 2.0), st.floats(1e-6, 1.0))
def test_correction_matches_the_joseph_form(
    s: ConstantVelocity, innovation: float, r: float
) -> None:
    h = np.array([[1.0, 0.0]])
    gain = matrix(s) @ h.T / (s.xx + r)
    keep = np.eye(2) - gain @ h
    after = ConstantVelocity(*cv_updated(s, innovation, r))
    assert (after.x, after.v) == pytest.approx(
        (s.x + gain[0, 0] * innovation, s.v + gain[1, 0] * innovation), abs=1e-9
    )
    assert matrix(after) == pytest.approx(keep @ matrix(s) @ keep.T + r * gain @ gain.T, abs=1e-9)
