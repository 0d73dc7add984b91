"""Multi-object tracking of clusters: association, confirmation and deletion of tracks.

A track is confirmed after ``BIRTH_HITS`` scans and deleted after ``DEATH_MISSES`` scans that see
through its place. A hidden thing is neither; it is deleted after ``_UNSEEN_TIMEOUT``.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import hypot, sqrt

from housefly.geometry import Vec2, distance
from housefly.messages import ObstacleKind
from housefly.perception.clusters import Cluster

BIRTH_HITS = 3
"""Scans that must show a new thing to confirm it."""
DEATH_MISSES = 3
"""Scans in a row that must see through a thing's place to delete it."""
_FULL_CONFIDENCE_HITS = 5
"""Scans after which the confidence is 1."""
_GATE, _GATE_SIGMAS = 0.35, 3.0
"""Association gate: this distance [m] plus so many sigmas of the prediction."""
_UNSEEN_TIMEOUT = 2.0
"""A thing that no scan shows is deleted after this [s]."""
_SIZE_GAIN = 0.2
"""Weight of a new scan in the smoothed size."""
_STANDING_SPEED = 0.2
"""Slower things count as standing [m/s]."""
_PERSON_RADIUS_MAX = 0.4
"""A disc that is no larger may be a person [m]."""
_MOVED = 0.4
"""Whatever moved farther than this is taken for a person [m]."""

_ACCELERATION_SIGMA = 1.5
"""One-sigma acceleration of people [m/s^2]."""
_POSITION_SIGMA = 0.05
"""One-sigma error of a cluster's centre [m]: the visible side changes as a thing turns."""
_START_SPEED_SIGMA = 1.0
"""One-sigma speed of a new thing [m/s]."""


@dataclass(frozen=True, slots=True)
class ObstacleTrack:
    """One tracked thing.

    Attributes:
        number: unique, never reused.
        motion: state of its filter.
        shape: the newest cluster; its radius is smoothed.
        hits: scans that showed it.
        misses: scans in a row that saw through its place.
        seen_at: when it was last seen [s].
        born_at: where it was first seen [m].
    """

    number: int
    motion: _MotionState
    shape: Cluster
    hits: int = 1
    misses: int = 0
    seen_at: float = 0.0
    born_at: Vec2 | None = None

    @property
    def kind(self) -> ObstacleKind:
        """A person, as far as one can tell: it moved, or it is as large as one."""
        if self.born_at is not None and distance(self.born_at, self.motion.position) > _MOVED:
            return ObstacleKind.PERSON
        is_disc = 0.0 < self.shape.radius <= _PERSON_RADIUS_MAX
        return ObstacleKind.PERSON if is_disc else ObstacleKind.UNKNOWN

    @property
    def confirmed(self) -> bool:
        """Whether it was seen often enough."""
        return self.hits >= BIRTH_HITS

    @property
    def confidence(self) -> float:
        """Confidence in the thing, 0 to 1."""
        return min(1.0, self.hits / _FULL_CONFIDENCE_HITS)

    @property
    def velocity(self) -> Vec2:
        """Velocity [m/s]; zero while it stands."""
        return (
            self.motion.velocity if hypot(*self.motion.velocity) > _STANDING_SPEED else (0.0, 0.0)
        )

    def updated(self, cluster: Cluster, expected: _MotionState, at: float) -> ObstacleTrack:
        """Return the track updated with a cluster of a time [s] and its own prediction for it."""
        radius = (
            cluster.radius
            and (1.0 - _SIZE_GAIN) * (self.shape.radius or cluster.radius)
            + _SIZE_GAIN * cluster.radius
        )
        shape = Cluster(cluster.position, radius, cluster.size, cluster.yaw, cluster.points)
        return ObstacleTrack(
            self.number,
            expected.updated(cluster.position),
            shape,
            hits=self.hits + 1,
            seen_at=at,
            born_at=self.born_at,
        )


