"""The height loop of a Betaflight, held against a drone whose poses come late."""

from __future__ import annotations

from collections import deque
from dataclasses import replace

import pytest

from housefly.config.airframe import airframe_named
from housefly.drones.betaflight.height import HeightLoop, height_model
from housefly.geometry import GRAVITY

PERIOD, MOTOR_TIME = 0.01, 0.04
IDLE = 0.05


def climbed(age: float, mistaken: float, seconds: float = 12.0) -> list[float]:
    """Return the heights of a drone that is to climb from 0.5 to 1 m by poses that are so old [s].

    Its thrust is larger than the model believes by a share, which the loop has to learn.
    """
    model = height_model(airframe_named("betaflight"), IDLE)
    z, speed, thrust = 0.5, 0.0, 1.0
    loop = HeightLoop(model, stands=False)
    under_way: deque[tuple[float, float]] = deque()
    heights = []
    for n in range(round(seconds / PERIOD)):
        now = n * PERIOD
        if n % 2 == 0:
            under_way.append((now, z))
        while under_way and under_way[0][0] <= now - age + 1e-9:
            captured_at, height = under_way.popleft()
            loop = loop.seen(height, captured_at)
        loop = loop.at(now)
        if not under_way or now >= age:
            loop = loop.climbing(min(max(1.5 * (1.0 - loop.state.place), -0.5), 0.5))
        asked = model.thrust(loop.throttle()) * (1.0 + mistaken)
        thrust += PERIOD / (PERIOD + MOTOR_TIME) * (asked - thrust)
        speed += PERIOD * (GRAVITY * (thrust - 1.0) - model.drag * speed)
        z += PERIOD * speed
        heights.append(z)
    return heights


@pytest.mark.parametrize("age", [0.0, 0.02, 0.1, 0.2])
@pytest.mark.parametrize("mistaken", [-0.1, 0.0, 0.1])
def test_it_reaches_its_height_and_stays_there_by_poses_of_any_age(
    age: float, mistaken: float
) -> None:
    heights = climbed(age, mistaken)
    assert max(heights) < 1.6 and min(heights) > 0.1
    assert all(abs(height - 1.0) < 0.05 for height in heights[-300:])


def test_a_rise_that_was_seen_late_went_on_since() -> None:
    model = height_model(airframe_named("betaflight"), IDLE)
    spool, push = 0.5, 0.3
    jerk = GRAVITY * spool
    lifted_for, seen_ago = 0.5, 0.2
    made = jerk * lifted_for - push
    standing = replace(HeightLoop(model), made=made)
    seen = standing.seen(jerk * (lifted_for - seen_ago) ** 3 / 6.0, 0.0)
    loop = seen.lifted(seen.state.place, seen_ago, spool)
    assert loop.state.push == pytest.approx(push)
    assert loop.state.speed == pytest.approx(0.5 * jerk * lifted_for**2)
    assert loop.state.place == pytest.approx(jerk * lifted_for**3 / 6.0)
