"""A search: beliefs stay beliefs, and no order of the same looks finds a thing sooner."""

from __future__ import annotations

from itertools import permutations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.numeric import FloatArray
from housefly.room.level_camera import LevelCamera
from housefly.tasks.vantage.search_belief import SearchBelief
from housefly.tasks.vantage.search_order import (
    LOOKS_MAX,
    chosen_looks,
    expected_time,
    soonest_order,
)
from housefly.tasks.vantage.thing_search import detection_probability

LOOK_TIME = 4.0


def belief(random: np.random.Generator, points: int) -> SearchBelief:
    shares = random.dirichlet(np.ones(points + 1))[:points]
    return SearchBelief(
        random.uniform(0.0, 8.0, (points, 3)), shares, np.arange(points) % 3, ("a", "b", "c")
    )


def some_looks(
    random: np.random.Generator, looks: int, points: int
) -> tuple[FloatArray, FloatArray]:
    """Return what looks at random places detect, and the times between them."""
    places = random.uniform(0.0, 8.0, (looks + 1, 2))
    detection = random.uniform(0.0, 1.0, (looks, points)) * (random.random((looks, points)) < 0.4)
    ways = np.linalg.norm(places[:, None] - places[None, 1:], axis=2)
    return detection, ways / 0.5 + LOOK_TIME


def nearest_first(times: FloatArray) -> list[int]:
    order, at = list[int](), -1
    while len(order) < times.shape[1]:
        left = [look for look in range(times.shape[1]) if look not in order]
        at = min(left, key=lambda look: times[at + 1, look])
        order.append(at)
    return order


seeds = st.integers(0, 2**32 - 1).map(np.random.default_rng)


@settings(max_examples=60)
@given(seeds, st.integers(1, 6), st.integers(1, 12))
def test_no_order_is_sooner_and_nearest_first_never_is(
    random: np.random.Generator, looks: int, points: int
) -> None:
    what = belief(random, points)
    detection, times = some_looks(random, looks, points)
    order = soonest_order(what.probability, detection, times)
    assert sorted(order) == list(range(looks))
    found = expected_time(order, what.probability, detection, times)
    nearest = expected_time(nearest_first(times), what.probability, detection, times)
    assert found <= nearest + 1e-9
    if looks <= 5:
        others = permutations(range(looks))
        least = min(expected_time(one, what.probability, detection, times) for one in others)
        assert found == pytest.approx(least)


@settings(max_examples=60)
@given(seeds, st.integers(1, 12), st.integers(0, 10))
def test_a_belief_stays_one_whatever_was_looked_at(
    random: np.random.Generator, points: int, looks: int
) -> None:
    now = belief(random, points)
    for _ in range(looks):
        detection = random.random(points) * random.integers(0, 2)
        elsewhere = 1.0 - now.probability.sum()
        after = now.after_nothing(detection)
        assert np.all(after.probability >= 0.0) and after.probability.sum() <= 1.0 + 1e-9
        assert after.of_places().sum() == pytest.approx(after.probability.sum())
        assert 1.0 - after.probability.sum() >= elsewhere - 1e-9
        now = after


def test_what_was_looked_at_in_vain_becomes_unlikely_and_the_rest_likelier() -> None:
    now = SearchBelief(np.zeros((2, 3)), np.array([0.5, 0.25]), np.array([0, 1]), ("a", "b"))
    after = now.after_nothing(np.array([0.8, 0.0]))
    assert after.probability == pytest.approx([0.1 / 0.6, 0.25 / 0.6])


@settings(max_examples=40)
@given(seeds, st.integers(1, 10))
def test_a_look_that_covers_all_ends_the_search(random: np.random.Generator, points: int) -> None:
    now = belief(random, points)
    after = now.after_nothing(np.ones(points))
    assert after.probability.sum() == pytest.approx(0.0)
    detection, times = some_looks(random, 4, points)
    assert chosen_looks(after.probability, detection, lambda at: times[at + 1], 0.01) == ()


@settings(max_examples=40)
@given(seeds, st.integers(1, 8), st.integers(1, 12), st.floats(0.0, 60.0))
def test_each_chosen_look_is_worth_it_and_all_fit_the_time(
    random: np.random.Generator, looks: int, points: int, budget: float
) -> None:
    what = belief(random, points)
    detection, times = some_looks(random, looks, points)
    chosen = chosen_looks(what.probability, detection, lambda at: times[at + 1], 0.05, budget)
    left, spent, at = what.probability, 0.0, -1
    for look in chosen:
        gains, costs = detection @ left, times[at + 1]
        can = (gains >= 0.05) & (spent + costs <= budget)
        assert can[look]
        assert gains[look] / costs[look] == pytest.approx((gains / costs)[can].max())
        left, spent, at = left * (1.0 - detection[look]), spent + costs[look], look
    if len(chosen) < LOOKS_MAX:
        gains, costs = detection @ left, times[at + 1]
        assert not np.any((gains >= 0.05) & (spent + costs <= budget))


def test_more_looks_than_can_be_ordered_are_refused() -> None:
    detection = np.zeros((LOOKS_MAX + 1, 1))
    with pytest.raises(ValueError, match=f"allowed: {LOOKS_MAX}"):
        soonest_order(np.ones(1), detection, np.ones((LOOKS_MAX + 2, LOOKS_MAX + 1)))


def test_what_is_no_belief_is_refused() -> None:
    with pytest.raises(ValueError, match="sum is at most 1"):
        SearchBelief(np.zeros((2, 3)), np.array([0.7, 0.7]), np.zeros(2, dtype=int), ("a",))


def test_a_thing_is_noticed_near_and_hardly_from_afar() -> None:
    near, half, far = detection_probability(LevelCamera.of(None), np.array([1.0, 5.9, 12.0]))
    assert near == pytest.approx(0.9, abs=0.01)
    assert half == pytest.approx(0.45, abs=0.03), "four line pairs: half of all observers"
    assert far < 0.1
    falling = detection_probability(LevelCamera.of(None), np.linspace(0.2, 15.0, 100))
    assert np.all(np.diff(falling) <= 1e-12)
    assert np.all(
        detection_probability(LevelCamera.of(None), np.linspace(0.5, 9.0, 20), 0.3) >= 0.5 * 0.9
    )
