"""Onboard odometry, compiled: the way flown by the drone's own velocity and heading alone.

The drone's optical flow tells a body velocity and its gyros a heading since its own start. Turned
into the world by the heading that tracking told, and summed up, they make a second track that no
tracking system can bend. Its error grows slowly: white noise and a wandering bias of the flow.
"""

from __future__ import annotations

from math import cos, inf, isnan, nan, sin
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from housefly.numeric import compiled, wrapped
from housefly.pilot.estimation.flow_model import FlowModel

REPORT_GAP_MAX = 0.25
"""Reports further apart than this leave a hole in the odometry [s]."""
STALL_MIN, STALL_PERIODS = 0.03, 2.0
"""The link stood still between reports further apart than this [s] and so many usual periods."""
PERIOD_SHARE = 0.05
"""Weight of a new time between two reports in the usual one."""
UNTOLD_AFTER = 0.3
"""A velocity that is the same to the last bit for this long in flight is no velocity at all [s]."""
SPEED_LOST = 0.1
"""... and one of exactly zero at once, where the drone flew faster than this before [m/s]."""
HEADING_TIME = 5.0
"""Time constant by which the onboard heading is tied to the tracked one [s]."""

MOTION_RING_SIZE = 512
"""Reports kept: two seconds and a half at 200 Hz; a power of two."""
ONBOARD_MOTION = np.dtype(
    [
        (name, "f8")
        for name in (
            "at",
            "psi",
            "height",
            "x",
            "y",
            "vx",
            "vy",
            "way",
            "variance",
            "drone_time",
            "stalled",
        )
    ]
)
"""One report: when it came [s], heading since the drone's start, unwrapped [rad], height [m], the
place [m], velocity [m/s] and way [m] of the odometry one delay of the flow before, the variance of
that place by white noise [m^2], when the drone wrote it by its own clock [s], and whether the link
stood still before it: 0 or 1.
"""
MotionRing = NDArray[Any]


class OnboardReport(NamedTuple):
    """What one report of the drone says: time [s], attitude [rad], velocity [m/s], height [m].

    Attributes:
        at, theta, phi, psi, forward, left, height: as in ``Telemetry``.
        vz: climb rate by tracking, which the wire does not tell [m/s].
        airborne: the propellers carry the drone; on the ground it stands still.
        drone_time: when the drone wrote it by its own clock [s]; nan where it does not tell it.
    """

    at: float
    theta: float
    phi: float
    psi: float
    forward: float
    left: float
    height: float
    vz: float
    airborne: bool
    drone_time: float


class OdometryState(NamedTuple):
    """Where the odometry stands.

    Attributes:
        reports: how many were taken in.
        heading: tracked heading minus onboard heading [rad]; nan before the first sighting.
        heading_at: when that was brought up to date [s].
        since: the odometry has no hole since then [s]; inf while it is not told.
        forward, left: velocity of the newest report [m/s].
        unchanged_since: the velocity is the same to the last bit since then [s]; inf when it is
            not.
        period: usual time between two reports [s].
        flow: what is known of the reported velocity.
    """

    reports: int
    heading: float
    heading_at: float
    since: float
    forward: float
    left: float
    unchanged_since: float
    period: float
    flow: FlowModel


class OdometryAt(NamedTuple):
    """The odometry at one time; fields as in ``ONBOARD_MOTION``.

    Attributes:
        psi, height, x, y, vx, vy, way, variance: of that time.
        stalled: between two reports around which the link stood still the place is a guess.
    """

    psi: float
    height: float
    x: float
    y: float
    vx: float
    vy: float
    way: float
    variance: float
    stalled: bool


def odometry_begun(flow: FlowModel) -> OdometryState:
    """Return the odometry before the first report."""
    return OdometryState(
        reports=0,
        heading=nan,
        heading_at=0.0,
        since=inf,
        forward=nan,
        left=nan,
        unchanged_since=inf,
        period=0.0,
        flow=flow,
    )


@compiled
def odometry_advanced(s: OdometryState, ring: MotionRing, report: OnboardReport) -> OdometryState:
    """Return the odometry after a report; one that is not newer than the last changes nothing."""
    mask = ring.size - 1
    before, row = ring[(s.reports - 1) & mask], ring[s.reports & mask]
    dt = report.at - before.at if s.reports > 0 else inf
    if dt <= 0.0:
        return s
    unchanged_since = _unchanged_since(s, report)
    silent = report.at - unchanged_since > UNTOLD_AFTER
    since = s.since
    flown = dt if s.reports == 0 else drone_seconds(before.drone_time, report.drone_time, dt)
    is_hole = max(dt, flown) > REPORT_GAP_MAX
    if is_hole or silent or isnan(s.heading):
        since = report.at
    row.at, row.height, row.drone_time = report.at, report.height, report.drone_time
    row.psi = report.psi if s.reports == 0 else before.psi + wrapped(report.psi - before.psi)
    row.vx, row.vy = _world_velocity(s, ring, report)
    if is_hole:
        row.x, row.y, row.way, row.variance, row.stalled = 0.0, 0.0, 0.0, 0.0, 0.0
        if s.reports > 0:
            row.x, row.y, row.way, row.variance = before.x, before.y, before.way, before.variance
    else:
        mean_x, mean_y = 0.5 * (before.vx + row.vx), 0.5 * (before.vy + row.vy)
        is_long = max(dt, flown) > STALL_MIN + STALL_PERIODS * s.period
        row.stalled = 1.0 if is_long else 0.0
        row.x, row.y = before.x + flown * mean_x, before.y + flown * mean_y
        row.way = before.way + flown * (mean_x * mean_x + mean_y * mean_y) ** 0.5
        noise = s.flow.noise * dt if report.airborne else 0.0
        row.variance = before.variance + noise * noise + (0.1 * dt * dt) ** 2
    return OdometryState(
        reports=s.reports + 1,
        heading=s.heading,
        heading_at=s.heading_at,
        since=since,
        forward=report.forward,
        left=report.left,
        unchanged_since=unchanged_since,
        period=s.period + PERIOD_SHARE * (min(dt, REPORT_GAP_MAX) - s.period),
        flow=s.flow,
    )


