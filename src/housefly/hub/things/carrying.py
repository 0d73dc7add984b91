"""What may have become of a carried thing, by the way of who carries it.

No sensor sees a cup put on a table. What can be known is where its carrier went: each visit to a
surface, each time out of sight and the time itself take a share of the belief that they still have
it. The shares are assumptions; how often they mislead is measured (``benchmarks/memory_score.py``).
"""

from __future__ import annotations

from collections import deque
from collections.abc import Container, Iterable, Sequence
from dataclasses import dataclass, replace
from math import hypot

from housefly.geometry import Vec2, Vec3
from housefly.hub.things.hypothesis import Belief, Hypothesis, belief_in
from housefly.hub.things.surfaces import Surface

_REACH, _LEFT_REACH = 0.8, 1.1
"""A surface this close to the middle of a person is within reach of a hand; out of it again [m]."""
_PASSED, _PASSED_TIME = 0.06, 1.0
"""Share of those who walk past a surface, no seat, that leave a thing there; their time [s]."""
_STOPPED = 0.4
"""Share of those who stop within reach of surfaces that leave a thing on one of them."""
_SEAT_WEIGHT = 0.2
"""How likely somebody leaves a thing on a seat, against a table."""
_STOP_SPEED, _SPEED_WINDOW = 0.5, 0.6
"""Whoever is slower than this [m/s] over this time [s] stops."""
_OUT_OF_SIGHT_AFTER = 2.0
"""A carrier who was not seen for this long is out of sight [s]."""
_OUT_OF_SIGHT_TIME, _ANYWHERE_TIME = 60.0, 1800.0
"""After these times half have left it elsewhere: out of sight, and anywhere at all [s]."""
_MAX_VISITS = 1000
"""After so many visits nobody can say where it is; further ones are not kept."""


@dataclass(slots=True)
class _Visit:
    """One stay within reach of a thing with surfaces: since when [s, Unix time], where."""

    since: float
    position: Vec3
    share: float = 0.0


class Carrying:
    """Follows one carried thing.

    Args:
        carrier: id of who carries it.
        since: when they took it [s, Unix time].
        surfaces: where they may leave it.
    """

    def __init__(self, carrier: str, since: float, surfaces: Sequence[Surface]) -> None:
        self.carrier, self.since = carrier, since
        self._surfaces = surfaces
        self._open: dict[str, _Visit] = {}
        self._visits: list[tuple[Surface, _Visit]] = []
        self._unseen = 0.0
        self._last: float | None = None
        self._way: deque[tuple[float, Vec2]] = deque()

    def add(self, at: float, position: Sequence[float]) -> None:
        """Add where the carrier is [m] at a time [s, Unix time]; older ones are ignored."""
        if at < self.since or (self._last is not None and at <= self._last):
            return
        self._unseen += self._gap(at)
        self._last = at
        point = (float(position[0]), float(position[1]))
        self._way.append((at, point))
        while len(self._way) > 2 and self._way[1][0] <= at - _SPEED_WINDOW:
            self._way.popleft()
        self._visit(at, point)

    def belief(self, now: float) -> Belief:
        """Return how sure it is that the carrier still has it [s, Unix time]."""
        held = 1.0
        lost: dict[str, Hypothesis] = {}
        for surface, visit in self._visits:
            share = held * visit.share
            held -= share
            before = lost[surface.thing].confidence if surface.thing in lost else 0.0
            words = f"left on {with_article(surface.name)}"
            lost[surface.thing] = Hypothesis(words, surface.thing, visit.position, before + share)
        unseen = self._unseen + self._gap(now)
        kept = 0.5 ** (unseen / _OUT_OF_SIGHT_TIME + max(0.0, now - self.since) / _ANYWHERE_TIME)
        others = (replace(one, confidence=kept * one.confidence) for one in lost.values())
        return belief_in(kept * held, others)

    def _gap(self, now: float) -> float:
        """Return how long the carrier has been out of sight until now [s]."""
        silent = now - (self.since if self._last is None else self._last)
        return silent if silent > _OUT_OF_SIGHT_AFTER else 0.0

    def _visit(self, at: float, point: Vec2) -> None:
        stopped = self._is_stopped()
        near = _within_reach(self._surfaces, point, self._open)
        total = sum(_LEFT_REACH - away for away, _ in near.values()) or 1.0
        self._open = {thing: visit for thing, visit in self._open.items() if thing in near}
        for thing, (away, surface) in near.items():
            visit = self._open.get(thing)
            if visit is None:
                visit = self._open[thing] = _Visit(at, surface.nearest(point))
                if len(self._visits) < _MAX_VISITS:
                    self._visits.append((surface, visit))
            passed = _PASSED * min(1.0, (at - visit.since) / _PASSED_TIME) * (not surface.seat)
            chosen = (_LEFT_REACH - away) / total * (_SEAT_WEIGHT if surface.seat else 1.0)
            share = chosen * (_STOPPED if stopped else passed)
            if share > visit.share:
                visit.share, visit.position = share, surface.nearest(point)

    def _is_stopped(self) -> bool:
        (begin, (x0, y0)), (end, (x1, y1)) = self._way[0], self._way[-1]
        enough = end - begin >= 0.9 * _SPEED_WINDOW
        return enough and hypot(x1 - x0, y1 - y0) < _STOP_SPEED * (end - begin)


def with_article(name: str) -> str:
    """Return a name with its article: "the sofa table"."""
    return name if name.startswith(("the ", "a ", "an ")) else f"the {name}"


def _within_reach(
    surfaces: Iterable[Surface], point: Vec2, before: Container[str]
) -> dict[str, tuple[float, Surface]]:
    """Return the surfaces within reach by thing, of each the nearest, and its distance [m].

    What was within reach before stays so a little longer, or noise would make many visits of one.
    """
    found: dict[str, tuple[float, Surface]] = {}
    for surface in surfaces:
        away = surface.distance(point)
        limit = _LEFT_REACH if surface.thing in before else _REACH
        if away <= limit and (surface.thing not in found or away < found[surface.thing][0]):
            found[surface.thing] = away, surface
    return found
