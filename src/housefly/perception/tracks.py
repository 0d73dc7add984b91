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
from housefly.perception.motion import Motion

BIRTH = 3
"""Scans in which a new thing must be seen before it is believed."""
DEATH = 3
"""Scans in a row that look through a thing's place before it is gone."""
SURE = 5
"""Scans after which a thing is believed fully."""
GATE, GATE_SIGMAS = 0.35, 3.0
"""A cluster may be the thing that is expected within this distance [m] plus so many sigmas."""
FORGOTTEN_AFTER = 2.0
"""A thing that no scan shows is forgotten after this [s]."""
SIZE_SHARE = 0.2
"""Share of a new scan in the remembered size."""
STANDING = 0.2
"""Slower things count as standing [m/s]."""
WALKED = 0.5
"""What moved farther than this from where it was first seen is a person [m]."""


@dataclass(frozen=True, slots=True)
class Track:
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
    motion: Motion
    shape: Cluster
    first: Vec2
    hits: int = 1
    misses: int = 0
    seen_at: float = 0.0
    walked: bool = False

    @property
    def believed(self) -> bool:
        """Whether it was seen often enough."""
        return self.hits >= BIRTH

    @property
    def confidence(self) -> float:
        """How far it is believed, 0 to 1."""
        return min(1.0, self.hits / SURE)

    @property
    def velocity(self) -> Vec2:
        """Velocity [m/s]; zero while it stands."""
        return self.motion.velocity if hypot(*self.motion.velocity) > STANDING else (0.0, 0.0)

    def updated(self, cluster: Cluster, at: float) -> Track:
        """Return the thing after it was seen."""
        motion = self.motion.predicted(at).seen(cluster.position)
        radius = (
            cluster.radius
            and (1.0 - SIZE_SHARE) * (self.shape.radius or cluster.radius)
            + SIZE_SHARE * cluster.radius
        )
        walked = self.walked or distance(motion.position, self.first) > WALKED
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
class Followed:
    """All things at one time.

    Attributes:
        tracks: in the order of their numbers.
        next_number: for the next new thing.
        gone: believed things that the last scan ended.
    """

    tracks: tuple[Track, ...] = ()
    next_number: int = 1
    gone: tuple[Track, ...] = ()

    def after(
        self, clusters: Sequence[Cluster], at: float, looks_through: Callable[[Vec2, float], bool]
    ) -> Followed:
        """Return the things after one scan.

        Args:
            clusters: what the scan shows.
            at: when it was taken [s].
            looks_through: whether its beams pass a place [m] of a radius [m] and end behind it.
        """
        pairs = _matched(self.tracks, clusters, at)
        kept: list[Track] = []
        gone: list[Track] = []
        for index, track in enumerate(self.tracks):
            found = pairs.get(index)
            if found is not None:
                kept.append(track.updated(clusters[found], at))
                continue
            missed = looks_through(track.motion.predicted(at).position, track.shape.radius)
            left = replace(track, misses=track.misses + 1) if missed else track
            ended = (
                left.misses >= (DEATH if left.believed else 1)
                or at - left.seen_at > FORGOTTEN_AFTER
            )
            (gone if ended else kept).append(left)
        free = [cluster for index, cluster in enumerate(clusters) if index not in pairs.values()]
        born = [
            Track(self.next_number + n, Motion(at, c.position), c, c.position, seen_at=at)
            for n, c in enumerate(free)
        ]
        return Followed(
            (*kept, *born),
            self.next_number + len(born),
            tuple(track for track in gone if track.believed),
        )


def _matched(tracks: Sequence[Track], clusters: Sequence[Cluster], at: float) -> dict[int, int]:
    """Return which track is which cluster: the nearest pairs first, believed things before new
    ones.
    """
    expected = [track.motion.predicted(at) for track in tracks]
    offers = []
    for i, motion in enumerate(expected):
        for j, cluster in enumerate(clusters):
            apart = distance(motion.position, cluster.position)
            if apart <= GATE + GATE_SIGMAS * motion.std:
                offers.append((not tracks[i].believed, apart, i, j))
    pairs: dict[int, int] = {}
    for _, _, i, j in sorted(offers):
        if i not in pairs and j not in pairs.values():
            pairs[i] = j
    return pairs