@compiled
def _unchanged_since(s: OdometryState, report: OnboardReport) -> float:
    """Return since when the velocity is the same to the last bit [s]; inf when it changed.

    A flow camera that sees nothing reports zeros, one that hangs what it saw last.
    """
    if not report.airborne:
        return inf
    if report.forward == s.forward and report.left == s.left:
        return min(s.unchanged_since, report.at)
    is_zero = report.forward == 0.0 and report.left == 0.0
    if is_zero and s.forward * s.forward + s.left * s.left > SPEED_LOST * SPEED_LOST:
        return report.at - 2.0 * UNTOLD_AFTER
    return report.at if is_zero else inf


@compiled
def drone_seconds(before: float, now: float, received: float) -> float:
    """Return the time between two reports [s] by the drone's clock, or by ours.

    A link that holds reports back, and a simulated drone whose machine stood still, stretch the
    time in which they are received: not the time in which the drone flew. After a stall the same
    report may come again. The drone's clock wraps and may stand: then ours counts. Where it jumps
    reports were never read: a driver that was held up reads an old one, then the newest.

    Args:
        before: time of the drone's clock [s], nan where it does not tell it.
        now: the same of the newer report.
        received: time between the receptions [s].
    """
    seconds = now - before
    if seconds == 0.0 and received > STALL_MIN:
        return 0.0
    return seconds if seconds > 0.0 else received


@compiled
def _world_velocity(
    s: OdometryState, ring: MotionRing, report: OnboardReport
) -> tuple[float, float]:
    """Return the velocity in the world that the flow means, with the heading of its time."""
    if not report.airborne or isnan(s.heading):
        return 0.0, 0.0
    ct, st, cp, sp = cos(report.theta), sin(report.theta), cos(report.phi), sin(report.phi)
    if ct < 0.5 or cp < 0.5:
        return 0.0, 0.0
    forward = (report.forward + st * report.vz) / ct
    left = (report.left - forward * sp * st - report.vz * sp * ct) / cp
    psi = report.psi
    if s.reports > 0:
        psi = odometry_at(s, ring, report.at - s.flow.delay).psi
    c, n = cos(psi + s.heading), sin(psi + s.heading)
    return c * forward - n * left, n * forward + c * left


def flow_is_told(s: OdometryState, at: float) -> bool:
    """Return whether the newest report tells a velocity, at its time [s]."""
    return not at - s.unchanged_since > UNTOLD_AFTER


@compiled
def odometry_at(s: OdometryState, ring: MotionRing, at: float) -> OdometryAt:
    """Return attitude and height told for a time [s], and the odometry's place then.

    Between two reports it is interpolated, after the newest extrapolated for a while.
    """
    psi, _ = _around(s, ring, at)
    second = min(psi + 1, s.reports - 1)
    a, b = ring[psi & (ring.size - 1)], ring[second & (ring.size - 1)]
    share = _share(a.at, b.at, at)
    heading = a.psi + share * (b.psi - a.psi)
    first, ahead = _around(s, ring, at + s.flow.delay)
    second = min(first + 1, s.reports - 1)
    a, b = ring[first & (ring.size - 1)], ring[second & (ring.size - 1)]
    share = _share(a.at, b.at, at + s.flow.delay)
    ahead = min(max(ahead, 0.0), REPORT_GAP_MAX) if second == first else 0.0
    return OdometryAt(
        psi=heading,
        height=a.height,
        x=a.x + share * (b.x - a.x) + ahead * a.vx,
        y=a.y + share * (b.y - a.y) + ahead * a.vy,
        vx=a.vx + share * (b.vx - a.vx),
        vy=a.vy + share * (b.vy - a.vy),
        way=a.way + share * (b.way - a.way),
        variance=a.variance + share * (b.variance - a.variance),
        stalled=b.stalled > 0.5,
    )


@compiled
def _around(s: OdometryState, ring: MotionRing, at: float) -> tuple[int, float]:
    """Return the number of the last report not after a time [s], and how long before it came."""
    mask = ring.size - 1
    index, oldest = s.reports - 1, max(s.reports - ring.size, 0)
    while index > oldest and ring[index & mask].at > at:
        index -= 1
    return index, at - ring[index & mask].at


@compiled
def _share(before: float, after: float, at: float) -> float:
    return min(max((at - before) / (after - before), 0.0), 1.0) if after > before else 0.0


@compiled
def odometry_headed(s: OdometryState, ring: MotionRing, at: float, yaw: float) -> OdometryState:
    """Return the odometry with its heading tied to one that tracking told [rad] for a time [s]."""
    if s.reports == 0:
        return s
    off = wrapped(yaw - odometry_at(s, ring, at).psi)
    heading = off
    if not isnan(s.heading):
        share = min(max(at - s.heading_at, 0.0) / HEADING_TIME, 1.0)
        heading = wrapped(s.heading + share * wrapped(off - s.heading))
    return OdometryState(
        reports=s.reports,
        heading=heading,
        heading_at=at,
        since=s.since,
        forward=s.forward,
        left=s.left,
        unchanged_since=s.unchanged_since,
        period=s.period,
        flow=s.flow,
    )
