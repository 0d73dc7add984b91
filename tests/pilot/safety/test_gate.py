from __future__ import annotations

from dataclasses import astuple, replace
from itertools import product
from math import hypot, inf, isfinite, nan

import pytest
from gate_bench import GateBench
from gate_flight import AIRFRAME
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.limits import LimitsConfig
from housefly.messages import (
    LEVEL,
    Action,
    Clearing,
    Command,
    DroneFault,
    DroneStatus,
    EventCode,
    Phase,
    Reference,
    SafetyMode,
    Setpoint,
    Severity,
    Telemetry,
)
from housefly.messages.sensing import AIRBORNE_STATUSES
from housefly.pilot.estimation.consistency import TrackingConsistency
from housefly.pilot.safety.control_source import STEERED_LANDING_TIME_MAX, ControlSource
from housefly.pilot.safety.fallbacks import possible_mode
from housefly.pilot.safety.gate import (
    AIRBORNE_ACTIONS,
    GROUND_ACTIONS,
    KEPT_SLACK,
    BrokenRule,
    Gate,
    GateAssessment,
    GateNotices,
    GateVerdict,
    gate_verdict,
)
from housefly.pilot.safety.inputs import GateInputs, Geofence
from housefly.pilot.safety.limits import DESCENT_RATE, GatedCommand
from housefly.pilot.safety.observer import NOTHING_OBSERVED, FlightObserver
from housefly.pilot.safety.rule import IN_SCOPE, RuleContext
from housefly.pilot.safety.rules import MODE_SEVERITY, ORDER_RULES, SAFETY_RULES

LIMITS = LimitsConfig()
FENCE = Geofence((0.0, 0.0, 10.0, 5.0), 2.5)
FINE = GateInputs(10.0, DroneStatus.FLYING, 0.9, 0.01, 0.05, (5.0, 2.0, 1.1), False, False)
FLY = Command(Action.FLY, Setpoint(0.1, -0.1, 0.3, 0.5))
REPORT = Telemetry(10.0, DroneStatus.FLYING, 0.9)
DEAF = Telemetry(10.0, DroneStatus.FLYING, 0.9, faults=(DroneFault.ULTRASOUND_DEAF,))
CLEAR = GateVerdict(Command(Action.HOVER), SafetyMode.NOMINAL)
OLD = GateVerdict(Command(Action.HOVER), SafetyMode.HOLD, EventCode.TRACKING_OLD, "old")
LOST = GateVerdict(Command(Action.HOVER), SafetyMode.LAND, "tracking_lost", "lost")
BOLDNESS = {
    Action.FLY: 3,
    Action.TAKE_OFF: 3,
    Action.HOVER: 2,
    Action.RESET: 2,
    Action.LAND: 1,
    Action.IDLE: 0,
    Action.CUT: 0,
}

number = st.floats() | st.floats(-2.0, 2.0)
setpoints = st.builds(Setpoint, number, number, number, number)
commands = st.builds(Command, st.sampled_from(Action), setpoints)
inputs = st.builds(
    GateInputs,
    now=st.floats(0.0, 1e4),
    status=st.sampled_from(DroneStatus),
    battery=number,
    pose_age=number,
    telemetry_age=number,
    position=st.none() | st.tuples(number, number, number),
    stopped=st.booleans(),
    cutting=st.booleans(),
) | st.just(FINE)


def judge(command: Command, *series: GateInputs) -> tuple[SafetyMode, Command]:
    gate = GateBench(LIMITS, FENCE)
    for each in series:
        verdict = gate.judge(command, each)
    return verdict.mode, verdict.command


