"""The state of a scene at one time: people, things, open doors; and its events."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum

from housefly.geometry import Vec2, Vec3


class Posture(Enum):
    """How a person is; AWAY means out of the room."""

    STANDING = "standing"
    WALKING = "walking"
    SITTING = "sitting"
    LYING = "lying"
    AWAY = "away"


class Act(Enum):
    """What people do to things and devices."""

    TAKE = "take"
    PUT = "put"
    OPEN = "open"
    CLOSE = "close"
    PRESS = "press"
    ON = "on"
    OFF = "off"


@dataclass(frozen=True, slots=True)
class PersonState:
    """One person.

    Attributes:
        name: stable id.
        position: feet of who stands, seat of who sits, middle of who lies [m].
        yaw: where who stands or sits faces; from feet to head of who lies [rad].
        support: height of what carries them: 0 on the floor, the seat, the mattress [m].
        posture: how they are.
    """

    name: str
    position: Vec2
    yaw: float
    support: float
    posture: Posture

    @property
    def present(self) -> bool:
        """Whether they are in the room."""
        return self.posture is not Posture.AWAY


@dataclass(frozen=True, slots=True)
class ThingState:
    """One thing.

    Attributes:
        name: stable id.
        position: where it is [m].
        inside: id of the device that contains it, or "".
        held_by: name of the person who carries it, or "".
    """

    name: str
    position: Vec3
    inside: str = ""
    held_by: str = ""


@dataclass(frozen=True, slots=True)
class SceneEvent:
    """Something that somebody did.

    Attributes:
        at: when [s since the scene began].
        act: what.
        what: id of the thing, or of the device.
        by: name of the person.
        where: id of the device that the thing was taken from or put into, or "".
        position: where the thing was put [m]; None otherwise.
    """

    at: float
    act: Act
    what: str
    by: str
    where: str = ""
    position: Vec3 | None = None


@dataclass(frozen=True, slots=True)
class SceneState:
    """The state at one time.

    Attributes:
        at: time since the scene began [s].
        people: in the order of the script.
        things: by name.
        open: ids of the devices whose doors stand open.
        on: ids of the devices that are switched on.
    """

    at: float
    people: tuple[PersonState, ...]
    things: Mapping[str, ThingState]
    open: frozenset[str]
    on: frozenset[str] = frozenset()

    def inside(self, device: str) -> tuple[ThingState, ...]:
        """Return what a device contains, in order of names."""
        return tuple(thing for _, thing in sorted(self.things.items()) if thing.inside == device)
