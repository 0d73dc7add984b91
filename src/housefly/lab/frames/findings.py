"""What can be wrong between tracking, drone and map, with the words for it."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum

from housefly.geometry import Vec2


class FrameFault(Enum):
    """What the frame check can find."""

    NOT_SEEN = "body not seen"
    WRONG_BODY = "wrong body"
    NO_MOVEMENT = "no movement"
    UP_AXIS = "up axis"
    MIRRORED = "mirrored axes"
    TURN_MIRRORED = "mirrored headings"
    NO_HEADING = "no heading"
    HEADING_UNCLEAR = "headings disagree"
    SCALE = "scale"
    UNEVEN = "ways disagree"
    ROTATED = "rotated frame"
    BODY_YAW = "body yaw"
    ORIGIN = "origin"
    HEIGHT = "height"
    LATE = "late tracking"
    EARLY = "late drone"
    NOT_BACK = "not back"


@dataclass(frozen=True, slots=True)
class FrameFinding:
    """One thing that is wrong.

    Attributes:
        fault: which.
        words: what was seen.
        mend: what to do.
    """

    fault: FrameFault
    words: str
    mend: str


@dataclass(frozen=True, slots=True)
class FrameMeasures:
    """What the samples say, as far as it can be told; None for what cannot.

    Attributes:
        scale: seen length of a way over its true one.
        rotation: of the frame against the map [rad].
        body_yaw: of the tracked body against the drone's nose [rad].
        origin: seen minus true place of the pad, on the map [m].
        height: seen minus true height of the drone on the floor [m].
        lag: of tracking against the drone's own heading [s].
    """

    scale: float | None = None
    rotation: float | None = None
    body_yaw: float | None = None
    origin: Vec2 | None = None
    height: float | None = None
    lag: float | None = None


@dataclass(frozen=True, slots=True)
class FrameVerdict:
    """What a frame check came to.

    Attributes:
        findings: what is wrong, the gravest first; empty when nothing is.
        measures: the numbers.
        mended: keys of [tracking] that would mend what a site file can mend.
        notes: what could not be checked.
    """

    findings: tuple[FrameFinding, ...]
    measures: FrameMeasures = FrameMeasures()
    mended: dict[str, float | str] = field(default_factory=dict)
    notes: tuple[str, ...] = ()

    @property
    def passed(self) -> bool:
        """Whether nothing is wrong."""
        return not self.findings
