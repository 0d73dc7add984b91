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
    """Place [m], velocity [m/s], acceleration [m/s^2] and heading [rad, nan keeps it] to track.

    What moves in the plane leaves its height to ``at_height``.
    """

    x: float
    y: float
    vx: float
    vy: float
    ax: float
    ay: float
    yaw: float
    waypoint: int
    finished: bool
    z: float
    vz: float
    az: float


@compiled
def at_height(target: TrajectorySetpoint, z: float) -> TrajectorySetpoint:
    """Return the same reference, level at a height [m]."""
    return TrajectorySetpoint(
        x=target.x,
        y=target.y,
        vx=target.vx,
        vy=target.vy,
        ax=target.ax,
        ay=target.ay,
        yaw=target.yaw,
        waypoint=target.waypoint,
        finished=target.finished,
        z=z,
        vz=0.0,
        az=0.0,
    )


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
def point_on(leg: int, s: float, profile: PathProfile) -> tuple[float, float]:
    """Return the point [m] at arc length s [m], which lies on this leg or past the end."""
    x, y = profile.points[leg, 0], profile.points[leg, 1]
    if profile.marks.size == 1:
        return x, y
    done = min(max(s - profile.marks[leg], 0.0), profile.marks[leg + 1] - profile.marks[leg])
    return x + done * profile.along[leg, 0], y + done * profile.along[leg, 1]


@compiled
def progress_advanced(
    progress: PathProgress,
    profile: PathProfile,
    speed: float,
    x: float,
    y: float,
    moving: bool,
    dt: float,
) -> PathProgress:
    """Return the progress after dt [s].

    Args:
        progress: before.
        profile: the path.
        speed: wanted along it [m/s].
        x: where the drone is [m].
        y: likewise.
        moving: whether the acceptor lets the reference move on; else it brakes and waits.
        dt: [s].
    """
    if dt <= 0.0 or progress.s >= profile.marks[-1]:
        return progress
    here_x, here_y = point_on(progress.leg, progress.s, profile)
    lagging = sqrt((x - here_x) ** 2 + (y - here_y) ** 2) > LAG_MAX
    wanted = speed if moving and not lagging else 0.0
    s, v = profile_travelled(
        progress.s,
        progress.v,
        progress.leg,
        wanted,
        profile.marks,
        profile.speeds,
        REFERENCE_ACCELERATION,
        dt,
    )
    leg = leg_from(progress.leg, s, profile.marks)
    return PathProgress(s=s, v=v, a=(v - progress.v) / dt, leg=leg, yaw=progress.yaw)


@compiled
def progress_headed(progress: PathProgress, profile: PathProfile) -> PathProgress:
    """Return the progress with the heading of the path ahead; near the end the last one stays."""
    s = progress.s + HEADING_LOOKAHEAD
    leg = leg_from(progress.leg, s, profile.marks)
    if leg == progress.leg and progress.s + HEADING_FREEZE < profile.marks[-1]:
        return _turned(progress, profile.headings[leg])
    here_x, here_y = point_on(progress.leg, progress.s, profile)
    x, y = point_on(leg, s, profile)
    dx, dy = x - here_x, y - here_y
    yaw = atan2(dy, dx) if dx * dx + dy * dy > HEADING_FREEZE * HEADING_FREEZE else progress.yaw
    return _turned(progress, yaw)


@compiled
def standing_setpoint(
    x: float, y: float, yaw: float, waypoint: int, finished: bool
) -> TrajectorySetpoint:
    """Return the reference that stands at a place [m] with a heading [rad]."""
    return TrajectorySetpoint(
        x=x,
        y=y,
        vx=0.0,
        vy=0.0,
        ax=0.0,
        ay=0.0,
        yaw=yaw,
        waypoint=waypoint,
        finished=finished,
        z=0.0,
        vz=0.0,
        az=0.0,
    )


@compiled
def _turned(progress: PathProgress, yaw: float) -> PathProgress:
    return PathProgress(s=progress.s, v=progress.v, a=progress.a, leg=progress.leg, yaw=yaw)


@compiled
def setpoint_at(progress: PathProgress, profile: PathProfile) -> TrajectorySetpoint:
    """Return the reference at this point of the progress."""
    x, y = point_on(progress.leg, progress.s, profile)
    finished = progress.s >= profile.marks[-1]
    along_x, along_y = 0.0, 0.0
    if profile.marks.size > 1:
        along_x, along_y = profile.along[progress.leg, 0], profile.along[progress.leg, 1]
    a = 0.0 if finished else progress.a
    return TrajectorySetpoint(
        x=x,
        y=y,
        vx=along_x * progress.v,
        vy=along_y * progress.v,
        ax=along_x * a,
        ay=along_y * a,
        yaw=progress.yaw,
        waypoint=progress.leg + 1,
        finished=finished,
        z=0.0,
        vz=0.0,
        az=0.0,
    )
