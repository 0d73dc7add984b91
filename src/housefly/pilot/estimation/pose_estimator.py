"""The estimator of one flying drone: checks sightings, counts what it rejects, and says so."""

from __future__ import annotations

from math import dist, sqrt

import numpy as np

from housefly.config.airframe import Airframe
from housefly.config.drone import TWIN_ODOMETRY_ERROR
from housefly.geometry import Vec2, Vec3
from housefly.messages.event_code import EventCode
from housefly.messages.flight import Event, Severity
from housefly.messages.sensing import Estimate, Sighting
from housefly.messages.words import Words, figure, said
from housefly.numeric import CompiledBox, boxed, unboxed
from housefly.pilot.estimation.boxed_estimator import (
    begun_at,
    estimated,
    newest_span,
    pose_gate,
    sighting_taken,
    tracked_climb_rate,
)
from housefly.pilot.estimation.delay_filter import COMMAND_SPAN, CommandHistory
from housefly.pilot.estimation.displacement import OdometryTolerance
from housefly.pilot.estimation.estimator import (
    disturbance_of,
    estimator_created,
    pose_estimate,
)
from housefly.pilot.estimation.estimator_state import (
    EstimatorParameters,
    EstimatorState,
    Measurement,
    PoseEstimate,
)
from housefly.pilot.estimation.flow_model import flow_model
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
        airframe: of the drone.
        drag: of the air on it, over mass [1/s].
        odometry_error: share of a way by which the drone's own odometry may misjudge it.
        trusting: what tracking says is not held against what the drone feels; for negative
            controls.

    Attributes:
        box: holds the state of the compiled estimator.
        history: the commands given, which the state refers to.
        accepted: the newest sighting that was accepted, None before the first.
        monitor: holds the sightings against the drone's own report.
    """

    def __init__(
        self,
        params: EstimatorParameters,
        body: str,
        now: float,
        airframe: Airframe,
        *,
        drag: float,
        odometry_error: float = TWIN_ODOMETRY_ERROR,
        trusting: bool = False,
    ) -> None:
        self._params, self._boxed_params = params, boxed(params)
        self._trusting = trusting
        self._body = body
        self._rejections = RejectionLog()
        self._last_position: Vec3 | None = None
        self.history: CommandHistory = np.zeros(HISTORY_SIZE, COMMAND_SPAN)
        self.box: CompiledBox[EstimatorState] = boxed(estimator_created(self.history, params, now))
        self.accepted: Sighting | None = None
        tolerance = OdometryTolerance(
            params.position_noise, odometry_error, flow_model(airframe.flow)
        )
        self.monitor = TrackingMonitor(tolerance, drag, airframe.sonar)

    @property
    def state(self) -> EstimatorState:
        """What the compiled estimator remembers; putting it together takes its time."""
        return unboxed(self.box)

    @property
    def disturbance(self) -> Vec2:
        """The steady push in the plane [m/s^2], as of the last sighting."""
        return disturbance_of(newest_span(self.box), self.history)

    @property
    def climb_rate(self) -> float:
        """The climb rate by tracking [m/s]."""
        return tracked_climb_rate(self.box)

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
        here, variance, is_known, seen_at = estimated(
            self.box, self.history, self._boxed_params, now
        )
        if not is_known:
            return None
        deviation = sqrt(variance)
        position, velocity = (here.x, here.y, here.z), (here.vx, here.vy, here.vz)
        return here, Estimate(now, position, velocity, here.yaw, now - seen_at, deviation)

    def _update(self, sighting: Sighting, now: float, grounded: bool) -> tuple[Event, ...]:
        gate = pose_gate(self.box)
        fault = sighting_fault(sighting, now, gate.last_capture)
        if fault is not None:
            return self._rejections.reject(fault, now)
        if self._repeats(sighting) and not grounded and not self._trusting:
            return self._rejections.reject(RejectionReason.FROZEN, now)
        self.monitor.see(sighting)
        is_back = gate.initialized and sighting.captured_at - gate.last_capture >= GAP_MIN
        predicted = self._predicted(sighting.captured_at) if is_back else None
        if not (self._trusting or self.monitor.agrees(sighting, predicted)):
            return self._reject(RejectionReason.DISAGREES, sighting, now, grounded)
        vouched = is_back and self.monitor.vouches(sighting.captured_at)
        if not self._take(sighting, now, vouched):
            return self._reject(RejectionReason.JUMP, sighting, now, grounded)
        self._accept(sighting)
        return ()

    def _predicted(self, at: float) -> Vec3:
        """Return where the filter expects the drone [m]."""
        here = pose_estimate(self.state, self.history, self._params, at)
        return here.x, here.y, here.z

    def _take(self, sighting: Sighting, now: float, vouched: bool) -> bool:
        """Let the filter judge a sighting; after a gap the odometry vouches for it."""
        seen = _measurement(sighting)
        return sighting_taken(self.box, self.history, self._boxed_params, seen, now, vouched)

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
        words = self._lying_still_words(sighting) if lies_still else said(reason)
        events = self._rejections.reject(reason, now, words)
        since = self._rejections.rejecting_since
        if not grounded or lies_still or since is None or now - since < RESTART_AFTER:
            return events
        begun_at(self.box, self.history, self._boxed_params, _measurement(sighting), now)
        self._accept(sighting)
        text = Words("the drone was moved on the ground: tracking starts anew")
        return (Event(now, Severity.INFO, EventCode.TRACKING_RESTARTED, text),)

    def _lying_still_words(self, sighting: Sighting) -> Words:
        assert self.accepted is not None
        moved = dist(sighting.pose.position, self.accepted.pose.position)
        return Words(
            "it says that the drone moved {d} m while it lay still: is it another body?"
            " Lift the drone to show where it is",
            d=figure(moved, ".1f"),
        )

    def _accept(self, sighting: Sighting) -> None:
        self.accepted = sighting
        self.monitor.accept(sighting)
        self._rejections.accepted()


def _measurement(sighting: Sighting) -> Measurement:
    pose = sighting.pose
    return Measurement(sighting.captured_at, *pose.position, pose.yaw)
