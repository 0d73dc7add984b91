"""F37: another drone in the room, tracked like any body, is never nearer than 1 m by our doing."""

from __future__ import annotations

from collections.abc import Callable
from math import dist, inf
from typing import Any

import pytest

from housefly.geometry import Vec2, Vec3
from housefly.messages import DroneStatus, Phase, Pose, Sighting

Fly = Callable[..., Any]
LEVEL = (1.0, 0.0, 0.0, 0.0)
SEPARATION, SEPARATION_AT_REST = 1.0, 0.7
"""From centre to centre, of one that flies and of one that stands still in the air [m]."""


class SecondDrone:
    """A drone that flies straight on and makes way for nobody."""

    def __init__(self, flight: Any, start: Vec2, velocity: Vec2) -> None:
        self._flight, self._began, self._look = flight, flight.now, flight._look
        self._start, self._velocity = start, velocity
        self.nearest = inf
        flight._look = self._seen_too

    @property
    def position(self) -> Vec3:
        """Where it is now [m]."""
        flown = self._flight.now - self._began
        (x, y), (vx, vy) = self._start, self._velocity
        return x + flown * vx, y + flown * vy, 1.1

    def _seen_too(self) -> tuple[Sighting, ...]:
        flight, here = self._flight, self.position
        if flight.status is not DroneStatus.LANDED:
            body = flight.body
            self.nearest = min(self.nearest, dist(here, (body.x, body.y, body.z)))
        now = flight.now
        return (*self._look(), Sighting("second", Pose(here, LEVEL), now - 0.01, now))


@pytest.mark.parametrize(
    ("start", "velocity", "separation"),
    [
        ((9.0, 3.2), (-0.5, 0.0), SEPARATION),
        ((7.0, 4.8), (0.0, -0.3), SEPARATION),
        pytest.param((2.6, 2.62), (0.9, 0.0), SEPARATION, marks=pytest.mark.safety),
        ((7.0, 3.2), (0.0, 0.0), SEPARATION_AT_REST),
    ],
    ids=["head-on", "crossing", "from behind", "hovering in the way"],
)
def test_a_second_drone_that_is_tracked_is_kept_clear_of(
    fly: Fly, start: Vec2, velocity: Vec2, separation: float
) -> None:
    flight = fly()
    flight.depart(6.0)
    second = SecondDrone(flight, start, velocity)
    flight.until(lambda o: o.phase is Phase.HOLDING, 40.0)
    assert second.nearest > separation
