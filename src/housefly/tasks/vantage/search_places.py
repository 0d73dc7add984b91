"""Where a thing may be: what the memory says, and, for what it does not know, everywhere.

The memory names places with how sure it is of each. It may be wrong, and it grows old: a share of
the belief, more with the time, is spread over all that the room has to lay things on.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache
from math import cos, exp, exp2, isfinite, sin

import numpy as np

from housefly.geometry import Vec2, Vec3
from housefly.hub.api.answers import WhereAnswer
from housefly.hub.things.carrying import with_article
from housefly.hub.things.surfaces import Surface
from housefly.hub.things_of_room import surfaces_of
from housefly.numeric import FloatArray, elementwise, running_sum
from housefly.room.grid import Cell
from housefly.tasks.execution.task_room import SeenPerson
from housefly.tasks.vantage.camera_views import lattice
from housefly.tasks.vantage.search_belief import IntArray, SearchBelief
from housefly.tasks.vantage.viewing_room import ViewingRoom

_POINT_EDGE = 0.3
"""A top is looked at in points about so far apart [m] ..."""
_ABOVE = 0.05
"""... and a thing that lies on it is seen so high above it [m]."""
_FLOOR_EDGE = 0.4
_ANYWHERE = 0.15
"""The memory is wrong so often, even of what it has just been told ..."""
_HALF_MOVED = 86_400.0
"""... and of half of what nobody has seen for so long [s]."""
_SPREAD = 0.4
"""A thing lies about so far from where the memory has it [m]."""
_HIDDEN = 0.1
"""Of what the memory does not know, this share is in drawers, bags and pockets, or gone."""
_EXACT = 0.5
"""Share of what the memory says that stays at the very point; the rest is around it."""
_TABLE, _SEAT, _FLOOR = 5.0, 2.0, 1.0
"""How often lost things lie on a square metre of each, in proportion: an assumption."""
_HANDS = 1.0
"""Height at which people carry things [m]."""
_FLOOR_WORDS = "the floor"


@dataclass(frozen=True, slots=True, eq=False)
class LayingPlaces:
    """All that a room has to lay things on, in points.

    Attributes:
        points: world [m], shape (n, 3).
        weight: how often a lost thing lies at each, sum 1, shape (n,).
        place: index of each point's place, shape (n,).
        places: what people call them, "the floor" last.
        things: the id of each, "" for the floor.
    """

    points: FloatArray
    weight: FloatArray
    place: IntArray
    places: tuple[str, ...]
    things: tuple[str, ...]


@lru_cache(maxsize=4)
def _laying_places(viewing: ViewingRoom) -> LayingPlaces:
    """Return all that a room has to lay things on: tops of furniture, and the floor."""
    surfaces = surfaces_of(viewing.room)
    names = {surface.thing: with_article(surface.name) for surface in surfaces}
    things = (*names, "")
    points, weight, place = list[Vec3](), list[float](), list[int]()
    for surface in surfaces:
        tops = _points_on(surface)
        area = 4.0 * surface.half[0] * surface.half[1]
        points += tops
        weight += [(_SEAT if surface.seat else _TABLE) * area / len(tops)] * len(tops)
        place += [things.index(surface.thing)] * len(tops)
    for x, y in _floor_places(viewing):
        points.append((x, y, _ABOVE))
        weight.append(_FLOOR * _FLOOR_EDGE**2)
        place.append(len(things) - 1)
    shares = np.array(weight) / max(running_sum(weight), 1e-9)
    shape = np.array(points, dtype=np.float64).reshape(-1, 3)
    return LayingPlaces(shape, shares, np.array(place), (*names.values(), _FLOOR_WORDS), things)


def belief_of(
    answer: WhereAnswer | None, viewing: ViewingRoom, people: Iterable[SeenPerson] = ()
) -> SearchBelief:
    """Return where a thing may be.

    Args:
        answer: what the memory says of it; None when it knows nothing.
        viewing: the room.
        people: who is seen now; what somebody carries is with them.
    """
    lying = _laying_places(viewing)
    hints = () if answer is None else _hints(answer, {one.id: one for one in people})
    known = running_sum(hint.share for hint in hints)
    points, chance = [lying.points], (1.0 - known) * (1.0 - _HIDDEN) * lying.weight
    place, places = [lying.place], list(lying.places)
    own = list[float]()
    for hint in hints:
        around = hint.share * (1.0 - _EXACT) * _around(hint, lying)
        chance = chance + around
        own.append(hint.share - float(around.sum()))
        points.append(np.array([hint.position]))
        place.append(np.array([_place_index(hint, lying, places)]))
    probability = np.concatenate([chance, own])
    return SearchBelief(
        np.concatenate(points),
        probability / max(1.0, float(probability.sum())),
        np.concatenate(place).astype(np.int_),
        tuple(places),
    )


@dataclass(frozen=True, slots=True)
class _Hint:
    """One place that the memory names: how likely it is, where [m], on or in which thing."""

    share: float
    position: Vec3
    thing: str
    words: str
    is_exact: bool = False


def _hints(answer: WhereAnswer, people: dict[str, SeenPerson]) -> tuple[_Hint, ...]:
    age = answer.age or 0.0
    trust = (1.0 - _ANYWHERE) * exp2(-max(0.0, age) / _HALF_MOVED)
    holder = answer.inside[0] if answer.inside else ""
    first = "where it was last" if not holder else f"in or on {with_article(holder)}"
    named = [(answer.confidence, answer.position, holder, first)]
    named += [(o.confidence, o.position, o.thing, o.words) for o in answer.alternatives]
    total = max(1.0, running_sum(share for share, *_ in named))
    found = []
    for share, position, thing, words in named:
        carrier = people.get(thing)
        if carrier is not None:
            at = (*carrier.position[:2], _HANDS)
            found.append(_Hint(trust * share / total, at, thing, f"with {thing}", True))
        elif position is not None and all(map(isfinite, position)):
            found.append(_Hint(trust * share / total, position, thing, words, bool(answer.inside)))
    return tuple(hint for hint in found if hint.share > 0.0)


def _around(hint: _Hint, lying: LayingPlaces) -> FloatArray:
    """Return the shares of the points around a hint, sum 1, or 0 when it has none."""
    away = np.linalg.norm(lying.points[:, :2] - np.array(hint.position[:2]), axis=1)
    near = elementwise(exp, -0.5 * (away / _SPREAD) ** 2) * (away < 3.0 * _SPREAD)
    if hint.thing in lying.things[:-1]:
        near = near * (lying.place == lying.things.index(hint.thing))
    total = float(near.sum())
    result: FloatArray = near / total if total > exp(-4.5) and not hint.is_exact else 0.0 * near
    return result


def _place_index(hint: _Hint, lying: LayingPlaces, places: list[str]) -> int:
    if hint.thing in lying.things[:-1] and not hint.is_exact:
        return lying.things.index(hint.thing)
    if hint.words not in places:
        places.append(hint.words)
    return places.index(hint.words)


def _points_on(surface: Surface) -> list[Vec3]:
    """Return points on a top, inside its edge [m]."""
    c, s = cos(surface.yaw), sin(surface.yaw)
    spans = [_span(half) for half in surface.half]
    found = []
    for along in spans[0]:
        for across in spans[1]:
            if surface.disc and np.hypot(along, across) > surface.half[0]:
                continue
            x = surface.centre[0] + along * c - across * s
            y = surface.centre[1] + along * s + across * c
            found.append((float(x), float(y), surface.top + _ABOVE))
    return found or [(*surface.centre, surface.top + _ABOVE)]


def _span(half: float) -> FloatArray:
    count = max(1, round(2.0 * half / _POINT_EDGE))
    middles: FloatArray = (np.arange(count) + 0.5) / count * 2.0 * half - half
    return middles


def _floor_places(viewing: ViewingRoom) -> list[Vec2]:
    """Return points of the floor on which nothing stands [m]."""
    grid = viewing.grid
    open_floor = (grid.cells != Cell.OUTSIDE) & (grid.cells != Cell.OCCUPIED)
    return [(x, y) for x, y in lattice(grid, open_floor, _FLOOR_EDGE).tolist()]
