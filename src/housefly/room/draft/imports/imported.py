"""Reads any file of a room that is known, by the end of its name."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from housefly.config.text import is_file, shortened
from housefly.errors import ConfigError, RoomError
from housefly.messages.words import Words, figure, percentage
from housefly.room.draft.codec import draft_from_json, draft_to_json
from housefly.room.draft.imports.cells import boxes_of_cells, refuse_too_many
from housefly.room.draft.imports.contracts import Imported, ImportHints
from housefly.room.draft.imports.dxf_plan import dxf_plan
from housefly.room.draft.imports.point_cloud import SCAN_SUFFIXES
from housefly.room.draft.imports.scan import scan
from housefly.room.draft.imports.svg_plan import svg_plan
from housefly.room.draft.model import SiteDraft
from housefly.room.draft.site_of_draft import suggested_places
from housefly.room.draft.suggestions import suggested_pad
from housefly.room.ros_image import RosMap, read_ros_map
from housefly.room.ros_map import cropped

FILE_SIZE_MAX = 500_000_000
"""Largest file that is read [bytes]."""

_MOSTLY = 0.5
_UNITS = (1e-6, 1000.0)
"""Metres per unit that may be said."""

_Importer = Callable[[SiteDraft, Path, ImportHints], Imported]


def _ros_cells(draft: SiteDraft, path: Path, hints: ImportHints) -> Imported:
    return _map_cells(draft, read_ros_map(path), str(path), path.name)


def _map_cells(draft: SiteDraft, whole: RosMap, source: str, name: str) -> Imported:
    """Return the draft with the room of a ROS map; raises RoomError."""
    ros_map, origin = cropped(whole, source)
    edge, (nx, ny) = ros_map.resolution, ros_map.free.shape
    unknown = ~ros_map.occupied & ~ros_map.free
    boxes = (
        *boxes_of_cells(ros_map.occupied, edge, draft.height, "wall"),
        *boxes_of_cells(unknown, edge, draft.height, "unexplored"),
    )
    refuse_too_many(boxes, name)
    length, width = round(nx * edge, 4), round(ny * edge, 4)
    notes = (
        *ros_map.notes,
        Words(
            "{name}: {a} m x {b} m, {n} boxes; a ROS map is flat, so its walls reach from the"
            " floor to the ceiling",
            name=name,
            a=figure(length, ".2f"),
            b=figure(width, ".2f"),
            n=figure(len(boxes)),
        ),
        Words(
            "the room begins at (0, 0), which the ROS map calls ({x}, {y}) m",
            x=figure(origin[0], ".2f"),
            y=figure(origin[1], ".2f"),
        ),
    )
    found = replace(draft, bounds=(0.0, 0.0, length, width), scanned=boxes)
    return Imported(found, notes)


_IMPORTERS: dict[str, _Importer] = {
    ".yaml": _ros_cells,
    ".yml": _ros_cells,
    **dict.fromkeys(SCAN_SUFFIXES, scan),
    ".svg": svg_plan,
    ".dxf": dxf_plan,
}
IMPORT_SUFFIXES = tuple(_IMPORTERS)
"""Ends of file names that are read."""
_WAYS_OUT = {
    (".pgm", ".png"): Words("give the map's yaml file, which names the picture"),
    (".pdf", ".ai", ".vsdx"): Words("export the plan as .svg or .dxf"),
    (".dwg", ".skp", ".rvt", ".ifc"): Words("export the walls as .dxf"),
    (".usdz", ".fbx", ".dae", ".3ds", ".blend", ".off"): Words("export the scan as .glb or .ply"),
    (".xyz", ".txt", ".csv", ".pts", ".asc", ".rcp", ".fls"): Words(
        "export the scan as .ply or .e57"
    ),
}
"""What to do with files that are often at hand, and not read."""


def imported(draft: SiteDraft, path: Path, hints: ImportHints | None = None) -> Imported:
    """Return a draft with the room of a file, with a pad and places that suit it.

    Walls, furniture, places and zones that were there before are gone; name, tracking and drone
    stay.

    Raises:
        ConfigError: the unit is out of range, or the room has a value that no draft may have.
        RoomError: the file cannot be read, or holds no room; says what to do.
        MissingPartError: its reader is not installed.
    """
    hints = hints or ImportHints()
    if hints.unit is not None and not _UNITS[0] <= hints.unit <= _UNITS[1]:
        raise ConfigError(
            "unit",
            Words(
                "is {a}; allowed: {b} to {c} metres per unit of the file",
                a=figure(hints.unit, "g"),
                b=figure(_UNITS[0], "g"),
                c=figure(_UNITS[1], "g"),
            ),
        )
    read = _IMPORTERS.get(path.suffix.lower())
    if read is None:
        raise RoomError(_unread(path))
    if not is_file(path):
        raise RoomError(Words("{name} is no file; check its name", name=shortened(str(path))))
    if path.stat().st_size > FILE_SIZE_MAX:
        raise RoomError(
            Words(
                "{name} has more than {n} MB; thin the scan out, 2 cm between points are enough",
                name=path.name,
                n=figure(FILE_SIZE_MAX // 1_000_000),
            )
        )
    return _with_pad(read(_emptied(draft, path.name), path, hints), hints)


def imported_ros_map(
    draft: SiteDraft, ros_map: RosMap, name: str, hints: ImportHints | None = None
) -> Imported:
    """Return a draft with the room of a ROS map, as ``imported``; ``name`` says where it is from.

    Raises:
        ConfigError, RoomError: as there.
    """
    found = _map_cells(_emptied(draft, name), ros_map, name, name)
    return _with_pad(found, hints or ImportHints())


def _emptied(draft: SiteDraft, source: str) -> SiteDraft:
    """Return a draft without its room."""
    return replace(
        draft,
        walls=(),
        furniture=(),
        scanned=(),
        pad=None,
        places=(),
        zones=(),
        frame_points=(),
        source=source,
    )


def _with_pad(found: Imported, hints: ImportHints) -> Imported:
    """Return what was found with a pad and places."""
    # What a file says is as much from outside as what a page sends.
    draft = draft_from_json(draft_to_json(found.draft), found.draft.source)
    pad = suggested_pad(draft)
    if pad is None:
        return Imported(draft, (*found.notes, _why_nowhere(draft)))
    draft = replace(draft, pad=pad)
    if hints.unexplored == "free":
        seen = tuple(box for box in draft.scanned if box.thing != "unexplored")
        draft = replace(draft, scanned=seen)
        note = Words("unexplored floor counts as free, as you said")
        found = replace(found, notes=(*found.notes, note))
    return Imported(replace(draft, places=suggested_places(draft)), found.notes)


def _unread(path: Path) -> Words:
    """Return that no reader knows such a file, and what to do with it."""
    end, name, allowed = path.suffix.lower(), shortened(path.name), ", ".join(IMPORT_SUFFIXES)
    way_out = next((words for ends, words in _WAYS_OUT.items() if end in ends), None)
    if way_out is None:
        return Words(
            "{name}: no room is read from such a file; allowed: {thing}", name=name, thing=allowed
        )
    return Words(
        "{name}: no room is read from such a file; {words}; allowed: {thing}",
        name=name,
        words=way_out,
        thing=allowed,
    )


def _why_nowhere(draft: SiteDraft) -> Words:
    """Return why the drone fits nowhere, by what covers the floor."""
    assert draft.bounds is not None
    x_min, y_min, x_max, y_max = draft.bounds
    unseen = sum(box.length * box.width for box in draft.scanned if box.thing == "unexplored")
    share = unseen / ((x_max - x_min) * (y_max - y_min))
    if share > _MOSTLY:
        return Words(
            "the drone fits nowhere: {a} % of the floor were never seen", a=percentage(share)
        )
    return Words("the drone fits nowhere: is the unit of the file right?")
