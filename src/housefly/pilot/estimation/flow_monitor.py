"""Whether the drone's own speed can be believed: a third witness decides between it and tracking.

Optical flow and tracking each tell how the drone moves. Where they part, the one that moves
otherwise than the drone leans is wrong (``felt_motion``). Where the witness cannot tell, nobody is
blamed here, and what parts is a drift (``track_windows``).
"""

from __future__ import annotations

from collections import deque
from math import cos, hypot, isnan, sin, tan
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from housefly.geometry import GRAVITY, Vec2
from housefly.messages.sensing import Sighting
from housefly.numeric import clipped, compiled
from housefly.pilot.estimation.onboard_odometry import (
    MotionRing,
    OdometryState,
    OnboardReport,
    odometry_at,
)

LOOK = 0.1
"""Velocities are compared over this [s]: shorter is noise, longer finds it later ..."""
LOOK_MAX = 0.5
"""... and no longer than this: so much of tracking may be missing [s]."""
PARTED = 0.12
"""Velocities that differ by more contradict each other [m/s]."""
TOGETHER, TOGETHER_TIME = 0.06, 3.0
"""Nearer than this [m/s] for so long [s], flow that was wrong is believed again."""
BLAME = 0.4
"""Who is blamed is so much nearer to the contradiction than to the witness: 1 is all of it."""
WITNESS_TIME = 2.0
"""The witness alone is worth something for so long [s]."""
ALONE = 0.4
"""Without tracking, flow that differs more from the witness is wrong [m/s]."""

_FELT_RING_SIZE = 512
"""Reports kept; a power of two."""
_FELT_MOTION = np.dtype([(name, "f8") for name in ("at", "x", "y")])
"""One report: when it was written [s], and the place by attitude alone [m]."""
_FeltRing = NDArray[Any]

_TIE = 1.0
"""How quickly velocity and push are tied to what is believed [rad/s]."""
_PUSH_MAX = 1.5
"""Largest steady push believed along an axis [m/s^2]."""
_STEP_MAX = 0.25
"""A longer time between two reports is a hole: nothing is known of the way [s]."""


class FlowMonitor:
    """Holds flow and tracking of one drone against the witness.

    Args:
        drag: linear drag over mass of the drone [1/s].

    Attributes:
        is_wrong: flow is not what tracking sees and the drone leans.
    """

    def __init__(self, drag: float) -> None:
        self._drag = drag
        self._ring = np.zeros(_FELT_RING_SIZE, _FELT_MOTION)
        self._felt = _NOTHING_FELT
        self._seen: deque[tuple[float, float, float]] = deque(maxlen=128)
        self.is_wrong = False
        self._reported_at = 0.0
        self._looked_at = 0.0
        self._parted_since: float | None = None
        self._together_since: float | None = None

    def restart(self) -> None:
        """Begin anew: the drone has just left or reached the ground."""
        self._felt = _NOTHING_FELT
        self._seen.clear()
        self.is_wrong = False
        self._parted_since = self._together_since = None

    def feel(
        self, report: OnboardReport, seconds: float, odometry: OdometryState, motion: MotionRing
    ) -> None:
        """Take in a report of a drone in the air, so long after the one before [s]."""
        if isnan(odometry.heading):
            return
        heading = odometry.heading + report.psi
        self._felt = _felt_advanced(
            self._felt, self._ring, report.at, seconds, report.theta, report.phi, heading,
            self._drag,
        )  # fmt: skip
        self._reported_at = report.at
        is_unseen = not self._seen or report.at - self._seen[-1][0] > LOOK_MAX
        if is_unseen and report.at - self._looked_at >= LOOK:
            self._look_alone(report.at, odometry, motion)

    def see(self, sighting: Sighting, odometry: OdometryState, motion: MotionRing) -> None:
        """Take in a sighting of the drone, believed or not."""
        at, (x, y, _) = sighting.captured_at, sighting.pose.position
        before = next((seen for seen in reversed(self._seen) if at - seen[0] >= LOOK), None)
        if not self._seen or at > self._seen[-1][0]:
            self._seen.append((at, x, y))
        if before is None or not self._is_covered(before[0], at, odometry):
            return
        since, x0, y0 = before
        seconds = at - since
        tracked = (x - x0) / seconds, (y - y0) / seconds
        flow = _flow(odometry, motion, since, at)
        self._judge(at, tracked, flow, self._felt_velocity(since, at), odometry.since <= since)

    def _is_covered(self, since: float, at: float, odometry: OdometryState) -> bool:
        is_felt = self._felt.reports > 0 and self._felt.since <= since
        is_fresh = at <= self._reported_at + LOOK
        return at - since <= LOOK_MAX and is_felt and is_fresh

    def _felt_velocity(self, since: float, at: float) -> Vec2:
        x0, y0 = _felt_place(self._felt, self._ring, since)
        x1, y1 = _felt_place(self._felt, self._ring, at)
        return (x1 - x0) / (at - since), (y1 - y0) / (at - since)

    def _judge(self, at: float, tracked: Vec2, flow: Vec2, felt: Vec2, is_told: bool) -> None:
        """Blame who has changed without a cause, and tie the witness to who is believed."""
        seconds, self._looked_at = min(max(at - self._looked_at, 0.0), LOOK), at
        tx, ty = tracked[0] - felt[0], tracked[1] - felt[1]
        if not is_told:
            self._felt = _felt_tied(self._felt, tx, ty, seconds)
            return
        fx, fy = flow[0] - felt[0], flow[1] - felt[1]
        dx, dy = fx - tx, fy - ty
        parted = hypot(dx, dy)
        if parted > PARTED:
            self._together_since = None
            self._parted_since = at if self._parted_since is None else self._parted_since
            blame = (dx * (fx + tx) + dy * (fy + ty)) / (parted * parted)
            is_fresh = at - self._parted_since <= WITNESS_TIME
            self.is_wrong |= blame > BLAME and is_fresh
            if self.is_wrong:
                self._felt = _felt_tied(self._felt, tx, ty, seconds)
            elif blame < -BLAME or not is_fresh:
                self._felt = _felt_tied(self._felt, fx, fy, seconds)
            return
        self._parted_since = None
        if parted < TOGETHER:
            self._together_since = at if self._together_since is None else self._together_since
            self.is_wrong &= at - self._together_since < TOGETHER_TIME
        self._felt = _felt_tied(self._felt, 0.5 * (fx + tx), 0.5 * (fy + ty), seconds)

    def _look_alone(self, at: float, odometry: OdometryState, motion: MotionRing) -> None:
        """Hold flow against the witness where nobody sees the drone."""
        self._looked_at = at
        until = at - odometry.flow.delay
        since = until - LOOK
        if max(self._felt.since, odometry.since) > since:
            return
        flow, felt = _flow(odometry, motion, since, until), self._felt_velocity(since, until)
        fx, fy = flow[0] - felt[0], flow[1] - felt[1]
        self.is_wrong |= hypot(fx, fy) > ALONE
        if not self.is_wrong:
            self._felt = _felt_tied(self._felt, fx, fy, LOOK)


