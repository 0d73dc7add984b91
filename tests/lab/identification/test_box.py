"""The box of an identification flight: free air close to the pad, or a reason why there is none."""

from __future__ import annotations

import numpy as np
import pytest

from housefly.config.site import Site
from housefly.errors import RoomError
from housefly.lab.identification.box import find_box, free_reach
from housefly.room.files import load_room
from housefly.room.grid import OccupancyGrid, build_grid


@pytest.fixture(scope="module")
def grid() -> OccupancyGrid:
    return build_grid(load_room("bsen"), Site())


def test_the_box_is_free_air_and_near_the_pad(grid: OccupancyGrid) -> None:
    room = load_room("bsen")
    box = find_box(grid, room.home, 0.62, 1.1)
    assert free_reach(grid, box.centre) >= 0.6
    assert np.hypot(box.centre[0] - room.home[0], box.centre[1] - room.home[1]) < 4.0


def test_a_room_without_so_much_room_says_where_the_most_is(grid: OccupancyGrid) -> None:
    with pytest.raises(
        RoomError, match=r"no free square of 6\.0 m anywhere: the most room is .* around \("
    ):
        find_box(grid, (10.0, 2.0), 3.0, 1.1)
