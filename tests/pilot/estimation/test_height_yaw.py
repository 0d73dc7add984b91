from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from kalman_twin import NOISE, filtered, small, states

from housefly.pilot.estimation.height_yaw import (
    CLIMB_PROCESS_NOISE,
    EXTRAPOLATION_MAX,
    YAW_NOISE_RATIO,
    YAW_PROCESS_NOISE,
    HeightYawState,
    height_yaw_at,
    height_yaw_initialized,
    height_yaw_updated,
)

uprights = st.builds(lambda z, yaw: HeightYawState(z, yaw, 1.0, 1e-5, 1e-4), states, states)


@given(uprights, small, small, st.floats(0.001, 0.3))
def test_height_and_heading_match_a_filter_with_matrices(
    u: HeightYawState, dz: float, dyaw: float, dt: float
) -> None:
    z, yaw = u.z.x + dt * u.z.v + dz, u.yaw.x + dt * u.yaw.v + dyaw
    believed, without, taken = height_yaw_updated(u, z, yaw, 1.0 + dt, False, NOISE)
    assert believed and without[:3] == u[:3] and taken.at == 1.0 + dt
    cases = (
        (u.z, CLIMB_PROCESS_NOISE, z, taken.z, NOISE**2),
        (u.yaw, YAW_PROCESS_NOISE, yaw, taken.yaw, (YAW_NOISE_RATIO * NOISE) ** 2),
    )
    for before, noise, seen, after, r in cases:
        x, p = filtered(before, noise, dt, seen, r)
        assert (after.x, after.v) == pytest.approx(tuple(x), abs=1e-9)
        assert (after.xx, after.xv, after.vv) == pytest.approx(
            (p[0, 0], p[0, 1], p[1, 1]), abs=1e-9
        )


@given(uprights, st.floats(0.4, 2.0), st.booleans())
def test_a_jump_is_refused_and_while_refusing_the_doubt_stays(
    u: HeightYawState, jump: float, refusing: bool
) -> None:
    believed, without, _ = height_yaw_updated(u, u.z.x + jump, u.yaw.x, 1.02, refusing, NOISE)
    assert not believed
    assert (without.z_innovation == u.z_innovation) == refusing


@given(uprights, st.floats(0.0, 3.0))
def test_height_is_extrapolated_no_further_than_its_reach(u: HeightYawState, ahead: float) -> None:
    z, climb, yaw = height_yaw_at(u, 1.0 + ahead)
    assert z == pytest.approx(u.z.x + min(ahead, EXTRAPOLATION_MAX) * u.z.v) and climb == u.z.v
    assert np.exp(1j * yaw) == pytest.approx(
        np.exp(1j * (u.yaw.x + min(ahead, EXTRAPOLATION_MAX) * u.yaw.v)), abs=1e-9
    )


def test_a_drone_first_seen_stands_still() -> None:
    assert height_yaw_at(height_yaw_initialized(1.1, 0.3, 5.0, NOISE), 5.2) == pytest.approx(
        (1.1, 0.0, 0.3)
    )
