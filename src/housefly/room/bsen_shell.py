"""B-sen's walls, windows and doors, from its 0.1 m grid and its 3-D model; lengths in metres."""

from __future__ import annotations

from housefly.room.model import Solid
from housefly.room.parts import (
    BIRCH,
    CHARCOAL,
    CREAM,
    GLASS,
    OAK,
    STEEL,
    WALNUT,
    WHITE,
    Part,
    box,
    paint,
    place_parts,
)

CEILING_HEIGHT = 2.70
_SKIRTING = 0.012

_WALL_COLOUR = paint(0.92, 0.90, 0.85)
_ACCENT_COLOUR = paint(0.63, 0.72, 0.70)
_DOOR_COLOUR = paint(0.36, 0.22, 0.14)

_Footprint = tuple[float, float, float, float]

# Inner faces: corridor x 0.15..4.75, y 3.35..5.05; living area x 4.75..14.75, y 0.55..6.25; an
# alcove at its north-west.
_WALLS: tuple[tuple[str, _Footprint], ...] = (
    ("corridor south", (0.05, 3.25, 4.75, 3.35)),
    ("corridor north", (0.05, 5.05, 6.15, 5.15)),
    ("living west", (4.65, 0.45, 4.75, 3.25)),
    ("living south", (4.75, 0.45, 14.85, 0.55)),
    ("alcove west", (6.05, 5.15, 6.15, 6.75)),
    ("alcove north", (6.15, 6.65, 7.45, 6.75)),
    ("alcove east", (7.35, 6.25, 7.45, 6.65)),
    ("living north", (7.45, 6.25, 14.85, 6.35)),
    ("kitchen side", (10.59, 5.54, 10.61, 6.25)),
)

_WINDOWS = ((0.70, 1.50), (1.58, 2.38), (2.46, 3.26), (3.34, 4.14), (4.22, 5.02))
_WINDOW_BOTTOM, _WINDOW_TOP = 1.10, 2.45

# The entrance: a leaf, a narrow glazed side panel and a fanlight in one frame of 1.38 m x 2.61 m.
_DOOR_LEAF = (3.975, 4.875)
_SIDE_PANEL = (3.525, 3.945)


def shell() -> tuple[Solid, ...]:
    """Return all walls, windows, doors and skirting boards of B-sen."""
    walls = [
        box(name, (r[0], r[1], 0.0), (r[2], r[3], CEILING_HEIGHT), _WALL_COLOUR, "wall")
        for name, r in _WALLS
    ]
    return (
        *place_parts("wall", walls, 0.0, 0.0),
        *place_parts("wall", _east_wall(), 0.0, 0.0),
        *place_parts("wall", _west_wall(), 0.0, 0.0),
        *place_parts("window", _windows(), 0.0, 0.0),
        *place_parts("entrance door", _entrance(), 0.0, 0.0),
        *place_parts("room door", _room_door(), 6.75, 6.65, 0.0),
        *place_parts("decoration", _decoration(), 0.0, 0.0),
    )


def _east_wall() -> list[Part]:
    x0, x1 = 14.75, 14.85
    edges = [0.45, *(edge for window in _WINDOWS for edge in window), 6.25]
    piers = zip(edges[::2], edges[1::2], strict=True)
    return [
        box("east sill", (x0, 0.45, 0.0), (x1, 6.25, _WINDOW_BOTTOM), _WALL_COLOUR, "wall"),
        box(
            "east lintel", (x0, 0.45, _WINDOW_TOP), (x1, 6.25, CEILING_HEIGHT), _WALL_COLOUR, "wall"
        ),
        *(
            box(
                f"east pier {i}",
                (x0, a, _WINDOW_BOTTOM),
                (x1, b, _WINDOW_TOP),
                _WALL_COLOUR,
                "wall",
            )
            for i, (a, b) in enumerate(piers)
        ),
    ]


def _windows() -> list[Part]:
    parts: list[Part] = []
    for i, (a, b) in enumerate(_WINDOWS):
        parts += [
            box(
                f"pane {i}",
                (14.79, a, _WINDOW_BOTTOM),
                (14.81, b, _WINDOW_TOP),
                paint(0.62, 0.74, 0.82),
                "daylight",
            ),
            box(
                f"bar {i}",
                (14.76, (a + b) / 2 - 0.02, _WINDOW_BOTTOM),
                (14.80, (a + b) / 2 + 0.02, _WINDOW_TOP),
                WHITE,
            ),
            box(f"sill {i}", (14.66, a, _WINDOW_BOTTOM - 0.03), (14.75, b, _WINDOW_BOTTOM), WHITE),
        ]
    return parts


def _west_wall() -> list[Part]:
    return [
        box("west right", (0.05, 3.35, 0.0), (0.15, 3.49, CEILING_HEIGHT), _ACCENT_COLOUR, "wall"),
        box("west left", (0.05, 4.91, 0.0), (0.15, 5.05, CEILING_HEIGHT), _ACCENT_COLOUR, "wall"),
        box("west top", (0.05, 3.49, 2.61), (0.15, 4.91, CEILING_HEIGHT), _ACCENT_COLOUR, "wall"),
    ]


