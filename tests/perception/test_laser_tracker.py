"""People and things in simulated scans of known truth."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import cos, hypot, inf, nan, sin
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from housefly.messages import Obstacle, Scan
from housefly.perception.laser_tracker import OwnFootprint
from housefly.perception.tracker import BIRTH_HITS, DEATH_MISSES

Make = Callable[..., Any]
once = settings(max_examples=30, suppress_health_check=[HealthCheck.function_scoped_fixture])


def error(obstacle: Obstacle, at: tuple[float, float]) -> float:
    return hypot(obstacle.position[0] - at[0], obstacle.position[1] - at[1])


@pytest.mark.parametrize("lasers", [(0,), (1,), (0, 1)])
def test_an_empty_room_has_no_ghosts(make_hall: Make, lasers: tuple[int, ...]) -> None:
    hall = make_hall(lasers=lasers, loss=0.02, noise=0.015)
    for _ in range(400):
        seen = hall.look()
        assert not seen.obstacles and not seen.problem


@once
@given(
    x=st.floats(1.0, 6.0),
    y=st.floats(1.0, 4.0),
    radius=st.floats(0.12, 0.4),
    seed=st.integers(0, 99),
)
def test_a_thing_that_stands_is_found_where_it_is(
    make_hall: Make, x: float, y: float, radius: float, seed: int
) -> None:
    hall = make_hall(seed=seed)
    hall.things = {"chair": ((x, y), radius)}
    seen = hall.look(40)
    (chair,) = seen.obstacles
    assert error(chair, (x, y)) < 0.08
    assert abs(chair.radius - radius) < 0.08
    assert chair.velocity == (0.0, 0.0) and chair.confidence == 1.0


def test_a_thing_is_believed_after_three_scans_and_told_gone_after_three_more_without_it(
    make_hall: Make,
) -> None:
    hall = make_hall()
    hall.look(5)
    hall.things = {"chair": ((3.0, 2.0), 0.25)}
    assert [len(hall.look().obstacles) for _ in range(BIRTH_HITS)] == [0] * (BIRTH_HITS - 1) + [1]
    hall.look(20)
    hall.things = {}
    told = [hall.look().obstacles for _ in range(DEATH_MISSES + 1)]
    assert [[o.confidence > 0.0 for o in obstacles] for obstacles in told] == [[True]] * (
        DEATH_MISSES - 1
    ) + [[False], []]


def test_somebody_who_walks_is_followed_with_their_velocity(make_hall: Make) -> None:
    hall = make_hall()
    errors = []

    def walking(at: float) -> dict[str, Any]:
        return {"anna": ((1.5 + 0.8 * (at - 10.0), 2.0 + 0.4 * (at - 10.0)), 0.25)}

    for n in range(160):
        seen = hall.look(1, walking)
        if n > 20:
            (anna,) = seen.obstacles
            errors.append(error(anna, walking(anna.seen_at)["anna"][0]))
            assert hypot(anna.velocity[0] - 0.8, anna.velocity[1] - 0.4) < 0.35
    assert max(errors) < 0.15


def test_two_people_who_cross_keep_their_names(make_hall: Make) -> None:
    hall = make_hall(lasers=(0, 1))

    def crossing(at: float) -> dict[str, Any]:
        t = at - 10.0
        return {
            "anna": ((2.0 + 0.7 * t, 2.0 + 0.1 * t), 0.22),
            "ben": ((6.5 - 0.7 * t, 3.2 - 0.1 * t), 0.22),
        }

    hall.look(20, crossing)
    names = {
        o.id: min(("anna", "ben"), key=lambda n, o=o: error(o, hall.things[n][0]))
        for o in hall.seen.obstacles
    }
    assert sorted(names.values()) == ["anna", "ben"]
    hall.look(200, crossing)
    assert {o.id for o in hall.seen.obstacles} == set(names)
    for obstacle in hall.seen.obstacles:
        assert error(obstacle, hall.things[names[obstacle.id]][0]) < 0.2


def test_a_thing_hidden_behind_another_is_not_gone(make_hall: Make) -> None:
    hall = make_hall()
    hall.things = {"far": ((5.0, 5.0), 0.2)}
    hall.look(10)
    hall.things["near"] = ((2.5, 2.5), 0.4)
    told = [o for _ in range(40) for o in hall.look().obstacles]
    assert all(o.confidence > 0.0 for o in told)
    assert len(hall.seen.obstacles) == 2


def test_the_drone_itself_is_no_obstacle_and_without_knowing_of_it_it_is(make_hall: Make) -> None:
    hall = make_hall()
    hall.things = {"drone": ((4.0, 2.0), 0.25)}
    hall.own = (OwnFootprint((4.0, 2.0), 0.6),)
    assert not hall.look(20).obstacles
    hall.own = ()
    assert len(hall.look(20).obstacles) == 1


def test_something_wide_is_a_rectangle_that_covers_it(make_hall: Make) -> None:
    hall = make_hall()
    hall.things = {str(n): ((3.0 + 0.2 * n, 2.5), 0.15) for n in range(9)}
    (board,) = hall.look(20).obstacles
    assert board.size[0] > 1.4 and board.radius == 0.0
    assert abs(board.position[0] - 3.8) < 0.2


def test_scans_that_cannot_be_are_refused_in_words_and_change_nothing(make_hall: Make) -> None:
    hall = make_hall()
    hall.things = {"chair": ((3.0, 2.0), 0.25)}
    hall.look(10)
    hall.now += 1.0
    good = hall.scan()
    bad = {
        "future": replace(good, captured_at=hall.now + 1.0),
        "s late": replace(good, captured_at=hall.now - 5.0),
        "finite": replace(good, first_angle=nan),
        "none": replace(good, ranges=(nan,) * BEAMS),
        "not a scanner": replace(good, source="stranger"),
    }
    for words, scan in bad.items():
        assert words in hall.tracker.update(scan, hall.now).problem
    assert "not newer" not in hall.tracker.update(good, hall.now).problem
    assert "not newer" in hall.tracker.update(good, hall.now).problem


BEAMS = 1081


def test_a_scanner_that_stands_still_or_is_covered_is_told(make_hall: Make) -> None:
    hall = make_hall()
    frozen = hall.scan()
    problems = [
        hall.tracker.update(
            replace(frozen, captured_at=hall.now + 0.025 * n), hall.now + 0.025 * n
        ).problem
        for n in range(6)
    ]
    assert [bool(problem) for problem in problems] == [False] * 3 + [True] * 3
    assert "stands still" in problems[-1]
    covered = replace(
        frozen, captured_at=hall.now + 1.0, ranges=tuple(np.linspace(0.03, 0.08, BEAMS).tolist())
    )
    assert "covers" in hall.tracker.update(covered, hall.now + 1.0).problem


numbers = st.floats() | st.floats(0.0, 12.0) | st.just(inf)
scans = st.builds(
    Scan,
    source=st.sampled_from(["laser-1", "laser-2", "x"]),
    captured_at=st.floats() | st.floats(9.0, 11.0),
    received_at=st.just(10.0),
    first_angle=numbers,
    step=numbers,
    ranges=st.lists(numbers, max_size=60).map(tuple),
)


@once
@given(st.lists(scans, max_size=8))
def test_any_scans_are_survived_and_what_comes_out_is_finite(
    make_hall: Make, garbage: list[Scan]
) -> None:
    hall = make_hall()
    for scan in garbage:
        for o in hall.tracker.update(scan, 10.0, (OwnFootprint((1.0, 1.0), 0.5),)).obstacles:
            assert all(np.isfinite([*o.position, o.radius, *o.size, *o.velocity]))


def test_the_same_scans_give_the_same_things(make_hall: Make) -> None:
    def circling(at: float) -> dict[str, Any]:
        return {"anna": ((4.0 + cos(at), 3.0 + sin(at)), 0.25)}

    one, two = make_hall(), make_hall()
    assert [one.look(1, circling) for _ in range(80)] == [two.look(1, circling) for _ in range(80)]
