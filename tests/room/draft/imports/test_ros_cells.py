"""ROS maps as drafts: they fly as those that ``housefly room import`` makes."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from housefly.errors import RoomError
from housefly.room.draft.imports.contracts import ImportHints
from housefly.room.draft.imports.imported import imported
from housefly.room.draft.missing import missing
from housefly.room.draft.model import SiteDraft
from housefly.room.draft.shapes import room_of_draft
from housefly.room.draft.site_of_draft import site_of_draft
from housefly.room.grid import Cell, build_grid
from housefly.room.ros_map import import_ros_map

YAML = (
    "image: map.png\nresolution: 0.01\norigin: [0, 0, 0]\nnegate: 0\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n"
)


@pytest.mark.parametrize("name", ["small_house", "turtlebot3"])
def test_a_shipped_map_lacks_nothing_and_is_the_room_of_room_import(
    shared_data: Path, tmp_path: Path, name: str
) -> None:
    path = shared_data / "rooms" / name / "map.yaml"
    found = imported(SiteDraft(name), path)
    assert missing(found.draft) == ()
    assert "were never seen" in found.notes[0]
    assert "which the ROS map calls" in found.notes[2]
    room = import_ros_map(path, tmp_path)
    draft = room_of_draft(found.draft)
    assert draft.bounds == room.bounds
    grid = build_grid(draft, site_of_draft(found.draft))
    other = build_grid(room, site_of_draft(found.draft))
    assert ((grid.cells == Cell.FREE) == (other.cells == Cell.FREE)).mean() > 0.99


def test_unexplored_floor_is_free_when_that_is_said_and_the_pad_is_where_it_was_seen(
    tmp_path: Path,
) -> None:
    pixels = np.full((400, 1000), 205, np.uint8)
    pixels[50:350, 20:320] = 254
    Image.fromarray(pixels).save(tmp_path / "map.png")
    (tmp_path / "map.yaml").write_text(YAML.replace("0.196", "0.25"))
    walled = imported(SiteDraft("a"), tmp_path / "map.yaml").draft
    open_ = imported(SiteDraft("a"), tmp_path / "map.yaml", ImportHints(unexplored="free")).draft
    assert {box.thing for box in walled.scanned} == {"unexplored"}
    assert open_.scanned == ()
    assert open_.bounds == walled.bounds
    assert open_.pad == walled.pad


def test_a_picture_of_noise_is_refused_before_its_boxes_are_counted(tmp_path: Path) -> None:
    pixels = np.random.default_rng(1).choice(np.array([0, 255], np.uint8), (2048, 2048))
    Image.fromarray(pixels).save(tmp_path / "map.png")
    (tmp_path / "map.yaml").write_text(YAML)
    with pytest.raises(RoomError, match="at most 20000"):
        imported(SiteDraft("noise"), tmp_path / "map.yaml")


def test_a_picture_that_is_a_pipe_is_refused_and_not_waited_for(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "map.png")
    (tmp_path / "map.yaml").write_text(YAML)
    with pytest.raises(RoomError, match=r"no ordinary file"):
        imported(SiteDraft("pipe"), tmp_path / "map.yaml")