def _entrance() -> list[Part]:
    (leaf_right, leaf_left), (side_right, side_left) = _DOOR_LEAF, _SIDE_PANEL
    frame = [
        box("frame right", (0.05, 3.49, 0.0), (0.19, side_right, 2.61), WHITE),
        box("frame left", (0.05, leaf_left, 0.0), (0.19, 4.91, 2.61), WHITE),
        box("frame middle", (0.05, side_left, 0.0), (0.19, leaf_right, 2.21), WHITE),
        box("frame rail", (0.05, side_right, 2.21), (0.19, leaf_left, 2.26), WHITE),
        box("frame top", (0.05, side_right, 2.57), (0.19, leaf_left, 2.61), WHITE),
        box(
            "fanlight",
            (0.09, side_right, 2.26),
            (0.11, leaf_left, 2.57),
            paint(0.56, 0.68, 0.76),
            "daylight",
        ),
        box(
            "side glass",
            (0.09, side_right, 0.20),
            (0.11, side_left, 2.21),
            paint(0.56, 0.68, 0.76),
            "daylight",
        ),
        box("side foot", (0.07, side_right, 0.0), (0.13, side_left, 0.20), _DOOR_COLOUR, "wood"),
        *(
            box(f"side bar {i}", (0.08, side_right, z), (0.13, side_left, z + 0.03), WHITE)
            for i, z in enumerate((0.86, 1.53))
        ),
    ]
    leaf = [
        box("leaf", (0.07, leaf_right, 0.01), (0.13, leaf_left, 2.21), _DOOR_COLOUR, "wood"),
        *(
            box(f"panel {i}", (0.13, a, low), (0.142, b, high), paint(0.45, 0.29, 0.18), "wood")
            for i, (a, b, low, high) in enumerate(
                (
                    (leaf_right + 0.12, leaf_right + 0.42, 0.18, 0.92),
                    (leaf_left - 0.42, leaf_left - 0.12, 0.18, 0.92),
                    (leaf_right + 0.12, leaf_right + 0.42, 1.12, 2.06),
                    (leaf_left - 0.42, leaf_left - 0.12, 1.12, 2.06),
                )
            )
        ),
        box("lock plate", (0.13, leaf_right + 0.03, 0.90), (0.145, leaf_right + 0.09, 1.16), STEEL),
        box(
            "handle stem", (0.145, leaf_right + 0.05, 1.03), (0.19, leaf_right + 0.07, 1.05), STEEL
        ),
        box("handle", (0.175, leaf_right + 0.05, 1.03), (0.195, leaf_right + 0.20, 1.055), STEEL),
        box(
            "viewer",
            (0.13, (leaf_right + leaf_left) / 2 - 0.015, 1.50),
            (0.15, (leaf_right + leaf_left) / 2 + 0.015, 1.53),
            STEEL,
        ),
        box("mat", (0.25, 3.98, 0.0), (0.85, 4.87, 0.012), CHARCOAL, "rug", collides=False),
    ]
    return frame + leaf


def _room_door() -> list[Part]:
    return [
        box("leaf", (-0.40, -0.02, 0.0), (0.40, 0.0, 2.02), BIRCH, "wood"),
        box("frame left", (-0.46, -0.03, 0.0), (-0.40, 0.0, 2.08), OAK),
        box("frame right", (0.40, -0.03, 0.0), (0.46, 0.0, 2.08), OAK),
        box("frame top", (-0.40, -0.03, 2.02), (0.40, 0.0, 2.08), OAK),
        box("handle", (0.26, -0.06, 1.0), (0.36, -0.02, 1.03), STEEL),
        box("pane", (-0.12, -0.025, 1.25), (0.12, -0.019, 1.85), GLASS),
    ]


def _decoration() -> list[Part]:
    s, top = _SKIRTING, 0.08
    runs: tuple[tuple[str, _Footprint], ...] = (
        ("corridor south", (0.15, 3.35, 4.75, 3.35 + s)),
        ("corridor north", (0.15, 5.05 - s, 6.15, 5.05)),
        ("living west", (4.75, 0.55, 4.75 + s, 3.25)),
        ("living south", (4.75, 0.55, 14.75, 0.55 + s)),
        ("living east", (14.75 - s, 0.55, 14.75, 6.25)),
        ("alcove west", (6.15, 5.15, 6.15 + s, 6.65)),
        ("living north", (13.95, 6.25 - s, 14.75, 6.25)),
    )
    boards = [
        box(f"{name} skirting", (r[0], r[1], 0.0), (r[2], r[3], top), WALNUT, collides=False)
        for name, r in runs
    ]
    return boards + _picture("north", (3.40, 5.05), -1) + _picture("south", (1.60, 3.35), 1)


def _picture(name: str, middle: tuple[float, float], side: int) -> list[Part]:
    """Return a framed seascape on a wall along x; side 1 faces +y, -1 faces -y."""
    x, wall = middle
    layers = (
        ("frame", 0.37, 1.33, 1.87, CHARCOAL),
        ("paper", 0.34, 1.36, 1.84, CREAM),
        ("sky", 0.28, 1.54, 1.78, paint(0.93, 0.74, 0.52)),
        ("sea", 0.28, 1.42, 1.54, paint(0.20, 0.45, 0.55)),
        ("sun", 0.06, 1.54, 1.64, paint(0.86, 0.35, 0.24)),
    )
    parts = []
    for depth, (part, half, bottom, top, colour) in enumerate(layers):
        near, far = sorted((wall, wall + side * (0.018 + 0.003 * depth)))
        parts.append(
            box(
                f"{name} picture {part}",
                (x - half, near, bottom),
                (x + half, far, top),
                colour,
                collides=False,
            )
        )
    return parts
