"""The furniture of B-sen as tables of parts; outer sizes follow B-sen's own models.

Every table is in the frame of ``room.parts``: x to the front, origin on the floor under the middle
[m].
"""

from __future__ import annotations

from math import cos, pi, sin

from housefly.room.parts import (
    BIRCH,
    BRICK,
    CHARCOAL,
    CREAM,
    GLASS,
    LEAF,
    OAK,
    SAND,
    STEEL,
    TEAL,
    WALNUT,
    WHITE,
    Part,
    box,
    paint,
    pillar,
)

_NAVY = paint(0.18, 0.26, 0.42)
_SAGE = paint(0.55, 0.66, 0.62)
_SCREEN = paint(0.05, 0.07, 0.10)


def _legs(
    length: float, width: float, top: float, inset: float, thick: float, colour: tuple[float, ...]
) -> tuple[Part, ...]:
    """Return four square legs under a table top of length x width [m]."""
    x, y, h = length / 2 - inset, width / 2 - inset, thick / 2
    tint = paint(*colour)
    return tuple(
        box(f"leg {i}", (sx * x - h, sy * y - h, 0.0), (sx * x + h, sy * y + h, top), tint)
        for i, (sx, sy) in enumerate(((1, 1), (1, -1), (-1, 1), (-1, -1)))
    )


BED = (
    box("frame", (-0.97, -0.41, 0.14), (0.97, 0.41, 0.30), BIRCH),
    box("mattress", (-0.93, -0.40, 0.30), (0.93, 0.40, 0.46), WHITE),
    box("blanket", (-0.34, -0.42, 0.40), (0.94, 0.42, 0.50), _NAVY, "fabric"),
    box("turned sheet", (-0.46, -0.42, 0.41), (-0.30, 0.42, 0.51), CREAM),
    box("pillow", (-0.88, -0.28, 0.46), (-0.54, 0.28, 0.56), WHITE, "fabric"),
    box("headboard", (-0.975, -0.41, 0.14), (-0.935, 0.41, 0.82), OAK, "wood"),
    box("footboard", (0.935, -0.41, 0.14), (0.975, 0.41, 0.60), OAK, "wood"),
    *_legs(1.95, 0.82, 0.14, 0.06, 0.06, CHARCOAL),
)

SOFA = (
    box("base", (-0.40, -1.17, 0.08), (0.38, 1.17, 0.30), TEAL, "fabric"),
    box("back", (-0.40, -1.17, 0.30), (-0.16, 1.17, 0.79), TEAL, "fabric"),
    box("left arm", (-0.40, 0.97, 0.30), (0.38, 1.175, 0.58), TEAL, "fabric"),
    box("right arm", (-0.40, -1.175, 0.30), (0.38, -0.97, 0.58), TEAL, "fabric"),
    *(
        box(
            f"seat {i}",
            (-0.16, low + 0.01, 0.30),
            (0.40, low + 0.64, 0.44),
            paint(0.20, 0.50, 0.52),
            "fabric",
        )
        for i, low in enumerate((-0.97, -0.325, 0.32))
    ),
    Part("cushion", (-0.08, 0.72, 0.58), (0.14, 0.38, 0.34), paint(0.90, 0.66, 0.27), "fabric"),
    Part("cushion red", (-0.08, -0.72, 0.57), (0.14, 0.36, 0.32), BRICK, "fabric"),
    *_legs(0.80, 2.35, 0.08, 0.08, 0.06, WALNUT),
)

SOFA_TABLE = (
    box("top", (-0.25, -0.65, 0.38), (0.25, 0.65, 0.43), WALNUT, "wood"),
    box("shelf", (-0.22, -0.60, 0.16), (0.22, 0.60, 0.18), WALNUT, "wood"),
    *_legs(0.50, 1.30, 0.38, 0.05, 0.05, CHARCOAL),
    box("book", (-0.10, -0.35, 0.43), (0.08, -0.10, 0.46), BRICK),
    pillar("cup", (0.06, 0.25), 0.43, 0.52, 0.08, WHITE),
)

