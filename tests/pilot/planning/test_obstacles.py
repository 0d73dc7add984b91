"""What is remembered of obstacles: the newest word of each, for as long as it is believable."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

from hypothesis import given
from hypothesis import strategies as st

from housefly.messages import Obstacle
from housefly.pilot.planning.obstacles import (
    CERTAINTY_HALF_LIFE,
    CERTAINTY_MIN,
    FREED_AFTER,
    OBSTACLES_MAX,
    ObstacleMemory,
    certainty_now,
    obstacle_fault,
)

EXTENT = (0.0, 0.0, 10.0, 5.0)
seen = st.builds(
    Obstacle,
    id=st.sampled_from("abcd"),
    position=st.tuples(st.floats(0.0, 10.0), st.floats(0.0, 5.0)),
    confidence=st.floats(0.0, 1.0),
    seen_at=st.floats(0.0, 10.0),
    source=st.sampled_from("xy"),
)


@given(st.lists(seen, max_size=20), st.floats(0.0, 20.0))
def test_what_is_remembered_is_the_newest_word_of_each_and_believable(
    heard: list[Obstacle], now: float
) -> None:
    memory = ObstacleMemory().updated(heard, now)
    names = [(o.source, o.id) for o in memory.obstacles]
    assert names == sorted(set(names))
    for obstacle in memory.obstacles:
        same = [o for o in heard if (o.source, o.id) == (obstacle.source, obstacle.id)]
        assert obstacle.seen_at == max(o.seen_at for o in same)
        assert certainty_now(obstacle, now) >= CERTAINTY_MIN
    assert memory.updated((), now) is memory


@given(seen, st.lists(st.floats(0.0, 10.0), min_size=2, max_size=10))
def test_belief_never_grows_while_nobody_looks(obstacle: Obstacle, times: list[float]) -> None:
    beliefs = [certainty_now(obstacle, at) for at in sorted(times)]
    assert all(later <= earlier for earlier, later in pairwise(beliefs))


def test_one_of_full_confidence_is_forgotten_after_the_time_that_is_documented() -> None:
    memory = ObstacleMemory().updated((Obstacle("chair", (1.0, 1.0), seen_at=5.0),), 5.0)
    assert memory.updated((), 5.0 + FREED_AFTER).obstacles
    assert not memory.updated((), 5.0 + FREED_AFTER + 0.01).obstacles
    assert 0.5 ** (FREED_AFTER / CERTAINTY_HALF_LIFE) == CERTAINTY_MIN


def test_old_words_do_not_replace_new_ones_and_gone_means_gone() -> None:
    chair = Obstacle("chair", (1.0, 1.0), seen_at=5.0)
    memory = ObstacleMemory().updated((chair,), 5.0)
    assert memory.updated((replace(chair, position=(9.0, 9.0), seen_at=4.0),), 5.0) == memory
    assert not memory.updated((replace(chair, confidence=0.0, seen_at=5.1),), 5.1).obstacles


def test_no_more_are_kept_than_allowed_and_the_most_believable_stay() -> None:
    crowd = tuple(
        Obstacle(f"{n:04}", (1.0, 1.0), confidence=0.3 + n / 1000, seen_at=1.0)
        for n in range(OBSTACLES_MAX + 30)
    )
    kept = ObstacleMemory().updated(crowd, 1.0).obstacles
    assert {o.id for o in kept} == {o.id for o in crowd[30:]}


def test_a_sound_obstacle_has_no_fault() -> None:
    assert (
        obstacle_fault(Obstacle("chair", (1.0, 1.0), 0.3, (0.5, 0.5), seen_at=1.0), 1.0, EXTENT)
        == ""
    )
