"""A hall with a scanner in its corner, and scans of known truth: people are upright cylinders."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from math import inf, pi

import numpy as np
import pytest

from housefly.config.laser import LaserConfig
from housefly.geometry import Vec2
from housefly.messages import Scan
from housefly.perception.background import expected_ranges
from housefly.perception.laser_tracker import LaserTracker, OwnFootprint, TrackingResult
from housefly.room.model import Place, Room, Shape, Solid

STEP, BEAMS = 2.0 * pi / 1440, 1081
FIRST = -0.75 * pi
PERIOD = 0.025


def hall() -> Room:
    def wall(name: str, x: float, y: float, length: float, width: float) -> Solid:
        return Solid(name, "wall", Shape.BOX, (x, y, 1.3), (length, width, 2.6))

    solids = (
        wall("south", 5.0, -0.1, 10.4, 0.2),
        wall("north", 5.0, 6.1, 10.4, 0.2),
        wall("west", -0.1, 3.0, 0.2, 6.4),
        wall("east", 10.1, 3.0, 0.2, 6.4),
        Solid("pillar", "pillar", Shape.CYLINDER, (7.0, 4.5, 1.3), (0.4, 0.4, 2.6)),
        Solid("cupboard", "cupboard", Shape.BOX, (4.0, 5.6, 0.9), (1.2, 0.6, 1.8), 0.2),
    )
    return Room(
        "hall",
        (0.0, 0.0, 10.0, 6.0),
        2.6,
        solids,
        (Place("home", (2.0, 2.0), (3.0, 2.0, 1.0)),),
        (),
        (2.0, 2.0),
    )


def scanners() -> tuple[LaserConfig, ...]:
    return (
        LaserConfig(name="laser-1", x=0.15, y=0.15, yaw=pi / 4),
        LaserConfig(name="laser-2", address="127.0.0.2", x=9.85, y=5.85, yaw=-3 * pi / 4),
    )


@dataclass
class Hall:
    """Scans of the hall with things in it, and what the tracker makes of them."""

    noise: float = 0.01
    loss: float = 0.002
    seed: int = 1
    lasers: Sequence[int] = (0,)
    now: float = 10.0
    things: dict[str, tuple[Vec2, float]] = field(default_factory=dict)
    own: tuple[OwnFootprint, ...] = ()

    def __post_init__(self) -> None:
        self.random = np.random.default_rng(self.seed)
        self.configs = scanners()
        self.room = hall()
        self.tracker = LaserTracker(self.room, self.configs)
        self.seen = TrackingResult()

    def scan(self, number: int = 0) -> Scan:
        laser = self.configs[number]
        people = tuple(
            Solid(n, n, Shape.CYLINDER, (*at, 1.0), (2 * r, 2 * r, 2.0))
            for n, (at, r) in self.things.items()
        )
        ranges = expected_ranges(self.room.solids + people, laser, FIRST, STEP, BEAMS)
        ranges = ranges + self.random.normal(0.0, self.noise, BEAMS)
        ranges[self.random.random(BEAMS) < self.loss] = inf
        return Scan(
            laser.name,
            self.now - 0.03,
            self.now,
            FIRST,
            STEP,
            tuple(np.maximum(ranges, 0.0).tolist()),
        )

    def look(
        self, scans: int = 1, moving: Callable[[float], dict[str, tuple[Vec2, float]]] | None = None
    ) -> TrackingResult:
        for _ in range(scans):
            self.now += PERIOD
            if moving is not None:
                self.things = moving(self.now - 0.03)
            for number in self.lasers:
                self.seen = self.tracker.update(self.scan(number), self.now, self.own)
        return self.seen


@pytest.fixture
def make_hall() -> type[Hall]:
    return Hall
