"""Values of the queries that the pilot answers: plan requests and the view of the room."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.geometry import Vec2, Vec3
from housefly.messages import PreflightCheck


@dataclass(frozen=True, slots=True)
class PlanRequest:
    """A request for a plan to a place or a point [m]; start None is where the drone is."""

    place: str = ""
    goal: Vec2 | None = None
    start: Vec2 | None = None


@dataclass(frozen=True, slots=True)
class PreflightView:
    """What the pre-flight checks found half a second ago, at most; nothing before the first look.

    Attributes:
        ready: nothing forbids a take-off.
        checks: each line of the list.
    """

    ready: bool = False
    checks: tuple[PreflightCheck, ...] = ()


@dataclass(frozen=True, slots=True)
class PlaceView:
    """A named place as the console shows it."""

    name: str
    title: str
    viewpoint: Vec2
    look_at: Vec3


@dataclass(frozen=True, slots=True)
class OutlineView:
    """The footprint of one solid: corners in world xy [m]; a tracked thing may have moved since."""

    thing: str
    corners: tuple[Vec2, ...]
    top: float
    colour: str
    tracked: bool = False


@dataclass(frozen=True, slots=True)
class GridView:
    """The occupancy grid, row by row from y_min, one character per cell.

    Characters: ``.`` free, ``#`` occupied, ``v`` virtual obstacle, ``i`` inflated by hull, bound
    and margin, ``x`` outside.

    Attributes:
        origin: world xy of the lower left corner [m].
        resolution: edge of a cell [m].
        width, height: cells along x and y.
        rows: ``height`` strings of ``width`` characters, lowest y first.
    """

    origin: Vec2
    resolution: float
    width: int
    height: int
    rows: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class RoomView:
    """Everything static that the console draws."""

    site: str
    mode: str
    bounds: tuple[float, float, float, float]
    grid: GridView
    outlines: tuple[OutlineView, ...]
    places: tuple[PlaceView, ...]
    home: Vec2
    flight_height: float
    visitor: Vec2 | None
    limits: dict[str, float]
