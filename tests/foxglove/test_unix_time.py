"""A step in Unix time is the same step, all of it moved on."""

from __future__ import annotations

from math import isclose

from foxglove_room import step
from hypothesis import given
from hypothesis import strategies as st

from housefly.foxglove.unix_time import in_unix_time

TIMES = st.floats(0.0, 1e6)


@given(TIMES, st.floats(1e9, 2e9))
def test_every_stamp_is_moved_by_the_same_and_nothing_else_changes(now: float, by: float) -> None:
    before, after = step(now), in_unix_time(step(now), by)
    assert before.inputs.telemetry and after.inputs.telemetry
    assert before.outputs.estimate and after.outputs.estimate
    pairs = (
        (before.now, after.now),
        (before.inputs.telemetry.received_at, after.inputs.telemetry.received_at),
        (before.outputs.estimate.at, after.outputs.estimate.at),
        (before.outputs.events[0].at, after.outputs.events[0].at),
    )
    assert all(isclose(late - early, by, abs_tol=1e-5) for early, late in pairs)
    assert after.outputs.command == before.outputs.command
    assert after.outputs.path == before.outputs.path
    assert after.outputs.estimate.position == before.outputs.estimate.position
