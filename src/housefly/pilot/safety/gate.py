"""The last gate before the drone: it may only make a command smaller.

"Level" means the drone's own hover (Action.HOVER): an AR.Drone told to keep level drifts, while its
hover holds the place by optical flow. A landing, once begun here, is kept until the drone says that
it stands; then nothing moves without a fresh order.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite

from housefly.config.site import LimitsConfig
from housefly.messages import LEVEL, Action, Command, DroneStatus, SafetyMode, Setpoint
from housefly.pilot.safety.facts import Facts, Fence
from housefly.pilot.safety.limits import limited
from housefly.pilot.safety.rules import RULES, SEVERITY, Rule

A, M = Action, SafetyMode

AIRBORNE_ACTIONS: dict[SafetyMode, dict[Action, Action]] = {
    M.NOMINAL: {A.RESET: A.HOVER},
    M.LEVEL: {A.FLY: A.HOVER, A.RESET: A.HOVER},
    M.STOPPED: {A.FLY: A.HOVER, A.TAKE_OFF: A.HOVER, A.RESET: A.HOVER},
    M.LAND: {A.FLY: A.LAND, A.HOVER: A.LAND, A.TAKE_OFF: A.LAND, A.IDLE: A.LAND, A.RESET: A.LAND},
    M.CUT: dict.fromkeys(Action, A.CUT),
}
"""What becomes of an action in the air, by safety mode; an action that is not listed passes."""

GROUND_ACTIONS: dict[SafetyMode, dict[Action, Action]] = {
    M.NOMINAL: {A.FLY: A.IDLE, A.HOVER: A.IDLE, A.RESET: A.IDLE},
    M.LEVEL: {A.FLY: A.IDLE, A.TAKE_OFF: A.IDLE, A.HOVER: A.IDLE, A.RESET: A.IDLE},
    M.STOPPED: {A.FLY: A.IDLE, A.TAKE_OFF: A.IDLE, A.HOVER: A.IDLE, A.RESET: A.IDLE},
    M.LAND: {A.FLY: A.IDLE, A.TAKE_OFF: A.IDLE, A.HOVER: A.IDLE, A.RESET: A.IDLE},
    M.CUT: dict.fromkeys(Action, A.CUT),
}
"""The same on the ground. The emergency command is a toggle: it is never sent in the emergency
state, and RESET only there.
"""


@dataclass(frozen=True, slots=True)
class Verdict:
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
    """Judges every command; remembers only how long each rule is broken, and a landing that it
    began.
    """

    def __init__(self, limits: LimitsConfig, fence: Fence) -> None:
        self._limits = limits
        self._fence = fence
        self._broken_since: dict[str, float] = {}
        self._landing: Rule | None = None
        self._landing_words = ""

    @property
    def landing(self) -> bool:
        """Whether a forced landing is under way."""
        return self._landing is not None

    def judge(self, command: Command, facts: Facts) -> Verdict:
        """Return the command made safe, and why."""
        rule, words = self._worst(facts)
        mode = rule.mode if rule else SafetyMode.NOMINAL
        code = rule.code if rule else ""
        if not _finite(command.setpoint):
            command = (
                Command(command.action, LEVEL)
                if command.action is not Action.FLY
                else Command(Action.HOVER)
            )
            if mode is SafetyMode.NOMINAL:
                mode, code, words = (
                    SafetyMode.LEVEL,
                    "not_finite",
                    "the command was not a number: the drone holds itself",
                )
        return Verdict(self._restrained(command, mode, facts), mode, code, words)

    def _worst(self, facts: Facts) -> tuple[Rule | None, str]:
        if facts.status in (DroneStatus.LANDED, DroneStatus.EMERGENCY):
            self._landing = None
        broken = [rule for rule in RULES if self._counts(rule, facts)]
        worst = max(broken, key=lambda rule: SEVERITY[rule.mode], default=None)
        if worst is not None and worst.mode is SafetyMode.LAND:
            self._landing, self._landing_words = worst, worst.words(facts, self._limits)
        if self._landing is not None and (
            worst is None or SEVERITY[worst.mode] <= SEVERITY[SafetyMode.LAND]
        ):
            return self._landing, self._landing_words
        return worst, worst.words(facts, self._limits) if worst else ""

    def _counts(self, rule: Rule, facts: Facts) -> bool:
        if not rule.broken(facts, self._limits, self._fence):
            self._broken_since.pop(rule.code, None)
            return False
        return facts.now - self._broken_since.setdefault(rule.code, facts.now) >= rule.after

    def _restrained(self, command: Command, mode: SafetyMode, facts: Facts) -> Command:
        if facts.status is DroneStatus.EMERGENCY:
            return Command(Action.RESET if command.action is Action.RESET else Action.IDLE)
        table = AIRBORNE_ACTIONS if facts.airborne else GROUND_ACTIONS
        action = table[mode].get(command.action, command.action)
        if action is Action.FLY:
            return Command(action, self._limited(command.setpoint))
        return Command(action)

    def _limited(self, setpoint: Setpoint) -> Setpoint:
        limits = self._limits
        asked = (setpoint.theta, setpoint.phi, setpoint.vz, setpoint.yaw_rate)
        return Setpoint(
            *limited(*asked, limits.tilt_max, limits.vertical_speed_max, limits.yaw_rate_max)
        )


def _finite(setpoint: Setpoint) -> bool:
    return all(
        isfinite(value) for value in (setpoint.theta, setpoint.phi, setpoint.vz, setpoint.yaw_rate)
    )