@given(commands, st.lists(inputs, min_size=1, max_size=6))
def test_what_leaves_the_gate_is_always_finite_within_limits_and_never_bolder(
    command: Command, series: list[GateInputs]
) -> None:
    gate = GateBench(LIMITS, FENCE)
    for each in series:
        verdict = gate.judge(command, each)
        out = verdict.command.setpoint
        assert all(isfinite(value) for value in (out.theta, out.phi, out.vz, out.yaw_rate))
        assert max(abs(out.theta), abs(out.phi)) <= LIMITS.tilt_max
        assert abs(out.vz) <= LIMITS.vertical_speed_max and abs(out.yaw_rate) <= LIMITS.yaw_rate_max
        asked = command.setpoint
        if verdict.mode is SafetyMode.DESCEND and verdict.command.action is Action.FLY:
            assert (out.vz, out.yaw_rate) == (-DESCENT_RATE, 0.0)
            assert abs(out.theta) <= abs(asked.theta) or not isfinite(asked.theta)
            assert abs(out.phi) <= abs(asked.phi) or not isfinite(asked.phi)
            continue
        if verdict.command.action is Action.FLY:
            assert hypot(out.theta, out.phi) <= hypot(asked.theta, asked.phi) + 1e-12
            assert command.action is Action.FLY
        else:
            assert out == LEVEL
        if verdict.command.action is not Action.LAND or each.status not in AIRBORNE_STATUSES:
            assert (
                BOLDNESS[verdict.command.action] <= BOLDNESS[command.action]
                or verdict.mode is SafetyMode.CUT
            )


@given(commands, inputs)
def test_motors_are_cut_in_the_air_only_by_order(command: Command, each: GateInputs) -> None:
    mode, out = judge(command, each)
    if out.action is Action.CUT and each.status in AIRBORNE_STATUSES:
        assert each.cutting or command.action is Action.CUT
    assert mode is not SafetyMode.CUT or each.cutting or each.status is DroneStatus.EMERGENCY


@given(commands, inputs)
def test_the_toggle_is_never_pressed_in_the_wrong_state(command: Command, each: GateInputs) -> None:
    _, out = judge(command, each)
    if each.status is DroneStatus.EMERGENCY:
        assert out.action in (Action.IDLE, Action.RESET)
    else:
        assert out.action is not Action.RESET


@given(setpoints, st.lists(inputs, min_size=1, max_size=6))
def test_numbers_leave_the_gate_exactly_when_the_command_is_to_fly(
    setpoint: Setpoint, series: list[GateInputs]
) -> None:
    gate = GateBench(LIMITS, FENCE)
    is_finite = all(map(isfinite, astuple(setpoint)))
    for each in series:
        numbers, verdict = gate.judged(Command(Action.FLY, setpoint), each)
        assert numbers.flown == (verdict.command.action is Action.FLY)
        may_be_ours = verdict.mode in (*STOPPING, SafetyMode.RETURN)
        is_ours = may_be_ours and (numbers.flown or not is_finite)
        waits = verdict.mode is SafetyMode.RETURN and holds(verdict)
        told = SafetyMode.HOLD if waits else verdict.mode
        assert is_ours or numbers.mode == MODE_SEVERITY[told]


def test_a_steered_landing_whose_command_is_no_number_is_left_to_the_drone() -> None:
    for yaw_rate, action in ((0.1, Action.FLY), (inf, Action.LAND), (nan, Action.LAND)):
        gate, high = GateBench(LIMITS, FENCE), replace(FINE, position=(0.0, 0.0, 3.0))
        verdict = gate.judge(Command(Action.FLY, Setpoint(yaw_rate=yaw_rate)), high)
        assert verdict.mode is SafetyMode.LAND and verdict.command.action is action


STOPPING = (SafetyMode.HOLD, SafetyMode.STOPPED, SafetyMode.LAND)
"""Modes in which our setpoint may keep the place, or sink."""


def holds(verdict: GateVerdict) -> bool:
    """Return whether a rule that holds the drone is broken."""
    return any(rule.mode is SafetyMode.HOLD for rule in verdict.broken)


@given(st.lists(inputs, min_size=1, max_size=6))
def test_a_drone_that_a_rule_holds_is_kept_or_left_to_itself_though_it_is_called_home(
    series: list[GateInputs],
) -> None:
    gate = Gate(LIMITS, FENCE, AIRFRAME)
    for n, each in enumerate(series):
        found = gate.assess(replace(each, now=1.5 * n, home_time=1e4))
        is_held = any(rule.mode is SafetyMode.HOLD for rule in found.broken)
        if is_held and found.mode in (SafetyMode.RETURN, SafetyMode.HOLD) and not found.lands:
            assert found.held and found.kept is (
                found.control_source is not ControlSource.ONBOARD_HOVER
            )


