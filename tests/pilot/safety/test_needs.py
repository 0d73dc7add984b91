"""Rules of the last gate that need what a drone may lack, and what it is told where it lacks it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import inf
from pathlib import Path
from typing import Any

import pytest
from gate_words import needs_table
from made_up_drones import BARE, known_made_up_drones

from housefly.config.airframe import Ability, Airframe, airframe_named
from housefly.config.limits import LimitsConfig
from housefly.messages import Action, DroneStatus, EventCode, SafetyMode, Telemetry
from housefly.messages.flight import Phase
from housefly.messages.words import literal
from housefly.pilot.estimation.consistency import TrackingConsistency
from housefly.pilot.safety.control_source import ControlSource
from housefly.pilot.safety.gate import Gate, GateAssessment, gate_verdict
from housefly.pilot.safety.inputs import GateInputs, Geofence
from housefly.pilot.safety.limits import GatedCommand
from housefly.pilot.safety.rules import SAFETY_RULES

FENCE = Geofence((0.0, 0.0, 10.0, 10.0), 2.5)
NOT_FLOWN = GatedCommand(0, False, 0.0, 0.0, 0.0, 0.0)


@pytest.fixture(scope="module")
def bare() -> Iterator[Airframe]:
    with known_made_up_drones():
        yield airframe_named(BARE)


def flying(now: float, **known: Any) -> GateInputs:
    return GateInputs(
        now=now,
        status=DroneStatus.FLYING,
        battery=0.9,
        pose_age=0.01,
        telemetry_age=0.01,
        position=(5.0, 5.0, 1.1),
        stopped=False,
        cutting=False,
        phase=Phase.HOLDING,
        velocity=(0.0, 0.0, 0.0),
        yaw=0.0,
        flight_height=1.1,
        telemetry=Telemetry(now, DroneStatus.FLYING, 0.9),
        consistency=TrackingConsistency(**known),
    )


def broken(airframe: Airframe, **known: Any) -> set[str]:
    """Return the rules that are broken after eight seconds of this."""
    gate = Gate(LimitsConfig(), FENCE, airframe)
    found = [gate.assess(flying(0.1 * tick, **known)) for tick in range(80)]
    return {rule.code.value for rule in found[-1].broken}


def test_a_rule_that_needs_what_the_drone_lacks_does_not_count(bare: Airframe) -> None:
    lies = {"drift": 1.0, "mirrored": True, "height_error": -1.0, "flow_untold": True}
    found = broken(airframe_named("ardrone"), **lies)
    assert {"tracking_drift", "tracking_mirrored", "tracking_height", "flow_untold"} <= found
    lacking = {rule.code.value for rule in SAFETY_RULES if rule.needs & bare.lacks}
    assert not broken(bare, **lies) & lacking


def test_every_rule_that_needs_something_says_what_stands_in_for_it() -> None:
    for rule in SAFETY_RULES:
        assert bool(rule.needs) == bool(rule.instead), rule.code
        assert Ability.CAMERA not in rule.needs
    page = Path(__file__).parents[3] / "docs" / "safety.md"
    assert needs_table() in page.read_text(encoding="utf-8")


@pytest.mark.parametrize("mode", list(SafetyMode))
@pytest.mark.parametrize("action", list(Action))
def test_one_without_a_hover_is_never_told_to_hover(mode: SafetyMode, action: Action) -> None:
    for status in DroneStatus:
        assessment = GateAssessment(mode, EventCode.STOPPED, literal("why"), status, hovers=False)
        told = gate_verdict(action, NOT_FLOWN, assessment).command.action
        assert told is not Action.HOVER or not assessment.airborne


def test_what_is_held_is_held_by_our_setpoint(bare: Airframe) -> None:
    gate = Gate(LimitsConfig(), FENCE, bare)
    stopped = gate.assess(replace(flying(1.0), stopped=True))
    assert stopped.kept and stopped.control_source is ControlSource.TRACKING
    assert gate.assess(replace(flying(1.1), pose_age=inf)).control_source is ControlSource.LEVEL
