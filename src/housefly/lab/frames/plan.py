"""What a person is asked to do with the drone, step by step, in one room."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from math import cos, degrees, inf, pi, sin

import numpy as np

from housefly.geometry import Vec2, Vec3, heading_to
from housefly.numeric import FloatArray, wrapped
from housefly.room.distance import clearance_field, footprints
from housefly.room.model import Room

CARRY_DISTANCE = 1.0
"""Length of the ways over the floor where there is room [m]; measured with a tape."""
_FORWARD, _SIDE = (1.0, 1.5, 2.0, 0.7), (1.0, 0.8, 0.6)
"""Lengths that are tried along the nose and to the side [m]."""
LIFT_HEIGHT = 0.5
"""How high it is lifted [m], about."""
QUARTER_TURN = pi / 2
"""How far it is turned to the left [rad], about."""
_WIDTH = 0.4
"""A way over the floor is free when nothing is nearer to it than this [m]."""
_LOWER, _UPPER = 0.02, 0.6
"""Heights between which solids are in the way of a drone that is carried low [m]."""
_TOWARDS = pi / 9
"""A place within this of the pad's heading says where to look [rad]."""


class CarryStep(Enum):
    """Five samples, and the way back that verifies them."""

    PAD = "on the pad"
    AHEAD = "along the nose"
    SIDE = "to the side"
    LIFT = "lifted"
    TURN = "turned"
    BACK = "back on the pad"


STEPS: tuple[CarryStep, ...] = tuple(CarryStep)


@dataclass(frozen=True, slots=True)
class CarryPlan:
    """The ways of one room.

    Attributes:
        home: the pad, on the map [m].
        heading: of the drone on the pad, on the map [rad].
        forward: length of the way along the nose, negative backwards [m].
        left: length of the way to the left, negative to the right [m].
        towards: what lies in the pad's heading, in words, or "".
    """

    home: Vec2
    heading: float
    forward: float = CARRY_DISTANCE
    left: float = CARRY_DISTANCE
    towards: str = ""

    def instruction(self, step: CarryStep) -> str:
        """Return what to do, in words."""
        ahead = "straight ahead, where its nose points," if self.forward > 0 else "straight back,"
        side = "left" if self.left > 0 else "right"
        towards = f", towards {self.towards}" if self.towards else ""
        return {
            CarryStep.PAD: (
                "Lay the drone on the middle of its pad, its nose along the pad's heading:"
                f" {_heading_words(self.heading)}{towards}."
            ),
            CarryStep.AHEAD: (
                f"Carry it {abs(self.forward):g} m {ahead} and lay it on the floor. Measure with a"
                " tape; do not turn it."
            ),
            CarryStep.SIDE: (
                f"Carry it {abs(self.left):g} m to its {side} and lay it on the floor. Measure;"
                " do not turn it."
            ),
            CarryStep.LIFT: (
                f"Lift it straight up by {LIFT_HEIGHT:g} m, level, and hold it still there. Let"
                " the cameras see its markers."
            ),
            CarryStep.TURN: (
                "Lay it down where it lay, and turn it there by a quarter to the LEFT (seen from"
                " above, against the clock), in about two seconds."
            ),
            CarryStep.BACK: (
                "To verify: lay it back on the middle of its pad, its nose along the pad's heading"
                " as in the beginning."
            ),
        }[step]

    def place(self, step: CarryStep) -> Vec3:
        """Return where a step leaves the drone, on the map and above the floor [m]."""
        (x, y), c, s = self.home, cos(self.heading), sin(self.heading)
        corner = x + self.forward * c, y + self.forward * s
        end = corner[0] - self.left * s, corner[1] + self.left * c
        return {
            CarryStep.PAD: (x, y, 0.0),
            CarryStep.AHEAD: (*corner, 0.0),
            CarryStep.SIDE: (*end, 0.0),
            CarryStep.LIFT: (*end, LIFT_HEIGHT),
            CarryStep.TURN: (*end, 0.0),
            CarryStep.BACK: (x, y, 0.0),
        }[step]

    def nose(self, step: CarryStep) -> float:
        """Return where a step leaves the drone's nose, on the map [rad]."""
        return wrapped(self.heading + (QUARTER_TURN if step is CarryStep.TURN else 0.0))

    def displacement(self, step: CarryStep) -> Vec3:
        """Return how a step moves the drone, from where the step before left it [m]."""
        before = STEPS[max(STEPS.index(step) - 1, 0)]
        x, y, z = (b - a for a, b in zip(self.place(before), self.place(step), strict=True))
        return x, y, z


def carry_plan(room: Room) -> CarryPlan:
    """Return the ways that are free in a room: near 1 m, ahead and left where that is free."""
    rows = footprints(room.solids, _LOWER, _UPPER)
    best, cost = (CARRY_DISTANCE, CARRY_DISTANCE), inf
    for forward in (sign * length for length in _FORWARD for sign in (1.0, -1.0)):
        corner = _along(room.home, room.home_yaw, forward)
        ahead = _least_clearance(room, rows, room.home, corner)
        for left in (sign * length for length in _SIDE for sign in (1.0, -1.0)):
            end = _along(corner, room.home_yaw + pi / 2, left)
            clear = min(ahead, _least_clearance(room, rows, corner, end))
            odd = abs(abs(forward) - 1.0) + 2.0 * abs(abs(left) - 1.0)
            backwards = 0.1 * ((forward < 0.0) + (left < 0.0))
            found = odd + backwards + (0.0 if clear >= _WIDTH else 100.0 * (_WIDTH - clear))
            if found < cost:
                best, cost = (forward, left), found
    return CarryPlan(room.home, room.home_yaw, *best, _towards_words(room))


def _along(start: Vec2, heading: float, length: float) -> Vec2:
    return start[0] + length * cos(heading), start[1] + length * sin(heading)


def _least_clearance(room: Room, rows: FloatArray, start: Vec2, end: Vec2) -> float:
    """Return how near solids and the bounds of the room come to a way, its start left out [m]."""
    x_min, y_min, x_max, y_max = room.bounds
    least = 5.0
    for part in (0.25, 0.5, 0.75, 1.0):
        x, y = (a + part * (b - a) for a, b in zip(start, end, strict=True))
        inside = min(x - x_min, x_max - x, y - y_min, y_max - y)
        clear = float(clearance_field(rows, np.array([x]), np.array([y]), 5.0)[0, 0])
        least = min(least, inside, clear)
    return least


def _heading_words(heading: float) -> str:
    """Return a heading on the map in words."""
    quarter = round(heading / (pi / 2)) % 4
    angle = f"{degrees(wrapped(heading)):.0f} deg on the map"
    if abs(wrapped(heading - quarter * pi / 2)) > 0.1:
        return angle
    return f"{angle} (along {('+x', '+y', '-x', '-y')[quarter]})"


def _towards_words(room: Room) -> str:
    """Return the title of the place that lies nearest to the pad's heading, or ""."""
    found = [
        (abs(wrapped(heading_to(room.home, place.viewpoint) - room.home_yaw)), place)
        for place in room.places
        if place.name != "home" and place.viewpoint != room.home
    ]
    near = [(angle, place.title or place.name) for angle, place in found if angle < _TOWARDS]
    return min(near)[1] if near else ""
