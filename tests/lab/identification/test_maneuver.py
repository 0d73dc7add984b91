"""The maneuver begins its blocks at rest and gives up when anything goes wrong."""

from __future__ import annotations

import pytest

from housefly.lab.identification.box import Box
from housefly.lab.identification.maneuver import REST_TIME, IdentificationManeuver
from housefly.lab.identification.pattern import blocks
from housefly.messages import Estimate

PLAN = blocks(4, 0.21)


def at(x: float, now: float, *, age: float = 0.01, speed: float = 0.0) -> Estimate:
    return Estimate(now, (x, 0.0, 1.1), (speed, 0.0, 0.0), 0.0, age, 0.001)


def begun() -> tuple[IdentificationManeuver, float]:
    """Return a maneuver in the middle of its first block, and the time."""
    maneuver, now = IdentificationManeuver(PLAN, Box((0.0, 0.0), 0.62, 1.1)), 0.0
    while not maneuver.flown:
        maneuver.propose(now, at(0.0, now))
        now += 0.01
    for _ in range(20):
        setpoint = maneuver.propose(now, at(0.05, now))
        assert setpoint is not None and setpoint.theta == PLAN[0].amplitude
        now += 0.01
    return maneuver, now


def test_a_block_begins_only_after_rest_in_the_middle() -> None:
    maneuver, now = IdentificationManeuver(PLAN, Box((0.0, 0.0), 0.62, 1.1)), 0.0
    for _ in range(300):
        assert maneuver.propose(now, at(0.0, now, speed=0.2)) is None
        now += 0.01
    calm_since = now
    while not maneuver.flown:
        maneuver.propose(now, at(0.0, now))
        now += 0.01
    assert maneuver.flown[0].began - calm_since == pytest.approx(REST_TIME, abs=0.02)


@pytest.mark.parametrize(
    ("x", "age", "later", "words"),
    [
        (0.7, 0.01, 0.01, "left the box"),
        (0.05, 0.3, 0.01, "tracking was lost for 0.30 s"),
        (0.05, 0.01, 0.5, "interrupted in the middle of a step"),
    ],
)
def test_a_block_is_given_up_and_never_taken_up_again(
    x: float, age: float, later: float, words: str
) -> None:
    maneuver, now = begun()
    now += later
    assert maneuver.propose(now, at(x, now, age=age)) is None
    assert words in maneuver.problem
    assert maneuver.finished
    for _ in range(100):
        now += 0.01
        assert maneuver.propose(now, at(0.0, now)) is None


def test_a_drone_that_never_rests_is_given_up() -> None:
    maneuver, now = IdentificationManeuver(PLAN, Box((0.0, 0.0), 0.62, 1.1)), 0.0
    while not maneuver.finished and now < 60.0:
        maneuver.propose(now, at(0.0, now, speed=0.5))
        now += 0.05
    assert "did not come to rest within 25 s" in maneuver.problem
