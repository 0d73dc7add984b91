"""Obstacles that no map shows: people, moved chairs, opened doors."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from housefly.geometry import Vec2
from housefly.messages.words import Words

TRACK = "track-"
"""Begins the id of what a sensor follows and nobody has named."""
_SOMEBODY, _SOMETHING = Words("somebody"), Words("something")


class ObstacleKind(Enum):
    """What stands in the way, as far as its source can tell."""

    UNKNOWN = "unknown"
    PERSON = "person"
    THING = "thing"
    DRONE = "drone"


@dataclass(frozen=True, slots=True)
class Obstacle:
    """One thing in the way, as one source last saw it.

    It is a rectangle of ``size``, turned by ``yaw`` and grown by ``radius``; a disc is a rectangle
    without extent. A confidence of 0 says that the thing is gone.

    Attributes:
        id: the source's own name for it, the same for as long as the source follows it.
        position: middle, world xy [m].
        radius: of the disc, or how far the rectangle's corners are rounded outwards [m].
        size: full length and width of the rectangle before it is turned [m].
        yaw: of the rectangle [rad].
        bottom, top: heights between which it stands [m].
        velocity: world xy [m/s].
        confidence: 0 to 1.
        seen_at: when it was seen [s, our monotonic clock].
        source: which sensor or process says so.
        kind: a person, a thing, another drone, or unknown; who may be a person is treated as one,
            and so is a drone that flies.
    """

    id: str
    position: Vec2
    radius: float = 0.0
    size: Vec2 = (0.0, 0.0)
    yaw: float = 0.0
    bottom: float = 0.0
    top: float = 3.0
    velocity: Vec2 = (0.0, 0.0)
    confidence: float = 1.0
    seen_at: float = 0.0
    source: str = ""
    kind: ObstacleKind = ObstacleKind.UNKNOWN


def called(who: str) -> str:
    """Return what people call who is in the way, by the id: a number is no name."""
    return _SOMEBODY if who.startswith(TRACK) else who


def thing_called(thing: str) -> str:
    """Return the same of what may be a thing as well."""
    return _SOMETHING if thing.startswith(TRACK) else thing
