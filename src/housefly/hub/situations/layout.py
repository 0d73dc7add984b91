"""What detectors know of the room in advance: seats, beds, the entrance, where devices stand."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import cos, hypot, sin

from housefly.geometry import Vec2, Vec3
from housefly.hub.situations.device_traits import DeviceTraits


@dataclass(frozen=True, slots=True)
class Area:
    """A rectangle on the floor plan.

    Attributes:
        name: of what is there: "sofa seat 1", "bed".
        centre: world [m].
        size: length and width before rotation [m].
        yaw: direction of its length [rad].
    """

    name: str
    centre: Vec2
    size: Vec2
    yaw: float = 0.0

    def distance(self, point: tuple[float, ...]) -> float:
        """Return how far outside a point lies [m], 0 inside."""
        x, y = point[0] - self.centre[0], point[1] - self.centre[1]
        along, across = x * cos(self.yaw) + y * sin(self.yaw), y * cos(self.yaw) - x * sin(self.yaw)
        return hypot(
            max(0.0, abs(along) - self.size[0] / 2), max(0.0, abs(across) - self.size[1] / 2)
        )


@dataclass(frozen=True, slots=True)
class Layout:
    """What is known of a room in advance; situations that need a missing part are not claimed.

    Attributes:
        seats: areas of seats.
        beds: areas of beds, by the id of the bed's sensor, or an id of its own without one.
        entrance: the rectangle at the door, or None.
        bells: ids of the doorbells of that entrance.
        motion: ids of the motion sensors that watch the entrance.
        containers: positions of cabinets and refrigerators, by id [m].
        open_limits: how long a door may stand open, by id [s]; default ``door.OPEN_TOO_LONG``.
        people: ids of people, for sources that do not say what a thing is.
        robots: ids of what moves by itself: nobody takes it, and nobody puts it down.
        devices: what is known of measuring devices, by id.
    """

    seats: tuple[Area, ...] = ()
    beds: Mapping[str, Area] = field(default_factory=dict)
    entrance: Area | None = None
    bells: frozenset[str] = frozenset()
    motion: frozenset[str] = frozenset()
    containers: Mapping[str, Vec3] = field(default_factory=dict)
    open_limits: Mapping[str, float] = field(default_factory=dict)
    people: frozenset[str] = frozenset()
    robots: frozenset[str] = frozenset()
    devices: Mapping[str, DeviceTraits] = field(default_factory=dict)
