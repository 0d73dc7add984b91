from __future__ import annotations

from math import inf, isfinite, nan

import pytest
from gate_bench import GateBench
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.limits import LimitsConfig
from housefly.messages import Action, Command, DroneStatus
from housefly.pilot.control.steering import ControlOutput
from housefly.pilot.safety.inputs import GateInputs, Geofence
from housefly.pilot.safety.limits import (
    DESCENT_RATE,
    CommandLimits,
    SafetyModeCode,
    gated,
    is_flown_in,
    pose_age_mode,
    too_old,
)
from housefly.pilot.safety.rules import MODE_SEVERITY

LIMITS = LimitsConfig()
COMMAND_LIMITS = CommandLimits(0.21, 0.7, 1.75)
BOUNDS = (0.21, 0.21, 0.7, 1.75)
anything = st.floats() | st.floats(-5.0, 5.0)
asks = st.builds(ControlOutput, anything, anything, anything, anything, anything)


@given(asks, st.booleans(), st.sampled_from(SafetyModeCode), st.booleans())
def test_limits_make_smaller_and_never_larger(
    asked: ControlOutput, flying: bool, mode: SafetyModeCode, airborne: bool
) -> None:
    passed = gated(asked, flying, int(mode), airborne, COMMAND_LIMITS)
    is_finite = all(isfinite(number) for number in asked[:4])
    if mode is SafetyModeCode.DESCEND and airborne:
        is_braked = flying and is_finite
        tilt = [min(max(a, -0.21), 0.21) if is_braked else 0.0 for a in (asked.theta, asked.phi)]
        assert passed == (mode, True, *tilt, -DESCENT_RATE, 0.0)
        return
    is_ours = bool(is_flown_in(int(mode)))
    assert passed.flown == (flying and airborne and is_finite and is_ours)
    held = passed.mode == SafetyModeCode.HOLD and flying and not is_finite and is_ours
    assert passed.mode == mode or held
    wanted = [min(max(a, -b), b) for a, b in zip(asked, BOUNDS, strict=False)]
    assert passed[2:] == (tuple(wanted) if passed.flown else (0.0, 0.0, 0.0, 0.0))


def test_our_setpoints_fly_the_drone_unless_it_is_held_stopped_or_brought_down() -> None:
    flown = {mode for mode in SafetyModeCode if is_flown_in(int(mode))}
    assert flown == {
        SafetyModeCode.NOMINAL,
        SafetyModeCode.WARN,
        SafetyModeCode.SLOW,
        SafetyModeCode.RETURN,
    }


def test_a_descent_is_no_faster_than_the_drone_may_sink() -> None:
    slow = COMMAND_LIMITS._replace(vertical_speed_max=0.1)
    level = ControlOutput(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    assert gated(level, False, int(SafetyModeCode.DESCEND), True, slow).vz == -0.1
    assert not gated(level, False, int(SafetyModeCode.DESCEND), False, slow).flown


@given(st.floats(0.0, 5.0) | st.sampled_from([nan, inf, 0.25, 2.0]))
def test_the_mode_of_an_age_is_what_the_rules_find_for_a_drone_that_flies(age: float) -> None:
    inputs = GateInputs(0.0, DroneStatus.FLYING, 1.0, age, 0.0, (1.0, 1.0, 1.0), False, False)
    gate = GateBench(LIMITS, Geofence((0.0, 0.0, 2.0, 2.0), 2.0))
    mode = pose_age_mode(age, LIMITS.pose_age_level, LIMITS.pose_age_land)
    assert mode == MODE_SEVERITY[gate.judge(Command(Action.HOVER), inputs).mode]


@pytest.mark.parametrize(("age", "is_too_old"), [(nan, True), (1.1, True), (1.0, False)])
def test_an_age_that_is_no_number_is_too_old(age: float, is_too_old: bool) -> None:
    assert too_old(age, 1.0) == is_too_old
