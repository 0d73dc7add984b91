"""One search for one thing: which look is next, and what the looks so far leave."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from math import cos, sin, tan

import numpy as np

from housefly.geometry import Vec2, Vec3, distance
from housefly.messages import Obstacle
from housefly.numeric import FloatArray, elementwise
from housefly.pilot.planning.dijkstra import UNREACHED, distances
from housefly.room.grid import Cell
from housefly.room.level_camera import LevelCamera
from housefly.tasks.vantage.camera_views import camera_views
from housefly.tasks.vantage.search_belief import SearchBelief
from housefly.tasks.vantage.search_order import chosen_looks, soonest_order
from housefly.tasks.vantage.viewing_room import ViewingRoom
from housefly.tasks.vantage.viewpoint import Viewpoint

_LOOKED = 0.5
"""A place of which the looks would have found so much was looked at."""
_NAMED = 0.15
"""A place that a look is for has at least this share of what it may find."""
_PLACES_NAMED = 2

_HALF_RECOGNISED = 4.0
"""Line pairs across a target with which half of all observers recognise it (Johnson 1958)."""
_ATTENTION = 0.9
"""Share of what can be recognised in a picture that whoever looks at it notices."""
_THING_SIZE = 0.1
"""A cup, glasses or a bunch of keys [m]."""


@dataclass(frozen=True, slots=True)
class SearchLook:
    """One look of a search.

    Attributes:
        row: which of the search's looks.
        view: where to hover and what to face.
        chance: that it shows the thing, 0 to 1.
        places: what it looks at, the likeliest first.
    """

    row: int
    view: Viewpoint
    chance: float
    places: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class SearchSummary:
    """What became of a search.

    Attributes:
        looked: places that pictures showed well.
        left: other places where it may be, the likeliest first, with the probability that they had
            at the beginning.
        covered: probability with which the pictures taken would have shown it, 0 to 1.
        answered: the same of the pictures that somebody looked at.
    """

    looked: tuple[str, ...]
    left: tuple[tuple[str, float], ...]
    covered: float
    answered: float


class ThingSearch:
    """Plans the looks of one search, anew after each of them; pure but for its own memory.

    Args:
        viewing: the room.
        belief: where the thing may be.
        drone: where the drone is [m]; None is at home.
        obstacles: people and things that no map shows.
        now: time of the obstacles [s].
        look_time: what each look takes beside the way to it [s].
    """

    def __init__(
        self,
        viewing: ViewingRoom,
        belief: SearchBelief,
        drone: Vec3 | None = None,
        obstacles: Iterable[Obstacle] = (),
        now: float = 0.0,
        look_time: float = 10.0,
    ) -> None:
        known = tuple(obstacles)
        start = viewing.room.home if drone is None else drone[:2]
        there = viewing.reachable(start, known, viewing.site.people.comfort_distance, now)
        self._viewing, self._look_time = viewing, look_time
        self._grid, self._free = there.grid, (there.grid.cells == Cell.FREE) & there.free
        self._first, self._now = belief, belief
        self._views = camera_views(viewing, there, belief.points, known)
        self._detection = np.zeros(self._views.shown.shape)
        self._detection[self._views.shown] = detection_probability(
            viewing.camera, self._distances()
        )
        self._missed = np.ones(len(belief.points))
        self._unanswered = np.ones(len(belief.points))

    @property
    def belief(self) -> SearchBelief:
        """Where the thing may be, after all looks so far."""
        return self._now

    def looks(
        self, drone: Vec3 | None = None, least: float = 0.03, budget: float = np.inf
    ) -> tuple[SearchLook, ...]:
        """Return the looks that are still worth a flight, in the order that finds it soonest.

        Args:
            drone: where the drone is [m]; None is at home.
            least: a look that would show it with less probability than this is not flown.
            budget: longest time of all of them [s].
        """
        start = self._viewing.room.home if drone is None else drone[:2]
        chance = self._now.probability

        def times_from(row: int) -> FloatArray:
            return self._times(start if row < 0 else _point(self._views.places[row]))

        rows = chosen_looks(chance, self._detection, times_from, least, budget)
        if not rows:
            return ()
        times = np.array([times_from(row)[list(rows)] for row in (-1, *rows)])
        order = soonest_order(chance, self._detection[list(rows)], times)
        left, found = chance, list[SearchLook]()
        for row in (rows[n] for n in order):
            found.append(self._look(row, left))
            left = left * (1.0 - self._detection[row])
        return tuple(found)

    def was_shown(self, look: SearchLook, *, nothing: bool) -> None:
        """Note that a picture was taken; ``nothing``: somebody looked at it and saw nothing.

        No look is flown twice, whoever answers: a second picture would show the same.
        """
        detection = self._detection[look.row].copy()
        self._detection[look.row] = 0.0
        self._now = self._now.after_nothing(detection)
        self._missed = self._missed * (1.0 - detection)
        if nothing:
            self._unanswered = self._unanswered * (1.0 - detection)

    def leave_out(self, look: SearchLook) -> None:
        """Note that the drone cannot get to where a look is flown from."""
        at = self._views.places[look.row]
        self._detection[np.all(self._views.places == at, axis=1)] = 0.0

    def summary(self) -> SearchSummary:
        """Return what was looked at, and what was not."""
        chance, before = self._first.probability, self._first.of_places()
        caught = np.bincount(
            self._first.place, weights=chance * (1.0 - self._missed), minlength=len(before)
        )
        shares = caught / np.maximum(before, 1e-12)
        order = [int(n) for n in np.argsort(-before, kind="stable") if before[n] > 0.0]
        names = self._first.places
        return SearchSummary(
            tuple(names[n] for n in order if shares[n] >= _LOOKED),
            tuple((names[n], float(before[n])) for n in order if shares[n] < _LOOKED),
            float(caught.sum()),
            float((chance * (1.0 - self._unanswered)).sum()),
        )

    def _distances(self) -> FloatArray:
        """Return the distance of each point from each view that shows it [m], shape (n,)."""
        view, point = np.nonzero(self._views.shown)
        places, points = self._views.places[view], self._views.points[point]
        flat = np.linalg.norm(places - points[:, :2], axis=1)
        away: FloatArray = np.hypot(flat, points[:, 2] - self._viewing.height)
        return away

    def _times(self, place: Vec2) -> FloatArray:
        """Return the time from a place [m] to each look and through it [s]; inf without a way."""
        cell = self._grid.cell_of(place)
        if not self._grid.contains(cell):
            return np.full(len(self._views.places), np.inf)
        moves = distances(self._free, cell)
        origin, edge = np.array(self._grid.origin), self._grid.resolution
        index = np.floor((self._views.places - origin) / edge).astype(int)
        steps = moves[index[:, 0], index[:, 1]].astype(np.float64)
        ways = np.where(steps == UNREACHED, np.inf, steps * edge)
        times: FloatArray = ways / self._viewing.site.limits.speed + self._look_time
        return times

    def _look(self, row: int, left: FloatArray) -> SearchLook:
        x, y = _point(self._views.places[row])
        heading = float(self._views.headings[row])
        caught = left * self._detection[row]
        total = float(caught.sum())
        shares = np.bincount(self._now.place, weights=caught, minlength=len(self._now.places))
        order = [int(n) for n in np.argsort(-shares, kind="stable")][:_PLACES_NAMED]
        places = tuple(self._now.places[n] for n in order if shares[n] >= _NAMED * total)
        mx, my, mz = (np.einsum("n,nk->k", caught, self._views.points) / total).tolist()
        away = max(1.0, distance((x, y), (mx, my)))
        look_at = (round(x + away * cos(heading), 3), round(y + away * sin(heading), 3), mz)
        name = " and ".join(places)
        view = Viewpoint(name, (x, y), look_at, away, f"may show it with {100.0 * total:.0f} %")
        return SearchLook(row, view, total, places)


def _point(row: FloatArray) -> Vec2:
    x, y = (round(value, 3) for value in row.tolist())
    return x, y


def detection_probability(
    camera: LevelCamera, distances: FloatArray, size: float = _THING_SIZE
) -> FloatArray:
    """Return the probability that a thing in the picture is noticed, by its distance.

    Args:
        camera: of the drone.
        distances: from the camera [m], any shape.
        size: of the thing [m].

    Returns:
        The same shape, 0 to 1, falling with the distance.
    """
    per_metre = camera.pixels / (2.0 * tan(camera.width / 2.0))
    pairs = 0.5 * size * per_metre / np.maximum(distances, 0.1) / _HALF_RECOGNISED
    raised = elementwise(math.pow, pairs, 2.7 + 0.7 * pairs)
    result: FloatArray = _ATTENTION * raised / (1.0 + raised)
    return result
