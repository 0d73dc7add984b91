"""The other drones of the site, as tracking shows them: what flies is kept away from as people are.

Two drones that made way for each other would dance. So the one that stands earlier in the site has
the right of way: to it the other is a thing where it is now, once it is near or hovers. Nobody has
the right of way over one that takes off or lands, which cannot make way, nor over one that comes at
it all the same. One that was lost sight of in the air may still fly: its last place is kept clear
for a while.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import hypot, inf, isfinite

from housefly.config.airframe import TakeOffConstants
from housefly.config.site import Site
from housefly.geometry import distance
from housefly.messages.obstacles import Obstacle, ObstacleKind
from housefly.messages.sensing import Sighting
from housefly.pilot.planning.furniture import TrackedPose
from housefly.pilot.planning.obstacles import OBSTACLE_CLOCK_TOLERANCE

DRONE_SOURCE = "other drone"
"""Source of these obstacles."""
DRONE_REPORT_PERIOD = 0.1
"""A drone is told again after this [s]."""
OFF_GROUND = 0.15
"""A drone this much higher than it stands flies, or is carried [m]."""
LOW = 0.3
"""One that flies so much lower than drones do takes off or lands [m]."""
LOST_AFTER = 0.5
"""Tracking that shows us, and another drone not for so long, has lost it [s]."""
LOST_KEPT = 60.0
"""The last place of a drone that is not seen any more is kept clear for so long [s]."""
LOST_MARGIN = 0.3
"""A drone without tracking brakes, hovers and lands at most so far beside its last place [m]."""
PASSING_MARGIN = 0.3
"""Who has the right of way keeps this much more from hull to hull than from a thing [m]."""
HEED_DISTANCE = 3.0
"""One that flies somewhere, and gives way to us, is not in our way yet when farther off [m]."""
HOVER_SPEED = 0.2
"""What flies slower than this hovers [m/s]."""
URGENT_TIME = 1.2
"""Right of way is nothing against a drone that would be at ours within this time [s] ..."""
URGENT_DISTANCE = 0.3
"""... and nearer from hull to hull than this [m] ..."""
URGENT_SPEED = 0.3
"""... because it flies at us, faster than this [m/s] ..."""
URGENT_KEPT = 2.0
"""... and for so long after that [s]."""
SETTLED_TIME = 5.0
"""One that has just come to hover, or up, sets off at any moment for so long [s]."""
_TOP = 9.0
"""Nothing is flown over that flies [m]."""
_STANDING_TOP = 0.3
"""A drone that stands is no higher than this [m]."""


@dataclass(frozen=True, slots=True)
class OtherDrone:
    """What is known of one of them beforehand.

    Attributes:
        name: as the site has it.
        radius: of the disc around its hull [m].
        standing_height: of its middle when it stands [m].
        rising_time: from the floor to where it can be steered [s].
        gives_way: whether it gives way to us.
    """

    name: str
    radius: float
    standing_height: float
    rising_time: float
    gives_way: bool


@dataclass(frozen=True, slots=True)
class _Seen:
    pose: TrackedPose
    flies: bool
    is_low: bool
    urgent_until: float = -inf
    settles_at: float = -inf


class OtherDrones:
    """All drones of a site but one.

    Args:
        site: as the chain of that one sees it.

    Attributes:
        lost: names of those that were lost sight of in the air, and whose place is kept clear.
        restless: names of those that hover, or rise, and may set off at any moment.
    """

    def __init__(self, site: Site) -> None:
        names = site.drone_names
        own = names.index(site.drone.name) if site.drones and site.drone.name in names else None
        self._own, self._radius = site.tracking.body, site.drone.reach
        self._low = site.map.flight_height - LOW
        self._drones = {
            drone.tracked_body: OtherDrone(
                drone.name,
                drone.reach,
                drone.airframe.body.standing_height,
                _rising_time(drone.airframe.take_off),
                names.index(drone.name) > own,
            )
            for drone in site.drones
            if own is not None and drone.enabled and drone.name != site.drone.name
        }
        self.lost: tuple[str, ...] = ()
        self.restless: frozenset[str] = frozenset()
        self._seen: dict[str, _Seen] = {}
        self._told_at: dict[str, float] = {}
        self._here: TrackedPose | None = None

    @property
    def bodies(self) -> frozenset[str]:
        """Their names among the tracked bodies."""
        return frozenset(self._drones)

    def step(self, sightings: Iterable[Sighting], now: float) -> tuple[Obstacle, ...]:
        """Return what is new of them at a time [s]."""
        if not self._drones:
            return ()
        for sighting in sightings:
            if sighting.body == self._own:
                self._here = _updated(self._here, sighting, now) or self._here
            elif sighting.body in self._drones:
                self._see(sighting, now)
        self._seen = {
            body: seen for body, seen in self._seen.items() if now - seen.pose.at <= LOST_KEPT
        }
        self.lost = tuple(
            self._drones[body].name
            for body, seen in self._seen.items()
            if seen.flies and self._is_lost(seen)
        )
        self.restless = frozenset(
            self._drones[body].name for body, seen in self._seen.items() if now < seen.settles_at
        )
        due = [
            body
            for body in sorted(self._seen)
            if now - self._told_at.get(body, -inf) >= DRONE_REPORT_PERIOD
        ]
        self._told_at |= dict.fromkeys(due, now)
        return tuple(self._obstacle(body, now) for body in due)

    def _see(self, sighting: Sighting, now: float) -> None:
        body, drone = sighting.body, self._drones[sighting.body]
        before = self._seen.get(body)
        pose = _updated(before.pose if before else None, sighting, now)
        if pose is None:
            return
        height = sighting.pose.position[2]
        flies = height > drone.standing_height + OFF_GROUND
        until = before.urgent_until if before else -inf
        if flies and drone.gives_way and self._comes_at_us(pose, drone.radius):
            until = now + URGENT_KEPT
        settles = _settles_at(before, pose, drone, now) if flies else -inf
        self._seen[body] = _Seen(pose, flies, height < self._low, until, settles)

    def _comes_at_us(self, pose: TrackedPose, radius: float) -> bool:
        """Return whether a drone flies at ours, were that to stay where it is."""
        speed = hypot(*pose.velocity)
        if self._here is None or speed < URGENT_SPEED:
            return False
        (x, y), (vx, vy), here = pose.middle, pose.velocity, self._here.middle
        dx, dy = here[0] - x, here[1] - y
        time = min(max((dx * vx + dy * vy) / (speed * speed), 0.0), URGENT_TIME)
        apart = hypot(dx - vx * time, dy - vy * time) - radius - self._radius
        return apart < URGENT_DISTANCE and time > 0.0

    def _is_elsewhere(self, pose: TrackedPose) -> bool:
        """Return whether a drone that gives way will be somewhere else when we come there."""
        if self._here is None or hypot(*pose.velocity) < HOVER_SPEED:
            return False
        return distance(pose.middle, self._here.middle) > HEED_DISTANCE

    def _is_lost(self, seen: _Seen) -> bool:
        return self._here is not None and self._here.at - seen.pose.at > LOST_AFTER

    def _obstacle(self, body: str, now: float) -> Obstacle:
        drone, seen = self._drones[body], self._seen[body]
        is_lost = self._is_lost(seen)
        has_way = not drone.gives_way or seen.is_low or now <= seen.urgent_until
        is_met = seen.flies and not is_lost and has_way
        margin = 0.0
        if seen.flies and not is_met:
            margin = LOST_MARGIN if is_lost else PASSING_MARGIN
        is_far = seen.flies and not is_lost and not is_met and self._is_elsewhere(seen.pose)
        return Obstacle(
            id=drone.name,
            position=seen.pose.middle,
            radius=drone.radius + margin,
            top=_TOP if seen.flies else _STANDING_TOP,
            velocity=seen.pose.velocity if is_met else (0.0, 0.0),
            confidence=0.0 if is_far else 1.0,
            seen_at=seen.pose.at if is_met else now,
            source=DRONE_SOURCE,
            kind=ObstacleKind.DRONE if is_met else ObstacleKind.THING,
        )


def _settles_at(before: _Seen | None, pose: TrackedPose, drone: OtherDrone, now: float) -> float:
    """Return when a drone in the air will have hovered for so long that it stays [s]."""
    if before is not None and not before.flies:
        return now + drone.rising_time + SETTLED_TIME
    if hypot(*pose.velocity) >= HOVER_SPEED:
        return now + SETTLED_TIME
    return before.settles_at if before else -inf


def _rising_time(climb: TakeOffConstants) -> float:
    return climb.steerable_height / climb.climb_rate


def _updated(before: TrackedPose | None, sighting: Sighting, now: float) -> TrackedPose | None:
    """Return where a body is after a sighting; None for one that says nothing new."""
    at, (x, y, z) = sighting.captured_at, sighting.pose.position
    if not all(isfinite(number) for number in (at, x, y, z)):
        return None
    if at > now + OBSTACLE_CLOCK_TOLERANCE or (before is not None and at <= before.at):
        return None
    if before is None:
        return TrackedPose(at, (x, y), 0.0, (0.0, 0.0), at, (x, y))
    return before.updated(at, (x, y), 0.0)
