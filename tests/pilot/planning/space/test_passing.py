"""People on the way, by times: what is chosen, and that it does not flap."""

from __future__ import annotations

from itertools import pairwise
from math import inf

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.messages.obstacles import Obstacle, ObstacleKind
from housefly.pilot.planning.people import NOBODY, people_at
from housefly.pilot.planning.space.approach import approach_distances
from housefly.pilot.planning.space.passage import (
    KeptDistances,
    Passage,
    first_passage,
    passages,
)
from housefly.pilot.planning.space.passing import (
    AGAIN_AFTER,
    CLEAR_TIME,
    GIVE,
    Passing,
    PassingChoice,
    passed,
)
from housefly.pilot.planning.trajectory.time_scale import TimeScale
from housefly.pilot.planning.trajectory.timing import TICK

STEP = 0.1
GOING = TimeScale(0.0, 1.0, 0.0)
KEPT = KeptDistances(hull=0.343, comfort=1.0, least=0.5)


def straight_rows(speed: float = 0.5, duration: float = 8.0) -> np.ndarray:
    """Return a motion along x at a constant speed, shape (n, 9)."""
    rows = np.zeros((round(duration / TICK) + 1, 9))
    rows[:, 0] = speed * TICK * np.arange(len(rows))
    rows[:, 3] = speed
    return rows


def choices_past(x: float, y: float, vx: float, vy: float) -> list[Passage]:
    """Return all passages of the straight motion past somebody."""
    person = Obstacle("p", (x, y), 0.25, velocity=(vx, vy), kind=ObstacleKind.PERSON)
    people = people_at((person,), 0.0)
    return passages(people, GOING, straight_rows(), TICK, KEPT, 1.0)


def test_without_people_it_is_flown_as_planned() -> None:
    best = first_passage(passages(NOBODY, GOING, straight_rows(), TICK, KEPT, 1.0), 0.0)
    assert best is not None and best[:2] == (0.0, 1.0)
    assert best.margin == inf and best.arrival == pytest.approx(8.0, abs=STEP)


def test_who_crosses_is_let_through_by_a_wait_or_a_slower_flight() -> None:
    best = first_passage(choices_past(2.0, 2.5, 0.0, -1.0), 0.0)
    assert best is not None
    assert best.wait > 0.0 or best.rate < 1.0
    assert 8.0 < best.arrival < 12.0


def test_who_stands_on_the_way_is_not_waited_for_and_who_comes_along_it_is_not_passed() -> None:
    assert first_passage(choices_past(2.0, 0.0, 0.0, 0.0), 0.0) is None
    assert first_passage(choices_past(3.0, 0.0, -0.8, 0.0), 0.0) is None


def test_near_people_it_is_counted_on_to_be_as_slow_as_it_will_be() -> None:
    beside = people_at((Obstacle("p", (1.0, 1.6), 0.25, kind=ObstacleKind.PERSON),), 0.0)
    times = []
    for slow in (0.0, 3.0):
        kept = KEPT._replace(comfort=0.5, slow=slow, slowest=0.5)
        choices = passages(beside, GOING, straight_rows(), TICK, kept, 1.0)
        times.append(min(choice.arrival for choice in choices))
    assert times[0] == pytest.approx(8.0, abs=STEP) and times[1] > 8.5


def test_who_is_too_near_already_and_goes_away_is_not_waited_for() -> None:
    best = first_passage(choices_past(-0.9, 0.0, -0.8, 0.0), 0.0)
    assert best is not None and best[:2] == (0.0, 1.0)
    assert first_passage(choices_past(0.9, 0.0, -0.8, 0.0), 0.0) is None


@given(st.floats(0.0, 3.0), st.floats(0.0, 3.0))
def test_more_room_is_kept_before_somebody_than_behind_and_never_too_little(
    one: float, other: float
) -> None:
    least, comfort = sorted((one, other))
    ahead, radius = approach_distances(comfort, least)
    assert ahead + radius == pytest.approx(comfort)
    assert radius - ahead >= least - 1e-9


def passage_with(margin: float) -> list[Passage]:
    """Return what there is when going on leaves a margin, and waiting is always possible."""
    return [Passage(0.0, 1.0, 5.0, margin), Passage(4.0, 1.0, 9.0, 1.0)]


@given(st.lists(st.floats(-GIVE + 1e-6, -1e-6), min_size=5, max_size=200))
def test_margins_that_sway_within_the_give_change_nothing(margins: list[float]) -> None:
    for first in (Passing(), Passing(PassingChoice.WAIT, 0.0)):
        state = first
        for n, margin in enumerate(margins):
            state = passed(state, passage_with(margin), inf, n * STEP)
            assert (state.choice, state.rate) == (first.choice, first.rate)


@settings(max_examples=200)
@given(
    st.lists(
        st.tuples(st.floats(-0.5, 0.5), st.sampled_from([inf, 1.0, 4.0, 9.0])),
        min_size=20,
        max_size=150,
    )
)
def test_whatever_is_seen_it_never_flaps(seen: list[tuple[float, float]]) -> None:
    state, states = Passing(), []
    for n, (margin, around) in enumerate(seen):
        state = passed(state, passage_with(margin), around, n * STEP)
        states.append(state)
        if state.choice is not PassingChoice.AROUND and margin < -GIVE:
            assert state.rate == 0.0
    arounds = [n for n, one in enumerate(states) if one.choice is PassingChoice.AROUND]
    faster = [
        n + 1
        for n, (a, b) in enumerate(pairwise(states))
        if b.rate > a.rate and b.choice is PassingChoice.GO_ON
    ]
    assert all(b - a >= AGAIN_AFTER / STEP - 1 for a, b in pairwise(arounds))
    assert all(b - a >= CLEAR_TIME / STEP - 1 for a, b in pairwise(faster))


def test_a_way_around_is_taken_only_when_it_is_much_earlier() -> None:
    waiting = Passing(PassingChoice.WAIT, 0.0)
    assert passed(waiting, passage_with(-0.5), 8.0, 0.0).choice is PassingChoice.WAIT
    assert passed(waiting, passage_with(-0.5), 6.0, 0.0).choice is PassingChoice.AROUND
