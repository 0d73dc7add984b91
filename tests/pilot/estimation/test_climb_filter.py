from __future__ import annotations

import pytest
from climb_bench import CLIMB_MODEL, ClimbBench
from hypothesis import given
from hypothesis import strategies as st

from housefly.pilot.estimation.climb_filter import climb_carried, climb_tick_known
from housefly.pilot.estimation.height_yaw import EXTRAPOLATION_MAX

TICK = 0.01
commands = st.lists(st.tuples(st.floats(-0.7, 0.7), st.booleans()), min_size=4, max_size=12)


@given(commands, st.integers(0, 8), st.floats(-0.02, 0.02))
def test_commands_count_one_delay_later_whatever_was_seen_between(
    given_: list[tuple[float, bool]], ticks: int, off: float
) -> None:
    height = ClimbBench(TICK * ticks)
    for n, (vz, flown) in enumerate(given_):
        height.give(TICK * n, vz, flown)
    seen_at = TICK * (len(given_) - 2)
    height.see(seen_at, 1.0 + off)
    end = seen_at + height.delay + 0.1
    wanted = height.by_hand(seen_at, end, height.climb.axis)
    assert tuple(height.look(end)) == pytest.approx(tuple(wanted), abs=1e-9)


@given(commands, st.integers(0, 8), st.integers(1, 5))
def test_what_is_known_beforehand_changes_nothing(
    given_: list[tuple[float, bool]], ticks: int, between: int
) -> None:
    """The step of a tick, and where the drone is at a time between sighting and look."""
    height = ClimbBench(TICK * ticks)
    for n, (vz, flown) in enumerate(given_):
        height.give(TICK * n, vz, flown)
    then, end = TICK * between, TICK * ticks + 0.1
    plain, middle = height.look(end), height.look(then)
    height.climb = climb_tick_known(height.climb, height.h, height.spans, CLIMB_MODEL)
    assert height.climb.length == pytest.approx(TICK)
    onward = climb_carried(
        height.climb, height.h, height.spans, CLIMB_MODEL, height.delay, middle, then, end
    )
    assert tuple(height.look(end)) == pytest.approx(tuple(plain), abs=1e-12)
    assert tuple(onward) == pytest.approx(tuple(plain), abs=1e-12)


def test_it_is_not_carried_on_for_ever() -> None:
    height = ClimbBench(0.06)
    height.give(0.0, 0.5)
    longest = height.look(0.06 + EXTRAPOLATION_MAX)
    assert height.look(5.0) == longest
    assert longest.z > 1.0


def test_a_load_is_found_within_a_second_and_the_commanded_climb_is_none() -> None:
    height, z, w, lift = ClimbBench(0.06), 1.0, 0.0, -0.98
    held = [0.0] * 7
    for n in range(300):
        at = n * TICK
        vz = 0.4 if n % 100 < 50 else -0.1
        height.give(at, vz)
        held.append(vz)
        u = held[-7]
        w += TICK * (1.4 * ((u if u >= 0.0 else 2.0 * u) - w) + lift)
        z += TICK * w
        if n > 1:
            height.see(at + 0.5 * TICK, z)
        if n == 100:
            assert height.climb.axis.d == pytest.approx(lift, abs=0.35)
    assert height.climb.axis.d == pytest.approx(lift, abs=0.05)