CARPET = (
    box(
        "pile",
        (-0.88, -1.275, 0.0),
        (0.88, 1.275, 0.012),
        paint(0.80, 0.72, 0.60),
        "rug",
        collides=False,
    ),
    box(
        "field",
        (-0.74, -1.135, 0.012),
        (0.74, 1.135, 0.015),
        paint(0.62, 0.30, 0.26),
        "rug",
        collides=False,
    ),
)

TV_TABLE = (
    box("body", (-0.175, -1.35, 0.04), (0.165, 1.35, 0.35), WALNUT, "wood"),
    *(
        box(f"drawer {i}", (0.160, y - 0.42, 0.09), (0.178, y + 0.42, 0.31), OAK, "wood")
        for i, y in enumerate((-0.89, 0.0, 0.89))
    ),
    box("plinth", (-0.15, -1.30, 0.0), (0.13, 1.30, 0.04), CHARCOAL),
    box("player", (-0.10, 0.55, 0.35), (0.14, 0.98, 0.41), _SCREEN),
)

TV = (
    box("frame", (-0.10, -1.25, 0.75), (0.06, 1.25, 2.15), CHARCOAL),
    box("screen", (0.06, -1.21, 0.79), (0.075, 1.21, 2.11), paint(0.08, 0.16, 0.28), "screen"),
    box("bracket", (-0.10, -0.20, 0.35), (-0.04, 0.20, 0.80), CHARCOAL),
)

KITCHEN = (
    box("plinth", (-0.325, -1.56, 0.0), (0.26, 1.56, 0.10), CHARCOAL),
    box("cupboards", (-0.325, -1.56, 0.10), (0.30, 1.56, 0.78), CREAM),
    *(
        box(f"front {i}", (0.30, y - 0.25, 0.13), (0.318, y + 0.25, 0.75), _SAGE)
        for i, y in enumerate((-1.30, -0.78, -0.26, 0.26, 0.78, 1.30))
    ),
    *(
        box(f"handle {i}", (0.318, y - 0.09, 0.69), (0.335, y + 0.09, 0.71), STEEL)
        for i, y in enumerate((-1.30, -0.78, -0.26, 0.26, 0.78, 1.30))
    ),
    box("counter", (-0.325, -1.56, 0.78), (0.325, 1.56, 0.82), paint(0.34, 0.35, 0.37)),
    box("sink", (-0.18, -0.95, 0.815), (0.22, -0.25, 0.825), STEEL),
    pillar("tap", (-0.24, -0.60), 0.82, 1.08, 0.035, STEEL),
    box("tap spout", (-0.24, -0.615, 1.05), (-0.04, -0.585, 1.08), STEEL),
    box("hob", (-0.22, 0.55, 0.82), (0.22, 1.15, 0.828), _SCREEN),
    *(
        pillar(f"ring {i}", (x, y), 0.828, 0.834, 0.17, BRICK)
        for i, (x, y) in enumerate(((0.08, 0.71), (0.08, 0.99), (-0.12, 0.85)))
    ),
    pillar("pot", (0.08, 0.99), 0.834, 0.98, 0.20, BRICK),
    box("wall cupboards", (-0.325, -1.56, 1.55), (0.02, 0.50, 2.20), CREAM),
    *(
        box(f"wall front {i}", (0.02, y - 0.32, 1.57), (0.035, y + 0.32, 2.18), _SAGE)
        for i, y in enumerate((-1.21, -0.53, 0.15))
    ),
    box("hood", (-0.325, 0.55, 1.62), (0.10, 1.15, 1.80), STEEL),
    box("hood duct", (-0.325, 0.72, 1.80), (-0.05, 0.98, 2.70), STEEL),
    box("splashback", (-0.325, -1.56, 0.82), (-0.31, 1.56, 1.55), WHITE, "tiles"),
)

REFRIGERATOR = (
    box("body", (-0.28, -0.24, 0.03), (0.25, 0.24, 1.11), paint(0.83, 0.85, 0.87)),
    box("freezer door", (0.25, -0.235, 0.04), (0.284, 0.235, 0.40), paint(0.88, 0.90, 0.92)),
    box("door", (0.25, -0.235, 0.42), (0.284, 0.235, 1.105), paint(0.88, 0.90, 0.92)),
    box("handle", (0.284, 0.16, 0.55), (0.31, 0.19, 0.95), CHARCOAL),
    box("freezer handle", (0.284, 0.16, 0.22), (0.31, 0.19, 0.36), CHARCOAL),
    box("feet", (-0.25, -0.22, 0.0), (0.24, 0.22, 0.03), CHARCOAL),
)

