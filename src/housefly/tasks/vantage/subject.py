"""What is to be seen: the points of a place, a thing or a person that a picture must show."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from itertools import product

from housefly.geometry import Vec2, Vec3, distance
from housefly.room.model import BUILDING_PARTS, Room, Solid
from housefly.room.outline import outline

_SHRUNK = 0.6
"""Share of a thing's extent whose corners must be seen."""
_SPREAD = 0.08
"""Half the size of a thing whose size nobody knows [m]."""
_WITHIN = 0.1
"""A thing so near to furniture is in it or on it [m]."""
_STANDING = (1.5, 1.75, 1.2, 0.9)
_SITTING = (1.15, 1.3, 0.8)
_LYING = (0.15, 0.3, 0.05)
"""Heights at which somebody must be seen [m], what is faced first; of who lies above what they lie
on.
"""
_UPRIGHT_FROM = 0.9
"""Who is tracked higher than this is tracked at the head, lower ones at the feet [m]."""


class SubjectKind(Enum):
    """What is looked at."""

    PLACE = "place"
    THING = "thing"
    PERSON = "person"


@dataclass(frozen=True, slots=True)
class Subject:
    """What is to be seen.

    Attributes:
        name: in words.
        kind: a place, a thing or a person.
        points: what a picture must show, world [m]; the first is faced.
        front: where its front faces [rad]; None when it has none.
        own: names of the room's solids that it consists of, or lies in; they do not hide it.
    """

    name: str
    kind: SubjectKind
    points: tuple[Vec3, ...]
    front: float | None = None
    own: frozenset[str] = frozenset()

    @property
    def look_at(self) -> Vec3:
        """The point to face [m]."""
        return self.points[0]


def place_subject(name: str, look_at: Vec3) -> Subject:
    """Return what a named place shows: the point that it looks at [m]."""
    return Subject(name, SubjectKind.PLACE, (look_at,))


def furniture_subject(name: str, solids: tuple[Solid, ...], room: Room) -> Subject:
    """Return a thing that consists of these solids, at least one, in a room."""
    low, high = _extent(solids)
    x, y, z = ((a + b) / 2 for a, b in zip(low, high, strict=True))
    half = [_SHRUNK * (b - a) / 2 for a, b in zip(low, high, strict=True)]
    corners = tuple(
        (x + sx * half[0], y + sy * half[1], z + sz * half[2])
        for sx, sy, sz in product((-1, 1), repeat=3)
    )
    # A window lies in its wall: a wall around its middle does not hide it.
    walls = (one for one in room.solids if one.thing in BUILDING_PARTS)
    around = (wall for wall in walls if _holds((wall,), (x, y, z)))
    own = frozenset(solid.name for solid in (*solids, *around))
    return Subject(name, SubjectKind.THING, ((x, y, z), *corners), solids[0].yaw, own)


def small_subject(name: str, position: Vec3, room: Room) -> Subject:
    """Return a thing known by its position [m]; what it lies in or on does not hide it."""
    x, y, z = position
    points = (position, (x, y, z + _SPREAD), (x - _SPREAD, y, z), (x + _SPREAD, y, z))
    holder = _holder(position, room)
    own = frozenset(solid.name for solid in holder)
    return Subject(name, SubjectKind.THING, points, holder[0].yaw if holder else None, own)


def person_subject(
    name: str, position: Vec3, room: Room, posture: str = "", facing: float | None = None
) -> Subject:
    """Return somebody at a position [m], tracked at the head or at the feet.

    Args:
        name: in words.
        position: world [m].
        room: what they sit or lie on does not hide them.
        posture: standing, walking, sitting, lying, or "" when unknown.
        facing: where they face [rad], None when unknown.
    """
    x, y, z = position
    holder = _holder((x, y, 0.4), room) if posture in ("sitting", "lying") else ()
    if posture == "lying":
        low = _top(holder, x, y)
        points: tuple[Vec3, ...] = tuple((x, y, low + height) for height in _LYING)
    elif posture == "sitting":
        points = tuple((x, y, height) for height in _SITTING)
    elif z > _UPRIGHT_FROM:
        points = ((x, y, z), (x, y, 0.75 * z), (x, y, 0.55 * z))
    else:
        points = tuple((x, y, height) for height in _STANDING)
    own = frozenset(solid.name for solid in holder)
    return Subject(name, SubjectKind.PERSON, points, facing, own)


def _top(holder: tuple[Solid, ...], x: float, y: float) -> float:
    """Return the height of the middle of what somebody lies on [m]; 0 for the floor."""
    under = (one for one in holder if distance(one.position[:2], (x, y)) < max(one.size[:2]) / 2)
    tops = sorted(one.position[2] + one.size[2] / 2 for one in under)
    return tops[len(tops) // 2] if tops else 0.0


def pieces_of(solids: tuple[Solid, ...]) -> tuple[tuple[Solid, ...], ...]:
    """Return solids that stand together as one piece each: five chairs are five pieces."""
    pieces: list[tuple[Solid, ...]] = []
    for solid in solids:
        near = [piece for piece in pieces if _are_near(piece, (solid,))]
        pieces = [piece for piece in pieces if piece not in near]
        pieces.append((*(one for piece in near for one in piece), solid))
    return tuple(pieces)


def _holder(position: Vec3, room: Room) -> tuple[Solid, ...]:
    """Return the solids of the furniture that a position [m] lies in or on."""
    things: dict[str, list[Solid]] = {}
    for solid in room.solids:
        if solid.collides and solid.thing not in BUILDING_PARTS:
            things.setdefault(solid.thing, []).append(solid)
    pieces = (piece for solids in things.values() for piece in pieces_of(tuple(solids)))
    return min((piece for piece in pieces if _holds(piece, position)), key=_area, default=())


def _holds(solids: tuple[Solid, ...], position: Vec3) -> bool:
    low, high = _extent(solids)
    return all(
        a - _WITHIN <= value <= b + _WITHIN for a, value, b in zip(low, position, high, strict=True)
    )


def _are_near(one: tuple[Solid, ...], other: tuple[Solid, ...]) -> bool:
    """Return whether the boxes around two pieces nearly touch."""
    (low, high), (bottom, top) = _extent(one), _extent(other)
    return all(
        a - _WITHIN <= d and c <= b + _WITHIN
        for a, b, c, d in zip(low, high, bottom, top, strict=True)
    )


def _area(solids: tuple[Solid, ...]) -> float:
    (x0, y0, _), (x1, y1, _) = _extent(solids)
    return (x1 - x0) * (y1 - y0)


def _extent(solids: tuple[Solid, ...]) -> tuple[Vec3, Vec3]:
    """Return the corners of the upright box around solids, along the world's axes [m]."""
    corners: list[Vec2] = [corner for solid in solids for corner in outline(solid)]
    xs, ys = zip(*corners, strict=True)
    bottom = min(solid.position[2] - solid.size[2] / 2 for solid in solids)
    top = max(solid.position[2] + solid.size[2] / 2 for solid in solids)
    return (min(xs), min(ys), bottom), (max(xs), max(ys), top)
