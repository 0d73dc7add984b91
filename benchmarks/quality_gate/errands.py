"""The errands that the gate flies: the same points for every tree, mode and speed.

Drawn once, with numpy's ``default_rng``, from the cells of the room's grid that can be reached;
kept as numbers, so that another grid does not make them other errands. Metres.
"""

from __future__ import annotations

from housefly.geometry import Vec2

BSEN_ERRANDS: tuple[Vec2, ...] = (
    (7.45, 1.35), (6.55, 3.35), (10.15, 4.25), (2.45, 4.45), (12.85, 4.75),
    (12.25, 3.95), (5.45, 3.45), (8.65, 1.55), (10.35, 1.15), (13.95, 4.15),
    (6.05, 3.95), (9.95, 3.75), (5.45, 3.05), (6.95, 4.05), (13.35, 3.65),
    (2.95, 4.05), (6.65, 4.15), (2.15, 3.95), (8.25, 1.35), (5.45, 2.95),
    (9.55, 4.25), (8.35, 3.95), (13.85, 4.35), (10.55, 1.15), (3.75, 4.35),
)  # fmt: skip
"""Seed 1030: from home one after the other 150.8 m, the shortest 1.0 m."""
SHORT_ERRANDS = BSEN_ERRANDS[:5]
"""27 m of them, with the longest but one: what disturbed flights fly."""
SMALL_HOUSE_ERRANDS: tuple[Vec2, ...] = (
    (9.75, 6.35), (10.35, 5.45), (13.65, 6.35), (17.15, 3.55), (1.55, 3.55),
    (4.15, 2.75), (14.75, 3.75), (17.15, 1.95), (5.85, 1.35), (7.25, 3.85),
    (15.55, 1.85), (8.85, 6.45), (6.15, 4.95), (14.75, 8.35), (5.95, 2.55),
    (8.55, 8.95), (12.25, 3.95), (10.85, 1.55), (2.95, 2.55), (1.35, 5.35),
    (15.45, 3.65), (13.65, 4.95), (14.95, 4.65), (10.65, 7.95), (14.65, 4.95),
)  # fmt: skip
"""Seed 1, ways of less than 1 m left out: 175.7 m."""
SLALOM_ERRANDS: tuple[Vec2, ...] = ((9.0, 3.0), (1.2, 3.0)) * 2
"""Round the poles, back, and again."""
TABLE_ERRANDS: tuple[Vec2, ...] = ((8.0, 3.0), (1.2, 3.0))
DOOR_ERRANDS: tuple[Vec2, ...] = ((8.5, 1.5), (1.5, 4.5), (8.0, 4.0), (2.0, 1.5), (8.5, 3.0))
"""Five times through the door, each time at another angle."""
