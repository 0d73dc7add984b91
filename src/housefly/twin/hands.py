"""Hands that carry the simulated drone, level, along a straight line."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from itertools import pairwise
from math import cos, isfinite, pi, sin

from housefly.errors import WireError
from housefly.geometry import Vec3, distance, wrap_angle

CARRY_TIME_MAX = 60.0
_REACH = 1000.0
_IN_HANDS = 1.1
"""So high a drone is carried over what stands in between [m] ..."""
_WALK_SPEED = 0.8
"""... and so fast, in the mean [m/s]: tracking follows."""


@dataclass(frozen=True, slots=True)
class CarryOrder:
    """Where to carry the drone.

    Attributes:
        position: of its body, in the world [m]; each within a kilometre.
        yaw: its heading there, -2 pi to 2 pi [rad].
        duration: how long that takes, 0.1 to 60 s.
        drone: which drone, "" for the first.

    Raises:
        WireError: a value out of its range.
    """

    position: Vec3
    yaw: float
    duration: float = 2.0
    drone: str = ""

    def __post_init__(self) -> None:
        if len(self.position) != 3 or not all(
            isfinite(value) and abs(value) <= _REACH for value in self.position
        ):
            raise WireError(f"position {self.position} m is not within a kilometre")
        if not (isfinite(self.yaw) and abs(self.yaw) <= 2.0 * pi):
            raise WireError(f"yaw is {self.yaw} rad; allowed: -6.28 to 6.28 rad")
        if not (isfinite(self.duration) and 0.1 <= self.duration <= CARRY_TIME_MAX):
            raise WireError(f"duration is {self.duration} s; allowed: 0.1 to 60 s")


@dataclass(frozen=True, slots=True)
class Carry:
    """A drone on its way in somebody's hands.

    Attributes:
        order: where to.
        start: where it was taken up [m].
        start_yaw: likewise [rad].
        began: when [s].
    """

    order: CarryOrder
    start: Vec3
    start_yaw: float
    began: float

    def at(self, now: float) -> tuple[Vec3, float, Vec3, float]:
        """Return position [m], heading [rad], velocity [m/s] and turn rate [rad/s] now [s].

        Slow at both ends, and still there after it arrived.
        """
        duration = self.order.duration
        part = min(1.0, max(0.0, (now - self.began) / duration))
        share = 0.5 - 0.5 * cos(pi * part)
        pace = 0.5 * pi * sin(pi * part) / duration
        way = [b - a for a, b in zip(self.start, self.order.position, strict=True)]
        turn = wrap_angle(self.order.yaw - self.start_yaw)
        x, y, z = (a + share * d for a, d in zip(self.start, way, strict=True))
        vx, vy, vz = (pace * d for d in way)
        return (x, y, z), self.start_yaw + share * turn, (vx, vy, vz), pace * turn

    def is_over(self, now: float) -> bool:
        """Return whether it has arrived."""
        return now >= self.began + self.order.duration


def way_in_hands(start: Vec3, end: Vec3, yaw: float) -> tuple[CarryOrder, ...]:
    """Return the orders that carry a drone up, across, and down, where it is laid.

    Args:
        start: where it lies [m].
        end: where it is to stand [m].
        yaw: its heading there [rad].
    """
    high = max(start[2], _IN_HANDS)
    way = (start, (start[0], start[1], high), (end[0], end[1], high), end)
    return tuple(
        CarryOrder(there, yaw, min(CARRY_TIME_MAX, max(0.5, distance(here, there) / _WALK_SPEED)))
        for here, there in pairwise(way)
    )


def encode_carry(order: CarryOrder) -> bytes:
    """Return an order as one datagram."""
    return json.dumps(asdict(order)).encode()


def decode_carry(datagram: bytes) -> CarryOrder:
    """Return the order of a datagram; raises WireError for one that is none."""
    try:
        tree = json.loads(datagram)
        x, y, z = (float(value) for value in tree["position"])
        drone = str(tree.get("drone", ""))
        return CarryOrder((x, y, z), float(tree["yaw"]), float(tree["duration"]), drone)
    except (ValueError, TypeError, KeyError, OverflowError, RecursionError) as error:
        raise WireError(f"no order to carry: {type(error).__name__}: {error}") from error
