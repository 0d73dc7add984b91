"""The estimator of one flying drone: checks sightings, counts what it rejects, and says so."""

from __future__ import annotations

from math import sqrt

import numpy as np

from housefly.geometry import Vec3
from housefly.messages.flight import Event, Severity
from housefly.messages.sensing import Estimate, Sighting
from housefly.pilot.estimation.delay_filter import COMMAND_SPAN, CommandHistory
from housefly.pilot.estimation.estimator import (
    EstimatorParameters,
    EstimatorState,
    Measurement,
    PoseEstimate,
    estimator_advanced,
    estimator_created,
    estimator_initialized,
    estimator_updated,
    pose_estimate,
    position_variance,
)
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

    Attributes:
        state: of the compiled estimator.
        history: the commands given, which the state refers to.
        accepted: the newest sighting that was accepted, None before the first.
    """

    def __init__(self, params: EstimatorParameters, body: str, now: float) -> None:
        self._params = params
        self._body = body
        self._rejections = RejectionLog()
        self._last_position: Vec3 | None = None
        self.history: CommandHistory = np.zeros(HISTORY_SIZE, COMMAND_SPAN)
        self.state: EstimatorState = estimator_created(self.history, params, now)
        self.accepted: Sighting | None = None

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
        self.state = estimator_advanced(self.state, self.history, self._params, now)
        if not self.state.gate.initialized:
            return None
        here = pose_estimate(self.state, self.history, self._params, now)
        deviation = sqrt(position_variance(self.state, self.history, self._params, now))
        position, velocity = (here.x, here.y, here.z), (here.vx, here.vy, here.vz)
        age = now - self.state.gate.last_capture
        return here, Estimate(now, position, velocity, here.yaw, age, deviation)

    def _update(self, sighting: Sighting, now: float, grounded: bool) -> tuple[Event, ...]:
        fault = sighting_fault(sighting, now, self.state.gate.last_capture)
        if fault is not None:
            return self._rejections.reject(fault, now)
        if self._repeats(sighting) and not grounded:
            return self._rejections.reject(RejectionReason.FROZEN, now)
        seen = _measurement(sighting)
        accepted, self.state = estimator_updated(self.state, self.history, self._params, seen, now)
        if not accepted:
            return self._reject_jump(sighting, now, grounded)
        self._accept(sighting)
        return ()

    def _repeats(self, sighting: Sighting) -> bool:
        """Return whether the position is the last one bit for bit: no flying drone does that."""
        before, self._last_position = self._last_position, sighting.pose.position
        return self._last_position == before

    def _reject_jump(self, sighting: Sighting, now: float, grounded: bool) -> tuple[Event, ...]:
        events = self._rejections.reject(RejectionReason.JUMP, now)
        since = self._rejections.rejecting_since
        if not grounded or since is None or now - since < RESTART_AFTER:
            return events
        seen = _measurement(sighting)
        self.state = estimator_initialized(self.state, self.history, self._params, seen, now)
        self._accept(sighting)
        text = "the drone was moved on the ground: tracking starts anew"
        return (Event(now, Severity.INFO, "tracking_restarted", text),)

    def _accept(self, sighting: Sighting) -> None:
        self.accepted = sighting
        self._rejections.accepted()


def _measurement(sighting: Sighting) -> Measurement:
    pose = sighting.pose
    return Measurement(sighting.captured_at, *pose.position, pose.yaw)
