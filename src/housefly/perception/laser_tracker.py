"""Tracks obstacles in the scans of a room's laser scanners. Pure: no clock, no wire."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial
from math import atan2, hypot, isfinite, pi

import numpy as np
from numpy.typing import NDArray

from housefly.config.laser import LaserConfig
from housefly.geometry import Vec2
from housefly.messages import Obstacle, Scan
from housefly.messages.obstacles import TRACK
from housefly.numeric import FloatArray
from housefly.perception.beams import (
    MAX_BEAMS,
    BeamBackground,
    BeamScan,
    background_of,
    beam_scan_of,
)
from housefly.perception.clusters import clusters_of
from housefly.perception.tracker import ObstacleTrack, TrackSet
from housefly.perception.wall_check import WallCheck
from housefly.room.model import Room

_SOURCE = "lasers"
"""Source of the obstacles of all scanners."""
_MAX_AHEAD, _SCAN_AGE_MAX = 0.05, 1.0
"""A scan further in the future, or older, is refused [s]."""
_FROZEN_SCANS = 3
"""This many identical scans in a row come from a frozen scanner."""
_COVERED_SHARE = 0.5
"""A scanner is covered if this share of its beams ends ..."""
_COVERED_DISTANCE = 0.1
"""... nearer than this [m]."""
OWN_MARGIN = 0.25
"""Whatever appears nearer to the hull than this is taken for the drone itself [m]."""
_KNOWN_MARGIN = 0.1
"""A point this near to where a known thing is expected belongs to it [m]."""
SEE_THROUGH_MARGIN = 0.2
"""Beams see through a place if they end this far behind it [m]."""


_BackgroundKey = tuple[str, float, float, int, tuple[float, float, float]]


@dataclass(frozen=True, slots=True)
class OwnFootprint:
    """A drone of ours, which is no obstacle for these sensors: tracking shows it.

    Attributes:
        place: its middle [m].
        radius: what is nearer than this, and was not seen before it came near, is the drone [m].
    """

    place: Vec2
    radius: float

    def others(self, ends: FloatArray, people: FloatArray) -> NDArray[np.bool_]:
        """Return which points are not the drone: those outside, and those of known things.

        Args:
            ends: world points, at least x and y [m], shape (n, 2 or 3).
            people: x, y and radius of what was seen before [m], shape (m, 3).
        """
        from_us = np.hypot(ends[:, 0] - self.place[0], ends[:, 1] - self.place[1])
        outside = from_us > self.radius
        if len(people) and not outside.all():
            away = np.hypot(ends[:, :1] - people[:, 0], ends[:, 1:2] - people[:, 1])
            known = (away < people[:, 2] + _KNOWN_MARGIN).any(axis=1)
            outside |= known & (from_us > self.radius - OWN_MARGIN)
        return np.asarray(outside, dtype=np.bool_)


@dataclass(frozen=True, slots=True)
class TrackingResult:
    """The result of one scan or image.

    Attributes:
        obstacles: the confirmed ones as the pilot receives them; a lost one comes once more with
            confidence 0.
        problem: why the input was refused, or is not to be relied on, in words, or "".
    """

    obstacles: tuple[Obstacle, ...] = ()
    problem: str = ""


class LaserTracker:
    """Tracks what no map shows, with all scanners of one room.

    Args:
        room: what the map shows.
        lasers: where the scanners are.
    """

    def __init__(self, room: Room, lasers: tuple[LaserConfig, ...]) -> None:
        self._room = room
        self._lasers = {laser.name: laser for laser in lasers}
        self._backgrounds: dict[_BackgroundKey, BeamBackground] = {}
        self._last: dict[str, BeamScan] = {}
        self._alike: dict[str, int] = {}
        self._tracks = TrackSet()
        self._wall_check = WallCheck(room)

    def update(self, scan: Scan, now: float, own: tuple[OwnFootprint, ...] = ()) -> TrackingResult:
        """Process one scan.

        Args:
            scan: of any of the scanners.
            now: time [s].
            own: where the drones are that are off the ground, as far as it is known.
        """
        return self.update_beams(beam_scan_of(scan), now, own)

    def update_beams(
        self, scan: BeamScan, now: float, own: tuple[OwnFootprint, ...] = ()
    ) -> TrackingResult:
        """Process one scan whose distances are in an array, as ``update``."""
        problem = self._fault(scan, now)
        if problem:
            return TrackingResult(problem=f"{scan.source}: {problem}")
        laser, at, doubt = self._lasers[scan.source], scan.captured_at, ""
        error = self._wall_check.look(scan, laser)
        if error is not None:
            doubt = f"{scan.source}: {error.words}"
            if error.laser is None:
                return TrackingResult(problem=doubt)
            laser, scan = error.laser, replace(scan, ranges=scan.ranges - error.longer)
        ends, beams = _foreground(scan, self._background(scan, laser), laser)
        for footprint in own:
            other = footprint.others(ends, known_discs(self._tracks, at))
            if not other.all():
                ends, beams = ends[other], beams[other]
        clusters = clusters_of(ends, beams, (laser.x, laser.y))
        self._tracks = self._tracks.updated(clusters, at, partial(_sees_through, scan, laser))
        confirmed = (track for track in self._tracks.tracks if track.confirmed)
        gone = (_gone(track, at) for track in self._tracks.gone)
        return TrackingResult((*(obstacle_of(track) for track in confirmed), *gone), doubt)

    def _background(self, scan: BeamScan, laser: LaserConfig) -> BeamBackground:
        place = laser.x, laser.y, laser.yaw
        key = (scan.source, scan.first_angle, scan.step, len(scan.ranges), place)
        if key not in self._backgrounds:
            self._backgrounds = {
                known: background
                for known, background in self._backgrounds.items()
                if known[0] != scan.source
            }
            self._backgrounds[key] = background_of(self._room, laser, scan)
        return self._backgrounds[key]

    def _fault(self, scan: BeamScan, now: float) -> str:
        """Return why a scan is refused, in words, or ""."""
        last, ranges = self._last.get(scan.source), scan.ranges
        problem = self._nonsense(scan, now)
        if problem:
            return problem
        if last is not None and scan.captured_at <= last.captured_at:
            return "a scan that is not newer than the last"
        is_alike = last is not None and np.array_equal(ranges, last.ranges)
        self._last[scan.source] = scan
        self._alike[scan.source] = self._alike.get(scan.source, 0) + 1 if is_alike else 0
        if self._alike[scan.source] >= _FROZEN_SCANS:
            return "the same distances to the last bit again and again: it stands still"
        if np.count_nonzero(ranges < _COVERED_DISTANCE) > _COVERED_SHARE * len(ranges):
            return "something covers it"
        return ""

    def _nonsense(self, scan: BeamScan, now: float) -> str:
        if scan.source not in self._lasers:
            return "not a scanner of this site"
        if (
            not all(isfinite(number) for number in (scan.captured_at, scan.first_angle, scan.step))
            or scan.step <= 0.0
        ):
            return "not all its numbers are finite"
        if not 0 < len(scan.ranges) <= MAX_BEAMS or not (scan.ranges >= 0.0).all():
            return "distances that are none"
        if scan.captured_at > now + _MAX_AHEAD:
            return "a scan from the future"
        return (
            f"scans come more than {_SCAN_AGE_MAX:.0f} s late"
            if scan.captured_at < now - _SCAN_AGE_MAX
            else ""
        )


def obstacle_of(track: ObstacleTrack) -> Obstacle:
    """Return a track as an obstacle from floor to ceiling: a scanner cannot measure heights."""
    shape = track.shape
    return Obstacle(
        id=f"{TRACK}{track.number}",
        position=track.motion.position,
        radius=shape.radius,
        size=shape.size,
        yaw=shape.yaw,
        velocity=track.velocity,
        confidence=track.confidence,
        seen_at=track.seen_at,
        source=_SOURCE,
        kind=track.kind,
    )


def known_discs(tracks: TrackSet, at: float) -> FloatArray:
    """Return x, y and radius [m] of the confirmed tracks at a time [s], shape (n, 3)."""
    discs = [
        (
            *track.motion.position_at(at),
            max(track.shape.radius, hypot(*track.shape.size) / 2),
        )
        for track in tracks.tracks
        if track.confirmed
    ]
    return np.array(discs, dtype=np.float64).reshape(-1, 3)


def _gone(track: ObstacleTrack, at: float) -> Obstacle:
    return replace(obstacle_of(track), confidence=0.0, seen_at=at)


def _foreground(
    scan: BeamScan, background: BeamBackground, laser: LaserConfig
) -> tuple[FloatArray, NDArray[np.int64]]:
    """Return where the beams end that hit something new [m], shape (n, 2), and their numbers."""
    beams = np.flatnonzero(scan.ranges < background.limit)
    away, ends = scan.ranges[beams], np.empty((len(beams), 2))
    ends[:, 0] = laser.x + away * background.cosines[beams]
    ends[:, 1] = laser.y + away * background.sines[beams]
    return ends, beams


def _sees_through(scan: BeamScan, laser: LaserConfig, place: Vec2, radius: float) -> bool:
    """Return whether the beams towards a place end behind it: nothing stands there."""
    dx, dy = place[0] - laser.x, place[1] - laser.y
    bearing = (atan2(dy, dx) - laser.yaw - scan.first_angle) % (2.0 * pi)
    beam, away = round(bearing / scan.step), hypot(dx, dy)
    if not 0 <= beam < len(scan.ranges):
        return False
    spread = max(1, int(0.5 * radius / max(away, 0.1) / scan.step))
    near = scan.ranges[max(0, beam - spread) : beam + spread + 1]
    ended: list[float] = [end for end in near.tolist() if isfinite(end)]
    through = sum(end > away + SEE_THROUGH_MARGIN for end in ended)
    return through > 0.7 * len(ended) > 0
