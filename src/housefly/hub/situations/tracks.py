"""Where people are and how fast they move, by each source that sees them."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass
from math import hypot, isfinite

from housefly.geometry import Vec2, Vec3
from housefly.hub.situations.situation import Item, fact, number
from housefly.hub.situations.trust import KNOWN, trust
from housefly.messages import Observation

HEARTBEAT = 1.0
"""A source that tracks people speaks at least this often [s]."""
UNSEEN = 2.0
"""Who is not seen for longer by a source that speaks is out of its sight [s]."""
MEMORY = 6.0
"""Positions are kept for this long [s], so that it can be said who was near when something happened
a moment ago.
"""
WINDOW = 1.2
"""Speeds are taken over this long [s]."""
SHORTEST = 0.8
"""And never over less [s]: noise would walk."""
THINNEST = 0.04
"""Positions closer in time than this are left out [s]: a fast source says no more about a walk."""
SIGMA = 0.05
"""One-sigma error of a position whose source does not say it [m]."""
MOST = 200
"""So many tracks are kept; the one longest unseen goes first."""


@dataclass(frozen=True, slots=True)
class Seen:
    """One position of a person.

    Attributes:
        at: when [s, Unix time].
        position: world [m].
        sigma: one-sigma error [m].
        head: height of the head above the floor [m], None when unknown.
    """

    at: float
    position: Vec3
    sigma: float
    head: float | None


class Track:
    """One person as one source sees them.

    Attributes:
        person: id.
        source: id.
        since: when they came into its sight [s, Unix time].
    """

    def __init__(self, person: str, source: str) -> None:
        self.person, self.source = person, source
        self.since = 0.0
        self._seen: deque[Seen] = deque()

    @property
    def last(self) -> Seen:
        """The newest position."""
        return self._seen[-1]

    def add(self, seen: Seen) -> None:
        """Add a position; times do not run backwards."""
        if not self._seen or seen.at - self.last.at > UNSEEN:
            self.since = seen.at
            self._seen.clear()
        elif seen.at - self.last.at < THINNEST:
            return
        self._seen.append(seen)
        while self._seen[0].at < seen.at - MEMORY:
            self._seen.popleft()

    def at(self, time: float) -> Seen:
        """Return the position nearest to a time [s, Unix time], of those still kept."""
        return min(self._seen, key=lambda seen: abs(seen.at - time))

    def speed(self) -> float | None:
        """Return the speed over the floor [m/s]: the way between the means of two half windows;
        None when too little is seen.
        """
        recent = sum(seen.at >= self.last.at - WINDOW for seen in self._seen)
        window = list(self._seen)[-recent:]
        if self.last.at - window[0].at < SHORTEST:
            window = list(self._seen)[-recent - 1 :]
        middle = len(window) // 2
        if middle == 0 or window[-1].at - window[0].at < SHORTEST:
            return None
        (t0, x0, y0), (t1, x1, y1) = _mean(window[:middle]), _mean(window[middle:])
        return hypot(x1 - x0, y1 - y0) / (t1 - t0)


class Tracks:
    """All people as all sources see them.

    Args:
        people: ids of people, for sources that do not say what a thing is.
    """

    def __init__(self, people: frozenset[str] = frozenset()) -> None:
        self._known = people
        self._tracks: dict[tuple[str, str], Track] = {}
        self._heard: dict[str, float] = {}

    def take(self, item: Item) -> None:
        """Take what a source says; an invalid position is a sign of its life and no more."""
        if not isinstance(item, Observation):
            return
        self._heard[item.source] = item.captured_at
        if item.position is None or not item.valid or item.inside or not self.is_person(item):
            return
        key = item.thing, item.source
        if key not in self._tracks and len(self._tracks) >= MOST:
            del self._tracks[min(self._tracks, key=lambda old: self._tracks[old].last.at)]
        variance = item.covariance[0] if item.covariance else SIGMA**2
        sigma = variance**0.5 if isfinite(variance) and variance > 0.0 else SIGMA
        seen = Seen(item.captured_at, item.position, sigma, number(item, "head"))
        self._tracks.setdefault(key, Track(*key)).add(seen)

    def is_person(self, item: Item) -> bool:
        """Tell whether an item is about a person: its source says so, or the layout does."""
        return fact(item, "kind") == "person" or item.thing in self._known

    def people(self) -> tuple[str, ...]:
        """Return everybody who was ever seen, in order of names."""
        return tuple(sorted({person for person, _ in self._tracks}))

    def trusted(self, track: Track, now: float) -> float:
        """Return how far the last position is believed at a time [s], 0 to 1; 0 if the source
        speaks without seeing them.
        """
        return 0.0 if self.out_of_sight(track) else trust(now - track.last.at, HEARTBEAT)

    def out_of_sight(self, track: Track) -> bool:
        """Tell whether the source has spoken since without seeing them."""
        return self._heard.get(track.source, 0.0) - track.last.at > UNSEEN

    def speaks(self, source: str, now: float) -> bool:
        """Tell whether a source was heard lately."""
        return trust(now - self._heard.get(source, float("-inf")), HEARTBEAT) >= KNOWN

    def best(self, person: str, now: float) -> Track | None:
        """Return the most exact track among those that are believed, None when there is none."""
        known = [track for track in self.of(person) if self.trusted(track, now) >= KNOWN]
        return min(
            known,
            key=lambda track: (-self.trusted(track, now), track.last.sigma, track.source),
            default=None,
        )

    def latest(self, person: str) -> Track | None:
        """Return the track that was seen last, however long ago."""
        return max(self.of(person), key=lambda track: (track.last.at, track.source), default=None)

    def of(self, person: str) -> tuple[Track, ...]:
        """Return the tracks of a person."""
        return tuple(track for (name, _), track in self._tracks.items() if name == person)

    def distances(
        self, point: tuple[float, ...], time: float
    ) -> Iterator[tuple[float, str, float]]:
        """Yield distance over the floor [m], id and trust of everybody who was seen around a time
        [s, Unix time].
        """
        for person in self.people():
            seen = [
                (abs(track.at(time).at - time), track.source, track.at(time))
                for track in self.of(person)
            ]
            age, _, nearest = min(seen, key=lambda row: (row[0], row[2].sigma, row[1]))
            believed = trust(age, HEARTBEAT)
            if believed >= KNOWN:
                yield (
                    hypot(nearest.position[0] - point[0], nearest.position[1] - point[1]),
                    person,
                    believed,
                )


def _mean(part: list[Seen]) -> tuple[float, float, float]:
    count = len(part)
    times, xs, ys = (
        sum(column) / count
        for column in zip(*((s.at, *_plane(s.position)) for s in part), strict=True)
    )
    return times, xs, ys


def _plane(position: Vec3) -> Vec2:
    return position[0], position[1]
