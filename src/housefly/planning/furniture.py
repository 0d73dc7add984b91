"""Tracked furniture as obstacles: wherever tracking sees the body of a thing, its footprint is in the way.

A thing that nobody sees any more is taken to stand where it was last seen, for as long as the site says; after that it is
forgotten like every other obstacle. The newest sighting is believed: where the thing stood before is free at once.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import cos, hypot, isfinite, sin

from housefly.config_furniture import FurnitureConfig
from housefly.geometry import Vec2, distance, wrap_angle
from housefly.messages import Obstacle, Pose, Sighting
from housefly.planning.obstacles import AHEAD_OF_TIME, FASTEST

SOURCE = "tracking"
"""Source of these obstacles."""
TELL_PERIOD = 0.25
"""A thing that stands still is told again after this [s]: far less than its confidence needs to fade."""
SHIFTED, TURNED = 0.01, 0.02
"""A thing is told at once when it moved by this [m] or turned by this [rad]."""
WINDOW = 0.3
"""Velocity is how far it moved in this time [s]; a thing that is not seen for as long counts as standing."""
STANDING = 0.1
"""Slower things count as standing [m/s]."""


@dataclass(frozen=True, slots=True)
class Whereabouts:
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

    def after(self, at: float, middle: Vec2, yaw: float) -> Whereabouts:
        """Return where it is after a newer sighting."""
        passed = at - self.since
        if passed < WINDOW:
            return Whereabouts(at, middle, yaw, self.velocity, self.since, self.came_from)
        velocity = ((middle[0] - self.came_from[0]) / passed, (middle[1] - self.came_from[1]) / passed)
        # What is faster was put down elsewhere while nobody looked, or tracking took another body for it.
        moves = STANDING < hypot(*velocity) < FASTEST
        return Whereabouts(at, middle, yaw, velocity if moves else (0.0, 0.0), at, middle)


class TrackedFurniture:
    """All tracked things of a site; what they did is in what was seen of them, so the same sightings tell the same.

    Args:
        furniture: of the site.
    """

    def __init__(self, furniture: tuple[FurnitureConfig, ...]) -> None:
        self._pieces = {piece.body: piece for piece in furniture}
        self._places: dict[str, Whereabouts] = {}
        self._told: dict[str, Obstacle] = {}

    def step(self, sightings: Iterable[Sighting], now: float) -> tuple[Obstacle, ...]:
        """Return what is new of the furniture at a time [s]."""
        for sighting in sightings:
            if sighting.body in self._pieces:
                self._see(sighting, now)
        obstacles = [self._obstacle(body, place, now) for body, place in self._places.items()]
        return tuple(obstacle for obstacle in obstacles if obstacle is not None)

    def _see(self, sighting: Sighting, now: float) -> None:
        at, known = sighting.captured_at, self._places.get(sighting.body)
        is_sane = all(isfinite(number) for number in (at, *sighting.pose.position, *sighting.pose.orientation))
        if not is_sane or at > now + AHEAD_OF_TIME or (known is not None and at <= known.at):
            return
        middle, yaw = footprint_of(self._pieces[sighting.body], sighting.pose)
        fresh = Whereabouts(at, middle, yaw, (0.0, 0.0), at, middle)
        self._places[sighting.body] = fresh if known is None else known.after(at, middle, yaw)

    def _obstacle(self, body: str, place: Whereabouts, now: float) -> Obstacle | None:
        """Return one thing as an obstacle of now, or None when there is nothing to tell of it."""
        piece, told = self._pieces[body], self._told.get(body)
        unseen = now - place.at
        if unseen > piece.remembered:
            return None
        is_due = told is None or now - told.seen_at >= TELL_PERIOD or _moved(told, place)
        if not is_due:
            return None
        velocity = place.velocity if unseen < WINDOW else (0.0, 0.0)
        size, band = (piece.length, piece.width), (piece.bottom, piece.top)
        self._told[body] = Obstacle(piece.name, place.middle, 0.0, size, place.yaw, *band, velocity, 1.0, now, SOURCE)
        return self._told[body]


def footprint_of(piece: FurnitureConfig, pose: Pose) -> tuple[Vec2, float]:
    """Return the middle [m] and the yaw [rad] of the footprint of a thing whose body is at a pose."""
    (x, y, _), yaw = pose.position, pose.yaw
    middle = (x + cos(yaw) * piece.x - sin(yaw) * piece.y, y + sin(yaw) * piece.x + cos(yaw) * piece.y)
    return middle, wrap_angle(yaw + piece.yaw)


def _moved(told: Obstacle, place: Whereabouts) -> bool:
    return distance(told.position, place.middle) > SHIFTED or abs(wrap_angle(told.yaw - place.yaw)) > TURNED
