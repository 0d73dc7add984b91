"""Computes where to hover to see a subject: in sight, in the picture, near, and away from people.

Every free cell of the map around the subject that the drone can reach is weighed. What is cheap is
weighed first; lines of sight are cast for the best only, until no other cell can be better.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import atan2, cos, hypot

import numpy as np

from housefly.errors import TaskError
from housefly.geometry import Vec2, Vec3, distance
from housefly.messages import Obstacle
from housefly.messages.words import UNSAID, Words, figure, joined
from housefly.numeric import FloatArray, elementwise, norm
from housefly.room.reach import Mask
from housefly.room.sight import in_sight
from housefly.tasks.api.values import ReasonCode
from housefly.tasks.vantage.subject import Subject, SubjectKind
from housefly.tasks.vantage.viewing_room import ReachableMap, ViewingRoom
from housefly.tasks.vantage.viewpoint import Viewpoint

_VIEW_RANGE = 5.0
"""Nothing is looked at from farther away [m]."""
_BEST_DISTANCE = 2.0
"""A picture is best from here, or from where all of the subject is in it [m]."""
_STAY_RANGE = 4.0
"""Whom the drone sees from where it is already, it sees well enough up to here [m]."""
_SHARE_MIN = 0.5
"""A view shows at least this share of the subject's points, and the one that is faced."""
_OWN_RADIUS = 0.4
"""An obstacle whose edge is so near to the subject is the subject [m]."""
_ASKED_MAX = 12
"""Who is in the way is looked for among so many obstacles."""
_BATCH = 48
"""Lines of sight are cast for so many cells at a time."""

# Worth of each quality, all from 0 to 1.
_SEEN = 3.0
_NEAR = 2.0
_FRONT = 0.8
_CLEAR = 0.5
_SHORT = 1.5
_LANDABLE = 1.0
"""Clear floor below: whatever happens there, the drone comes down on nothing."""
_CLEAR_ENOUGH = 1.0
"""More clearance than this is worth nothing [m]."""
_LONG_WAY = 15.0
"""A way of this length or more is worth nothing [m]."""


def find_viewpoint(
    viewing: ViewingRoom,
    subject: Subject,
    drone: Vec3 | None = None,
    obstacles: Iterable[Obstacle] = (),
    now: float = 0.0,
) -> Viewpoint:
    """Return where to hover to see a subject, keeping the comfort distance where there is room.

    Args:
        viewing: the room.
        subject: what is to be seen.
        drone: where the drone is; of equal viewpoints the nearer one is taken [m]. None: at home.
        obstacles: people and things that no map shows.
        now: time [s], for their ages.

    Raises:
        TaskError: NO_VIEW or NO_WAY, in one sentence.
    """
    start = viewing.room.home if drone is None else drone[:2]
    known = tuple(obstacles)
    people = viewing.site.people
    problem = UNSAID
    for kept in (people.comfort_distance, people.min_distance):
        there = viewing.reachable(start, known, kept, now)
        found = _best(viewing, there, subject, known)
        if isinstance(found, Viewpoint):
            return found
        problem = found
    if isinstance(_best(viewing, there.everywhere(), subject, known), Viewpoint):
        words = Words("there is no free way to where {name} can be seen from", name=subject.name)
        if who := _who_is_in_the_way(viewing, subject, start, known, now):
            words = joined(": ", (words, Words("{who} is in the way", who=who)))
        raise TaskError(words, ReasonCode.NO_WAY.value)
    raise TaskError(problem, ReasonCode.NO_VIEW.value)


def viewpoint_at(
    viewing: ViewingRoom, subject: Subject, place: Vec2, obstacles: Iterable[Obstacle] = ()
) -> Viewpoint | None:
    """Return the viewpoint at a place [m] itself, or None when the subject is not seen well there.

    Args:
        viewing: the room.
        subject: what is to be seen.
        place: where the drone hovers, world xy [m].
        obstacles: people and things that no map shows.
    """
    look_at, points = np.array(subject.look_at), np.array(subject.points)
    eyes = viewing.camera.eyes(np.array([[*place, viewing.height]]), look_at)
    away = norm(eyes[0] - look_at)
    hiding = viewing.hiding(subject.own, obstacles, subject.look_at[:2], _OWN_RADIUS)
    seen = viewing.camera.frames(eyes, look_at, points) & in_sight(hiding, eyes, points)
    if away > _STAY_RANGE or not _shows(seen)[0]:
        return None
    words = f"{subject.name} is seen from here, {away:.1f} m away"
    return Viewpoint(subject.name, place, subject.look_at, away, words)


def _who_is_in_the_way(
    viewing: ViewingRoom,
    subject: Subject,
    start: Vec2,
    obstacles: tuple[Obstacle, ...],
    now: float,
) -> str:
    """Return without whom there would be a way; "" when more than one closes it."""
    for one in obstacles[:_ASKED_MAX]:
        others = tuple(each for each in obstacles if each is not one)
        there = viewing.reachable(start, others, viewing.site.people.min_distance, now)
        if isinstance(_best(viewing, there, subject, others), Viewpoint):
            return one.id
    return ""