def _flow(odometry: OdometryState, motion: MotionRing, since: float, at: float) -> Vec2:
    a, b = odometry_at(odometry, motion, since), odometry_at(odometry, motion, at)
    return (b.x - a.x) / (at - since), (b.y - a.y) / (at - since)


class _FeltState(NamedTuple):
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


_NOTHING_FELT = _FeltState(0, 0.0, 0.0, 0.0, 0.0, 0.0)


@compiled
def _felt_advanced(
    s: _FeltState,
    ring: _FeltRing,
    at: float,
    seconds: float,
    theta: float,
    phi: float,
    heading: float,
    drag: float,
) -> _FeltState:
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
    if s.reports == 0 or not 0.0 <= seconds <= _STEP_MAX or abs(theta) > 1.0 or abs(phi) > 1.0:
        row.x, row.y = 0.0, 0.0
        return _FeltState(s.reports + 1, s.vx, s.vy, s.px, s.py, at)
    forward, left = GRAVITY * tan(theta), -GRAVITY * tan(phi) / cos(theta)
    c, n = cos(heading), sin(heading)
    ax, ay = c * forward - n * left + s.px, n * forward + c * left + s.py
    half = 0.5 * seconds
    vx = s.vx + seconds * (ax - drag * (s.vx + half * (ax - drag * s.vx)))
    vy = s.vy + seconds * (ay - drag * (s.vy + half * (ay - drag * s.vy)))
    row.x, row.y = before.x + half * (s.vx + vx), before.y + half * (s.vy + vy)
    return _FeltState(s.reports + 1, vx, vy, s.px, s.py, s.since)


@compiled
def _felt_place(s: _FeltState, ring: _FeltRing, at: float) -> tuple[float, float]:
    """Return the place by attitude alone at a time [s], between or after reports [m]."""
    mask, newest = ring.size - 1, s.reports - 1
    index, oldest = newest, max(s.reports - ring.size, 0)
    while index > oldest and ring[index & mask].at > at:
        index -= 1
    a = ring[index & mask]
    if index == newest:
        ahead = min(max(at - a.at, 0.0), _STEP_MAX)
        return a.x + ahead * s.vx, a.y + ahead * s.vy
    b = ring[(index + 1) & mask]
    share = min(max((at - a.at) / (b.at - a.at), 0.0), 1.0) if b.at > a.at else 0.0
    return a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)


@compiled
def _felt_tied(s: _FeltState, x: float, y: float, seconds: float) -> _FeltState:
    """Return the witness tied to who is believed, that is faster by (x, y) [m/s], for a time [s].

    A critically damped observer: it adopts a velocity within two seconds, a push within four.
    """
    k, kk = min(2.0 * _TIE * seconds, 1.0), _TIE * _TIE * seconds
    return _FeltState(
        s.reports,
        s.vx + k * x,
        s.vy + k * y,
        clipped(s.px + kk * x, _PUSH_MAX),
        clipped(s.py + kk * y, _PUSH_MAX),
        s.since,
    )
