"""A site that is not whole yet, as a value: dialog and page of ``housefly new`` fill it in.

Map frame: x and y along the walls, floor at z = 0; metres and radians.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import isfinite
from typing import Annotated, ClassVar, Literal

from pydantic import AfterValidator, ConfigDict, Field

from housefly.config.airframe import Airframe, airframe_named, airframe_names, is_model
from housefly.config.drone import DroneConfig
from housefly.config.edits import NAME
from housefly.config.rectangle import FLOOR_SIDE_MAX, check_floor
from housefly.config.tracking import DRONE_BODY, AddressedTracking
from housefly.config.validation import out_of_range
from housefly.errors import ConfigError
from housefly.geometry import Vec2

Coordinate = Annotated[float, Field(ge=-1000.0, le=1000.0, allow_inf_nan=False)]
Extent = Annotated[float, Field(gt=0.0, le=1000.0, allow_inf_nan=False)]
Angle = Annotated[float, Field(ge=-6.3, le=6.3, allow_inf_nan=False)]
Height = Annotated[float, Field(ge=0.0, le=100.0, allow_inf_nan=False)]
Text = Annotated[str, Field(max_length=60, pattern=r"^[^\x00-\x1f\x7f]*$")]
Point2 = tuple[Coordinate, Coordinate]
Point3 = tuple[Coordinate, Coordinate, Coordinate]
Corners = tuple[Coordinate, Coordinate, Coordinate, Coordinate]
"""x_min, y_min, x_max, y_max [m]."""

WALL_THICKNESS = 0.1
ROOM_HEIGHT = 2.5
_SIDE_MIN = 1.0
_HEIGHT_MIN, _HEIGHT_MAX = 1.5, 100.0
SCANNED_MAX = 20_000


def _bearable(bounds: Corners) -> Corners:
    """Return the bounds of a floor; raises ValueError for one whose map no memory would hold."""
    check_floor(bounds)
    return bounds


@dataclass(frozen=True, slots=True)
class DraftWall:
    """A straight wall along the line between two points; ``top`` None is the ceiling [m]."""

    __pydantic_config__: ClassVar[ConfigDict] = ConfigDict(extra="forbid")

    start: Point2
    end: Point2
    thickness: Annotated[float, Field(ge=0.01, le=5.0)] = WALL_THICKNESS
    bottom: Height = 0.0
    top: Height | None = None


@dataclass(frozen=True, slots=True)
class DraftBox:
    """A box between two heights: a piece of furniture, or a part of an imported file [m, rad].

    ``x`` and ``y`` are its middle; ``thing`` is what it is, its name when empty.
    """

    __pydantic_config__: ClassVar[ConfigDict] = ConfigDict(extra="forbid")

    name: Annotated[Text, Field(min_length=1)]
    x: Coordinate
    y: Coordinate
    length: Extent
    width: Extent
    top: Height
    bottom: Height = 0.0
    yaw: Angle = 0.0
    thing: Text = ""


@dataclass(frozen=True, slots=True)
class DraftPlace:
    """A named place to hover at; ``look_at`` None looks away from the pad [m]."""

    __pydantic_config__: ClassVar[ConfigDict] = ConfigDict(extra="forbid")

    name: Annotated[str, Field(min_length=1, max_length=40, pattern=NAME)]
    x: Coordinate
    y: Coordinate
    title: Text = ""
    look_at: Point3 | None = None


@dataclass(frozen=True, slots=True)
class DraftZone:
    """A rectangle that the drone must not enter, and why."""

    __pydantic_config__: ClassVar[ConfigDict] = ConfigDict(extra="forbid")

    rectangle: Corners
    reason: Annotated[Text, Field(min_length=1)]


@dataclass(frozen=True, slots=True)
class DraftTracking:
    """The motion capture system; ``port`` None is the one that such a system usually has."""

    __pydantic_config__: ClassVar[ConfigDict] = ConfigDict(extra="forbid")

    kind: AddressedTracking
    address: Annotated[Text, Field(min_length=1)]
    port: Annotated[int, Field(ge=1, le=65535)] | None = None
    body: Annotated[Text, Field(min_length=1)] = DRONE_BODY
    bridge_system: Annotated[str, Field(pattern="^[a-z_]{1,40}$")] = "qualisys"
    vrpn_transport: Literal["tcp", "udp"] = "tcp"
    up_axis: Literal["auto", "y", "z"] = "auto"


@dataclass(frozen=True, slots=True)
class FramePoint:
    """One point twice: where it is on the map, and where tracking sees it [m]."""

    __pydantic_config__: ClassVar[ConfigDict] = ConfigDict(extra="forbid")

    name: Text
    on_map: Point3
    seen: tuple[
        Annotated[float, Field(ge=-1e6, le=1e6, allow_inf_nan=False)],
        Annotated[float, Field(ge=-1e6, le=1e6, allow_inf_nan=False)],
        Annotated[float, Field(ge=-1e6, le=1e6, allow_inf_nan=False)],
    ]


USUAL_MODEL: str = DroneConfig.model_fields["kind"].default
"""What flies where nobody chose."""


def _known(model: str) -> str:
    if not is_model(model):
        raise ValueError(f"is {model!r}; allowed: {', '.join(airframe_names())}")
    return model


@dataclass(frozen=True, slots=True)
class DraftDrone:
    """A drone.

    Attributes:
        address: where a real one answers; "" while unknown.
        profile: of ``housefly identify``; "" without one.
        model: its driver and airframe.
    """

    __pydantic_config__: ClassVar[ConfigDict] = ConfigDict(extra="forbid")

    address: Text = ""
    profile: Annotated[str, Field(max_length=400)] = ""
    model: Annotated[str, AfterValidator(_known)] = USUAL_MODEL

    @property
    def airframe(self) -> Airframe:
        """What its model can do."""
        return airframe_named(self.model)


@dataclass(frozen=True, slots=True)
class SiteDraft:
    """Everything that was said about a site so far.

    Attributes:
        name: of the site.
        bounds: x_min, y_min, x_max, y_max of the floor [m]; None while unknown.
        height: of the ceiling [m].
        walls, furniture: drawn or typed by somebody.
        scanned: boxes that came with a file.
        pad: where the drone starts and lands [m]; None while unknown.
        pad_yaw: where its nose looks there [rad].
        places, zones: where to fly to, and where not.
        tracking, frame_points: of the real room.
        drone: what flies; None is the usual model.
        hardware: whether real hardware flies; False is all simulated.
        flight_height: [m].
        source: the file that the room came from.
        answered: the last step that was answered on the terminal.
    """

    __pydantic_config__: ClassVar[ConfigDict] = ConfigDict(extra="forbid")

    name: Text = ""
    bounds: Annotated[Corners, AfterValidator(_bearable)] | None = None
    height: Annotated[float, Field(ge=1.0, le=_HEIGHT_MAX)] = ROOM_HEIGHT
    walls: Annotated[tuple[DraftWall, ...], Field(max_length=2000)] = ()
    furniture: Annotated[tuple[DraftBox, ...], Field(max_length=2000)] = ()
    scanned: Annotated[tuple[DraftBox, ...], Field(max_length=SCANNED_MAX)] = ()
    pad: Point2 | None = None
    pad_yaw: Angle = 0.0
    places: Annotated[tuple[DraftPlace, ...], Field(max_length=100)] = ()
    zones: Annotated[tuple[DraftZone, ...], Field(max_length=100)] = ()
    tracking: DraftTracking | None = None
    frame_points: Annotated[tuple[FramePoint, ...], Field(max_length=50)] = ()
    drone: DraftDrone | None = None
    hardware: bool = False
    flight_height: Annotated[float, Field(ge=0.3, le=2.5)] = 1.1
    source: Annotated[str, Field(max_length=400)] = ""
    answered: Text = ""


def with_size(
    draft: SiteDraft, length: float, width: float, height: float = ROOM_HEIGHT
) -> SiteDraft:
    """Return the draft of a rectangular room from (0, 0) to (length, width) [m].

    Its four walls stand just outside; walls and boxes that were there before are gone.

    Raises:
        ConfigError: a side or the height is out of range.
    """
    _check("length", length, _SIDE_MIN, FLOOR_SIDE_MAX)
    _check("width", width, _SIDE_MIN, FLOOR_SIDE_MAX)
    _check("height", height, _HEIGHT_MIN, _HEIGHT_MAX)
    return replace(
        draft,
        bounds=(0.0, 0.0, length, width),
        height=height,
        walls=_outer_walls((0.0, 0.0, length, width)),
        scanned=(),
        source="",
    )


def _outer_walls(bounds: Corners, thickness: float = WALL_THICKNESS) -> tuple[DraftWall, ...]:
    """Return four walls whose inner faces are the bounds [m]."""
    half = thickness / 2
    x0, y0, x1, y1 = bounds[0] - half, bounds[1] - half, bounds[2] + half, bounds[3] + half
    corners: tuple[Vec2, ...] = ((x0, y0), (x1, y0), (x1, y1), (x0, y1))
    return tuple(
        DraftWall(start, end, thickness)
        for start, end in zip(corners, (*corners[1:], corners[0]), strict=True)
    )


def without_scanned(draft: SiteDraft, rectangle: Corners) -> SiteDraft:
    """Return the draft without the imported boxes whose middle is in a rectangle [m]."""
    x_min, y_min, x_max, y_max = rectangle
    kept = tuple(
        box for box in draft.scanned if not (x_min <= box.x <= x_max and y_min <= box.y <= y_max)
    )
    return replace(draft, scanned=kept)


def _check(key: str, value: float, low: float, high: float) -> None:
    if not (isfinite(value) and low <= value <= high):
        raise ConfigError(key, out_of_range(f"{value:g}", low, high, "m"))
