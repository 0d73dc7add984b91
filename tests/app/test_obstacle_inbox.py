"""What the pilot's shell lets in of what others say of obstacles."""

from __future__ import annotations

from math import nan
from threading import Thread

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.app.obstacle_inbox import REFUSED_OBSTACLE_SHOWN_FOR, ObstacleInbox
from housefly.clock import SteppedClock
from housefly.messages import Obstacle
from housefly.pilot.planning.obstacles import OBSTACLES_MAX, obstacle_fault

EXTENT = (0.0, 0.0, 10.0, 5.0)


def inbox_and_clock() -> tuple[ObstacleInbox, SteppedClock]:
    clock = SteppedClock(10.0)
    return ObstacleInbox(EXTENT, clock), clock


anything = st.builds(
    Obstacle,
    id=st.text(max_size=3),
    position=st.tuples(st.floats(), st.floats())
    | st.tuples(st.floats(0.0, 10.0), st.floats(0.0, 5.0)),
    radius=st.floats() | st.floats(0.0, 1.0),
    seen_at=st.floats() | st.floats(8.0, 10.0),
    confidence=st.floats() | st.floats(0.0, 1.0),
    source=st.text(max_size=2),
)


@given(st.lists(anything, max_size=30))
def test_what_comes_out_is_sound_and_the_newest_word_of_each(told: list[Obstacle]) -> None:
    inbox, _ = inbox_and_clock()
    for obstacle in told:
        inbox.add(obstacle)
    taken = inbox.drain()
    assert not any(obstacle_fault(obstacle, 10.0, EXTENT) for obstacle in taken)
    assert len({(o.source, o.id) for o in taken}) == len(taken)
    assert inbox.drain() == ()


@pytest.mark.parametrize(
    ("obstacle", "words"),
    [
        (Obstacle("a", (nan, 1.0), seen_at=10.0), "finite"),
        (Obstacle("a", (400.0, 1.0), seen_at=10.0), "outside the map"),
        (Obstacle("a", (1.0, 1.0), seen_at=11.0), "future"),
    ],
)
def test_a_refusal_is_told_for_a_while(obstacle: Obstacle, words: str) -> None:
    inbox, clock = inbox_and_clock()
    inbox.add(obstacle)
    assert words in inbox.problem and inbox.refused == 1 and inbox.drain() == ()
    clock.advance(REFUSED_OBSTACLE_SHOWN_FOR + 0.1)
    assert not inbox.problem


def test_a_flood_is_cut_down() -> None:
    inbox, _ = inbox_and_clock()
    for number in range(1000):
        inbox.add(Obstacle(str(number), (1.0, 1.0), seen_at=10.0))
    assert len(inbox.drain()) == OBSTACLES_MAX and inbox.refused == 1000 - OBSTACLES_MAX


def test_what_another_thread_adds_while_steps_take_is_taken_once() -> None:
    inbox, _ = inbox_and_clock()
    told = [Obstacle(f"{n}", (1.0, 1.0), seen_at=9.0) for n in range(2000)]
    taken: list[Obstacle] = []
    adding = Thread(target=lambda: [inbox.add(one) for one in told])
    adding.start()
    while adding.is_alive():
        taken += inbox.drain()
    taken += inbox.drain()
    assert len(taken) + inbox.refused == len(told)
    assert len({one.id for one in taken}) == len(taken)
