"""How to get past people on a trajectory: at once, slower, or after a wait.

Everybody walks on as they walk now, less surely the farther ahead. Each choice is looked at as it
would be flown: the rate of the trajectory's time changes as ``time_scale`` changes it, and near
people it is no faster than ``speed_share`` lets it be.
"""

from __future__ import annotations

from math import inf
from typing import Any, NamedTuple

import numpy as np

from housefly.numeric import FloatArray, compiled
from housefly.pilot.planning.people import (
    SPEED_UNCERTAINTY,
    UNCERTAIN_TIME,
    WALKING_SPEED,
    ObservedPeople,
    speed_share,
)
from housefly.pilot.planning.space.approach import approach_distances
from housefly.pilot.planning.trajectory.time_scale import TimeScale, motion_at, scale_advanced

LOOKED_AHEAD = 3.5
"""People are thought of for so long after a wait [s]; nobody walks straight on for much longer."""
STEP = 0.1
"""Between two looks [s]."""
CHOICES = (
    *((0.0, rate) for rate in (1.0, 0.75, 0.5, 0.3)),
    *((wait, 1.0) for wait in (0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0)),
)
"""Waits [s] and the rates of the trajectory's time after them."""


class Passage(NamedTuple):
    """One way of flying on.

    Attributes:
        wait: to stand so long first [s].
        rate: of the trajectory's time afterwards.
        arrival: at the end of the trajectory, from now on [s].
        margin: smallest distance from people beyond what is kept [m]; where somebody is nearer
            already, beyond how near they are.
    """

    wait: float
    rate: float
    arrival: float
    margin: float


class KeptDistances(NamedTuple):
    """What is kept from people [m].

    Attributes:
        hull: radius of the disc around the drone.
        comfort: ahead of them.
        least: never less.
        slow: from hull to body, nearer than this it flies slower.
        slowest: the same, here and nearer it is slowest.
    """

    hull: float
    comfort: float
    least: float
    slow: float = 0.0
    slowest: float = 0.0


@compiled
def _margin(people: Any, x: float, y: float, ahead: float, kept: Any) -> tuple[float, float]:
    """Return distances from people [m] at a time ahead [s]: beyond what is kept, and to a body.

    ``kept`` is how far before those who walk the middle of their disc is, its distance, and the
    distance around those who stand, from the middle of the drone [m].
    """
    best, nearest = inf, inf
    for n in range(people.shape[0]):
        vx, vy = people[n, 2], people[n, 3]
        speed = np.sqrt(vx * vx + vy * vy)
        walked = min(ahead, people[n, 5])
        px, py, need = people[n, 0] + vx * walked, people[n, 1] + vy * walked, kept[2]
        to_body = np.sqrt((x - px) * (x - px) + (y - py) * (y - py)) - people[n, 4]
        nearest = min(nearest, to_body)
        if speed > WALKING_SPEED:
            px, py, need = px + kept[0] * vx / speed, py + kept[0] * vy / speed, kept[1]
        if speed > 0.0:
            need += SPEED_UNCERTAINTY * min(ahead, UNCERTAIN_TIME)
        apart = np.sqrt((x - px) * (x - px) + (y - py) * (y - py))
        best = min(best, apart - people[n, 4] - need)
    return best, nearest


@compiled
def _fly(
    people: Any,
    kept: Any,
    scale: TimeScale,
    rows: FloatArray,
    tick: float,
    braking: float,
    wait: float,
    rate: float,
    ahead: float,
    step: float,
) -> tuple[float, float]:
    """Return the smallest margin while it flies on [m], and when it arrives [s]."""
    end = tick * (rows.shape[0] - 1)
    best, floor, now = inf, 0.0, 0.0
    while now <= ahead:
        here = motion_at(scale, rows, tick)
        margin, nearest = _margin(people, here.x, here.y, now, kept)
        if now == 0.0:
            floor = min(0.0, margin)
        best = min(best, margin - floor)
        if scale.time >= end:
            break
        share = speed_share(nearest - kept[3], kept[4], kept[5])
        wanted = 0.0 if now < wait else min(rate, share)
        scale = scale_advanced(scale, rows, tick, wanted, braking, step)
        now += step
    return best, now + max(end - scale.time, 0.0) / rate


def passages(
    people: ObservedPeople,
    scale: TimeScale,
    rows: FloatArray,
    tick: float,
    distances: KeptDistances,
    braking: float,
) -> list[Passage]:
    """Return all choices, the earliest arrival first.

    Args:
        people: where they are now.
        scale: how far the trajectory has been flown.
        rows: of the trajectory, shape (n, 9) or wider.
        tick: time between two of them [s].
        distances: to keep from people.
        braking: deceleration to count on [m/s^2].
    """
    rows, seen = np.ascontiguousarray(rows), np.ascontiguousarray(people.rows)  # compiled once
    before, beside = approach_distances(distances.comfort, distances.least)
    hull = distances.hull
    kept = (
        *(before, beside + hull, distances.comfort + hull),
        *(hull, distances.slow, distances.slowest),
    )
    found = []
    for wait, rate in CHOICES:
        margin, arrival = _fly(
            seen, kept, scale, rows, tick, braking, wait, rate, LOOKED_AHEAD + wait, STEP
        )
        found.append(Passage(wait, rate, arrival, margin))
    return sorted(found, key=lambda choice: choice.arrival)


def first_passage(choices: list[Passage], give: float) -> Passage | None:
    """Return the earliest choice that comes nearer than it should by no more than ``give`` [m]."""
    return next((choice for choice in choices if choice.margin >= -give), None)
