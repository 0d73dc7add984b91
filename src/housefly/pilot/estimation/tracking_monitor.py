"""Holds tracking against what the drone itself feels: which poses are believed, and how well.

The drone's own report is used as a second track (``onboard_odometry``). It is never flown by; it
says when tracking lies, and after a gap whether the place that comes back can be the drone's.
Numbers are compiled; here are states, and what a drone on the ground may do.
"""

from __future__ import annotations

from math import hypot, inf, isfinite, nan, sqrt

import numpy as np

from housefly.config.airframe import SonarConstants
from housefly.geometry import Vec2, Vec3
from housefly.messages.sensing import AIRBORNE_STATUSES, DroneStatus, Sighting, Telemetry
from housefly.numeric import wrapped
from housefly.pilot.estimation.climb_odometry import ClimbOdometry
from housefly.pilot.estimation.consistency import (
    CarryDetector,
    LeanWatch,
    ReportClock,
    TrackingConsistency,
)
from housefly.pilot.estimation.dead_reckoning import ReckonedPose
from housefly.pilot.estimation.displacement import (
    TRACK_ROW,
    WINDOW_RING_SIZE,
    OdometryTolerance,
    displacement_bound,
)
from housefly.pilot.estimation.flow_model import flow_bias_variance
from housefly.pilot.estimation.flow_monitor import FlowMonitor
from housefly.pilot.estimation.latency import NO_LATENCY, lag_bank, latency_advanced
from housefly.pilot.estimation.onboard_odometry import (
    MOTION_RING_SIZE,
    ONBOARD_MOTION,
    REPORT_GAP_MAX,
    OdometryAt,
    OnboardReport,
    drone_seconds,
    flow_is_told,
    odometry_advanced,
    odometry_at,
    odometry_begun,
    odometry_headed,
)
from housefly.pilot.estimation.track_windows import (
    EMPTY_WINDOWS,
    windows_advanced,
    windows_cleared,
    windows_restarted,
)

GAP_MIN = 0.3
"""After a gap of this long a pose must agree with the odometry, or with the prediction [s]."""
JUMP_FLOOR = 0.08
"""A pose nearer than this to where the odometry says is never refused [m]."""
CLIMB_JUMP = 0.25
"""After a gap a height further than this from what is expected is refused [m]."""
JUMP_CEILING = 0.25
"""... and one further than this always, however long the gap: a stopping distance [m]."""
TURN_JUMP = 0.35
"""A heading further than this from where the gyros say is refused [rad]."""
FLOOR_STEP = 0.25
"""Heights further apart than this mean that something is below: they tell no delay [m]."""
START_RADIUS = 0.4
"""So near to where it took off, the floor below is the floor it stood on [m]."""
FLOOR_SEEN = 0.12
"""The floor is below when tracked and onboard height differ by less than this [m]."""
HEIGHT_TIME = 0.3
"""Time constant of the height's comparison [s]: the sonar is noisy."""
MOVED_AT_REST = 0.1
"""Further than this from where it came to rest, a drone that nobody moved is drifting [m]."""


