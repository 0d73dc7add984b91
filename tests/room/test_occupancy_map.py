"""Values of an OccupancyGrid become cells as those of a map file do; bad ones are refused."""

from __future__ import annotations

from dataclasses import replace
from math import cos, inf, nan, pi, sin
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from housefly.errors import RoomError
from housefly.room.occupancy_map import FREE_TO, OCCUPIED_FROM, OccupancyMessage, ros_map_of
from housefly.room.ros_image import MAP_SIDE_MAX, read_ros_map

UPRIGHT = (1.0, 0.0, 0.0, 0.0)


def told(rows: list[list[int]], **changes: object) -> OccupancyMessage:
    values = np.array(rows, np.int8)
    message = OccupancyMessage(
        (values.shape[1], values.shape[0]), 0.1, (-1.0, 2.0), UPRIGHT, values.reshape(-1)
    )
    return replace(message, **changes)  # type: ignore[arg-type]


def test_cells_lie_along_x_first_from_the_lower_left_corner() -> None:
    found = ros_map_of(told([[100, 0, -1], [0, 0, 0]]), "m")
    assert found.occupied.shape == (3, 2)
    assert found.occupied[0, 0] and np.count_nonzero(found.occupied) == 1
    assert not found.free[2, 0] and np.count_nonzero(found.free) == 4
    assert (found.origin, found.resolution) == ((-1.0, 2.0), 0.1)


def test_a_probability_between_the_thresholds_is_unknown() -> None:
    rows = [[FREE_TO, FREE_TO + 1, OCCUPIED_FROM - 1, OCCUPIED_FROM]]
    found = ros_map_of(told(rows), "m")
    assert found.free[:, 0].tolist() == [True, False, False, False]
    assert found.occupied[:, 0].tolist() == [False, False, False, True]


def test_it_is_the_map_that_map_saver_would_have_written(tmp_path: Path) -> None:
    rows = np.random.default_rng(1).choice([-1, 0, 100], size=(40, 60)).astype(np.int8)
    greys = np.select([rows == 100, rows == 0], [0, 254], 205).astype(np.uint8)
    Image.fromarray(greys[::-1]).save(tmp_path / "map.pgm")
    (tmp_path / "map.yaml").write_text(
        "image: map.pgm\nresolution: 0.1\norigin: [-1.0, 2.0, 0.0]\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.25\n"
    )
    of_file = read_ros_map(tmp_path / "map.yaml")
    of_topic = ros_map_of(told(rows.tolist()), "m")
    assert np.array_equal(of_file.occupied, of_topic.occupied)
    assert np.array_equal(of_file.free, of_topic.free)
    assert (of_file.origin, of_file.resolution) == (of_topic.origin, of_topic.resolution)


@pytest.mark.parametrize("turn", [UPRIGHT, (-1.0, 0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0)])
def test_a_map_that_is_not_turned_is_read(turn: tuple[float, ...]) -> None:
    assert ros_map_of(told([[0]], orientation=turn), "m").free.all()


BAD = {
    "no cells": {"size": (0, 1)},
    "too many": {"size": (MAP_SIDE_MAX + 1, 1)},
    "a value too few": {"size": (2, 1)},
    "a resolution of 0": {"resolution": 0.0},
    "millimetres": {"resolution": 50.0},
    "no resolution": {"resolution": nan},
    "no place": {"origin": (nan, 0.0)},
    "an endless place": {"origin": (0.0, inf)},
    "turned": {"orientation": (cos(pi / 8), 0.0, 0.0, sin(pi / 8))},
    "upside down": {"orientation": (0.0, 1.0, 0.0, 0.0)},
    "no turn": {"orientation": (nan, 0.0, 0.0, nan)},
    "more than 100 %": {"values": np.array([101], np.int8)},
    "less than unknown": {"values": np.array([-2], np.int8)},
}


@pytest.mark.parametrize("changes", BAD.values(), ids=BAD.keys())
def test_what_is_no_map_is_refused_in_words(changes: dict[str, object]) -> None:
    with pytest.raises(RoomError, match="ros2:/map"):
        ros_map_of(told([[0]], **changes), "ros2:/map")
