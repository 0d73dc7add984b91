"""Tracked furniture as obstacles: its footprint, wherever tracking sees it.

A thing that nobody sees any more is taken to stand where it was last seen, for as long as the site
says; after that it is forgotten like every other obstacle. The newest sighting is believed: where
the thing stood before is free at once. A thing that the room model has, too, stands where the model
has it until it is seen, and is never forgotten.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import hypot, isfinite

from housefly.config.site import Site
from housefly.geometry import Vec2, distance, wrap_angle
from housefly.messages.obstacles import Obstacle, ObstacleKind
from housefly.messages.sensing import Sighting
from housefly.pilot.planning.obstacles import OBSTACLE_CLOCK_TOLERANCE
from housefly.room.model import Room
from housefly.room.tracked import Stand, footprint_of, stand_of

FURNITURE_SOURCE = "tracking"
"""Source of these obstacles."""
FURNITURE_REPORT_PERIOD = 0.25
"""A thing that stands still is told again after this [s]: far less than its confidence needs to
fade.
"""
SHIFTED, TURNED = 0.01, 0.02
"""A thing is told at once when it moved by this [m] or turned by this [rad]."""
VELOCITY_WINDOW = 0.3
"""Velocity is how far it moved in this time [s]; a thing that is not seen for as long counts as
standing.
"""
STANDING_SPEED_MAX = 0.1
"""Slower things count as standing [m/s]."""
CARRIED_SPEED_MAX = 3.0
"""Faster things were put down elsewhere while nobody looked [m/s]."""


@dataclass(frozen=True, slots=True)
class TrackedPose:
    """Where one thing is.

    Attributes:
        at: when it was last seen [s].
        middle: of its footprint [m].
        yaw: of its length [rad].
        velocity: [m/s].
        since: when the window began that its velocity is measured in [s].
        came_from: where its middle was then [m].
    """

    at: float
    middle: Vec2
    yaw: float
    velocity: Vec2
    since: float
    came_from: Vec2

    def updated(self, at: float, middle: Vec2, yaw: float) -> TrackedPose:
        """Return where it is after a newer sighting."""
        passed = at - self.since
        if passed < VELOCITY_WINDOW:
            return TrackedPose(at, middle, yaw, self.velocity, self.since, self.came_from)
        velocity = (
            (middle[0] - self.came_from[0]) / passed,
            (middle[1] - self.came_from[1]) / passed,
        )
        # What is faster was put down elsewhere while nobody looked, or tracking took another body
        # for it.
        moves = STANDING_SPEED_MAX < hypot(*velocity) < CARRIED_SPEED_MAX
        return TrackedPose(at, middle, yaw, velocity if moves else (0.0, 0.0), at, middle)


class TrackedFurniture:
    """All tracked things of a site; the same sightings give the same obstacles.

    Args:
        site: which things tracking sees.
        room: where those that it models stand; raises ConfigError as ``room.tracked.untracked``.
    """

    def __init__(self, site: Site, room: Room) -> None:
        self._pieces = {piece.body: piece for piece in site.furniture}
        stands = {piece.body: stand_of(room, piece) for piece in site.furniture}
        self._stands = {body: stand for body, stand in stands.items() if stand is not None}
        self._places: dict[str, TrackedPose] = {}
        self._told: dict[str, Obstacle] = {}

    def step(self, sightings: Iterable[Sighting], now: float) -> tuple[Obstacle, ...]:
        """Return what is new of the furniture at a time [s]."""
        for sighting in sightings:
            if sighting.body in self._pieces:
                self._see(sighting, now)
        unseen = (
            (body, self._standing(body, stand, now))
            for body, stand in self._stands.items()
            if body not in self._places
        )
        seen = ((body, self._obstacle(body, place, now)) for body, place in self._places.items())
        fresh = {
            body: obstacle
            for body, obstacle in (*unseen, *seen)
            if obstacle is not None and self._is_news(body, obstacle)
        }
        self._told |= fresh
        return tuple(fresh.values())

    def _see(self, sighting: Sighting, now: float) -> None:
        at, known = sighting.captured_at, self._places.get(sighting.body)
        is_sane = all(
            isfinite(number) for number in (at, *sighting.pose.position, *sighting.pose.orientation)
        )
        if (
            not is_sane
            or at > now + OBSTACLE_CLOCK_TOLERANCE
            or (known is not None and at <= known.at)
        ):
            return
        middle, yaw = footprint_of(self._pieces[sighting.body], sighting.pose)
        fresh = TrackedPose(at, middle, yaw, (0.0, 0.0), at, middle)
        self._places[sighting.body] = fresh if known is None else known.updated(at, middle, yaw)

    def _standing(self, body: str, stand: Stand, now: float) -> Obstacle:
        """Return a thing that was never seen, where the room model has it."""
        name, band = self._pieces[body].name, (stand.bottom, stand.top)
        return Obstacle(
            name,
            stand.middle,
            0.0,
            stand.size,
            stand.yaw,
            *band,
            (0.0, 0.0),
            1.0,
            now,
            FURNITURE_SOURCE,
            ObstacleKind.THING,
        )

    def _obstacle(self, body: str, place: TrackedPose, now: float) -> Obstacle | None:
        """Return one thing as an obstacle of now, or None when it is forgotten."""
        piece, unseen = self._pieces[body], now - place.at
        if unseen > piece.remembered and body not in self._stands:
            return None
        velocity = place.velocity if unseen < VELOCITY_WINDOW else (0.0, 0.0)
        size, band = (piece.length, piece.width), (piece.bottom, piece.top)
        return Obstacle(
            piece.name,
            place.middle,
            0.0,
            size,
            place.yaw,
            *band,
            velocity,
            1.0,
            now,
            FURNITURE_SOURCE,
            ObstacleKind.THING,
        )

    def _is_news(self, body: str, obstacle: Obstacle) -> bool:
        told = self._told.get(body)
        if told is None or obstacle.seen_at - told.seen_at >= FURNITURE_REPORT_PERIOD:
            return True
        return (
            distance(told.position, obstacle.position) > SHIFTED
            or abs(wrap_angle(told.yaw - obstacle.yaw)) > TURNED
        )
