"""What the drone said last of itself: kept over restarts of its pilot, until it surely stands."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import inf

from housefly.messages import DroneStatus, Phase, PilotStep
from housefly.messages.sensing import AIRBORNE_STATUSES

TELEMETRY_AGE_MAX = 1.0
"""Where the room does not tell ``limits.telemetry_age`` [s]."""


@dataclass(frozen=True, slots=True)
class LastStatus:
    """What a drone said last.

    Attributes:
        at: when it was heard, or since when nothing was; infinite before the first step [s].
        status: what it said; UNKNOWN of a drone that never said it.
        phase: what its pilot was doing, then or later.
    """

    at: float = inf
    status: DroneStatus = DroneStatus.UNKNOWN
    phase: Phase = Phase.IDLE

    @property
    def may_be_airborne(self) -> bool:
        """Whether one must reckon with a drone in the air."""
        return self.status in AIRBORNE_STATUSES or self.phase is not Phase.IDLE

    def after(self, step: PilotStep) -> LastStatus:
        """Return what it said last after a step; only a fresh one puts a drone on the ground.

        A new pilot knows nothing of the flight that it finds, and a pilot that flies without
        word of the drone may have taken off.
        """
        told, phase = step.inputs.telemetry, step.outputs.phase
        if told is not None and told.status is not DroneStatus.UNKNOWN:
            is_fresh = step.now - told.received_at <= TELEMETRY_AGE_MAX
            if is_fresh or told.status in AIRBORNE_STATUSES or not self.may_be_airborne:
                return LastStatus(told.received_at, told.status, phase)
        last = self.phase if phase is Phase.IDLE else phase
        return replace(self, at=min(self.at, step.now), phase=last)