WARDROBE = (
    box("body", (-0.35, -0.475, 0.06), (0.32, 0.475, 2.56), OAK, "wood"),
    box("left door", (0.32, 0.005, 0.10), (0.345, 0.465, 2.52), BIRCH, "wood"),
    box("right door", (0.32, -0.465, 0.10), (0.345, -0.005, 2.52), BIRCH, "wood"),
    box("left handle", (0.345, 0.03, 1.05), (0.37, 0.05, 1.35), CHARCOAL),
    box("right handle", (0.345, -0.05, 1.05), (0.37, -0.03, 1.35), CHARCOAL),
    box("plinth", (-0.34, -0.46, 0.0), (0.30, 0.46, 0.06), CHARCOAL),
)

WORK_DESK = (
    box("top", (-0.325, -1.22, 0.67), (0.325, 1.22, 0.71), BIRCH, "wood"),
    *_legs(0.65, 2.44, 0.67, 0.05, 0.06, CHARCOAL),
    box("modesty panel", (-0.30, -1.16, 0.30), (-0.28, 1.16, 0.67), WHITE),
    box("monitor foot", (-0.20, -0.14, 0.71), (0.0, 0.14, 0.73), CHARCOAL),
    box("monitor stand", (-0.14, -0.03, 0.73), (-0.11, 0.03, 0.90), CHARCOAL),
    box("monitor", (-0.11, -0.30, 0.84), (-0.07, 0.30, 1.19), CHARCOAL),
    box(
        "monitor picture",
        (-0.07, -0.285, 0.855),
        (-0.065, 0.285, 1.175),
        paint(0.20, 0.42, 0.62),
        "screen",
    ),
    box("keyboard", (0.08, -0.22, 0.71), (0.22, 0.22, 0.73), STEEL),
    box("books", (-0.26, 0.62, 0.71), (-0.02, 0.98, 0.97), BRICK),
    pillar("lamp foot", (-0.12, -0.80), 0.71, 0.73, 0.16, CHARCOAL),
    pillar("lamp arm", (-0.12, -0.80), 0.73, 1.12, 0.02, CHARCOAL),
    pillar("lamp shade", (-0.06, -0.80), 1.08, 1.20, 0.18, paint(0.93, 0.78, 0.36)),
)

DRAWER = (
    box("body", (-0.30, -0.20, 0.0), (0.29, 0.20, 0.60), WHITE),
    *(
        box(f"front {i}", (0.29, -0.185, z), (0.305, 0.185, z + 0.17), SAND)
        for i, z in enumerate((0.02, 0.21, 0.40))
    ),
    *(
        box(f"knob {i}", (0.305, -0.05, z + 0.08), (0.32, 0.05, z + 0.10), CHARCOAL)
        for i, z in enumerate((0.02, 0.21, 0.40))
    ),
)

WORK_CHAIR = (
    *(
        Part(f"foot {i}", (0.15 * cos(a), 0.15 * sin(a), 0.05), (0.30, 0.04, 0.04), CHARCOAL, yaw=a)
        for i, a in enumerate(2 * pi * k / 5 for k in range(5))
    ),
    pillar("column", (0.0, 0.0), 0.05, 0.44, 0.06, STEEL),
    box("seat", (-0.24, -0.24, 0.44), (0.24, 0.24, 0.52), _NAVY, "fabric"),
    box("back", (-0.28, -0.22, 0.56), (-0.21, 0.22, 1.06), _NAVY, "fabric"),
    box("back bar", (-0.28, -0.03, 0.44), (-0.24, 0.03, 0.60), CHARCOAL),
)

MEETING_TABLE = (
    pillar("top", (0.0, 0.0), 0.69, 0.73, 1.32, BIRCH, "wood"),
    pillar("column", (0.0, 0.0), 0.04, 0.69, 0.12, STEEL),
    pillar("foot", (0.0, 0.0), 0.0, 0.04, 0.66, CHARCOAL),
    box("notebook", (0.10, -0.18, 0.73), (0.33, 0.14, 0.75), STEEL),
    box("papers", (-0.35, 0.05, 0.73), (-0.14, 0.35, 0.737), WHITE),
)