def is_reachable(
    viewing: ViewingRoom,
    position: Vec2,
    drone: Vec3 | None = None,
    obstacles: Iterable[Obstacle] = (),
    now: float = 0.0,
) -> bool:
    """Return whether the drone can go to a place and hover there now; arguments as above [m]."""
    start = viewing.room.home if drone is None else drone[:2]
    there = viewing.reachable(start, obstacles, viewing.site.people.min_distance, now)
    cell = there.grid.cell_of(position)
    return bool(there.grid.contains(cell) and there.moves[cell] >= 0)


def _best(
    viewing: ViewingRoom, there: ReachableMap, subject: Subject, obstacles: tuple[Obstacle, ...]
) -> Viewpoint | Words:
    """Return the best viewpoint, or why there is none."""
    look_at = np.array(subject.look_at)
    flat, ways = there.open_cells(subject.look_at[:2], _VIEW_RANGE)
    if not len(flat):
        return Words(
            "there is no place within {d} m of {name} where the drone may hover and tracking sees"
            " it",
            d=figure(_VIEW_RANGE, ".0f"),
            name=subject.name,
        )
    places = np.column_stack([flat, np.full(len(flat), viewing.height)])
    eyes, points = viewing.camera.eyes(places, look_at), np.array(subject.points)
    framed = viewing.camera.frames(eyes, look_at, points)
    worth = _cheap_worth(there, subject, flat, ways, eyes)
    worth[~_shows(framed)] = -np.inf
    if not np.isfinite(worth).any():
        return Words(
            "{name} is nowhere in the picture: too near, too high or too low", name=subject.name
        )
    hiding = viewing.hiding(subject.own, obstacles, subject.look_at[:2], _OWN_RADIUS)
    best = _in_best_order(worth, framed, hiding, eyes, points)
    if best < 0:
        return Words(
            "{name} cannot be seen from any place where the drone may hover: something stands in"
            " between",
            name=subject.name,
        )
    return _viewpoint(there, subject, flat[best], eyes[best])


def _in_best_order(
    worth: FloatArray, framed: Mask, hiding: FloatArray, eyes: FloatArray, points: FloatArray
) -> int:
    """Return the cell that is worth most with what is in sight from it; -1 for none."""
    order = np.argsort(-worth, kind="stable")
    order = order[np.isfinite(worth[order])]
    best, most = -1, -np.inf
    for first in range(0, len(order), _BATCH):
        batch = order[first : first + _BATCH]
        if worth[batch[0]] + _SEEN <= most:
            break
        seen = in_sight(hiding, eyes[batch], points) & framed[batch]
        total = np.where(_shows(seen), worth[batch] + _SEEN * seen.mean(axis=1), -np.inf)
        top = int(np.argmax(total))
        if total[top] > most:
            best, most = int(batch[top]), float(total[top])
    return best


def _shows(seen: Mask) -> Mask:
    """Return which rows show enough of the subject."""
    enough: Mask = seen[:, 0] & (seen.mean(axis=1) >= _SHARE_MIN)
    return enough


def _cheap_worth(
    there: ReachableMap, subject: Subject, flat: FloatArray, ways: FloatArray, eyes: FloatArray
) -> FloatArray:
    """Return the worth of places without lines of sight, shape (n,)."""
    away = np.linalg.norm(eyes - np.array(subject.look_at), axis=1)
    worth = _NEAR * np.maximum(0.0, 1.0 - np.abs(away - _BEST_DISTANCE) / _VIEW_RANGE)
    worth += _CLEAR * np.minimum(there.clearances(flat) / _CLEAR_ENOUGH, 1.0)
    worth += _SHORT * np.maximum(0.0, 1.0 - ways / _LONG_WAY)
    worth += _LANDABLE * there.can_land(flat)
    if subject.front is not None:
        x, y = (flat - np.array(subject.look_at[:2])).T
        ahead = elementwise(cos, elementwise(atan2, y, x) - subject.front)
        worth += _FRONT * np.maximum(0.0, ahead)
    result: FloatArray = worth
    return result


def _viewpoint(
    there: ReachableMap, subject: Subject, place: FloatArray, eye: FloatArray
) -> Viewpoint:
    x, y = (round(value, 3) for value in place.tolist())
    ex, ey, ez = eye.tolist()
    away = distance((ex, ey, ez), subject.look_at)
    clear = there.grid.clearance_at((x, y))
    flat = hypot(x - subject.look_at[0], y - subject.look_at[1])
    faces = "faces" if subject.kind is SubjectKind.PERSON else "sees"
    words = f"{faces} {subject.name} from {flat:.1f} m, {clear:.1f} m from anything"
    return Viewpoint(subject.name, (x, y), subject.look_at, away, words)
