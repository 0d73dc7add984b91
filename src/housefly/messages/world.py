"""What the room senses and what happens in it, as sensors report it and the hub keeps it."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.geometry import Quaternion, Vec3

Fact = str | float | bool
Facts = tuple[tuple[str, Fact], ...]
"""Named values beside the pose; names end in their unit where it is not SI: ("weight", 0.21),
("open", True).
"""
Covariance = tuple[float, float, float, float, float, float]
"""Upper triangle xx, xy, xz, yy, yz, zz of a position's covariance [m^2]."""


@dataclass(frozen=True, slots=True)
class Observation:
    """One thing as one source saw it at one time.

    Attributes:
        thing: stable id of what was seen: "cup", "person-1", "entrance-door".
        source: id of the sensor or process that saw it: "vicon", "cabinet", "laser-1".
        captured_at: when it was measured [s, Unix time].
        received_at: when we received it [s, Unix time].
        position: world [m]; None when the source does not know it.
        orientation: (w, x, y, z), body to world; None when unknown.
        covariance: of the position [m^2]; None when unknown.
        inside: id of the thing that contains it, "" when the source does not say.
        valid: whether the source stands by it; an occluded or implausible sample says False.
        facts: what else the source says of it.
    """

    thing: str
    source: str
    captured_at: float
    received_at: float
    position: Vec3 | None = None
    orientation: Quaternion | None = None
    covariance: Covariance | None = None
    inside: str = ""
    valid: bool = True
    facts: Facts = ()


@dataclass(frozen=True, slots=True)
class RoomEvent:
    """Something that happened.

    Attributes:
        kind: what, in words of a small vocabulary: "bell pressed", "door opened", "object taken",
            "flight started".
        thing: id of the thing that it happened to.
        at: when [s, Unix time].
        source: id of the sensor or detector that says so.
        cause: id of who or what brought it about, "" when unknown.
        confidence: 0 to 1.
        facts: the evidence.
    """

    kind: str
    thing: str
    at: float
    source: str
    cause: str = ""
    confidence: float = 1.0
    facts: Facts = ()


@dataclass(frozen=True, slots=True)
class RecordingNews:
    """Whether the drone's camera is recorded; said again twice a second while it is.

    Attributes:
        at: when, by the monotonic clock of this machine [s].
        records: whether it is.
    """

    at: float
    records: bool