class TrackingMonitor:
    """Holds the poses of one drone against its reports.

    Args:
        tolerance: what tracking and odometry may be off by.
        drag: linear drag over mass of the drone [1/s].
        sonar: what its own height is like; None where it tells none.

    Attributes:
        lean: whether the attitude that the drone reports stands still, and how it leans then.
    """

    def __init__(
        self, tolerance: OdometryTolerance, drag: float, sonar: SonarConstants | None
    ) -> None:
        self._tolerance = tolerance
        self._motion = np.zeros(MOTION_RING_SIZE, ONBOARD_MOTION)
        self._odometry = odometry_begun(tolerance.flow)
        self._rows = np.zeros(WINDOW_RING_SIZE, TRACK_ROW)
        self._windows = EMPTY_WINDOWS
        self._bank = lag_bank()
        self._latency = NO_LATENCY
        self._flow = FlowMonitor(drag)
        self.lean = LeanWatch()
        self._report: OnboardReport | None = None
        self._carry = CarryDetector()
        self._climb, self._climbed_then = ClimbOdometry(sonar), 0.0
        self._has_sonar = sonar is not None
        self._airborne = False
        self._attitude_told = False
        self._height_told = False
        self._report_clock = ReportClock()
        self._received_at = self._reported_at = -inf
        self._last: tuple[Sighting, OdometryAt] | None = None
        self._start: Vec3 | None = None
        self._rest: Vec2 | None = None
        self._height_error = self._height_drift = nan
        self._height_at = nan
        self._refused_since: float | None = None

    def feel(self, telemetry: Telemetry | None, status: DroneStatus, vz: float) -> None:
        """Take in the drone's newest report, with the climb rate by tracking [m/s]."""
        if telemetry is None or telemetry.received_at <= self._received_at:
            return
        self._received_at = telemetry.received_at
        at = self._report_clock.written_at(telemetry.drone_time, telemetry.received_at)
        self._reported_at = max(at, self._reported_at)
        self._climb = self._climb.updated(at, telemetry.height)
        airborne = status in AIRBORNE_STATUSES
        if airborne != self._airborne:
            self._leave_or_reach_ground(airborne)
        self._carry = self._carry.updated(telemetry, airborne)
        self._attitude_told |= any((telemetry.phi, telemetry.theta, telemetry.psi))
        self._height_told = not airborne or (self._has_sonar and telemetry.height > 0.0)
        forward, left, _ = telemetry.velocity
        report = OnboardReport(
            at=at,
            theta=telemetry.theta,
            phi=telemetry.phi,
            psi=telemetry.psi,
            forward=forward,
            left=left,
            height=telemetry.height,
            vz=vz,
            airborne=airborne,
            drone_time=nan if telemetry.drone_time is None else telemetry.drone_time,
        )
        if all(map(isfinite, report[:-2])):
            self.lean.feel(report)
            self._odometry = odometry_advanced(self._odometry, self._motion, report)
            self._witness(report)

    def _witness(self, report: OnboardReport) -> None:
        """Let a third witness know how the drone leans."""
        before, self._report = self._report, report
        if before is None or not report.airborne or report.at <= before.at:
            return
        seconds = drone_seconds(before.drone_time, report.drone_time, report.at - before.at)
        self._flow.feel(report, seconds, self._odometry, self._motion)

    def see(self, sighting: Sighting) -> None:
        """Take in a sighting before it is judged."""
        if self._airborne and self._odometry.reports > 0:
            self._flow.see(sighting, self._odometry, self._motion)

    def _leave_or_reach_ground(self, airborne: bool) -> None:
        self._airborne = airborne
        self._windows = windows_cleared(self._windows)
        self._flow.restart()
        self._latency, self._rest = NO_LATENCY, None
        self._start = self._last[0].pose.position if self._last and airborne else None

    @property
    def carried(self) -> bool:
        """Whether somebody may have moved the drone on the ground since its last believed pose."""
        since = self._last[0].captured_at if self._last else -inf
        return self._carry.stirred_since(since)

    def agrees(self, sighting: Sighting, predicted: Vec3 | None) -> bool:
        """Return whether a sighting can be the drone, by its own motion.

        Args:
            sighting: of the drone.
            predicted: where the filter expects it after a gap [m]; its height is what a gap is
                judged by, its place only when the odometry has a hole.
        """
        if self._last is None:
            return True
        last, then = self._last
        seconds = sighting.captured_at - last.captured_at
        if seconds <= 0.0:
            return True
        now = odometry_at(self._odometry, self._motion, sighting.captured_at)
        if predicted is not None and not self._is_at_height(last, sighting, predicted):
            return False
        if not self._is_covered(last.captured_at, sighting.captured_at):
            return seconds < GAP_MIN or predicted is None or _near(sighting, predicted)
        return self._is_on_track(last, then, sighting, now, seconds)

    def _is_on_track(
        self, last: Sighting, then: OdometryAt, new: Sighting, now: OdometryAt, seconds: float
    ) -> bool:
        (x0, y0, _), (x1, y1, _) = last.pose.position, new.pose.position
        off = hypot(x1 - x0 - (now.x - then.x), y1 - y0 - (now.y - then.y))
        white, way = now.variance - then.variance, now.way - then.way
        change = hypot(now.vx - then.vx, now.vy - then.vy)
        bound = displacement_bound(seconds, white, way, change, self._tolerance)
        if then.stalled or now.stalled:
            bound += REPORT_GAP_MAX * hypot(now.vx, now.vy)
        turn = wrapped(new.pose.yaw - last.pose.yaw - (now.psi - then.psi))
        return off <= min(JUMP_FLOOR + bound, JUMP_CEILING) and abs(turn) <= TURN_JUMP

    def _is_at_height(self, last: Sighting, new: Sighting, predicted: Vec3) -> bool:
        """Return whether a height is what the drone has climbed since, by its sonar.

        A drone that holds itself follows the floor below, which no filter expects.
        """
        expected = predicted[2]
        if self._height_told and self._is_covered(last.captured_at, new.captured_at):
            expected = last.pose.position[2] + self._climb.climbed - self._climbed_then
        return abs(new.pose.position[2] - expected) <= CLIMB_JUMP

    def _is_covered(self, since: float, until: float) -> bool:
        """Return whether the odometry has no hole between two times [s]."""
        is_fresh = until <= self._reported_at + REPORT_GAP_MAX
        is_told = self._attitude_told and not self._is_flow_wrong
        return is_told and is_fresh and self._odometry.since <= since

    def vouches(self, at: float) -> bool:
        """Return whether the odometry leads from the last believed pose to a time [s]."""
        return self._last is not None and self._is_covered(self._last[0].captured_at, at)

    def reckoned(self, now: float) -> ReckonedPose | None:
        """Return where the drone is by its own motion since the last believed pose, now [s].

        None where it has not told its motion all the while.
        """
        if self._last is None or not self._is_covered(self._last[0].captured_at, now):
            return None
        last, then = self._last
        here, (x, y, z) = odometry_at(self._odometry, self._motion, now), last.pose.position
        bias = flow_bias_variance(self._tolerance.flow, max(now - last.captured_at, 0.0))
        way_error = self._tolerance.way_error * (here.way - then.way)
        return ReckonedPose(
            position=(
                x + here.x - then.x,
                y + here.y - then.y,
                z + self._climb.climbed - self._climbed_then,
            ),
            velocity=(here.vx, here.vy),
            yaw=wrapped(last.pose.yaw + here.psi - then.psi),
            deviation=sqrt(max(here.variance - then.variance, 0.0) + bias) + way_error,
        )

    @property
    def _is_flow_wrong(self) -> bool:
        """Whether the drone's own hover flies by a speed, or an attitude, that is wrong."""
        return self._flow.is_wrong or self.lean.is_stuck

    @property
    def refusing(self) -> bool:
        """Whether the newest sighting was refused."""
        return self._refused_since is not None

    @property
    def is_doubtful(self) -> bool:
        """Whether something is known against tracking while the drone stands."""
        return self.refusing or self._moved_at_rest() > 0.0

    def refuse(self, now: float) -> None:
        """A sighting was refused because it does not agree."""
        self._refused_since = now if self._refused_since is None else self._refused_since

    def accept(self, sighting: Sighting) -> None:
        """Take in a sighting that is believed."""
        self._refused_since = None
        at, pose = sighting.captured_at, sighting.pose
        onboard = odometry_at(self._odometry, self._motion, at)
        self._compare_heights(at, pose.position, onboard.height)
        if self._attitude_told:
            self._odometry = odometry_headed(self._odometry, self._motion, at, pose.yaw)
        since = self._last[0].captured_at if self._last else at
        self._last, self._climbed_then = (sighting, onboard), self._climb.climbed
        if not self._airborne:
            self._rest_at(pose.position)
            return
        self.lean.see(at, pose.orientation)
        if self._is_flow_wrong:
            self._windows, self._latency = windows_cleared(self._windows), NO_LATENCY
            return
        if not self._is_covered(since, at):
            self._windows = windows_restarted(self._windows)
            self._latency = NO_LATENCY
            return
        x, y, z = pose.position
        self._windows = windows_advanced(
            self._windows, self._rows, at, x, y, pose.yaw, onboard, self._tolerance
        )
        is_floor = self._is_over_known_floor() and abs(z - onboard.height) < FLOOR_STEP
        height = z if is_floor else nan
        self._latency = latency_advanced(
            self._latency, self._bank, self._odometry, self._motion, at, x, y, height, pose.yaw
        )

    def _rest_at(self, position: Vec3) -> None:
        """Remember where the drone lies still."""
        if self._rest is None or self.carried:
            self._rest = position[:2]

    def _compare_heights(self, at: float, position: Vec3, told: float) -> None:
        if self._odometry.reports == 0 or not self._height_told:
            self._height_error = self._height_drift = nan
            return
        error = position[2] - (told if self._airborne else 0.0)
        if isfinite(self._height_error):
            share = min(max(at - self._height_at, 0.0) / HEIGHT_TIME, 1.0)
            error = self._height_error + share * (error - self._height_error)
        self._height_error, self._height_at = error, at
        # The smoothed error is late, the newest reading noisy: what both say counts. A sighting
        # may be the last for half a second, just as the floor steps away below the drone.
        newest = position[2] - self._climb.height
        if max(abs(error), abs(newest)) < FLOOR_SEEN:
            self._climb = self._climb.over_floor()
        self._height_drift = min(error, newest) + self._climb.stepped if self._airborne else nan

    def consistency(self, now: float) -> TrackingConsistency:
        """Return how well tracking agrees with the drone's own report, now [s]."""
        refused = now - self._refused_since if self._refused_since is not None else 0.0
        return TrackingConsistency(
            drift=self._windows.drift if self._airborne else self._moved_at_rest(),
            frame_error=self._windows.frame_error,
            mirrored=self._windows.mirrored,
            height_error=self._told_height_error(),
            height_drift=self._height_drift,
            latency_error=self._latency.error,
            refused_for=refused,
            flow_untold=self._airborne and not flow_is_told(self._odometry, self._reported_at),
            flow_wrong=self._is_flow_wrong,
        )

    def _moved_at_rest(self) -> float:
        """Return how far tracking has moved a drone that lies still [m]."""
        if self._rest is None or self._last is None:
            return nan
        x, y, _ = self._last[0].pose.position
        moved = hypot(x - self._rest[0], y - self._rest[1])
        return moved if moved > MOVED_AT_REST else 0.0

    def _told_height_error(self) -> float:
        """Return the error of the height where the floor below is known, or where it is too low."""
        error = self._height_error
        if not self._airborne or error < 0.0:
            return error
        return error if self._is_over_known_floor() else nan

    def _is_over_known_floor(self) -> bool:
        """Return whether the drone flies near where it took off."""
        if self._start is None or self._last is None:
            return False
        x, y, _ = self._last[0].pose.position
        return hypot(x - self._start[0], y - self._start[1]) < START_RADIUS


def _near(sighting: Sighting, place: Vec3) -> bool:
    x, y, _ = sighting.pose.position
    return hypot(x - place[0], y - place[1]) <= JUMP_CEILING