@pytest.mark.parametrize("steers", [True, False])
def test_stop_is_flown_by_our_setpoint_while_the_place_is_believed_and_kept(steers: bool) -> None:
    gate = GateBench(LIMITS, FENCE)
    stopped = replace(FINE, stopped=True, steers=steers, velocity=(0.5, 0.0, 0.0))
    first = gate.judge(FLY, stopped)
    assert first.mode is SafetyMode.STOPPED
    assert first.command == (FLY if steers else Command(Action.HOVER))
    reach = 0.5 * 0.3 + 0.5 * 0.5**2 + KEPT_SLACK
    near = replace(stopped, now=10.5, position=(5.0 + 0.99 * reach, 2.0, 1.1))
    assert (gate.judge(FLY, near).command.action is Action.FLY) is steers
    gone = replace(stopped, now=10.6, position=(5.0 + 1.01 * reach, 2.0, 1.1))
    assert gate.judge(FLY, gone).command == Command(Action.HOVER)


@given(setpoints, st.tuples(st.floats(), st.floats()))
def test_what_a_drone_is_asked_for_whose_attitude_hangs_is_within_limits(
    setpoint: Setpoint, missing: tuple[float, float]
) -> None:
    hangs = replace(FINE, missing_lean=missing)
    out = judge(Command(Action.FLY, setpoint), hangs)[1].setpoint
    assert all(isfinite(value) for value in (out.theta, out.phi, out.vz, out.yaw_rate))
    assert max(abs(out.theta), abs(out.phi)) <= LIMITS.tilt_max


def test_a_drone_whose_attitude_hangs_is_asked_for_what_is_missing_besides() -> None:
    out = judge(FLY, replace(FINE, missing_lean=(-0.05, 0.3)))[1].setpoint
    assert out == replace(FLY.setpoint, theta=pytest.approx(0.05), phi=pytest.approx(0.2))


WRONG = TrackingConsistency(flow_wrong=True)
UNTOLD = TrackingConsistency(flow_untold=True)


@pytest.mark.parametrize("doubt", [WRONG, UNTOLD])
def test_without_tracking_and_flow_it_brakes_and_sinks_level_at_once(
    doubt: TrackingConsistency,
) -> None:
    unseen = replace(FINE, pose_age=0.3, stopped=True, consistency=doubt)
    gate = GateBench(LIMITS, FENCE)
    assert gate.judge(FLY, unseen).command == FLY, "not left to a hover that flies by nothing"
    sinking = gate.judge(FLY, replace(unseen, now=10.3, pose_age=0.6))
    assert sinking.mode is SafetyMode.DESCEND and sinking.code == "nothing_believed"
    assert sinking.command.setpoint == replace(FLY.setpoint, vz=-DESCENT_RATE, yaw_rate=0.0)


def test_flow_that_is_wrong_lands_the_drone_by_our_setpoint_down_to_the_floor() -> None:
    gate = GateBench(LIMITS, FENCE)
    standing = replace(FINE, status=DroneStatus.LANDED, position=(5.0, 2.0, 0.05))
    gate.judge(Command(Action.IDLE), standing)
    doubted = replace(FINE, consistency=WRONG, phase=Phase.LANDING)
    gate.judge(FLY, replace(doubted, now=10.7))
    for n, z in enumerate((1.1, 0.25, 0.12)):
        verdict = gate.judge(FLY, replace(doubted, now=11.0 + n, position=(5.0, 2.0, z)))
        assert verdict.mode is SafetyMode.LAND and verdict.command.action is Action.FLY
    down = gate.judge(FLY, replace(doubted, now=14.0, position=(5.0, 2.0, 0.08)))
    assert down.command.action is Action.LAND


