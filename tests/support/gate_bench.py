"""What the tests of the last gate share: both halves of it, put together as ``Pilot`` does."""

from __future__ import annotations

from gate_flight import AIRFRAME

from housefly.config.limits import LimitsConfig
from housefly.messages import Action, Command, SafetyMode
from housefly.pilot.control.steering import ControlOutput
from housefly.pilot.safety.gate import Gate, GateAssessment, GateVerdict, gate_verdict
from housefly.pilot.safety.inputs import GateInputs, Geofence
from housefly.pilot.safety.limits import CommandLimits, GatedCommand, gated
from housefly.pilot.safety.rule import SafetyRule
from housefly.pilot.safety.rules import SAFETY_RULES


class GateBench:
    """One gate that judges whole commands."""

    def __init__(
        self,
        limits: LimitsConfig,
        fence: Geofence,
        rules: tuple[SafetyRule, ...] = SAFETY_RULES,
    ) -> None:
        self._gate = Gate(limits, fence, AIRFRAME, rules)
        self._limits = CommandLimits(
            limits.tilt_max, limits.vertical_speed_max, limits.yaw_rate_max
        )

    @property
    def landing(self) -> bool:
        return self._gate.landing

    def judge(self, command: Command, inputs: GateInputs) -> GateVerdict:
        """Return what becomes of a command now."""
        return self.judged(command, inputs)[1]

    def judged(self, command: Command, inputs: GateInputs) -> tuple[GatedCommand, GateVerdict]:
        """Return what leaves the compiled half, and what becomes of the command."""
        assessment, s = self._gate.assess(inputs), command.setpoint
        numbers = gated(
            ControlOutput(s.theta, s.phi, s.vz, s.yaw_rate, 0.0, 0.0, 0.0),
            command.action is Action.FLY,
            assessment.severity,
            assessment.airborne,
            self._limits,
        )
        return numbers, gate_verdict(command.action, numbers, assessment)


def blind(inputs: GateInputs) -> GateAssessment:
    """Find nothing wrong whatever happens: the negative control of every rule."""
    return GateAssessment(SafetyMode.NOMINAL, "", "", inputs.status)
