"""A ROS map as a draft: what is occupied are walls, what nobody saw is unexplored."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from housefly.room.draft.imports.cells import boxes_of_cells, refuse_too_many
from housefly.room.draft.imports.contracts import Imported, ImportHints
from housefly.room.draft.model import SiteDraft
from housefly.room.ros_image import read_ros_map
from housefly.room.ros_map import cropped


def ros_cells(draft: SiteDraft, path: Path, hints: ImportHints) -> Imported:
    """Return the draft with the room of a ROS map; raises RoomError."""
    ros_map, origin = cropped(read_ros_map(path), path)
    edge, (nx, ny) = ros_map.resolution, ros_map.free.shape
    unknown = ~ros_map.occupied & ~ros_map.free
    boxes = (
        *boxes_of_cells(ros_map.occupied, edge, draft.height, "wall"),
        *boxes_of_cells(unknown, edge, draft.height, "unexplored"),
    )
    refuse_too_many(boxes, path.name)
    length, width = round(nx * edge, 4), round(ny * edge, 4)
    notes = (
        *ros_map.notes,
        f"{path.name}: {length:.2f} m x {width:.2f} m, {len(boxes)} boxes; a ROS map is flat, so"
        " its walls reach from the floor to the ceiling",
        f"the room begins at (0, 0), which the ROS map calls ({origin[0]:.2f}, {origin[1]:.2f}) m",
    )
    found = replace(draft, bounds=(0.0, 0.0, length, width), scanned=boxes)
    return Imported(found, notes)
