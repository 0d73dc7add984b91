"""Things followed from scan to scan: which cluster is which thing, when one is believed, and when
one is gone.

A thing is believed after ``BIRTH`` scans and gone after ``DEATH`` scans that look through its
place. One that is hidden behind something else is neither seen nor gone; it is forgotten after
``FORGOTTEN_AFTER``.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import hypot

from housefly.geometry import Vec2, distance
from housefly.perception.clusters import Cluster
from housefly.perception.motion import MotionState

BIRTH_HITS = 3
"""Scans in which a new thing must be seen before it is believed."""
DEATH_MISSES = 3
"""Scans in a row that look through a thing's place before it is gone."""
_FULL_CONFIDENCE_HITS = 5
"""Scans after which a thing is believed fully."""
_GATE, _GATE_SIGMAS = 0.35, 3.0
"""A cluster may be the thing that is expected within this distance [m] plus so many sigmas."""
_UNSEEN_TIMEOUT = 2.0
"""A thing that no scan shows is forgotten after this [s]."""
_SIZE_GAIN = 0.2
"""Share of a new scan in the remembered size."""
_STANDING_SPEED = 0.2
"""Slower things count as standing [m/s]."""
_WALKED_DISTANCE = 0.5
"""What moved farther than this from where it was first seen is a person [m]."""


@dataclass(frozen=True, slots=True)
class ObstacleTrack:
    """One thing.

    Attributes:
        number: its own, never used again.
        motion: where it is and how it moves.
        shape: the newest cluster; its radius is smoothed.
        first: where it was first seen [m].
        hits: scans that showed it.
        misses: scans in a row that looked through its place.
        seen_at: when it was last seen [s].
        walked: it moved away from where it was first seen.
    """

    number: int
    motion: MotionState
    shape: Cluster
    first: Vec2
    hits: int = 1
    misses: int = 0
    seen_at: float = 0.0
    walked: bool = False

    @property
    def confirmed(self) -> bool:
        """Whether it was seen often enough."""
        return self.hits >= BIRTH_HITS

    @property
    def confidence(self) -> float:
        """How far it is believed, 0 to 1."""
        return min(1.0, self.hits / _FULL_CONFIDENCE_HITS)

    @property
    def velocity(self) -> Vec2:
        """Velocity [m/s]; zero while it stands."""
        return (
            self.motion.velocity if hypot(*self.motion.velocity) > _STANDING_SPEED else (0.0, 0.0)
        )

    def updated(self, cluster: Cluster, at: float) -> ObstacleTrack:
        """Return the thing after it was seen."""
        motion = self.motion.predicted(at).updated(cluster.position)
        radius = (
            cluster.radius
            and (1.0 - _SIZE_GAIN) * (self.shape.radius or cluster.radius)
            + _SIZE_GAIN * cluster.radius
        )
        walked = self.walked or distance(motion.position, self.first) > _WALKED_DISTANCE
        shape = replace(cluster, radius=radius)
        return replace(
            self,
            motion=motion,
            shape=shape,
            hits=self.hits + 1,
            misses=0,
            seen_at=at,
            walked=walked,
        )


@dataclass(frozen=True, slots=True)
class TrackSet:
    """All things at one time.

    Attributes:
        tracks: in the order of their numbers.
        next_number: for the next new thing.
        gone: believed things that the last scan ended.
    """

    tracks: tuple[ObstacleTrack, ...] = ()
    next_number: int = 1
    gone: tuple[ObstacleTrack, ...] = ()

    def updated(
        self, clusters: Sequence[Cluster], at: float, looks_through: Callable[[Vec2, float], bool]
    ) -> TrackSet:
        """Return the things after one scan.

        Args:
            clusters: what the scan shows.
            at: when it was taken [s].
            looks_through: whether its beams pass a place [m] of a radius [m] and end behind it.
        """
        pairs = _matched(self.tracks, clusters, at)
        kept: list[ObstacleTrack] = []
        gone: list[ObstacleTrack] = []
        for index, track in enumerate(self.tracks):
            found = pairs.get(index)
            if found is not None:
                kept.append(track.updated(clusters[found], at))
                continue
            missed = looks_through(track.motion.predicted(at).position, track.shape.radius)
            left = replace(track, misses=track.misses + 1) if missed else track
            ended = (
                left.misses >= (DEATH_MISSES if left.confirmed else 1)
                or at - left.seen_at > _UNSEEN_TIMEOUT
            )
            (gone if ended else kept).append(left)
        free = [cluster for index, cluster in enumerate(clusters) if index not in pairs.values()]
        born = [
            ObstacleTrack(
                self.next_number + n, MotionState(at, c.position), c, c.position, seen_at=at
            )
            for n, c in enumerate(free)
        ]
        return TrackSet(
            (*kept, *born),
            self.next_number + len(born),
            tuple(track for track in gone if track.confirmed),
        )


def _matched(
    tracks: Sequence[ObstacleTrack], clusters: Sequence[Cluster], at: float
) -> dict[int, int]:
    """Return which track is which cluster: the nearest pairs first, believed things before new
    ones.
    """
    expected = [track.motion.predicted(at) for track in tracks]
    offers = []
    for i, motion in enumerate(expected):
        for j, cluster in enumerate(clusters):
            apart = distance(motion.position, cluster.position)
            if apart <= _GATE + _GATE_SIGMAS * motion.std:
                offers.append((not tracks[i].confirmed, apart, i, j))
    pairs: dict[int, int] = {}
    for _, _, i, j in sorted(offers):
        if i not in pairs and j not in pairs.values():
            pairs[i] = j
    return pairs
