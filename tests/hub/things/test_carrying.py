"""What may have become of a carried thing: belief that adds up and only ever falls."""

from __future__ import annotations

from collections.abc import Sequence
from random import Random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.hub.things.carrying import Carrying
from housefly.hub.things.hypothesis import Belief
from housefly.hub.things.surfaces import Surface

_TABLE = Surface("sofa-table", "sofa table", (3.0, 1.0), (0.5, 0.3), 0.43)
_DESK = Surface("desk", "the desk", (6.0, -1.0), (0.6, 0.3), 0.7)
_CHAIR = Surface("chair", "chair", (3.0, -1.0), (0.25, 0.25), 0.45, seat=True)
_ALL = (_TABLE, _DESK, _CHAIR)
_PERIOD, _SPEED = 0.1, 0.8
_POINTS = st.lists(st.tuples(st.floats(-1.0, 8.0), st.floats(-2.0, 2.0)), min_size=1, max_size=60)


def walked(legs: Sequence[tuple[float, float, float]], noise: float = 0.0) -> Carrying:
    """Return what is carried along legs (x [m], y [m], rest there [s]), told at 10 Hz."""
    dice = Random(1)
    carrying, at, x, y = Carrying("somebody", 0.0, _ALL), 0.0, 0.0, 0.0

    def tell() -> None:
        carrying.add(at, (x + dice.gauss(0.0, noise), y + dice.gauss(0.0, noise), 0.0))

    for goal_x, goal_y, rest in legs:
        length = ((goal_x - x) ** 2 + (goal_y - y) ** 2) ** 0.5
        steps = max(1, round(length / (_SPEED * _PERIOD)))
        start_x, start_y = x, y
        for step in range(1, steps + 1):
            x = start_x + (goal_x - start_x) * step / steps
            y = start_y + (goal_y - start_y) * step / steps
            at += _PERIOD
            tell()
        for _ in range(round(rest / _PERIOD)):
            at += _PERIOD
            tell()
    return carrying


def belief_after(
    *legs: tuple[float, float, float], noise: float = 0.0, later: float = 0.0
) -> Belief:
    carrying = walked(legs, noise)
    assert carrying._last is not None
    return carrying.belief(carrying._last + later)


def share(belief: Belief, thing: str) -> float:
    return sum(one.confidence for one in belief.alternatives if one.thing == thing)


@settings(max_examples=60, deadline=None)
@given(_POINTS, st.floats(0.05, 4.0), st.floats(0.0, 3000.0))
def test_belief_adds_up_and_falls_with_every_step_and_with_time(
    points: list[tuple[float, float]], period: float, later: float
) -> None:
    carrying = Carrying("somebody", 0.0, _ALL)
    before = 1.0
    for number, point in enumerate(points, 1):
        carrying.add(number * period, point)
        belief = carrying.belief(number * period)
        told = belief.confidence + sum(one.confidence for one in belief.alternatives)
        assert 0.0 <= belief.confidence <= before + 1e-9
        assert told == pytest.approx(1.0, abs=0.05) and told <= 1.0 + 1e-9
        before = belief.confidence
    assert carrying.belief(len(points) * period + later).confidence <= before + 1e-9


@given(_POINTS)
def test_samples_out_of_order_change_nothing(points: list[tuple[float, float]]) -> None:
    told, shuffled = Carrying("somebody", 0.0, _ALL), Carrying("somebody", 0.0, _ALL)
    for number, point in enumerate(points, 1):
        told.add(0.1 * number, point)
        shuffled.add(0.1 * number, point)
        shuffled.add(0.1 * number - 0.05, (100.0, 100.0))
        shuffled.add(-1.0, (3.0, 1.0))
    assert told.belief(10.0) == shuffled.belief(10.0)


def test_who_stays_away_from_furniture_still_has_it() -> None:
    belief = belief_after((0.0, 0.0, 5.0))
    assert belief.alternatives == () and belief.confidence > 0.98


def test_a_table_that_was_passed_is_named_and_one_at_which_they_stopped_is_likelier() -> None:
    passed = belief_after((2.0, 0.2, 0.0), (5.0, 0.2, 0.0))
    stopped = belief_after((3.0, 0.2, 1.0), (5.0, 0.2, 0.0))
    assert 0.05 <= share(passed, "sofa-table") < share(stopped, "sofa-table")
    (first, *_) = stopped.alternatives
    assert first.words == "left on the sofa table"
    assert first.position == pytest.approx((3.0, 0.7, 0.43), abs=0.05)


def test_a_stop_of_half_a_second_is_seen_through_the_noise_of_a_floor() -> None:
    assert share(belief_after((3.0, 0.2, 0.5), (5.0, 0.2, 0.0), noise=0.03), "sofa-table") > 0.2


def test_nobody_leaves_a_thing_on_a_chair_in_passing_and_few_when_they_stop() -> None:
    passed = belief_after((2.0, -0.5, 0.0), (4.0, -0.5, 0.0))
    stopped = belief_after((3.0, -0.5, 2.0))
    assert share(passed, "chair") == 0.0
    assert 0.0 < share(stopped, "chair") < 0.15


def test_an_hour_at_the_edge_of_reach_is_one_visit() -> None:
    short = belief_after((3.0, -0.1, 5.0), noise=0.05)
    long = belief_after((3.0, -0.1, 60.0), noise=0.05)
    assert share(long, "sofa-table") == pytest.approx(share(short, "sofa-table"), abs=0.03)


def test_out_of_sight_half_have_left_it_after_a_minute() -> None:
    belief = belief_after((0.0, 0.0, 1.0), later=60.0)
    assert belief.confidence == pytest.approx(0.5, abs=0.03)
    assert [one.words for one in belief.alternatives] == ["elsewhere"]
