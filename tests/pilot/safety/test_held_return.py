"""A drone that is called home is held by whatever holds any other, and flies home after it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace

import pytest
from gate_bench import GateBench
from gate_cases import BROKEN, SETTLED, STOOD, SUDDEN, TICK, Change, drained, now, pulsed, seen
from gate_flight import FENCE, FINE, LIMITS, RULES

from housefly.messages import LEVEL, Action, Command, DroneStatus, SafetyMode, Setpoint
from housefly.pilot.safety.gate import GateVerdict
from housefly.pilot.safety.rule import RuleScope
from housefly.pilot.safety.rules import SAFETY_RULES

FLY = Command(Action.FLY, Setpoint(0.1, -0.1, 0.3, 0.5))
CALLED_HOME = {"home_time": 440.0}
"""A way home for which charge and time are just too short."""
HOLDING = sorted(
    code
    for code, rule in RULES.items()
    if rule.mode is SafetyMode.HOLD and rule.scope is not RuleScope.GROUND
)


@dataclass
class HomewardFlight:
    """A flight that is called home and meets the case of a rule; every step asks to fly."""

    code: str = ""
    clock: float = 0.0
    bench: GateBench = field(init=False)

    def __post_init__(self) -> None:
        others = SUDDEN.get(self.code, ())
        rules = tuple(rule for rule in SAFETY_RULES if rule.code not in others)
        self.bench = GateBench(LIMITS, FENCE, rules)
        self.bench.judge(FLY, replace(STOOD, now=-TICK))
        self.go_on(SETTLED, called_home=False)
        assert self.go_on(1.5)[-1].mode is SafetyMode.RETURN

    def go_on(
        self,
        seconds: float,
        change: Change = lambda inputs, _: inputs,
        until: Callable[[GateVerdict], bool] = lambda _: False,
        called_home: bool = True,
    ) -> list[GateVerdict]:
        """Return what leaves the gate in so many more seconds [s], or until something is true."""
        found: list[GateVerdict] = []
        for n in range(round(seconds / TICK)):
            inputs = change(drained(replace(FINE, now=self.clock)), TICK * n)
            inputs = now(**CALLED_HOME)(inputs, 0.0) if called_home else inputs
            found.append(self.bench.judge(FLY, inputs))
            self.clock += TICK
            if until(found[-1]):
                break
        return found


def tells(code: str) -> Callable[[GateVerdict], bool]:
    """Return whether a verdict tells a rule."""
    return lambda verdict: any(rule.code == code for rule in verdict.broken)


@pytest.mark.parametrize("code", HOLDING)
def test_a_return_waits_for_whatever_holds_the_drone_and_goes_on_after_it(code: str) -> None:
    flight = HomewardFlight(code)
    held = flight.go_on(2.0, BROKEN[code][0], until=tells(code))[-1]
    assert tells(code)(held) and tells("flight_time")(held)
    is_kept = RULES[code].may_steer
    assert (held.mode, held.command) == (
        SafetyMode.RETURN,
        FLY if is_kept else Command(Action.HOVER),
    )
    (words,) = (rule.words for rule in held.broken if rule.code == code)
    assert held.reason.endswith(f": coming home; {words}")
    later = flight.go_on(RULES[code].lasts + 0.2)
    assert all(verdict.mode is SafetyMode.RETURN for verdict in later)
    if not is_kept:
        assert all((verdict.command == FLY) is not tells(code)(verdict) for verdict in later)
    assert later[-1].command == FLY


def test_a_return_whose_poses_come_and_go_is_held_while_they_are_old_and_never_landed() -> None:
    verdicts = HomewardFlight().go_on(30.0, pulsed(1.0, 0.3, now(pose_age=0.4)))
    assert {verdict.mode for verdict in verdicts} == {SafetyMode.RETURN}
    actions = [verdict.command.action for verdict in verdicts]
    assert actions.count(Action.HOVER) * TICK == pytest.approx(9.0, abs=0.1)


@pytest.mark.parametrize("change", [now(pose_age=2.01), seen(refused_for=2.01)])
def test_a_return_that_has_lost_its_place_is_a_landing(change: Change) -> None:
    flight = HomewardFlight()
    lost = flight.go_on(TICK, change)[-1]
    assert (lost.mode, lost.command) == (SafetyMode.LAND, Command(Action.LAND))
    assert flight.go_on(1.0)[-1].command.action is Action.LAND


@pytest.mark.parametrize("code", HOLDING)
def test_a_return_that_is_held_for_too_long_is_a_landing(code: str) -> None:
    verdicts = HomewardFlight(code).go_on(6.0, BROKEN[code][0])
    assert verdicts[-1].mode is SafetyMode.LAND


def test_a_drone_called_home_that_stands_stays_down_whatever_holds_it() -> None:
    standing = now(status=DroneStatus.LANDED, position=STOOD.position, pose_age=0.4)
    verdict = HomewardFlight().go_on(1.0, standing)[-1]
    assert verdict.command == Command(Action.IDLE, LEVEL)
