"""B-sen, the paper's room, from its furniture poses, 0.1 m grid and camera calibration.

World frame: B-sen's own, 15 m x 8 m, x along the long wall. Lengths in metres, angles in radians.
Furniture stands where B-sen's robot model puts it; walls and free floor follow its grid; the
entrance door and windows follow its 3-D model.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from math import atan, pi

from housefly.geometry import Quaternion, Vec3, normalized
from housefly.room import furniture
from housefly.room.bsen_shell import CEILING_HEIGHT, shell
from housefly.room.home_pad import home_pad
from housefly.room.model import Place, Room, Solid, TrackingCamera
from housefly.room.parts import Part, place_parts

_BOUNDS = (0.0, 0.0, 15.0, 8.0)
_HOME = (10.55, 1.25)
_VISITOR = (0.85, 4.20)

_SOUTH, _EAST, _NORTH, _WEST = -pi / 2, 0.0, pi / 2, pi

# thing, name, parts, x, y, direction of its front
_FURNITURE: tuple[tuple[str, str, tuple[Part, ...], float, float, float], ...] = (
    ("kitchen", "", furniture.KITCHEN, 9.03, 5.87, _SOUTH),
    ("refrigerator", "", furniture.REFRIGERATOR, 7.176, 5.82, _SOUTH),
    ("wardrobe", "", furniture.WARDROBE, 13.46, 5.90, _SOUTH),
    ("work desk", "", furniture.WORK_DESK, 11.80, 5.90, _SOUTH),
    ("drawer", "", furniture.DRAWER, 12.72, 5.80, _SOUTH),
    ("chair", "work chair", furniture.WORK_CHAIR, 11.80, 5.28, _NORTH),
    ("bed", "", furniture.BED, 10.35, 2.70, _EAST),
    ("sofa", "", furniture.SOFA, 11.75, 2.60, _EAST),
    ("sofa table", "", furniture.SOFA_TABLE, 12.70, 2.50, _EAST),
    ("carpet", "", furniture.CARPET, 12.30, 2.60, _EAST),
    ("tv table", "", furniture.TV_TABLE, 14.25, 2.50, _WEST),
    ("tv", "", furniture.TV, 14.37, 2.20, _WEST),
    ("smart shelf", "", furniture.SMART_SHELF, 11.50, 4.20, _EAST),
    ("partition", "", furniture.PARTITION_PANEL, 10.90, 5.00, _NORTH),
    ("meeting table", "", furniture.MEETING_TABLE, 5.70, 1.50, _EAST),
    ("chair", "meeting chair north", furniture.MEETING_CHAIR, 5.70, 2.28, _SOUTH),
    ("chair", "meeting chair west", furniture.MEETING_CHAIR, 4.99, 1.50, _EAST),
    ("chair", "meeting chair south", furniture.MEETING_CHAIR, 5.70, 0.84, _NORTH),
    ("chair", "meeting chair east", furniture.MEETING_CHAIR, 6.45, 1.50, _WEST),
    ("wall shelf", "", furniture.WALL_SHELF, 7.50, 0.65, _NORTH),
    ("wagon", "", furniture.WAGON, 6.58, 5.75, _EAST),
    ("tree", "", furniture.TREE, 14.30, 5.30, _EAST),
)

_PLACES = (
    Place("home", _HOME, (6.0, 2.6, 1.1), "Home"),
    Place("entrance", (3.05, 4.25), (_VISITOR[0], _VISITOR[1], 1.35), "Entrance"),
    Place("table", (7.55, 2.25), (5.70, 1.50, 0.75), "Meeting table"),
    Place("bed", (8.05, 2.75), (10.2, 2.70, 0.50), "Bed"),
    Place("kitchen", (9.05, 4.25), (9.03, 5.80, 0.95), "Kitchen"),
    Place("sofa", (13.55, 1.25), (11.85, 2.50, 0.55), "Sofa"),
    Place("tv", (12.55, 1.25), (14.30, 2.20, 1.45), "TV"),
    Place("desk", (12.55, 4.75), (11.80, 5.90, 0.95), "Work desk"),
    Place("window", (13.55, 4.25), (14.80, 4.60, 1.60), "Window"),
)

_SENSORS = {"Bonita 10": (1024, 1024), "Bonita 3": (640, 480)}
_MARKER_DIAMETER = 0.014
"""Diameter of the reflecting spheres on tracked bodies [m]."""

# Number, kind, position [m], camera to world (w, x, y, z), focal length [px], from the calibration
# of 2016-05-19. It measures some cameras up to 0.34 m inside our walls, which follow another
# survey: those (10, 11, 12, 14 to 17) hang 7 cm in front.
_CAMERAS: tuple[tuple[int, str, Vec3, Quaternion, float], ...] = (
    (0, "Bonita 10", (0.270, 4.460, 2.428), (0.2092, -0.5122, 0.7278, -0.4052), 710.2),
    (1, "Bonita 10", (4.670, 4.380, 2.394), (0.1671, -0.4044, 0.8343, -0.3354), 721.6),
    (2, "Bonita 10", (6.257, 6.012, 2.485), (0.1680, -0.4378, 0.7871, -0.4007), 725.2),
    (3, "Bonita 10", (7.058, 3.578, 2.409), (0.2823, -0.5310, -0.6890, 0.4044), 722.5),
    (4, "Bonita 10", (7.075, 4.398, 2.385), (0.2661, -0.4893, -0.7704, 0.3103), 710.8),
    (5, "Bonita 10", (7.463, 4.691, 2.418), (0.3530, -0.7029, 0.5385, -0.3021), 721.1),
    (6, "Bonita 10", (10.987, 3.062, 2.373), (0.2612, -0.7128, -0.5642, 0.3246), 702.7),
    (7, "Bonita 10", (10.380, 5.501, 2.487), (0.2007, -0.4357, -0.7867, 0.3885), 721.3),
    (8, "Bonita 3", (10.840, 5.476, 2.488), (0.2274, -0.3279, 0.8396, -0.3684), 361.4),
    (9, "Bonita 3", (14.341, 4.612, 2.243), (0.4725, 0.7520, -0.3851, -0.2508), 357.8),
    (10, "Bonita 3", (14.231, 0.620, 2.436), (0.3340, -0.8596, -0.3641, 0.1304), 359.3),
    (11, "Bonita 3", (11.450, 0.620, 2.379), (0.4041, -0.8378, 0.3372, -0.1454), 361.1),
    (12, "Bonita 3", (11.058, 0.620, 2.378), (0.3658, -0.8427, -0.3188, 0.2333), 358.2),
    (13, "Bonita 10", (8.171, 1.216, 2.389), (0.3262, -0.5363, 0.7200, -0.2959), 727.0),
    (14, "Bonita 3", (7.377, 0.620, 2.398), (0.4303, -0.8979, 0.0916, 0.0117), 357.8),
    (15, "Bonita 10", (4.820, 1.234, 2.375), (0.2673, -0.6020, 0.7201, -0.2180), 720.3),
    (16, "Bonita 10", (4.820, 3.087, 2.394), (0.2489, -0.7253, 0.5416, -0.3446), 720.6),
    (17, "Bonita 10", (0.266, 3.420, 2.419), (0.3449, -0.7124, 0.5434, -0.2798), 732.7),
)


@cache
def bsen() -> Room:
    """Return B-sen."""
    return Room(
        name="B-sen",
        bounds=_BOUNDS,
        height=CEILING_HEIGHT,
        solids=tuple(_solids()),
        places=_PLACES,
        cameras=tuple(_camera(*row) for row in _CAMERAS),
        home=_HOME,
        home_yaw=pi,
        visitor=_VISITOR,
        visitor_yaw=0.0,
    )


def _solids() -> Iterator[Solid]:
    yield from shell()
    for thing, name, parts, x, y, yaw in _FURNITURE:
        yield from place_parts(thing, parts, x, y, yaw, name)
    yield from home_pad(_HOME)


def _camera(
    number: int, kind: str, position: Vec3, orientation: Quaternion, focal_px: float
) -> TrackingCamera:
    """Return a tracking camera; a marker is seen while it is at least 0.8 px wide (our choice)."""
    width, height = _SENSORS[kind]
    field = (2 * atan(width / 2 / focal_px), 2 * atan(height / 2 / focal_px))
    reach = round(_MARKER_DIAMETER * focal_px / 0.8, 2)
    return TrackingCamera(f"{kind} #{number}", position, normalized(orientation), field, reach)