def test_what_is_wrong_with_the_commands_leaves_the_drone_to_its_own_hover() -> None:
    unheard = replace(REPORT, hears_us=False)
    first, held = (replace(FINE, now=at, telemetry=unheard) for at in (10.0, 10.5))
    assert judge(FLY, first, held) == (SafetyMode.HOLD, Command(Action.HOVER))
    blind = replace(held, consistency=WRONG)
    assert judge(FLY, replace(first, consistency=WRONG), blind)[1].action is Action.FLY


@given(inputs)
def test_the_worst_broken_rule_decides(each: GateInputs) -> None:
    gate = GateBench(LIMITS, FENCE)
    mode = gate.judge(Command(Action.HOVER), each).mode
    seen = FlightObserver(LIMITS).observe(each, held=False, landing=False)
    context = RuleContext(each, seen, LIMITS, FENCE, AIRFRAME)
    counted = [rule for rule in SAFETY_RULES if IN_SCOPE[rule.scope](context)]
    at_once = [rule for rule in counted if rule.debounce == 0.0 and rule.is_broken(context)]
    worst = max((MODE_SEVERITY[possible_mode(rule.mode, context)] for rule in at_once), default=0)
    assert MODE_SEVERITY[mode] >= worst
    assert MODE_SEVERITY[mode] == worst or gate.landing


def test_what_is_too_much_is_cut_to_the_limits() -> None:
    wild = Command(Action.FLY, Setpoint(9.0, -9.0, 9.0, -9.0))
    tilt, climb, turn = LIMITS.tilt_max, LIMITS.vertical_speed_max, LIMITS.yaw_rate_max
    assert judge(wild, FINE) == (
        SafetyMode.NOMINAL,
        Command(Action.FLY, Setpoint(tilt, -tilt, climb, -turn)),
    )


def test_what_is_right_passes_unchanged() -> None:
    assert judge(FLY, FINE) == (SafetyMode.NOMINAL, FLY)


@pytest.mark.parametrize(
    ("change", "mode", "action"),
    [
        ({"pose_age": 0.251}, SafetyMode.HOLD, Action.HOVER),
        ({"pose_age": nan}, SafetyMode.LAND, Action.LAND),
        ({"pose_age": 2.01}, SafetyMode.LAND, Action.LAND),
        ({"telemetry_age": 1.01, "steers": False}, SafetyMode.LAND, Action.LAND),
        ({"telemetry_age": 1.01}, SafetyMode.LAND, Action.FLY),
        ({"position": (11.01, 2.0, 1.0)}, SafetyMode.LAND, Action.FLY),
        ({"position": (5.0, -1.01, 1.0)}, SafetyMode.LAND, Action.FLY),
        ({"position": (5.0, nan, 1.0)}, SafetyMode.LAND, Action.LAND),
        ({"position": (5.0, 2.0, 2.51)}, SafetyMode.LAND, Action.FLY),
        ({"stopped": True}, SafetyMode.STOPPED, Action.FLY),
        ({"stopped": True, "pose_age": 0.3}, SafetyMode.STOPPED, Action.HOVER),
        ({"cutting": True}, SafetyMode.CUT, Action.CUT),
        ({"stopped": True, "pose_age": 3.0}, SafetyMode.LAND, Action.LAND),
        ({"cutting": True, "pose_age": 3.0}, SafetyMode.CUT, Action.CUT),
    ],
)
def test_each_fault_has_its_answer(
    change: dict[str, object], mode: SafetyMode, action: Action
) -> None:
    expected = FLY if action is Action.FLY else Command(action)
    assert judge(FLY, replace(FINE, **change)) == (mode, expected)  # type: ignore[arg-type]


@pytest.mark.parametrize("battery", [0.149, nan, -inf])
def test_an_empty_battery_lands_after_a_second_and_a_dip_does_not(battery: float) -> None:
    low = replace(FINE, battery=battery)
    assert judge(FLY, low, replace(low, now=10.9))[0] is SafetyMode.NOMINAL
    assert judge(FLY, low, replace(low, now=11.0))[0] is SafetyMode.LAND
    assert judge(FLY, low, replace(FINE, now=10.5), replace(low, now=11.4))[0] is SafetyMode.NOMINAL


