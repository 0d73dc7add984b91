"""The third witness, compiled: the motion that the drone's attitude must have given it.

    v' = g tan(tilt) + d - drag v

in the world, by the attitude that the drone reports and the heading that tracking told. ``d`` is
whatever pushes steadily. It drifts within seconds, so it is tied to what is believed, and is asked
only which of two others has just changed without a cause.
"""

from __future__ import annotations

from math import cos, sin, tan
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from housefly.geometry import GRAVITY
from housefly.numeric import clipped, compiled

FELT_RING_SIZE = 512
"""Reports kept; a power of two."""
FELT_MOTION = np.dtype([(name, "f8") for name in ("at", "x", "y")])
"""One report: when it was written [s], and the place by attitude alone [m]."""
FeltRing = NDArray[Any]

TIE = 1.0
"""How quickly velocity and push are tied to what is believed [rad/s]."""
PUSH_MAX = 1.5
"""Largest steady push believed along an axis [m/s^2]."""
STEP_MAX = 0.25
"""A longer time between two reports is a hole: nothing is known of the way [s]."""


class FeltState(NamedTuple):
    """Where the witness stands.

    Attributes:
        reports: how many were taken in.
        vx, vy: velocity in the world [m/s].
        px, py: steady push [m/s^2].
        since: no hole since then [s].
    """

    reports: int
    vx: float
    vy: float
    px: float
    py: float
    since: float


NOTHING_FELT = FeltState(0, 0.0, 0.0, 0.0, 0.0, 0.0)


@compiled
def felt_advanced(
    s: FeltState,
    ring: FeltRing,
    at: float,
    seconds: float,
    theta: float,
    phi: float,
    heading: float,
    drag: float,
) -> FeltState:
    """Return the witness after a report; one that is not newer than the last changes nothing.

    Args:
        s: before.
        ring: of reports.
        at: when it was written [s].
        seconds: how long the drone flew since the one before [s].
        theta: pitch [rad].
        phi: roll [rad].
        heading: in the world [rad].
        drag: linear drag over mass [1/s].
    """
    mask = ring.size - 1
    before, row = ring[(s.reports - 1) & mask], ring[s.reports & mask]
    if s.reports > 0 and at <= before.at:
        return s
    row.at = at
    if s.reports == 0 or not 0.0 <= seconds <= STEP_MAX or abs(theta) > 1.0 or abs(phi) > 1.0:
        row.x, row.y = 0.0, 0.0
        return FeltState(s.reports + 1, s.vx, s.vy, s.px, s.py, at)
    forward, left = GRAVITY * tan(theta), -GRAVITY * tan(phi) / cos(theta)
    c, n = cos(heading), sin(heading)
    ax, ay = c * forward - n * left + s.px, n * forward + c * left + s.py
    half = 0.5 * seconds
    vx = s.vx + seconds * (ax - drag * (s.vx + half * (ax - drag * s.vx)))
    vy = s.vy + seconds * (ay - drag * (s.vy + half * (ay - drag * s.vy)))
    row.x, row.y = before.x + half * (s.vx + vx), before.y + half * (s.vy + vy)
    return FeltState(s.reports + 1, vx, vy, s.px, s.py, s.since)


@compiled
def felt_place(s: FeltState, ring: FeltRing, at: float) -> tuple[float, float]:
    """Return the place by attitude alone at a time [s], between or after reports [m]."""
    mask, newest = ring.size - 1, s.reports - 1
    index, oldest = newest, max(s.reports - ring.size, 0)
    while index > oldest and ring[index & mask].at > at:
        index -= 1
    a = ring[index & mask]
    if index == newest:
        ahead = min(max(at - a.at, 0.0), STEP_MAX)
        return a.x + ahead * s.vx, a.y + ahead * s.vy
    b = ring[(index + 1) & mask]
    share = min(max((at - a.at) / (b.at - a.at), 0.0), 1.0) if b.at > a.at else 0.0
    return a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)


@compiled
def felt_tied(s: FeltState, x: float, y: float, seconds: float) -> FeltState:
    """Return the witness tied to who is believed, that is faster by (x, y) [m/s], for a time [s].

    A critically damped observer: it adopts a velocity within two seconds, a push within four.
    """
    k, kk = min(2.0 * TIE * seconds, 1.0), TIE * TIE * seconds
    return FeltState(
        s.reports,
        s.vx + k * x,
        s.vy + k * y,
        clipped(s.px + kk * x, PUSH_MAX),
        clipped(s.py + kk * y, PUSH_MAX),
        s.since,
    )