@dataclass(frozen=True, slots=True)
class TrackSet:
    """All tracks at one time.

    Attributes:
        tracks: in the order of their numbers.
        next_number: of the next new track.
        gone: confirmed tracks that the last scan deleted.
    """

    tracks: tuple[ObstacleTrack, ...] = ()
    next_number: int = 1
    gone: tuple[ObstacleTrack, ...] = ()

    def updated(
        self, clusters: Sequence[Cluster], at: float, looks_through: Callable[[Vec2, float], bool]
    ) -> TrackSet:
        """Return the tracks after one scan.

        Args:
            clusters: of the scan.
            at: when it was taken [s].
            looks_through: whether its beams see through a place [m] with a radius [m].
        """
        expected = [track.motion.predicted(at) for track in self.tracks]
        pairs = _matched(self.tracks, expected, clusters)
        kept: list[ObstacleTrack] = []
        gone: list[ObstacleTrack] = []
        for index, track in enumerate(self.tracks):
            found = pairs.get(index)
            if found is not None:
                kept.append(track.updated(clusters[found], expected[index], at))
                continue
            missed = looks_through(expected[index].position, track.shape.radius)
            left = replace(track, misses=track.misses + 1) if missed else track
            ended = (
                left.misses >= (DEATH_MISSES if left.confirmed else 1)
                or at - left.seen_at > _UNSEEN_TIMEOUT
            )
            (gone if ended else kept).append(left)
        free = [cluster for index, cluster in enumerate(clusters) if index not in pairs.values()]
        born = [
            ObstacleTrack(
                self.next_number + n,
                _MotionState(at, c.position),
                c,
                seen_at=at,
                born_at=c.position,
            )
            for n, c in enumerate(free)
        ]
        return TrackSet(
            (*kept, *born),
            self.next_number + len(born),
            tuple(track for track in gone if track.confirmed),
        )


def _matched(
    tracks: Sequence[ObstacleTrack], expected: Sequence[_MotionState], clusters: Sequence[Cluster]
) -> dict[int, int]:
    """Return each track's cluster: confirmed tracks before new ones, nearest pairs first."""
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


@dataclass(frozen=True, slots=True)
class _MotionState:
    """The filter's state; both axes share the covariance (pp, pv, vv).

    Attributes:
        at: time [s].
        position: [m].
        velocity: [m/s].
        pp, pv, vv: covariance of position and velocity of one axis.
    """

    at: float
    position: Vec2
    velocity: Vec2 = (0.0, 0.0)
    pp: float = _POSITION_SIGMA * _POSITION_SIGMA
    pv: float = 0.0
    vv: float = _START_SPEED_SIGMA * _START_SPEED_SIGMA

    @property
    def std(self) -> float:
        """One-sigma error of the position [m]."""
        return sqrt(self.pp)

    def position_at(self, at: float) -> Vec2:
        """Return the position predicted to a later time [m, s]."""
        dt = max(0.0, at - self.at)
        (x, y), (vx, vy) = self.position, self.velocity
        return x + vx * dt, y + vy * dt

    def predicted(self, at: float) -> _MotionState:
        """Return the state predicted to a later time [s]."""
        dt = max(0.0, at - self.at)
        q = _ACCELERATION_SIGMA * _ACCELERATION_SIGMA
        pp = self.pp + dt * (2.0 * self.pv + dt * self.vv) + q * (dt * dt) ** 2 / 4.0
        pv = self.pv + dt * self.vv + q * dt * dt * dt / 2.0
        return _MotionState(
            max(at, self.at),
            self.position_at(at),
            self.velocity,
            pp,
            pv,
            self.vv + q * dt * dt,
        )

    def updated(self, place: Vec2) -> _MotionState:
        """Return the state updated with a position [m] measured at the state's own time."""
        gain = self.pp / (self.pp + _POSITION_SIGMA * _POSITION_SIGMA)
        gain_v = self.pv / (self.pp + _POSITION_SIGMA * _POSITION_SIGMA)
        off_x, off_y = place[0] - self.position[0], place[1] - self.position[1]
        position = (self.position[0] + gain * off_x, self.position[1] + gain * off_y)
        velocity = (self.velocity[0] + gain_v * off_x, self.velocity[1] + gain_v * off_y)
        return _MotionState(
            self.at,
            position,
            velocity,
            (1.0 - gain) * self.pp,
            (1.0 - gain) * self.pv,
            self.vv - gain_v * self.pv,
        )