def test_a_forced_landing_is_kept_until_the_drone_stands() -> None:
    gate = GateBench(LIMITS, FENCE)
    gate.judge(FLY, replace(FINE, pose_age=3.0))
    assert gate.judge(FLY, FINE).command.action is Action.LAND
    assert gate.landing
    gate.judge(Command(Action.LAND), replace(FINE, status=DroneStatus.LANDED))
    assert not gate.landing


HIGH = replace(FINE, phase=Phase.HOLDING, flight_height=1.1, position=(5.0, 2.0, 1.6))
"""Half a metre above its height: a landing that the pilot may steer."""


def blown_up(until: float = 20.0) -> tuple[GateBench, GateInputs]:
    """Return a gate that lands a drone for its height, and the inputs of its last step."""
    gate, inputs = GateBench(LIMITS, FENCE), replace(HIGH, now=0.0)
    while inputs.now < until:
        verdict = gate.judge(FLY, inputs)
        if verdict.mode is SafetyMode.LAND:
            return gate, inputs
        inputs = replace(inputs, now=inputs.now + 0.05)
    raise AssertionError("never landed")


def test_a_landing_for_a_wrong_height_is_steered_until_the_drone_is_low_and_then_its_own() -> None:
    gate, inputs = blown_up()
    inputs = replace(inputs, phase=Phase.LANDING, now=inputs.now + 0.05)
    assert gate.judge(FLY, inputs).command == FLY
    low = replace(inputs, position=(5.0, 2.0, 0.29), now=inputs.now + 3.0)
    assert gate.judge(FLY, low).command.action is Action.LAND
    assert gate.judge(FLY, replace(inputs, now=low.now + 0.05)).command.action is Action.LAND


@pytest.mark.parametrize(
    "change",
    [
        {"pose_age": 0.3},
        {"position": None},
        {"late": 0.2},
        {"status": DroneStatus.LANDING},
        {"consistency": TrackingConsistency(refused_for=2.1)},
        {"consistency": TrackingConsistency(drift=0.2)},
        {"reference": Reference((5.9, 2.0, 1.1), (0.0, 0.0, 0.0), 0.0)},
    ],
)
def test_a_landing_is_steered_no_more_once_the_place_is_in_doubt(change: dict[str, object]) -> None:
    gate, inputs = blown_up()
    worse = replace(inputs, phase=Phase.LANDING, now=inputs.now + 0.05, **change)  # type: ignore[arg-type]
    assert gate.judge(FLY, worse).command.action is Action.LAND
    better = replace(inputs, phase=Phase.LANDING, now=inputs.now + 0.1)
    assert gate.judge(FLY, better).command.action is Action.LAND


def test_a_steered_landing_that_does_not_come_down_becomes_the_drones_own() -> None:
    gate, inputs = blown_up()
    inputs = replace(inputs, phase=Phase.LANDING)
    actions = [
        gate.judge(FLY, replace(inputs, now=inputs.now + 0.05 * n)).command.action
        for n in range(1, 200)
    ]
    assert actions[0] is Action.FLY and actions[-1] is Action.LAND
    assert actions.count(Action.FLY) * 0.05 <= STEERED_LANDING_TIME_MAX


def test_a_steered_landing_without_a_number_is_the_drones_own() -> None:
    gate, inputs = blown_up()
    bad = Command(Action.FLY, Setpoint(theta=nan))
    verdict = gate.judge(bad, replace(inputs, now=inputs.now + 0.05, phase=Phase.LANDING))
    assert (verdict.mode, verdict.command) == (SafetyMode.LAND, Command(Action.LAND))


def test_a_level_episode_ends_by_itself() -> None:
    gate = GateBench(LIMITS, FENCE)
    assert gate.judge(FLY, replace(FINE, pose_age=1.0)).mode is SafetyMode.HOLD
    assert gate.judge(FLY, FINE).command == FLY


