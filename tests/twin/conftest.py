"""Small rooms and a steady hand on the sticks, for the tests of the simulated world."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import radians

import pytest
from empty_hall import empty_hall

from housefly.config.site import Site, changed
from housefly.geometry import Vec3, quaternion_from_euler
from housefly.messages.stick import Stick
from housefly.room.model import Room, Shape, Solid, TrackingCamera
from housefly.twin.contracts import FlightState
from housefly.twin.world import SimulatedWorld


@dataclass
class Hand:
    """Keeps the simulated drone's client alive and moves time on."""

    world: SimulatedWorld

    def wait(self, seconds: float, each: Callable[[], None] | None = None) -> None:
        """Let time pass in steps of 10 ms, feed the watchdog, call ``each`` after every step."""
        for _ in range(round(seconds / 0.01)):
            self.world.keep_alive()
            self.world.advance(0.01)
            if each is not None:
                each()

    def hover(self, height: float = 1.0) -> None:
        """Trim, take off and hover; then climb or sink to about this height [m]."""
        self.world.flat_trim()
        self.world.request_take_off()
        self.wait(8.0)
        assert self.world.onboard().flight is FlightState.HOVERING
        while abs(missing := height - self.world.onboard().height) > 0.1:
            self.fly(up=max(-1.0, min(1.0, missing)), seconds=0.1)
        self.world.set_stick(Stick())
        self.wait(2.0)

    def fly(
        self,
        forward: float = 0.0,
        left: float = 0.0,
        up: float = 0.0,
        turn: float = 0.0,
        seconds: float = 1.0,
    ) -> None:
        """Hold a stick for some time."""
        self.world.set_stick(Stick(forward, left, up, turn, hover=False))
        self.wait(seconds)


@pytest.fixture
def make_room() -> Callable[..., Room]:
    """Return a maker of rooms 12 m by 5 m with nothing in them unless asked."""
    return empty_hall


@pytest.fixture
def make_world(make_room: Callable[..., Room]) -> Callable[..., SimulatedWorld]:
    """Return a maker of worlds; keywords are dotted site keys with two underscores."""

    def make(room: Room | None = None, **values: object) -> SimulatedWorld:
        return SimulatedWorld(changed(Site(), **values), room or make_room())

    return make


@pytest.fixture
def hand() -> type[Hand]:
    """Return the class that holds the sticks."""
    return Hand


@pytest.fixture
def wall() -> Solid:
    """Return a wall across the room, 2 m in front of the pad."""
    return Solid("wall", "wall", Shape.BOX, (4.0, 2.5, 1.3), (0.1, 5.0, 2.6))


@pytest.fixture
def ceiling_cameras() -> tuple[TrackingCamera, ...]:
    """Return three cameras that look straight down on the pad from 2.6 m."""
    down = quaternion_from_euler(radians(180.0), 0.0, 0.0)
    view = (radians(80.0), radians(80.0))
    at: tuple[Vec3, ...] = ((1.5, 2.5, 2.6), (2.5, 2.5, 2.6), (2.0, 3.0, 2.6))
    return tuple(
        TrackingCamera(f"camera {n}", position, down, view, 5.0) for n, position in enumerate(at)
    )
