"""Follows one service from the outside, from take-off to landing, and says how it ended."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import inf

from housefly.geometry import Vec2, distance
from housefly.messages import DroneStatus, Phase, PilotStep, SafetyMode, Severity
from housefly.pilot.behavior.standing import NEVER_STOOD, StandingHeight
from housefly.record.truth import COMPLETED, HOME_RADIUS

STAGES = (Phase.TAKING_OFF, Phase.OUTBOUND, Phase.LOOKING, Phase.RETURNING, Phase.LANDING)
"""The phases of a whole service, in order."""
_SEVERITIES = tuple(SafetyMode)


@dataclass(frozen=True, slots=True)
class ServiceMonitor:
    """One service as seen so far; ``outcome`` is "" while it goes on.

    Attributes:
        started_at: when the order was given [s].
        home: where the pad is, world xy [m].
        give_up_after: longest time allowed for the whole service [s].
        grace: longest time allowed until the pilot starts to act [s].
        seen: phases passed, in order.
        trouble: the last fault or refusal, in words.
        worst: the most severe safety mode seen.
        outcome: "completed", or the reason why not.
        standing: where the drone stood before the flight.
    """

    started_at: float
    home: Vec2
    give_up_after: float = 240.0
    grace: float = 3.0
    seen: tuple[Phase, ...] = ()
    trouble: str = ""
    worst: SafetyMode = SafetyMode.NOMINAL
    outcome: str = ""
    standing: StandingHeight = NEVER_STOOD

    def updated(self, step: PilotStep) -> ServiceMonitor:
        """Return the monitor after one more step of the pilot."""
        if self.outcome:
            return self
        phase = step.outputs.phase
        seen = self.seen if phase in self.seen or phase not in STAGES else (*self.seen, phase)
        texts = [event.text for event in step.outputs.events if event.severity is not Severity.INFO]
        worst = max(self.worst, step.outputs.safety, key=_SEVERITIES.index)
        standing, monitor = self._stood(step), self
        if texts or standing is not self.standing or (seen, worst) != (self.seen, self.worst):
            trouble = texts[-1] if texts else self.trouble
            monitor = replace(self, seen=seen, worst=worst, trouble=trouble, standing=standing)
        outcome = monitor._verdict(step)
        return replace(monitor, outcome=outcome) if outcome else monitor

    def _stood(self, step: PilotStep) -> StandingHeight:
        """Learn where the drone stands before its flight."""
        estimate, telemetry = step.outputs.estimate, step.inputs.telemetry
        stands = telemetry is not None and telemetry.status is DroneStatus.LANDED
        if estimate is None or not stands or len(self.seen) > 1:
            return self.standing
        return self.standing.stood_at(estimate.position[2], estimate.pose_age)

    def _verdict(self, step: PilotStep) -> str:
        elapsed = step.now - self.started_at
        telemetry = step.inputs.telemetry
        landed = telemetry is not None and telemetry.status is DroneStatus.LANDED
        idle = step.outputs.phase is Phase.IDLE
        if self.seen and idle and landed:
            return self._verdict_on_the_ground(step)
        if not self.seen and idle and elapsed > self.grace:
            return self.trouble or "the pilot did not start"
        if step.outputs.safety is SafetyMode.CUT:
            return "motors were cut"
        if elapsed > self.give_up_after:
            return f"not done after {self.give_up_after:.0f} s" + (
                f": {self.trouble}" if self.trouble else ""
            )
        return ""

    def _verdict_on_the_ground(self, step: PilotStep) -> str:
        if self.seen != STAGES:
            return self.trouble or "landed before the service was done"
        estimate = step.outputs.estimate
        away = inf if estimate is None else distance(estimate.position[:2], self.home)
        if away > HOME_RADIUS:
            return f"landed {away:.1f} m from the pad" + (
                f": {self.trouble}" if self.trouble else ""
            )
        assert estimate is not None
        return self.standing.fault(estimate.position[2], estimate.pose_age) or COMPLETED
