"""Judges a flight in real processes on the recorded truth, by the invariants of the matrix."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from housefly.geometry import stopping_distance
from housefly.lab.safety_case.oracle import FALL_HEIGHT, HARD_LANDING, STANDING
from housefly.record.truth import TrueFlight

Bounds = tuple[float, float, float, float]
"""Smallest and largest x and y of a room, in the order of ``Room.bounds`` [m]."""
_FALL_TIME = 0.15
"""A fall is judged over at least this long: samples are 0.02 s apart [s]."""


def wired_violations(
    truth: TrueFlight, bounds: Bounds, speed: float, end: str, *, cannot_hover: bool = False
) -> tuple[str, ...]:
    """Return what happened that must not, in words; none means safe.

    Args:
        truth: of the whole flight.
        bounds: of the room.
        speed: cruise speed of the site [m/s].
        end: when the flight was over, in words.
        cannot_hover: whether it has to fall by its fault, which is not judged then.
    """
    return (
        *sorted({f"I1: touched {c.kind} {c.name}" for c in truth.contacts if c.motors_turned}),
        *_outside(truth, bounds, stopping_distance(speed, 1.0, 0.3)),
        *_cut_in_the_air(truth),
        *_risen_again(truth),
        *(() if cannot_hover else _fallen(truth)),
        *_left_up(truth, end),
    )


def _outside(truth: TrueFlight, bounds: Bounds, allowed: float) -> Iterator[str]:
    x_min, y_min, x_max, y_max = bounds
    x, y = truth.position[:, 0], truth.position[:, 1]
    outside = float(np.maximum.reduce([x_min - x, x - x_max, y_min - y, y - y_max]).max())
    if outside > allowed:
        yield f"I2: {outside:.1f} m outside the room"


def _cut_in_the_air(truth: TrueFlight) -> Iterator[str]:
    stopped = np.flatnonzero(truth.airborne[:-1] & ~truth.airborne[1:])
    heights = truth.position[stopped, 2]
    if len(heights) and heights.max() > FALL_HEIGHT:
        yield f"I4: the motors stopped at {heights.max():.1f} m"


def _risen_again(truth: TrueFlight) -> Iterator[str]:
    """One order is given: who stood after it and rises again does so without one."""
    if np.count_nonzero(~truth.airborne[:-1] & truth.airborne[1:]) > 1:
        yield "I8: took off again without an order"


def _fallen(truth: TrueFlight) -> Iterator[str]:
    height = truth.position[:, 2]
    later = np.searchsorted(truth.time, truth.time + _FALL_TIME)
    ends = later < len(height)
    lost = height[ends] - height[later[ends]]
    took = truth.time[later[ends]] - truth.time[ends]
    fastest = float(np.max(lost / took, initial=0.0))
    if fastest > HARD_LANDING:
        yield f"fall: came down at {fastest:.1f} m/s"


def _left_up(truth: TrueFlight, end: str) -> Iterator[str]:
    if truth.airborne[-1] or truth.position[-1][2] > STANDING:
        yield f"end: at {truth.position[-1][2]:.1f} m {end}"
