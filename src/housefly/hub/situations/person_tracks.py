"""Positions and speeds of people, by each source that sees them."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass
from math import hypot, isfinite

from housefly.geometry import Vec2, Vec3
from housefly.hub.situations.confidence import KNOWN_THRESHOLD, freshness
from housefly.hub.situations.situation import DetectorInput, fact, number
from housefly.messages import Observation

TRACK_HEARTBEAT = 1.0
"""Longest time between two messages of a source that tracks people [s]."""
OUT_OF_SIGHT_AFTER = 2.0
"""A person whom a live source has not seen for this long is out of its sight [s]."""
_MEMORY = 6.0
"""How long positions are kept [s], to find out who was near when something happened."""
SPEED_WINDOW = 1.2
"""Time over which a speed is measured [s]."""
_MIN_SPEED_WINDOW = 0.8
"""Shortest time over which a speed is measured [s]: noise would walk."""
_MIN_SPACING = 0.04
"""Positions closer in time than this are skipped [s]: they add nothing to a speed."""
_DEFAULT_SIGMA = 0.05
"""One-sigma error of a position without a covariance [m]."""
MAX_TRACKS = 200
"""At most this many tracks are kept; the one unseen for longest is dropped."""


@dataclass(frozen=True, slots=True)
class _TrackPoint:
    """One position of a person.

    Attributes:
        at: when [s, Unix time].
        position: world [m].
        sigma: one-sigma error [m].
        head: height of the head above the floor [m], None when unknown.
        extent: over what length they touch the floor [m], None when unknown.
    """

    at: float
    position: Vec3
    sigma: float
    head: float | None
    extent: float | None = None


class PersonTrack:
    """One person as one source sees them.

    Attributes:
        person: id.
        source: id.
        since: when they came into its sight [s, Unix time].
    """

    def __init__(self, person: str, source: str) -> None:
        self.person, self.source = person, source
        self.since = 0.0
        self._seen: deque[_TrackPoint] = deque()

    @property
    def last(self) -> _TrackPoint:
        """The newest position."""
        return self._seen[-1]

    def add(self, seen: _TrackPoint) -> None:
        """Add a position; times must not run backwards."""
        if not self._seen or seen.at - self.last.at > OUT_OF_SIGHT_AFTER:
            self.since = seen.at
            self._seen.clear()
        elif seen.at - self.last.at < _MIN_SPACING:
            return
        self._seen.append(seen)
        while self._seen[0].at < seen.at - _MEMORY:
            self._seen.popleft()

    def at(self, time: float) -> _TrackPoint:
        """Return the kept position nearest to a time [s, Unix time]."""
        return min(self._seen, key=lambda seen: abs(seen.at - time))

    def speed(self) -> float | None:
        """Return the speed over the floor between two half windows [m/s]; None if unknown."""
        recent = sum(seen.at >= self.last.at - SPEED_WINDOW for seen in self._seen)
        window = list(self._seen)[-recent:]
        if self.last.at - window[0].at < _MIN_SPEED_WINDOW:
            window = list(self._seen)[-recent - 1 :]
        middle = len(window) // 2
        if middle == 0 or window[-1].at - window[0].at < _MIN_SPEED_WINDOW:
            return None
        (t0, x0, y0), (t1, x1, y1) = _mean(window[:middle]), _mean(window[middle:])
        return hypot(x1 - x0, y1 - y0) / (t1 - t0)


class PersonTracks:
    """All people as all sources see them.

    Args:
        people: ids of people, for sources that do not say what a thing is.
    """

    def __init__(self, people: frozenset[str] = frozenset()) -> None:
        self._known = people
        self._tracks: dict[tuple[str, str], PersonTrack] = {}
        self._heard: dict[str, float] = {}

    def add(self, item: DetectorInput) -> None:
        """Add what a source reports; an invalid position only shows that the source is alive."""
        if not isinstance(item, Observation):
            return
        self._heard[item.source] = item.captured_at
        if item.position is None or not item.valid or item.inside or not self.is_person(item):
            return
        key = item.thing, item.source
        if key not in self._tracks and len(self._tracks) >= MAX_TRACKS:
            del self._tracks[min(self._tracks, key=lambda old: self._tracks[old].last.at)]
        variance = item.covariance[0] if item.covariance else _DEFAULT_SIGMA**2
        sigma = variance**0.5 if isfinite(variance) and variance > 0.0 else _DEFAULT_SIGMA
        seen = _TrackPoint(
            item.captured_at, item.position, sigma, number(item, "head"), number(item, "extent")
        )
        self._tracks.setdefault(key, PersonTrack(*key)).add(seen)

    def is_person(self, item: DetectorInput) -> bool:
        """Return whether an item is about a person, by its source or by the layout."""
        return fact(item, "kind") == "person" or item.thing in self._known

    def people(self) -> tuple[str, ...]:
        """Return everybody who was ever seen, sorted by id."""
        return tuple(sorted({person for person, _ in self._tracks}))

    def confidence(self, track: PersonTrack, now: float) -> float:
        """Return the confidence in the last position at a time [s], 0 to 1; 0 when out of sight."""
        return 0.0 if self.out_of_sight(track) else freshness(now - track.last.at, TRACK_HEARTBEAT)

    def out_of_sight(self, track: PersonTrack) -> bool:
        """Return whether the source has reported since without seeing them."""
        return self._heard.get(track.source, 0.0) - track.last.at > OUT_OF_SIGHT_AFTER

    def is_live(self, source: str, now: float) -> bool:
        """Return whether a source was heard recently."""
        return (
            freshness(now - self._heard.get(source, float("-inf")), TRACK_HEARTBEAT)
            >= KNOWN_THRESHOLD
        )

    def best(self, person: str, now: float) -> PersonTrack | None:
        """Return the most accurate track with enough confidence, None if there is none."""
        known = [
            track for track in self.of(person) if self.confidence(track, now) >= KNOWN_THRESHOLD
        ]
        return min(
            known,
            key=lambda track: (-self.confidence(track, now), track.last.sigma, track.source),
            default=None,
        )

    def latest(self, person: str) -> PersonTrack | None:
        """Return the track that was seen last, however long ago."""
        return max(self.of(person), key=lambda track: (track.last.at, track.source), default=None)

    def of(self, person: str) -> tuple[PersonTrack, ...]:
        """Return the tracks of a person."""
        return tuple(track for (name, _), track in self._tracks.items() if name == person)

    def distances(
        self, point: tuple[float, ...], time: float
    ) -> Iterator[tuple[float, str, float]]:
        """Yield distance over the floor [m], id and confidence of everybody around a time [s]."""
        for person in self.people():
            seen = [
                (abs(track.at(time).at - time), track.source, track.at(time))
                for track in self.of(person)
            ]
            age, _, nearest = min(seen, key=lambda row: (row[0], row[2].sigma, row[1]))
            confidence = freshness(age, TRACK_HEARTBEAT)
            if confidence >= KNOWN_THRESHOLD:
                yield (
                    hypot(nearest.position[0] - point[0], nearest.position[1] - point[1]),
                    person,
                    confidence,
                )


def _mean(part: list[_TrackPoint]) -> tuple[float, float, float]:
    count = len(part)
    times, xs, ys = (
        sum(column) / count
        for column in zip(*((s.at, *_plane(s.position)) for s in part), strict=True)
    )
    return times, xs, ys


def _plane(position: Vec3) -> Vec2:
    return position[0], position[1]
