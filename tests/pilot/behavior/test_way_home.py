from __future__ import annotations

from housefly.geometry import Vec2
from housefly.messages import Path, PlanAnswer
from housefly.pilot.behavior.way_home import (
    ASKING_PERIOD,
    ASKING_PERIOD_IN_SPACE,
    DETOUR_FACTOR,
    WayHome,
)

HOME = (0.0, 0.0)


def test_the_planner_is_asked_now_and_then_and_a_closed_way_is_counted_longer() -> None:
    asked: list[Vec2] = []

    def route(start: Vec2, goal: Vec2) -> PlanAnswer:
        asked.append(start)
        path = Path((start, goal), start[0], 1.0) if start[0] < 5.0 else None
        return PlanAnswer(start, goal, path, duration=2.0 * start[0])

    way = WayHome(route, HOME, 0.5)
    way.update((4.0, 0.0), 0.0)
    assert (way.exists, way.duration) == (True, 8.0)
    way.update((6.0, 0.0), 0.9 * ASKING_PERIOD)
    assert asked == [(4.0, 0.0)]
    way.update((6.0, 0.0), ASKING_PERIOD)
    assert (way.exists, way.duration) == (False, DETOUR_FACTOR * 12.0)


def test_in_space_the_planner_is_asked_seldom_and_what_was_moved_is_counted_as_longer() -> None:
    asked: list[Vec2] = []

    def route(start: Vec2, goal: Vec2) -> PlanAnswer:
        asked.append(start)
        return PlanAnswer(start, goal, Path((start, goal), start[0], 1.0), duration=2.0 * start[0])

    way = WayHome(route, HOME, 0.5, in_space=True)
    way.update((4.0, 0.0), 0.0)
    way.update((6.0, 0.0), 0.9 * ASKING_PERIOD_IN_SPACE)
    assert asked == [(4.0, 0.0)] and way.duration == 8.0 + 2.0 / 0.5
    way.update((6.0, 0.0), ASKING_PERIOD_IN_SPACE)
    assert asked[-1] == (6.0, 0.0) and way.duration == 12.0
