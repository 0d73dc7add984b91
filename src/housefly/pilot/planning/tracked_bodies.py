"""People and unknown bodies that the tracking system sees, as obstacles.

Any body that is neither a drone nor furniture of the site is in the way. One that is not seen any
more is forgotten like every other obstacle.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import isfinite

from housefly.config.site import Site
from housefly.messages.obstacles import Obstacle, ObstacleKind
from housefly.messages.sensing import Sighting
from housefly.pilot.planning.furniture import TrackedPose
from housefly.pilot.planning.obstacles import OBSTACLE_CLOCK_TOLERANCE, OBSTACLES_MAX

BODY_SOURCE = "tracked body"
"""Source of these obstacles."""
BODY_REPORT_PERIOD = 0.1
"""A body is told again after this [s]."""


class TrackedBodies:
    """All bodies of a site that are neither drones nor furniture.

    Args:
        site: names the drones, the furniture and the people.
    """

    def __init__(self, site: Site) -> None:
        ours = {site.tracking.body, *(piece.body for piece in site.furniture)}
        ours |= {drone.tracked_body for drone in site.drones}
        self._ours = frozenset(ours)
        self._people = frozenset({site.tracking.visitor, *site.people.bodies})
        self._radius = site.people.body_radius
        self._places: dict[str, TrackedPose] = {}
        self._told_at: dict[str, float] = {}

    def step(self, sightings: Iterable[Sighting], now: float) -> tuple[Obstacle, ...]:
        """Return what is new of the bodies at a time [s]."""
        seen = {
            sighting.body
            for sighting in sightings
            if sighting.body not in self._ours and self._see(sighting, now)
        }
        due = [
            body
            for body in sorted(seen)
            if now - self._told_at.get(body, -1.0) >= BODY_REPORT_PERIOD
        ]
        self._told_at |= dict.fromkeys(due, now)
        return tuple(self._obstacle(body) for body in due)

    def _see(self, sighting: Sighting, now: float) -> bool:
        """Take in a sighting; return whether it says something new."""
        at, (x, y, z) = sighting.captured_at, sighting.pose.position
        known = self._places.get(sighting.body)
        if not all(isfinite(number) for number in (at, x, y, z)):
            return False
        if at > now + OBSTACLE_CLOCK_TOLERANCE or (known is not None and at <= known.at):
            return False
        if known is None and len(self._places) >= OBSTACLES_MAX:
            return False
        fresh = TrackedPose(at, (x, y), 0.0, (0.0, 0.0), at, (x, y))
        self._places[sighting.body] = fresh if known is None else known.updated(at, (x, y), 0.0)
        return True

    def _obstacle(self, body: str) -> Obstacle:
        place = self._places[body]
        kind = ObstacleKind.PERSON if body in self._people else ObstacleKind.UNKNOWN
        return Obstacle(
            id=body,
            position=place.middle,
            radius=self._radius,
            velocity=place.velocity,
            seen_at=place.at,
            source=BODY_SOURCE,
            kind=kind,
        )
