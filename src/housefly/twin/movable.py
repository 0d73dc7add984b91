"""Things that stand in the simulated room although no map shows them: a chair, a person who walks through."""

from __future__ import annotations

from dataclasses import dataclass
from xml.sax.saxutils import quoteattr

import numpy as np
from numpy.typing import NDArray

from housefly.messages import Pose

MOVABLE = "movable "
"""Bodies of movable things carry their name behind this."""
MARKER = 0.02
"""How far markers stand out [m]."""
AWAY = -30.0
"""How far below the floor what is not there is kept [m]."""


@dataclass(frozen=True, slots=True)
class Movable:
    """An upright cylinder that can be put anywhere.

    Attributes:
        name: of the thing.
        radius, height: [m].
    """

    name: str
    radius: float = 0.25
    height: float = 1.5


def markers_on(movable: Movable, pose: Pose) -> NDArray[np.float64]:
    """Return the world positions [m] of the four markers on top of a movable thing, shape (4, 3)."""
    (x, y, z), out = pose.position, 0.8 * movable.radius
    return np.array([(x + dx * out, y + dy * out, z + movable.height + MARKER) for dx, dy in ((1, 0), (0, 1), (-1, 0), (0, -1))])


def movable_body(movable: Movable) -> str:
    """Return the MJCF of a movable thing as a mocap body, out of the building."""
    name = quoteattr(MOVABLE + movable.name)
    return (
        f'<body name={name} mocap="true" pos="0 0 {AWAY}"><geom type="cylinder" pos="0 0 {movable.height / 2:.9g}" '
        f'size="{movable.radius:.9g} {movable.height / 2:.9g}" rgba="0.35 0.42 0.55 1" material="cloth"/></body>'
    )
