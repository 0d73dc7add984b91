"""What is in the way now, and who is seen: from sensors and tracking, as the pilot hears it."""

from __future__ import annotations

import threading

from housefly.config.site import Site
from housefly.geometry import Vec2, Vec3, distance
from housefly.messages import Obstacle, Sighting, TrackedFrame
from housefly.pilot.planning.furniture import TrackedFurniture
from housefly.pilot.planning.people import may_be_person
from housefly.room.model import Room
from housefly.tasks.execution.task_room import SeenPerson

SEEN_TIME = 2.0
"""Who or what was seen longer ago [s] is not there now."""
_WINDOW = 0.3
"""The velocity of a tracked person is how far they came in this time [s]."""
_FASTEST = 4.0
"""Faster than this [m/s] is another body that tracking took for the same."""
_FEET = 0.0
"""Height of the feet of somebody whom a scanner sees [m]."""
_MAX_OBSTACLES = 256


class LiveObstacles:
    """Keeps the newest of each obstacle and person; thread-safe.

    Args:
        site: who among the tracked bodies is a person.
        room: its furniture.
    """

    def __init__(self, site: Site, room: Room) -> None:
        self._people = {site.tracking.visitor, *site.people.bodies}
        self._furniture = TrackedFurniture(site, room)
        self._lock = threading.Lock()
        self._obstacles: dict[tuple[str, str], Obstacle] = {}
        self._persons: dict[str, _Track] = {}

    def heard_frame(self, frame: TrackedFrame) -> None:
        """Take in what tracking saw."""
        sightings = frame.sightings
        found = self._furniture.step(
            sightings, max((one.received_at for one in sightings), default=0.0)
        )
        with self._lock:
            for obstacle in found:
                self._obstacles[obstacle.source, obstacle.id] = obstacle
            for sighting in sightings:
                if sighting.body in self._people:
                    self._persons.setdefault(sighting.body, _Track()).add(sighting)

    def heard_obstacle(self, obstacle: Obstacle) -> None:
        """Take in what a sensor reports; a confidence of 0 removes it."""
        key = obstacle.source, obstacle.id
        with self._lock:
            if obstacle.confidence <= 0.0:
                self._obstacles.pop(key, None)
            elif key in self._obstacles or len(self._obstacles) < _MAX_OBSTACLES:
                self._obstacles[key] = obstacle

    def obstacles(self, now: float) -> tuple[Obstacle, ...]:
        """Return what is in the way [s]; tracked people are not in it."""
        with self._lock:
            self._obstacles = {
                key: one for key, one in self._obstacles.items() if now - one.seen_at <= SEEN_TIME
            }
            return tuple(self._obstacles.values())

    def people(self, now: float) -> tuple[SeenPerson, ...]:
        """Return who is seen now [s]: tracked people by name, others by their sensor's name."""
        known = self.tracked_people(now)
        others = (one for one in self.obstacles(now) if may_be_person(one))
        return known + tuple(
            SeenPerson(
                f"{one.source}/{one.id}", (*one.position, _FEET), one.velocity, now - one.seen_at
            )
            for one in others
            if all(distance(one.position, who.position[:2]) > 0.6 for who in known)
        )

    def tracked_people(self, now: float) -> tuple[SeenPerson, ...]:
        """Return the people whom tracking sees now [s]."""
        with self._lock:
            tracks = tuple(self._persons.items())
        return tuple(
            SeenPerson(name, track.position, track.velocity, now - track.at)
            for name, track in tracks
            if now - track.at <= SEEN_TIME
        )


class _Track:
    """One tracked person."""

    def __init__(self) -> None:
        self.at = self._since = float("-inf")
        self.position: Vec3 = (0.0, 0.0, 0.0)
        self._from: Vec2 = (0.0, 0.0)
        self.velocity: Vec2 = (0.0, 0.0)

    def add(self, sighting: Sighting) -> None:
        at, position = sighting.captured_at, sighting.pose.position
        if at <= self.at:
            return
        is_new = at - self.at > SEEN_TIME
        self.at, self.position = at, position
        passed = at - self._since
        if is_new or passed >= _WINDOW:
            moved = position[0] - self._from[0], position[1] - self._from[1]
            speed = (moved[0] / passed, moved[1] / passed)
            self.velocity = (
                speed
                if not is_new and abs(speed[0]) + abs(speed[1]) < _FASTEST
                else (
                    0.0,
                    0.0,
                )
            )
            self._since, self._from = at, position[:2]
