"""Things that stand in the simulated room although no map shows them: a chair, a person who walks through."""

from __future__ import annotations

from dataclasses import dataclass
from xml.sax.saxutils import quoteattr

MOVABLE = "movable "
"""Bodies of movable things carry their name behind this."""
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


def movable_body(movable: Movable) -> str:
    """Return the MJCF of a movable thing as a mocap body, out of the building."""
    name = quoteattr(MOVABLE + movable.name)
    return (
        f'<body name={name} mocap="true" pos="0 0 {AWAY}"><geom type="cylinder" pos="0 0 {movable.height / 2:.9g}" '
        f'size="{movable.radius:.9g} {movable.height / 2:.9g}" rgba="0.35 0.42 0.55 1" material="cloth"/></body>'
    )
