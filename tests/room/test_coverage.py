"""Lines of sight of tracking cameras."""

from __future__ import annotations

from math import pi, sqrt

import numpy as np
import pytest

from housefly.geometry import rotate
from housefly.room.coverage import seen_by
from housefly.room.model import Place, Room, Shape, Solid, TrackingCamera

# Camera to world: looks along +x, picture x to the world's -y, picture y down.
ALONG_X = (0.5, -0.5, 0.5, -0.5)


def room_with(*solids: Solid, reach: float = 10.0) -> Room:
    camera = TrackingCamera("eye", (0.0, 0.0, 1.0), ALONG_X, (pi / 2, pi / 3), reach)
    return Room(
        "r",
        (-1.0, -9.0, 9.0, 9.0),
        3.0,
        solids,
        (Place("home", (1, 0), (2, 0, 1)),),
        (camera,),
        (1.0, 0.0),
    )


def test_the_camera_looks_along_its_own_z() -> None:
    assert rotate(ALONG_X, (0.0, 0.0, 1.0)) == pytest.approx((1.0, 0.0, 0.0))
    assert rotate(ALONG_X, (0.0, 1.0, 0.0)) == pytest.approx((0.0, 0.0, -1.0))


@pytest.mark.parametrize(
    ("point", "seen"),
    [
        ((3.0, 0.0, 1.0), True),
        ((3.0, 2.9, 1.0), True),
        ((3.0, 3.1, 1.0), False),
        ((3.0, 0.0, 1.0 + 3 / sqrt(3) - 0.1), True),
        ((3.0, 0.0, 1.0 + 3 / sqrt(3) + 0.1), False),
        ((-3.0, 0.0, 1.0), False),
        ((9.9, 0.0, 1.0), True),
        ((10.1, 0.0, 1.0), False),
    ],
)
def test_field_of_view_and_reach_bound_what_is_seen(
    point: tuple[float, float, float], seen: bool
) -> None:
    assert seen_by(room_with(), np.array([point])).tolist() == [[seen]]


def test_a_wall_hides_what_is_behind_it_and_nothing_else() -> None:
    wall = Solid("wall", "wall", Shape.BOX, (2.0, 0.0, 1.0), (0.1, 1.0, 0.6), 0.3)
    points = np.array([(4.0, 0.0, 1.0), (1.5, 0.0, 1.0), (4.0, 2.0, 1.0), (4.0, 0.0, 1.9)])
    assert seen_by(room_with(wall), points)[:, 0].tolist() == [False, True, True, True]