@pytest.mark.parametrize("bad", [nan, inf, -inf])
def test_a_command_that_is_not_a_number_becomes_hover(bad: float) -> None:
    mode, out = judge(Command(Action.FLY, Setpoint(theta=bad)), FINE)
    assert (mode, out) == (SafetyMode.HOLD, Command(Action.HOVER))


def test_on_the_ground_stop_keeps_the_drone_there() -> None:
    ground = replace(FINE, status=DroneStatus.LANDED, stopped=True)
    assert judge(Command(Action.TAKE_OFF), ground)[1].action is Action.IDLE


def test_every_action_has_an_outcome_in_every_mode_in_the_air_and_on_the_ground() -> None:
    cells = 0
    for mode, action, status in product(SafetyMode, Action, DroneStatus):
        code, is_down = MODE_SEVERITY[mode], mode is SafetyMode.DESCEND
        airborne = status in AIRBORNE_STATUSES
        numbers = GatedCommand(code, is_down and airborne, 0.0, 0.0, -0.3 * is_down, 0.0)
        verdict = gate_verdict(action, numbers, GateAssessment(mode, "code", "words", status))
        assert isinstance(verdict.command.action, Action)
        if not airborne:
            assert verdict.command.action not in (Action.FLY, Action.HOVER)
        if mode in (SafetyMode.HOLD, SafetyMode.STOPPED) or is_down:
            assert verdict.command.action is not Action.FLY or is_down
        cells += 1
    assert cells == len(SafetyMode) * len(Action) * len(DroneStatus)
    assert set(AIRBORNE_ACTIONS) == set(GROUND_ACTIONS) == set(SafetyMode)


@pytest.mark.parametrize("action", [action for action in Action if action is not Action.CUT])
def test_a_descent_sinks_whatever_is_asked(action: Action) -> None:
    deaf = replace(FINE, pose_age=3.0, telemetry=DEAF)
    mode, out = judge(Command(action), deaf)
    assert (mode, out) == (SafetyMode.DESCEND, Command(Action.FLY, Setpoint(vz=-DESCENT_RATE)))


@pytest.mark.parametrize(
    ("change", "clears"),
    [
        ({}, Clearing.ITSELF),
        ({"pose_age": 0.4}, Clearing.ITSELF),
        ({"pose_age": 3.0}, Clearing.GROUND),
        ({"stopped": True}, Clearing.RESUME),
        ({"stopped": True, "pose_age": 3.0}, Clearing.GROUND),
        ({"status": DroneStatus.EMERGENCY}, Clearing.RESET),
    ],
)
def test_what_leaves_the_gate_says_what_ends_it(
    change: dict[str, object], clears: Clearing
) -> None:
    bench = GateBench(LIMITS, FENCE)
    verdict = bench.judge(FLY, replace(FINE, **change))  # type: ignore[arg-type]
    assert verdict.clears is clears


def test_a_command_that_is_no_number_ends_by_itself() -> None:
    verdict = GateBench(LIMITS, FENCE).judge(Command(Action.FLY, Setpoint(theta=nan)), FINE)
    assert (verdict.code, verdict.clears) == ("not_finite", Clearing.ITSELF)


def test_all_that_is_wrong_is_told_worst_first() -> None:
    gate = Gate(LIMITS, FENCE, AIRFRAME)
    found = gate.assess(replace(FINE, pose_age=3.0, stopped=True, battery=0.1, telemetry=DEAF))
    codes = [rule.code for rule in found.broken]
    assert codes[0] == "tracking_lost" and {"stopped", "drone_complains"} <= set(codes)
    assert found.reason == found.broken[0].words and found.code == codes[0]


def test_a_landing_that_began_is_told_with_what_is_wrong_besides() -> None:
    gate = Gate(LIMITS, FENCE, AIRFRAME)
    gate.assess(replace(FINE, pose_age=3.0))
    found = gate.assess(replace(FINE, now=10.1, stopped=True))
    assert [rule.code for rule in found.broken] == ["tracking_lost", "stopped"]
    assert found.mode is SafetyMode.LAND


