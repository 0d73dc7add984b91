"""The estimator of one flying drone: checks sightings, counts what it rejects, and says so."""

from __future__ import annotations

from math import dist, sqrt

import numpy as np

from housefly.config.drone import TWIN_ODOMETRY_ERROR
from housefly.geometry import Vec2, Vec3
from housefly.messages.flight import Event, Severity
from housefly.messages.sensing import Estimate, Sighting
from housefly.pilot.estimation.delay_filter import COMMAND_SPAN, CommandHistory
from housefly.pilot.estimation.estimator import (
    estimate_at,
    estimator_created,
    estimator_initialized,
    estimator_updated,
    pose_estimate,
)
from housefly.pilot.estimation.estimator_state import (
    EstimatorParameters,
    EstimatorState,
    Measurement,
    PoseEstimate,
)
from housefly.pilot.estimation.track_windows import OdometryTolerance
from housefly.pilot.estimation.tracking_monitor import GAP_MIN, TrackingMonitor
from housefly.pilot.estimation.validation import (
    RejectionLog,
    RejectionReason,
    sighting_fault,
)

RESTART_AFTER = 0.5
"""On the ground, after rejecting jumps for this long, the new place is accepted [s]."""
HISTORY_SIZE = 1024
"""Command spans kept: over two seconds at the fastest loop rate, twice over."""


class PoseEstimator:
    """Feeds the sightings of one body to the compiled estimator.

    Args:
        params: of the compiled estimator.
        body: name of the drone in the tracking system.
        now: [s].
        odometry_error: share of a way by which the drone's own odometry may misjudge it.
        trusting: what tracking says is not held against what the drone feels; for negative
            controls.

    Attributes:
        state: of the compiled estimator.
        history: the commands given, which the state refers to.
        accepted: the newest sighting that was accepted, None before the first.
        monitor: holds the sightings against the drone's own report.
    """

    def __init__(
        self,
        params: EstimatorParameters,
        body: str,
        now: float,
        *,
        odometry_error: float = TWIN_ODOMETRY_ERROR,
        trusting: bool = False,
    ) -> None:
        self._params = params
        self._trusting = trusting
        self._body = body
        self._rejections = RejectionLog()
        self._last_position: Vec3 | None = None
        self.history: CommandHistory = np.zeros(HISTORY_SIZE, COMMAND_SPAN)
        self.state: EstimatorState = estimator_created(self.history, params, now)
        self.accepted: Sighting | None = None
        tolerance = OdometryTolerance(params.position_noise, odometry_error)
        self.monitor = TrackingMonitor(tolerance)

    @property
    def rejected(self) -> dict[RejectionReason, int]:
        """How many sightings were rejected, and why."""
        return self._rejections.counts

    def update(
        self, sightings: tuple[Sighting, ...], now: float, grounded: bool
    ) -> tuple[Event, ...]:
        """Take in sightings; on the ground a drone that was carried elsewhere is found again."""
        events: list[Event] = []
        for sighting in sightings:
            if sighting.body == self._body:
                events.extend(self._update(sighting, now, grounded))
        return tuple(events)

    def estimate(self, now: float) -> tuple[PoseEstimate, Estimate] | None:
        """Return where the drone is now [s], as numbers and as a message; None before a sighting.

        The state is advanced to now in any case.
        """
        self.state, here, variance = estimate_at(self.state, self.history, self._params, now)
        if not self.state.gate.initialized:
            return None
        deviation = sqrt(variance)
        position, velocity = (here.x, here.y, here.z), (here.vx, here.vy, here.vz)
        age = now - self.state.gate.last_capture
        return here, Estimate(now, position, velocity, here.yaw, age, deviation)

    def _update(self, sighting: Sighting, now: float, grounded: bool) -> tuple[Event, ...]:
        fault = sighting_fault(sighting, now, self.state.gate.last_capture)
        if fault is not None:
            return self._rejections.reject(fault, now)
        if self._repeats(sighting) and not grounded and not self._trusting:
            return self._rejections.reject(RejectionReason.FROZEN, now)
        agrees = self._trusting or self.monitor.agrees(sighting, self._predicted(sighting))
        if not agrees:
            return self._reject(RejectionReason.DISAGREES, sighting, now, grounded)
        if not self._take(sighting, now):
            return self._reject(RejectionReason.JUMP, sighting, now, grounded)
        self._accept(sighting)
        return ()

    def _predicted(self, sighting: Sighting) -> Vec2 | None:
        """Return where the filter expects the drone after a gap [m], None without one."""
        if not self._is_back(sighting):
            return None
        here = pose_estimate(self.state, self.history, self._params, sighting.captured_at)
        return here.x, here.y

    def _is_back(self, sighting: Sighting) -> bool:
        """Return whether a sighting is the first after a gap."""
        gate = self.state.gate
        return gate.initialized and sighting.captured_at - gate.last_capture >= GAP_MIN

    def _take(self, sighting: Sighting, now: float) -> bool:
        """Let the filter judge a sighting; after a gap the odometry vouches for it."""
        seen, before = _measurement(sighting), self.state
        accepted, self.state = estimator_updated(before, self.history, self._params, seen, now)
        vouched = self._is_back(sighting) and self.monitor.vouches(sighting.captured_at)
        if accepted or not vouched:
            return accepted
        self.state = estimator_initialized(before, self.history, self._params, seen, now)
        return True

    def _repeats(self, sighting: Sighting) -> bool:
        """Return whether the position is the last one bit for bit: no flying drone does that."""
        before, self._last_position = self._last_position, sighting.pose.position
        return self._last_position == before

    def _reject(
        self, reason: RejectionReason, sighting: Sighting, now: float, grounded: bool
    ) -> tuple[Event, ...]:
        """Count a jump; on the ground, a drone that was carried is found again where it is now."""
        self.monitor.refuse(now)
        lies_still = grounded and not self.monitor.carried
        words = self._lying_still_words(sighting) if lies_still else reason.value
        events = self._rejections.reject(reason, now, words)
        since = self._rejections.rejecting_since
        if not grounded or lies_still or since is None or now - since < RESTART_AFTER:
            return events
        seen = _measurement(sighting)
        self.state = estimator_initialized(self.state, self.history, self._params, seen, now)
        self._accept(sighting)
        text = "the drone was moved on the ground: tracking starts anew"
        return (Event(now, Severity.INFO, "tracking_restarted", text),)

    def _lying_still_words(self, sighting: Sighting) -> str:
        assert self.accepted is not None
        moved = dist(sighting.pose.position, self.accepted.pose.position)
        return (
            f"it says that the drone moved {moved:.1f} m while it lay still: is it another body?"
            " Lift the drone to show where it is"
        )

    def _accept(self, sighting: Sighting) -> None:
        self.accepted = sighting
        self.monitor.accept(sighting)
        self._rejections.accepted()


def _measurement(sighting: Sighting) -> Measurement:
    pose = sighting.pose
    return Measurement(sighting.captured_at, *pose.position, pose.yaw)
