from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.pilot.estimation.climb_axis import (
    LIFT_LIMIT,
    ClimbAxis,
    ClimbCovariance,
    ClimbModel,
    climb_answer,
    climb_step,
    first_climb_covariance,
    predicted_climb,
    predicted_climb_covariance,
    updated_climb,
    updated_climb_covariance,
)

MODEL = ClimbModel(pole=1.4, sink_gain=2.0, noise=0.1, wander=0.5)
R = 9e-6
speeds, lifts = st.floats(-0.7, 0.7), st.floats(-1.0, 1.0)
axes = st.builds(ClimbAxis, st.floats(0.0, 2.5), speeds, lifts)


def matrix(p: ClimbCovariance) -> np.ndarray:
    return np.array([[p.zz, p.zw, p.zd], [p.zw, p.ww, p.wd], [p.zd, p.wd, p.dd]])


@given(axes, speeds, st.floats(0.001, 0.3), st.floats(0.1, 0.9), st.booleans())
def test_two_steps_make_the_same_as_one(
    axis: ClimbAxis, u: float, dt: float, share: float, flown: bool
) -> None:
    whole = predicted_climb(axis, u, climb_step(MODEL, flown, dt))
    half = predicted_climb(axis, u, climb_step(MODEL, flown, share * dt))
    both = predicted_climb(half, u, climb_step(MODEL, flown, (1.0 - share) * dt))
    assert tuple(both) == pytest.approx(tuple(whole), abs=1e-12)


@given(axes, speeds)
def test_a_short_step_is_the_equation_of_motion(axis: ClimbAxis, u: float) -> None:
    dt = 1e-5
    after = predicted_climb(axis, u, climb_step(MODEL, True, dt))
    assert (after.z - axis.z) / dt == pytest.approx(axis.w, abs=1e-4)
    rise = MODEL.pole * (u - axis.w) + axis.d
    assert (after.w - axis.w) / dt == pytest.approx(rise, abs=1e-4)


@given(lifts, speeds)
def test_at_rest_the_drone_climbs_beside_its_command(d: float, u: float) -> None:
    rest = ClimbAxis(1.0, u + d / MODEL.pole, d)
    after = predicted_climb(rest, u, climb_step(MODEL, True, 0.2))
    assert after.w == pytest.approx(rest.w, abs=1e-12)


def test_while_the_drone_flies_itself_the_lift_is_kept_and_does_not_count() -> None:
    p = first_climb_covariance(R)
    step = climb_step(MODEL, False, 0.02)
    after = predicted_climb(ClimbAxis(1.0, 0.1, -0.8), 0.5, step)
    assert tuple(after) == pytest.approx((1.002, 0.1, -0.8))
    assert predicted_climb_covariance(p, step).dd == p.dd


@given(axes, st.floats(-0.1, 0.1), st.booleans())
def test_a_step_and_an_update_match_the_matrices(axis: ClimbAxis, off: float, flown: bool) -> None:
    step = climb_step(MODEL, flown, 0.02)
    f = np.array([[1.0, step.zw, step.zd], [0.0, step.ww, step.wd], [0.0, 0.0, 1.0]])
    q = np.array(
        [
            [step.noise_zz, step.noise_zw, 0.0],
            [step.noise_zw, step.noise_ww, 0.0],
            [0.0, 0.0, step.noise_dd],
        ]
    )
    p = predicted_climb_covariance(first_climb_covariance(R), climb_step(MODEL, True, 0.02))
    ahead = predicted_climb_covariance(p, step)
    assert matrix(ahead) == pytest.approx(f @ matrix(p) @ f.T + q, abs=1e-15)
    gain = matrix(ahead)[:, 0] / (ahead.zz + R)
    after = updated_climb(axis, ahead, axis.z + off, R)
    wanted = np.array(axis) + gain * off
    wanted[2] = np.clip(wanted[2], -LIFT_LIMIT, LIFT_LIMIT)
    assert np.array(after) == pytest.approx(wanted, abs=1e-12)
    left = matrix(ahead) - np.outer(gain, matrix(ahead)[0])
    assert matrix(updated_climb_covariance(ahead, R)) == pytest.approx(left, abs=1e-12)


def test_a_commanded_sinking_is_answered_twice_as_fast() -> None:
    assert climb_answer(MODEL, 0.3) == 0.3
    assert climb_answer(MODEL, -0.3) == -0.6
