"""A sonar that shows something low on the whole of a long way is wrong; no child is left for it."""

from __future__ import annotations

import pytest

from housefly.pilot.behavior.shown_everywhere import LOW, STEP, STEPS, ShownEverywhere

WAY = STEPS * STEP
PERIOD = 0.02
"""So far the drone flies between two reports [m]."""


def flown(way: float, *heights: float, begun: ShownEverywhere | None = None) -> ShownEverywhere:
    """Return what a straight way [m] showed, with these heights again and again [m]."""
    everywhere = begun or ShownEverywhere()
    for number in range(round(way / PERIOD) + 1):
        everywhere.step((PERIOD * number, 0.0), heights[number % len(heights)])
    return everywhere


@pytest.mark.parametrize("heights", [(0.4,), (0.0, 0.5), (0.0, 0.9, 0.3, 0.0, 0.3)])
def test_a_sonar_that_is_low_or_noisy_on_a_long_way_is_wrong(heights: tuple[float, ...]) -> None:
    assert flown(WAY + 2 * STEP, *heights).is_wrong
    assert not flown(WAY - 2 * STEP, *heights).is_wrong


def test_who_may_follow_the_drone_is_never_taken_for_a_wrong_sonar() -> None:
    assert not flown(3 * WAY, 0.9).is_wrong
    assert not flown(3 * WAY, LOW + 0.01).is_wrong


def test_floor_that_shows_on_two_steps_makes_it_believed_again() -> None:
    everywhere = flown(WAY + 2 * STEP, 0.4)
    assert not flown(4 * STEP, 0.0, begun=everywhere).is_wrong


def test_something_below_a_drone_that_hovers_says_nothing_of_the_sonar() -> None:
    everywhere = ShownEverywhere()
    for number in range(10_000):
        everywhere.step((0.1 * (number % 2), 0.0), 0.4)
    assert not everywhere.is_wrong


def test_a_new_flight_begins_anew() -> None:
    everywhere = flown(WAY + 2 * STEP, 0.4)
    everywhere.forget()
    assert not everywhere.is_wrong
