from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from kalman_twin import NOISE, filtered, small, states

from housefly.pilot.estimation.constant_velocity import ConstantVelocity
from housefly.pilot.estimation.height_yaw import within_gate
from housefly.pilot.estimation.paper_filter import (
    PaperFilterState,
    paper_filter_advanced,
    paper_filter_commanded,
    paper_filter_gated,
    paper_filter_initialized,
    paper_filter_updated,
)


@given(states, states, st.floats(-2.0, 2.0), st.floats(0.0, 0.2), small, small)
def test_the_papers_filter_matches_one_with_matrices(
    x: ConstantVelocity, y: ConstantVelocity, u: float, dt: float, dx: float, dy: float
) -> None:
    p = paper_filter_advanced(
        paper_filter_commanded(PaperFilterState(x, y, 0.0, 0.0, 2.0, 1e-5), u, -u, True),
        0.4,
        2.0 + dt,
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
    seen = paper_filter_initialized(
        PaperFilterState(nowhere, nowhere, 1.0, 1.0, 0.0, 0.0), 1.0, 2.0, 3.0, 1e-5
    )
    p = paper_filter_commanded(seen, 1.0, 1.0, False)
    assert (p.ux, p.uy, p.at, p.x.x, p.y.x) == (0.0, 0.0, 3.0, 1.0, 2.0)


@given(states, states, st.floats(-1.0, 1.0), st.booleans())
def test_the_papers_filter_judges_by_its_doubt(
    x: ConstantVelocity, y: ConstantVelocity, off: float, refusing: bool
) -> None:
    p = PaperFilterState(x, y, 0.0, 0.0, 0.0, 1e-6)
    believed, kept = paper_filter_gated(p, x.x + off, y.x, refusing, NOISE**2)
    doubt = 1e-6 if refusing else x.xx + NOISE**2
    assert kept.innovation_variance == doubt and believed == within_gate(off * off, doubt, 0.15)
