"""The volumes of a site file: what is taken, and in which words the rest is refused."""

from __future__ import annotations

from math import cos, pi, sin
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.site import Site, changed, site_from_tree
from housefly.errors import ConfigError

SQUARE = [[1.0, 1.0], [3.0, 1.0], [3.0, 3.0], [1.0, 3.0]]


def volume(**values: Any) -> dict[str, Any]:
    """Return a site with one volume to keep out of, some of its values changed."""
    return {"volumes": [{"kind": "keep_out", "polygon": SQUARE, **values}]}


@pytest.mark.parametrize(
    ("tree", "words"),
    [
        (volume(bottom=1.0, top=1.0), r"bottom \(1.0 m\) must be below top"),
        (volume(kind="slow"), "needs a speed; allowed: a number from 0.05 to 2 m/s"),
        (volume(speed=0.3), "speed is for kind slow, and this is keep_out"),
        (volume(kind="slow", speed=9.0), r"volumes\.0\.speed: is 9.0; allowed: .* 0.05 to 2 m/s"),
        (volume(kind="fast"), "is 'fast'"),
        (volume(polygon=SQUARE[:2]), "at least 3"),
        (volume(polygon=[[0, 0], [1, 1], [2, 2]]), "area of 0 m"),
        (volume(polygon=[[0, 0], [2, 2], [2, 0], [0, 2]]), "area of 0 m"),
        (volume(polygon=[[0, 0], [4, 2], [4, 0], [0, 3]]), "crosses itself between corners 1 and"),
        (volume(polygon=[[0, 0], [float("nan"), 1], [2, 2]]), "finite number"),
        (
            volume(kind="slow", speed=0.3, reason="desk") | {"map": {"planner": "grid"}},
            "'desk' is of kind slow, and corners are flown",
        ),
        (volume(kind="slow", speed=0.3) | {"mode": "paper"}, "slow, and corners are flown"),
    ],
)
def test_a_volume_that_makes_no_sense_is_refused_in_words(tree: dict[str, Any], words: str) -> None:
    with pytest.raises(ConfigError, match=words):
        site_from_tree(tree)


def test_a_slow_volume_is_for_the_planner_in_space() -> None:
    assert site_from_tree(volume(kind="slow", speed=0.3)).volumes[0].speed == 0.3


@given(
    st.lists(st.floats(0.3, 4.0), min_size=3, max_size=12),
    st.floats(0.0, 2.0 * pi),
    st.booleans(),
)
def test_a_polygon_around_a_point_is_taken_either_way_round(
    radii: list[float], turn: float, is_clockwise: bool
) -> None:
    angles = [turn + 2.0 * pi * n / len(radii) for n in range(len(radii))]
    corners = [[r * cos(a), r * sin(a)] for r, a in zip(radii, angles, strict=True)]
    tree = volume(polygon=corners[::-1] if is_clockwise else corners)
    assert len(site_from_tree(tree).volumes[0].polygon) == len(radii)


def test_mode_paper_flies_its_own_grid() -> None:
    assert Site().flies_in_space
    assert not changed(Site(), mode="paper").flies_in_space
    assert not changed(Site(), map__planner="grid").flies_in_space