def test_a_return_is_wanted_from_when_its_rule_is_broken_until_the_drone_stands() -> None:
    gate = Gate(LIMITS, FENCE, AIRFRAME)
    low = replace(FINE, battery=0.2, home_time=30.0)
    for n in range(21):
        found = gate.assess(replace(low, now=10.0 + 0.1 * n))
    assert gate.returning and found.mode is SafetyMode.RETURN
    gate.assess(replace(FINE, now=12.5))
    assert gate.returning, "the way home grows shorter: that is no reason for another errand"
    gate.assess(replace(low, now=13.0, status=DroneStatus.LANDED))
    assert not gate.returning


def test_the_height_of_a_drone_that_stands_is_the_lowest_seen() -> None:
    gate = Gate(LIMITS, FENCE, AIRFRAME)
    for z, height in ((0.07, 0.07), (0.6, 0.07), (nan, 0.07), (0.04, 0.04)):
        gate.assess(replace(FINE, status=DroneStatus.LANDED, position=(5.0, 2.0, z)))
        assert gate.standing_height == height
    gate.assess(replace(FINE, status=DroneStatus.LANDED, position=(5.0, 2.0, 0.0), pose_age=9.0))
    assert gate.standing_height == 0.04


def test_without_its_rules_only_what_people_order_counts() -> None:
    gate = Gate(LIMITS, FENCE, AIRFRAME, ORDER_RULES)
    assert gate.assess(replace(FINE, pose_age=9.0)).mode is SafetyMode.NOMINAL
    assert gate.assess(replace(FINE, stopped=True)).mode is SafetyMode.STOPPED


def test_every_rule_has_words_and_a_name_of_its_own() -> None:
    assert len({rule.code for rule in SAFETY_RULES}) == len(SAFETY_RULES)
    context = RuleContext(FINE, NOTHING_OBSERVED, LIMITS, FENCE, AIRFRAME)
    for rule in SAFETY_RULES:
        assert isinstance(rule.words(context), str)


def test_a_trouble_is_told_at_once_and_its_end_when_it_has_lasted() -> None:
    notices = GateNotices()
    assert [event.code for event in notices.update(OLD, 1.0)] == ["tracking_old"]
    assert notices.update(OLD, 1.5) == ()
    assert notices.update(CLEAR, 2.0) == ()
    assert [event.code for event in notices.update(CLEAR, 3.0)] == ["safety_clear"]
    assert notices.update(CLEAR, 9.0) == ()


def test_a_trouble_that_comes_and_goes_is_told_once() -> None:
    notices = GateNotices()
    told = [
        event for n in range(100) for event in notices.update(OLD if n % 4 < 2 else CLEAR, 0.1 * n)
    ]
    assert len(told) == 1


def test_a_worse_trouble_is_told_although_another_is_known() -> None:
    notices = GateNotices()
    notices.update(OLD, 1.0)
    (worse,) = notices.update(LOST, 2.0)
    assert worse.severity is Severity.FAULT and worse.text == "lost"


def test_each_trouble_of_a_step_is_told_once() -> None:
    two = (
        BrokenRule(EventCode.TRACKING_OLD, SafetyMode.HOLD, "old"),
        BrokenRule(EventCode.BATTERY_WEAK, SafetyMode.WARN, "weak"),
    )
    both = GateVerdict(Command(Action.HOVER), SafetyMode.HOLD, EventCode.TRACKING_OLD, "old", two)
    notices = GateNotices()
    assert [event.code for event in notices.update(OLD, 1.0)] == ["tracking_old"]
    assert [event.code for event in notices.update(both, 1.1)] == ["battery_weak"]
    assert notices.update(both, 1.2) == ()
    strange = GateVerdict(Command(Action.HOVER), SafetyMode.HOLD, "not_finite", "no number", two)
    assert [event.code for event in notices.update(strange, 1.3)] == ["not_finite"]


def test_a_pilot_whose_every_step_is_late_lands_the_drone() -> None:
    gate = Gate(LIMITS, FENCE, AIRFRAME)
    modes = [gate.assess(replace(FINE, now=0.4 * n, late=0.39)).mode for n in range(16)]
    assert SafetyMode.HOLD in modes and modes[-1] is SafetyMode.LAND
