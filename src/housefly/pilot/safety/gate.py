"""The last gate before the drone: it may only make a command smaller.

"Level" means the drone's own hover (Action.HOVER): an AR.Drone told to keep level drifts, while its
hover holds the place by optical flow. A landing, once begun here, is kept until the drone says that
it stands; then nothing moves without a fresh order.
"""

from __future__ import annotations

from dataclasses import dataclass

from housefly.config.limits import LimitsConfig
from housefly.messages.flight import Event, Severity
from housefly.messages.sensing import DroneStatus
from housefly.messages.steering import Action, Command, SafetyMode, Setpoint
from housefly.pilot.safety.limits import GatedCommand
from housefly.pilot.safety.rules import (
    AIRBORNE_STATUSES,
    MODE_SEVERITY,
    SAFETY_RULES,
    GateInputs,
    Geofence,
    SafetyRule,
)

A, M = Action, SafetyMode

_FLOWN = {A.RESET: A.HOVER}
_HELD = {A.FLY: A.HOVER, A.TAKE_OFF: A.HOVER, A.RESET: A.HOVER}
_LANDED = dict.fromkeys((A.FLY, A.HOVER, A.TAKE_OFF, A.IDLE, A.RESET), A.LAND)

AIRBORNE_ACTIONS: dict[SafetyMode, dict[Action, Action]] = {
    M.NOMINAL: _FLOWN,
    M.WARN: _FLOWN,
    M.SLOW: _FLOWN,
    M.HOLD: {A.FLY: A.HOVER, A.RESET: A.HOVER},
    M.RETURN: _FLOWN,
    M.STOPPED: _HELD,
    M.LAND: _LANDED,
    M.DESCEND: dict.fromkeys((A.FLY, A.HOVER, A.TAKE_OFF, A.IDLE, A.RESET, A.LAND), A.FLY),
    M.CUT: dict.fromkeys(Action, A.CUT),
}
"""What becomes of an action in the air, by safety mode; an action that is not listed passes."""

_STANDING = dict.fromkeys((A.FLY, A.HOVER, A.RESET), A.IDLE)
_KEPT_DOWN = {**_STANDING, A.TAKE_OFF: A.IDLE}

GROUND_ACTIONS: dict[SafetyMode, dict[Action, Action]] = {
    M.NOMINAL: _STANDING,
    M.WARN: _STANDING,
    M.SLOW: _STANDING,
    M.HOLD: _KEPT_DOWN,
    M.RETURN: _KEPT_DOWN,
    M.STOPPED: _KEPT_DOWN,
    M.LAND: _KEPT_DOWN,
    M.DESCEND: _KEPT_DOWN,
    M.CUT: dict.fromkeys(Action, A.CUT),
}
"""The same on the ground. The emergency command is a toggle: it is never sent in the emergency
state, and RESET only there.
"""


@dataclass(frozen=True, slots=True)
class GateAssessment:
    """What the rules found in one step, before any command is looked at.

    Attributes:
        mode: the worst that was found.
        code, reason: of the deciding rule, "" when nothing is wrong.
        status: the drone's own status.
    """

    mode: SafetyMode
    code: str
    reason: str
    status: DroneStatus

    @property
    def airborne(self) -> bool:
        """Whether the propellers carry the drone, by its last word."""
        return self.status in AIRBORNE_STATUSES


@dataclass(frozen=True, slots=True)
class GateVerdict:
    """What leaves the gate.

    Attributes:
        command: for the driver.
        mode: the worst that was found.
        code, reason: of the deciding rule, "" when nothing is wrong.
    """

    command: Command
    mode: SafetyMode
    code: str = ""
    reason: str = ""


