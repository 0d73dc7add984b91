"""How the moving reference travels along a path, compiled: arc length, speed and heading.

It speeds up and slows down at a bounded rate, creeps around corners, stops at the end, and waits
for a drone that lags.
"""

from __future__ import annotations

from math import atan2, sqrt
from typing import NamedTuple

from housefly.numeric import FloatArray, compiled
from housefly.pilot.behavior.path_profile import PathProfile

REFERENCE_ACCELERATION = 0.4
"""How quickly the reference speeds up and slows down [m/s^2]: a fifth of what the tilt limit can
give.
"""
HEADING_LOOKAHEAD = 0.5
"""The drone looks to where the path will be after this distance [m], so that turns begin before
corners.
"""
HEADING_FREEZE = 0.25
"""Nearer than this to the end the heading stays [m]: a direction over a short distance means
nothing.
"""
LAG_MAX = 0.3
"""The reference waits while the drone is further behind than this [m]."""


class PathProgress(NamedTuple):
    """How far the reference has come.

    Attributes:
        s: arc length [m].
        v: speed [m/s].
        a: acceleration [m/s^2].
        leg: number of the leg.
        yaw: heading of the path [rad]; nan until there is one.
    """

    s: float
    v: float
    a: float
    leg: int
    yaw: float


class TrajectorySetpoint(NamedTuple):
    """Place [m], velocity [m/s], acceleration [m/s^2] and heading [rad, nan keeps it] to track."""

    x: float
    y: float
    vx: float
    vy: float
    ax: float
    ay: float
    yaw: float
    waypoint: int
    finished: bool


@compiled
def speed_allowed(
    s: float, leg: int, wanted: float, marks: FloatArray, speeds: FloatArray, acceleration: float
) -> float:
    """Return the highest speed [m/s] from which every mark ahead can be passed at its own."""
    squared = wanted * wanted
    for mark in range(leg + 1, marks.size):
        braking = 2.0 * acceleration * (marks[mark] - s)
        if braking >= squared:
            break
        squared = min(squared, speeds[mark] * speeds[mark] + braking)
    return sqrt(squared)


@compiled
def profile_travelled(
    s: float,
    v: float,
    leg: int,
    wanted: float,
    marks: FloatArray,
    speeds: FloatArray,
    acceleration: float,
    dt: float,
) -> tuple[float, float]:
    """Return arc length [m] and speed [m/s] after dt [s], respecting the marks ahead."""
    end = marks[-1]
    target = speed_allowed(s, leg, wanted, marks, speeds, acceleration)
    faster, slower = v + acceleration * dt, v - 1.5 * acceleration * dt
    v_new = max(0.0, min(faster, max(slower, target)))
    s_new = s + 0.5 * (v + v_new) * dt
    if s_new >= end - 1e-4:
        return end, 0.0
    return s_new, v_new


@compiled
def leg_from(leg: int, s: float, marks: FloatArray) -> int:
    """Return the number of the leg at arc length s [m], searched from an earlier one."""
    while leg < marks.size - 2 and marks[leg + 1] <= s:
        leg += 1
    return leg


@compiled
def point_on(leg: int, s: float, way: PathProfile) -> tuple[float, float]:
    """Return the point [m] at arc length s [m], which lies on this leg or past the end."""
    x, y = way.points[leg, 0], way.points[leg, 1]
    if way.marks.size == 1:
        return x, y
    done = min(max(s - way.marks[leg], 0.0), way.marks[leg + 1] - way.marks[leg])
    return x + done * way.along[leg, 0], y + done * way.along[leg, 1]


@compiled
def progress_advanced(
    ride: PathProgress, way: PathProfile, speed: float, x: float, y: float, moving: bool, dt: float
) -> PathProgress:
    """Return the ride after dt [s].

    Args:
        ride: before.
        way: the path.
        speed: wanted along it [m/s].
        x: where the drone is [m].
        y: likewise.
        moving: whether the acceptor lets the reference move on; else it brakes and waits.
        dt: [s].
    """
    if dt <= 0.0 or ride.s >= way.marks[-1]:
        return ride
    here_x, here_y = point_on(ride.leg, ride.s, way)
    lagging = sqrt((x - here_x) ** 2 + (y - here_y) ** 2) > LAG_MAX
    wanted = speed if moving and not lagging else 0.0
    s, v = profile_travelled(
        ride.s, ride.v, ride.leg, wanted, way.marks, way.speeds, REFERENCE_ACCELERATION, dt
    )
    return PathProgress(s, v, (v - ride.v) / dt, leg_from(ride.leg, s, way.marks), ride.yaw)


@compiled
def progress_headed(ride: PathProgress, way: PathProfile) -> PathProgress:
    """Return the ride with the heading of the path ahead; near the end the last one stays."""
    s = ride.s + HEADING_LOOKAHEAD
    leg = leg_from(ride.leg, s, way.marks)
    if leg == ride.leg and ride.s + HEADING_FREEZE < way.marks[-1]:
        return PathProgress(ride.s, ride.v, ride.a, ride.leg, way.headings[leg])
    here_x, here_y = point_on(ride.leg, ride.s, way)
    x, y = point_on(leg, s, way)
    dx, dy = x - here_x, y - here_y
    yaw = atan2(dy, dx) if dx * dx + dy * dy > HEADING_FREEZE * HEADING_FREEZE else ride.yaw
    return PathProgress(ride.s, ride.v, ride.a, ride.leg, yaw)


@compiled
def setpoint_at(ride: PathProgress, way: PathProfile) -> TrajectorySetpoint:
    """Return the reference at this point of the ride."""
    x, y = point_on(ride.leg, ride.s, way)
    finished = ride.s >= way.marks[-1]
    along_x, along_y = 0.0, 0.0
    if way.marks.size > 1:
        along_x, along_y = way.along[ride.leg, 0], way.along[ride.leg, 1]
    a = 0.0 if finished else ride.a
    return TrajectorySetpoint(
        x,
        y,
        along_x * ride.v,
        along_y * ride.v,
        along_x * a,
        along_y * a,
        ride.yaw,
        ride.leg + 1,
        finished,
    )
