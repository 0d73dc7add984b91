from __future__ import annotations

from math import inf, pi, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.geometry import Vec2
from housefly.pilot.behavior.path_profile import CORNER_VELOCITY_JUMP, path_profile

steps = st.tuples(st.floats(0.1, 2.0), st.floats(-pi, pi))


@given(st.lists(steps, min_size=1, max_size=6), st.integers(0, 5))
def test_a_path_is_its_legs_one_after_the_other_and_a_repeated_corner_counts_once(
    legs: list[tuple[float, float]], repeated: int
) -> None:
    corners: list[Vec2] = [(1.0, 2.0)]
    for length, heading in legs:
        x, y = corners[-1]
        corners.append((x + length * np.cos(heading), y + length * np.sin(heading)))
    again = min(repeated, len(corners) - 1)
    profile = path_profile((*corners[: again + 1], *corners[again:]))
    assert profile.points == pytest.approx(np.array(corners))
    assert len(profile.waypoints) == len(corners) + 1
    lengths, headings = np.array(legs).T
    assert profile.marks == pytest.approx(np.concatenate(([0.0], np.cumsum(lengths))))
    turned = np.exp(1j * headings)
    assert np.exp(1j * profile.headings) == pytest.approx(turned, abs=1e-9)
    assert profile.along @ (1.0, 1j) == pytest.approx(turned, abs=1e-9)


def test_the_drone_stands_at_both_ends_and_passes_a_corner_the_slower_the_sharper_it_is() -> None:
    def passed(end: Vec2) -> float:
        first, middle, last = path_profile(((0.0, 0.0), (1.0, 0.0), end)).speeds
        assert first == last == 0.0
        return float(middle)

    assert passed((2.0, 0.0)) == inf
    assert passed((1.0, 1.0)) == pytest.approx(CORNER_VELOCITY_JUMP / sqrt(2.0))
    assert passed((0.0, 1e-9)) == pytest.approx(CORNER_VELOCITY_JUMP / 2.0)
    assert passed((2.0, 1.0)) > passed((1.0, 1.0)) > passed((0.0, 1.0))


def test_a_path_of_one_point_has_no_legs() -> None:
    profile = path_profile(((1.0, 2.0),))
    assert profile.marks.tolist() == profile.speeds.tolist() == [0.0]
    assert profile.along.shape == (0, 2) and profile.headings.size == 0