class Gate:
    """Judges every step; remembers how long each rule is broken, and a landing that it began."""

    def __init__(self, limits: LimitsConfig, fence: Geofence) -> None:
        self._limits = limits
        self._fence = fence
        self._broken_since: dict[str, float] = {}
        self._landing: SafetyRule | None = None
        self._landing_reason = ""

    @property
    def landing(self) -> bool:
        """Whether a forced landing is under way."""
        return self._landing is not None

    def assess(self, inputs: GateInputs) -> GateAssessment:
        """Return what the rules find now."""
        rule, reason = self._worst(inputs)
        if rule is None:
            return GateAssessment(SafetyMode.NOMINAL, "", "", inputs.status)
        return GateAssessment(rule.mode, rule.code, reason, inputs.status)

    def _worst(self, inputs: GateInputs) -> tuple[SafetyRule | None, str]:
        if inputs.status in (DroneStatus.LANDED, DroneStatus.EMERGENCY):
            self._landing = None
        broken = [rule for rule in SAFETY_RULES if self._is_broken(rule, inputs)]
        worst = max(broken, key=lambda rule: MODE_SEVERITY[rule.mode], default=None)
        if worst is not None and worst.mode is SafetyMode.LAND:
            self._landing, self._landing_reason = worst, worst.words(inputs, self._limits)
        if self._landing is not None and (
            worst is None or MODE_SEVERITY[worst.mode] <= MODE_SEVERITY[SafetyMode.LAND]
        ):
            return self._landing, self._landing_reason
        return worst, worst.words(inputs, self._limits) if worst else ""

    def _is_broken(self, rule: SafetyRule, inputs: GateInputs) -> bool:
        if not rule.broken(inputs, self._limits, self._fence):
            self._broken_since.pop(rule.code, None)
            return False
        return inputs.now - self._broken_since.setdefault(rule.code, inputs.now) >= rule.after


def released(action: Action, gated: GatedCommand, assessment: GateAssessment) -> GateVerdict:
    """Return the verdict on one step.

    Args:
        action: what the pilot wants.
        gated: the numbers that left the compiled gate.
        assessment: what the rules found in this step.
    """
    mode, code, reason = assessment.mode, assessment.code, assessment.reason
    if gated.mode != MODE_SEVERITY[mode]:
        mode, code = SafetyMode.HOLD, "not_finite"
        reason = "the command was not a number: the drone holds itself"
    allowed = _allowed(action, mode, assessment)
    if allowed is not Action.FLY:
        return GateVerdict(Command(allowed), mode, code, reason)
    setpoint = Setpoint(gated.theta, gated.phi, gated.vz, gated.yaw_rate)
    return GateVerdict(Command(allowed, setpoint), mode, code, reason)


def _allowed(action: Action, mode: SafetyMode, assessment: GateAssessment) -> Action:
    if assessment.status is DroneStatus.EMERGENCY:
        return Action.RESET if action is Action.RESET else Action.IDLE
    table = AIRBORNE_ACTIONS if assessment.airborne else GROUND_ACTIONS
    return table[mode].get(action, action)


CLEAR_AFTER = 1.0
"""Trouble that returns sooner than this is the same trouble [s]: a lossy tracking system would fill
the log otherwise.
"""


class GateNotices:
    """Remembers the trouble told last."""

    def __init__(self) -> None:
        self._reported = ""
        self._clear_since: float | None = None

    def update(self, verdict: GateVerdict, now: float) -> tuple[Event, ...]:
        """Return the events of one verdict at a time [s]."""
        if verdict.code:
            self._clear_since = None
            if verdict.code == self._reported:
                return ()
            self._reported = verdict.code
            severity = (
                Severity.FAULT
                if verdict.mode in (SafetyMode.LAND, SafetyMode.CUT)
                else Severity.WARNING
            )
            return (Event(now, severity, verdict.code, verdict.reason),)
        self._clear_since = now if self._clear_since is None else self._clear_since
        if not self._reported or now - self._clear_since < CLEAR_AFTER:
            return ()
        self._reported = ""
        return (Event(now, Severity.INFO, "safety_clear", "nothing holds the drone back any more"),)
