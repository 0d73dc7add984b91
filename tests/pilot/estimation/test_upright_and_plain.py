from __future__ import annotations

import numpy as np
import pytest
from housefly.pilot.estimation.plain import (
    PaperFilterState,
    paper_filter_advanced,
    paper_filter_commanded,
    paper_filter_gated,
    paper_filter_initialized,
    paper_filter_updated,
)
from hypothesis import given
from hypothesis import strategies as st

from housefly.pilot.estimation.constant_velocity import ConstantVelocity
from housefly.pilot.estimation.height_yaw import (
    CLIMB_PROCESS_NOISE,
    EXTRAPOLATION_MAX,
    YAW_NOISE_RATIO,
    YAW_PROCESS_NOISE,
    HeightYawState,
    height_yaw_at,
    height_yaw_initialized,
    height_yaw_updated,
    within_gate,
)
from housefly.pilot.estimation.validation import (
    CLOCK_TOLERANCE,
    FUTURE,
    OUT_OF_ORDER,
    SIGHTING_AGE_MAX,
    STALE,
    stamp_fault,
)

NOISE = 0.003
small = st.floats(-0.05, 0.05)
drifts = st.builds(
    lambda x, v: ConstantVelocity(x, v, 1e-4, 1e-5, 1e-3), st.floats(-2.0, 2.0), st.floats(-0.5, 0.5)
)
uprights = st.builds(lambda z, yaw: HeightYawState(z, yaw, 1.0, 1e-5, 1e-4), drifts, drifts)


def filtered(
    s: ConstantVelocity, noise: float, dt: float, seen: float, r: float
) -> tuple[np.ndarray, np.ndarray]:
    """One textbook step of the Kalman filter with matrices."""
    f, h = np.array([[1.0, dt], [0.0, 1.0]]), np.array([1.0, 0.0])
    q = noise**2 * np.array([[dt**3 / 3.0, dt**2 / 2.0], [dt**2 / 2.0, dt]])
    x, p = f @ [s.x, s.v], f @ np.array([[s.xx, s.xv], [s.xv, s.vv]]) @ f.T + q
    gain = p @ h / (h @ p @ h + r)
    return x + gain * np.angle(np.exp(1j * (seen - h @ x))), p - np.outer(gain, h @ p)


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
    assert (without.z_doubt == u.z_doubt) == refusing


@given(uprights, st.floats(0.0, 3.0))
def test_height_is_extrapolated_no_further_than_its_reach(u: HeightYawState, ahead: float) -> None:
    z, climb, yaw = height_yaw_at(u, 1.0 + ahead)
    assert z == pytest.approx(u.z.x + min(ahead, EXTRAPOLATION_MAX) * u.z.v) and climb == u.z.v
    assert np.exp(1j * yaw) == pytest.approx(
        np.exp(1j * (u.yaw.x + min(ahead, EXTRAPOLATION_MAX) * u.yaw.v)), abs=1e-9
    )


def test_a_drone_first_seen_stands_still() -> None:
    assert height_yaw_at(height_yaw_initialized(1.1, 0.3, 5.0, NOISE), 5.2) == pytest.approx((1.1, 0.0, 0.3))


@given(st.floats(0.0, 2.0), st.floats(-0.01, 0.02), st.floats(0.0, 2.0))
def test_a_stamp_is_judged_by_the_clock_and_by_the_one_before(
    captured: float, ahead: float, last: float
) -> None:
    now = captured - ahead
    expected = (
        FUTURE if captured > now + CLOCK_TOLERANCE else OUT_OF_ORDER if captured <= last else 0
    )
    assert stamp_fault(captured, now, last) == expected
    assert stamp_fault(captured, captured + SIGHTING_AGE_MAX + 0.1, -1.0) == STALE


@given(drifts, drifts, st.floats(-2.0, 2.0), st.floats(0.0, 0.2), small, small)
def test_the_papers_filter_matches_one_with_matrices(
    x: ConstantVelocity, y: ConstantVelocity, u: float, dt: float, dx: float, dy: float
) -> None:
    p = paper_filter_advanced(
        paper_filter_commanded(PaperFilterState(x, y, 0.0, 0.0, 2.0, 1e-5), u, -u, True), 0.4, 2.0 + dt
    )
    for before, after, push, off in ((x, p.x, u, dx), (y, p.y, -u, dy)):
        assert after.x == pytest.approx(before.x + dt * before.v + 0.5 * dt**2 * push, abs=1e-12)
        assert after.v == pytest.approx(before.v + dt * push, abs=1e-12)
        measured = paper_filter_updated(p, p.x.x + dx, p.y.x + dy, NOISE**2)
        state, _ = filtered(after, 0.4, 0.0, after.x + off, NOISE**2)
        found = measured.x if before is x else measured.y
        if x != y:
            assert (found.x, found.v) == pytest.approx(tuple(state), abs=1e-9)
    assert paper_filter_advanced(p, 0.4, 1.0) == p


def test_the_papers_filter_hears_no_command_while_the_drone_flies_itself() -> None:
    nowhere = ConstantVelocity(0.0, 0.0, 0.0, 0.0, 0.0)
    seen = paper_filter_initialized(PaperFilterState(nowhere, nowhere, 1.0, 1.0, 0.0, 0.0), 1.0, 2.0, 3.0, 1e-5)
    p = paper_filter_commanded(seen, 1.0, 1.0, False)
    assert (p.ux, p.uy, p.at, p.x.x, p.y.x) == (0.0, 0.0, 3.0, 1.0, 2.0)


@given(drifts, drifts, st.floats(-1.0, 1.0), st.booleans())
def test_the_papers_filter_judges_by_its_doubt(
    x: ConstantVelocity, y: ConstantVelocity, off: float, refusing: bool
) -> None:
    p = PaperFilterState(x, y, 0.0, 0.0, 0.0, 1e-6)
    believed, kept = paper_filter_gated(p, x.x + off, y.x, refusing, NOISE**2)
    doubt = 1e-6 if refusing else x.xx + NOISE**2
    assert kept.doubt == doubt and believed == within_gate(off * off, doubt, 0.15)
