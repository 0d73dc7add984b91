"""The height by what was commanded, and by the floor where it shows."""

from __future__ import annotations

from math import nan

import pytest

from housefly.pilot.estimation.dead_reckoning import ReckonedHeight


def flown(commanded: float, floor: float, seconds: float, lag: float = 4.0) -> float:
    """Return the height after so long of a command, from 1.2 m [m/s, m, s]."""
    reckoned = ReckonedHeight(0.0, 1.2)
    for n in range(1, round(seconds / 0.02) + 1):
        reckoned = reckoned.advanced(0.02 * n, commanded, lag, 2.0, floor)
    return reckoned.height


def test_it_climbs_and_sinks_as_it_is_told() -> None:
    assert flown(0.2, nan, 2.0) == pytest.approx(1.2 + 0.2 * (2.0 - 0.25), abs=0.01)
    assert flown(-0.1, nan, 2.0) == pytest.approx(1.2 - 0.2 * (2.0 - 0.25), abs=0.01)


@pytest.mark.parametrize("floor", [0.3, 0.9, nan])
def test_what_stands_below_draws_it_nowhere(floor: float) -> None:
    assert flown(0.0, floor, 20.0) == pytest.approx(1.2)


def test_the_floor_draws_it_to_itself() -> None:
    assert flown(0.0, 1.12, 8.0) == pytest.approx(1.12, abs=0.01)
