"""Things of the catalogue: what does not change unless somebody edits it."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from housefly.geometry import Quaternion, Vec3
from housefly.messages import Facts


class ThingKind(StrEnum):
    """Kind of a thing."""

    PERSON = "person"
    ROBOT = "robot"
    FURNITURE = "furniture"
    OBJECT = "object"
    SENSOR = "sensor"
    PLACE = "place"
    STRUCTURE = "structure"
    SPACE = "space"


@dataclass(frozen=True, slots=True)
class NamedPose:
    """A named pose from which a robot reaches or sees a thing.

    Attributes:
        name: "front", "for smartpal5_2".
        position: world [m].
        yaw: heading there [rad].
        pitch: of the camera, positive looks down [rad].
        robot: name of the robot or class of robots that it is for; "" for any.
    """

    name: str
    position: Vec3
    yaw: float
    pitch: float = 0.0
    robot: str = ""


@dataclass(frozen=True, slots=True)
class Thing:
    """One thing of the catalogue.

    Attributes:
        id: stable, rarely shown: "cup-1".
        name: what people call it: "the red cup".
        kind: what kind of thing it is.
        aliases: other names, spoken ones too.
        position: where it is unless a source says otherwise, world [m].
        orientation: (w, x, y, z), body to world, unless a source says otherwise.
        inside: id of its container unless a source says otherwise, "" for none.
        viewpoints: from where to reach or see it.
        facts: what else is known about it.
    """

    id: str
    name: str
    kind: ThingKind = ThingKind.OBJECT
    aliases: tuple[str, ...] = ()
    position: Vec3 | None = None
    orientation: Quaternion | None = None
    inside: str = ""
    viewpoints: tuple[NamedPose, ...] = ()
    facts: Facts = ()
