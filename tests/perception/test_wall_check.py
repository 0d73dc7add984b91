"""A scanner that does not see the walls of the map where they are is not believed."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from housefly.geometry import distance
from housefly.messages import Scan
from housefly.perception.laser_tracker import LaserTracker
from housefly.perception.wall_check import LOOK_PERIOD, LOOKS

Make = Callable[..., Any]
ENOUGH = round((LOOKS + 1) * LOOK_PERIOD / 0.025)
"""Scans after which it is told."""


def told(hall: Any, change: Callable[[Scan], Scan] = lambda scan: scan, scans: int = ENOUGH) -> str:
    """Return what is said of the first scanner after so many scans, each changed."""
    for _ in range(scans):
        hall.now += 0.025
        seen = hall.tracker.update(change(hall.scan()), hall.now)
    problem: str = seen.problem
    return problem


def hang(hall: Any, x: float = 0.0, y: float = 0.0, turn: float = 0.0) -> None:
    """Hang the first scanner at (2, 1); the site has it so far off [m, rad]."""
    true = hall.configs[0].model_copy(update={"x": 2.0, "y": 1.0, "yaw": 0.7})
    site = true.model_copy(update={"x": 2.0 + x, "y": 1.0 + y, "yaw": 0.7 + turn})
    hall.configs = (true, hall.configs[1])
    hall.tracker = LaserTracker(hall.room, (site, hall.configs[1]))


def longer(by: float) -> Callable[[Scan], Scan]:
    """Return what makes the distances of a scan longer [m]."""
    return lambda scan: replace(scan, ranges=tuple(max(0.0, r + by) for r in scan.ranges))


@pytest.mark.parametrize(("by", "way"), [(0.5, "long"), (-0.5, "short"), (0.3, "long")])
def test_distances_that_are_off_are_told_with_how_far(make_hall: Make, by: float, way: str) -> None:
    hall = make_hall()
    hang(hall)
    problem = told(hall, longer(by))
    assert problem.startswith("laser-1: ") and f"{abs(by):.2f} m too {way}" in problem
    assert not hall.tracker.update(longer(by)(hall.scan()), hall.now + 0.01).obstacles


def test_whom_a_wrong_scanner_sees_is_put_where_they_are(make_hall: Make) -> None:
    """Not seen at all they would be flown into."""
    hall = make_hall()
    hang(hall)
    told(hall, longer(0.5))
    hall.things = {"anna": ((5.0, 3.0), 0.25)}
    for _ in range(10):
        hall.now += 0.025
        seen = hall.tracker.update(longer(0.5)(hall.scan()), hall.now)
    (anna,) = seen.obstacles
    assert distance(anna.position, (5.0, 3.0)) < 0.1 and seen.problem


@pytest.mark.parametrize(
    ("x", "y", "turn"), [(0.5, 0.0, 0.0), (0.0, -0.3, 0.0), (0.3, 0.4, 0.1), (0.0, 0.0, 0.15)]
)
def test_a_scanner_that_hangs_elsewhere_is_told_with_the_place_that_fits(
    make_hall: Make, x: float, y: float, turn: float
) -> None:
    hall = make_hall()
    hang(hall, x, y, turn)
    problem = told(hall)
    assert "x = 2.0" in problem or "x = 1.99" in problem, problem
    assert "[[lasers]]" in problem


def test_one_that_is_right_again_is_believed_again(make_hall: Make) -> None:
    hall = make_hall()
    assert told(hall, longer(0.5))
    assert not told(hall)


@pytest.mark.parametrize("n", range(6))
def test_people_and_things_before_the_walls_are_no_error_of_the_scanner(
    make_hall: Make, n: int
) -> None:
    hall = make_hall(seed=n)
    hall.things = {
        f"p{k}": ((1.0 + 0.35 * ((k * (n + 2)) % 7), 0.9 + 0.3 * ((k * 3 + n) % 5)), 0.3)
        for k in range(2 + 3 * n)
    }
    assert not told(hall)


def test_in_flight_an_error_that_lasts_less_than_a_second_is_not_told(make_hall: Make) -> None:
    hall = make_hall()
    assert not told(hall)
    assert not told(hall, longer(0.5), scans=round((LOOKS - 1) * LOOK_PERIOD / 0.025))


def test_the_first_scans_tell_it_at_once(make_hall: Make) -> None:
    """Before anybody can order a take-off."""
    assert told(make_hall(), longer(0.5), scans=LOOKS)
