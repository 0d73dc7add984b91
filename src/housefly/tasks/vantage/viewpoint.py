"""Where to hover and where to look, computed for one subject."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.geometry import Vec2, Vec3


@dataclass(frozen=True, slots=True)
class Viewpoint:
    """Where to hover to see a subject.

    Attributes:
        subject: name of the place, thing or person.
        position: where to hover, world xy [m]; the height is the map's flight height.
        look_at: the point to face, world [m].
        distance: from the camera to that point [m].
        words: what is seen from where, for people.
    """

    subject: str
    position: Vec2
    look_at: Vec3
    distance: float
    words: str
