"""ROS maps as drafts: they fly as those that ``housefly room import`` makes."""

from __future__ import annotations

from pathlib import Path

import pytest

from housefly.room.draft.imports.imported import imported
from housefly.room.draft.missing import missing
from housefly.room.draft.model import SiteDraft
from housefly.room.draft.shapes import room_of_draft
from housefly.room.draft.site_of_draft import site_of_draft
from housefly.room.grid import Cell, build_grid
from housefly.room.ros_map import import_ros_map


@pytest.mark.parametrize("name", ["small_house", "turtlebot3"])
def test_a_shipped_map_lacks_nothing_and_is_the_room_of_room_import(
    shared_data: Path, tmp_path: Path, name: str
) -> None:
    path = shared_data / "rooms" / name / "map.yaml"
    found = imported(SiteDraft(name), path)
    assert missing(found.draft) == ()
    assert "which the ROS map calls" in found.notes[1]
    room = import_ros_map(path, tmp_path)
    draft = room_of_draft(found.draft)
    assert draft.bounds == room.bounds
    grid = build_grid(draft, site_of_draft(found.draft))
    other = build_grid(room, site_of_draft(found.draft))
    assert ((grid.cells == Cell.FREE) == (other.cells == Cell.FREE)).mean() > 0.99