MEETING_CHAIR = (
    box("seat", (-0.20, -0.21, 0.42), (0.22, 0.21, 0.46), paint(0.84, 0.45, 0.22), "fabric"),
    box("back", (-0.23, -0.20, 0.52), (-0.19, 0.20, 0.795), paint(0.84, 0.45, 0.22), "fabric"),
    box("left post", (-0.225, 0.15, 0.44), (-0.195, 0.18, 0.78), STEEL),
    box("right post", (-0.225, -0.18, 0.44), (-0.195, -0.15, 0.78), STEEL),
    *_legs(0.40, 0.40, 0.42, 0.03, 0.03, STEEL),
)

SMART_SHELF = (
    box("left side", (-0.15, 0.21, 0.0), (0.15, 0.23, 0.89), BIRCH, "wood"),
    box("right side", (-0.15, -0.23, 0.0), (0.15, -0.21, 0.89), BIRCH, "wood"),
    box("back", (-0.15, -0.21, 0.0), (-0.14, 0.21, 0.89), BIRCH, "wood"),
    *(
        box(f"board {i}", (-0.14, -0.21, z), (0.15, 0.21, z + 0.02), OAK, "wood")
        for i, z in enumerate((0.02, 0.30, 0.58, 0.87))
    ),
    box("books", (-0.10, -0.18, 0.60), (0.10, 0.05, 0.82), TEAL),
    pillar("tea bottle", (0.03, 0.13), 0.32, 0.53, 0.07, LEAF),
    box("box", (-0.08, -0.15, 0.32), (0.10, 0.02, 0.48), BRICK),
)

WAGON = (
    box("upper tray", (-0.305, -0.172, 0.62), (0.305, 0.172, 0.66), WHITE),
    box("lower tray", (-0.305, -0.172, 0.14), (0.305, 0.172, 0.18), WHITE),
    *_legs(0.61, 0.344, 0.70, 0.02, 0.025, STEEL),
    pillar("kettle", (0.12, 0.0), 0.66, 0.84, 0.15, BRICK),
    box("tray", (-0.25, -0.12, 0.66), (-0.02, 0.12, 0.68), OAK),
)

TREE = (
    pillar("pot", (0.0, 0.0), 0.0, 0.34, 0.36, BRICK),
    pillar("soil", (0.0, 0.0), 0.34, 0.35, 0.32, WALNUT),
    pillar("trunk", (0.0, 0.0), 0.35, 1.05, 0.05, WALNUT),
    pillar("crown low", (0.0, 0.0), 0.78, 1.02, 0.40, LEAF, "leaves"),
    pillar("crown", (0.03, 0.02), 1.02, 1.40, 0.40, paint(0.27, 0.53, 0.25), "leaves"),
    pillar("crown top", (-0.02, 0.0), 1.40, 1.70, 0.28, paint(0.33, 0.60, 0.29), "leaves"),
)

WALL_SHELF = (
    box("board", (-0.10, -2.20, 0.95), (0.10, 2.20, 1.05), OAK, "wood"),
    box("books", (-0.06, -1.70, 1.05), (0.06, -1.10, 1.28), BRICK),
    box("books blue", (-0.06, -1.08, 1.05), (0.06, -0.72, 1.31), _NAVY),
    pillar("vase", (0.0, 0.30), 1.05, 1.32, 0.11, TEAL),
    box("picture", (-0.06, 1.00, 1.05), (-0.04, 1.35, 1.30), paint(0.90, 0.66, 0.27)),
)

PARTITION_PANEL = (
    box("foot", (-0.14, -0.30, 0.0), (0.14, 0.30, 0.04), CHARCOAL),
    box("panel", (-0.025, -0.74, 0.04), (0.025, 0.74, 1.80), SAND, "fabric"),
    box("rail", (-0.03, -0.75, 1.80), (0.03, 0.75, 1.84), OAK),
    box("window", (-0.028, -0.60, 1.25), (0.028, 0.60, 1.68), GLASS),
)
