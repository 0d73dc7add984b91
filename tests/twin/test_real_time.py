"""The world keeps up with the clock, and a stall is not replayed in a rush."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from kinematic_world import KinematicWorld

from housefly.clock import SteppedClock
from housefly.twin.real_time import MAX_CATCH_UP, RealTimeRunner


@given(st.lists(st.floats(0.0, 1.0), max_size=20))
def test_world_time_plus_lost_time_is_clock_time(pauses):
    clock, world = SteppedClock(100.0), KinematicWorld()
    runner = RealTimeRunner(world, clock)
    for pause in pauses:
        clock.advance(pause)
        before = world.now
        runner.catch_up()
        assert world.now - before <= MAX_CATCH_UP + 1e-9
    assert world.now + runner.slipped == pytest.approx(clock.now() - 100.0, abs=1e-6)


def test_short_steps_lose_nothing():
    clock, world = SteppedClock(), KinematicWorld()
    runner = RealTimeRunner(world, clock)
    for _ in range(1000):
        clock.advance(0.005)
        runner.catch_up()
    assert runner.slipped == 0.0
    assert world.now == pytest.approx(5.0)
