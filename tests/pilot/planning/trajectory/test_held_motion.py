"""A velocity that is held for a moment, and the rest that follows by itself."""

from __future__ import annotations

from math import hypot

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.airframe import airframe_named
from housefly.config.limits import LimitsConfig
from housefly.numeric import FloatArray
from housefly.pilot.planning.trajectory.held_motion import (
    LONGEST,
    held_limits,
    held_motion,
    held_velocity,
)
from housefly.pilot.planning.trajectory.kinematic_state import TICK, KinematicState

LIMITS = held_limits(LimitsConfig(nudge_speed=0.5))
PARTS = st.tuples(*[st.floats(-3.0, 3.0)] * 3)


def moving(velocity: tuple[float, ...]) -> KinematicState:
    start = held_velocity(np.array(velocity), LIMITS)
    return KinematicState(np.array((1.0, 2.0, 1.1)), start, np.zeros(3))


def pushes(rows: FloatArray) -> tuple[float, float]:
    return float(np.hypot(rows[:, 6], rows[:, 7]).max()), float(np.abs(rows[:, 8]).max())


@given(start=PARTS, wish=PARTS, held=st.floats(0.0, 0.3))
def test_whatever_is_held_it_keeps_its_limits_and_comes_to_rest(
    start: tuple[float, ...], wish: tuple[float, ...], held: float
) -> None:
    velocity = held_velocity(np.array(wish), LIMITS)
    assert np.linalg.norm(velocity) <= LIMITS.speed + 1e-9 and abs(velocity[2]) <= LIMITS.climb
    rows = held_motion(moving(start), velocity, held, LIMITS)
    assert 2 <= len(rows) < LONGEST / TICK and not rows[-1, 3:].any()
    level, upright = pushes(rows)
    assert level <= LIMITS.acceleration + 1e-9
    assert upright <= LIMITS.vertical_acceleration + 1e-9
    jerks = np.linalg.norm(np.diff(rows[:, 6:], axis=0), axis=1) / TICK
    assert jerks[:-1].max(initial=0.0) <= LIMITS.jerk + 1e-6
    assert jerks[-1] <= 2.0 * LIMITS.jerk  # it ends where next to nothing is left
    # Neither axis is ever faster than at the start or than asked for.
    fastest = np.maximum(np.abs(rows[0, 3:6]), np.abs(velocity))
    assert (np.abs(rows[:, 3:6]) <= fastest + 0.01).all()


@given(start=PARTS, wish=PARTS, held=st.floats(0.0, 0.3))
def test_places_and_velocities_belong_together(
    start: tuple[float, ...], wish: tuple[float, ...], held: float
) -> None:
    rows = held_motion(moving(start), held_velocity(np.array(wish), LIMITS), held, LIMITS)
    moved = np.diff(rows[:, :3], axis=0)
    mean = 0.5 * TICK * (rows[1:, 3:6] + rows[:-1, 3:6])
    assert np.abs(moved - mean).max() < 1e-4
    faster = np.diff(rows[:-1, 3:6], axis=0)
    pushed = 0.5 * TICK * (rows[1:-1, 6:] + rows[:-2, 6:])
    assert np.abs(faster - pushed).max(initial=0.0) < 1e-9


@pytest.mark.parametrize("speed", [0.1, 0.25, 0.5])
def test_what_is_let_go_rests_within_the_stopping_distance(speed: float) -> None:
    rows = held_motion(moving((speed, 0.0, 0.0)), np.zeros(3), 0.0, LIMITS)
    away = hypot(*(rows[-1, :2] - rows[0, :2]))
    assert away <= airframe_named("ardrone").braking.way_to_rest(speed)


def test_a_second_of_holding_is_what_the_speed_says() -> None:
    rows = held_motion(moving((0.5, 0.0, 0.0)), np.array((0.5, 0.0, 0.0)), 1.0, LIMITS)
    assert rows[50, 0] - rows[0, 0] == pytest.approx(0.5)
