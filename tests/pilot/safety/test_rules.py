"""Every row of the last gate, each way: told in time when broken, never when just within bounds."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import inf, nan
from pathlib import Path

import pytest
from gate_cases import (
    BROKEN,
    FLOOR,
    SETTLED,
    STOOD,
    SUDDEN,
    TICK,
    UNCHANGED,
    Change,
    assessed,
    at,
    drained,
    lying,
    moving,
    now,
    off,
    pulsed,
    taking_off,
    times,
)
from gate_flight import AIRFRAME, FENCE, FINE, HERE, LIMITS, REPORT, RULES
from gate_words import rules_table

from housefly.config.limits import LimitsConfig
from housefly.messages import (
    Action,
    Clearing,
    DroneStatus,
    Phase,
    Reference,
    SafetyMode,
    Telemetry,
)
from housefly.pilot.estimation.consistency import TrackingConsistency
from housefly.pilot.safety.energy import NO_ENERGY, EnergyBudget
from housefly.pilot.safety.gate import Gate, GateAssessment, gate_verdict
from housefly.pilot.safety.inputs import GateInputs
from housefly.pilot.safety.limits import GatedCommand
from housefly.pilot.safety.motion_rules import vertical_speed
from housefly.pilot.safety.observer import NOTHING_OBSERVED, FlightObservations
from housefly.pilot.safety.rule import RuleContext
from housefly.pilot.safety.rules import MODE_SEVERITY, SAFETY_RULES
from housefly.pilot.safety.tracking_rules import (
    DRIFT_LAND,
    DRIFT_WARN,
)
from housefly.pilot.safety.wind_rules import TAKE_OFF_DRIFT


def test_every_rule_has_its_case() -> None:
    assert set(BROKEN) == set(RULES)


@pytest.mark.parametrize("code", sorted(set(RULES) - {"flight_time_over"}))
def test_what_is_broken_is_told_half_a_second_after_its_time_and_never_sooner(code: str) -> None:
    change, _, observable = BROKEN[code]
    due = RULES[code].debounce + observable
    found = times(code, change, due + 0.6)
    assert found and found[0] <= due + 0.5
    assert found[0] >= RULES[code].debounce - 1e-6


AFTER_MAX = 0.5
"""Longest time for which a rule may be broken until it is told [s]."""
# Charge and clock run down over minutes, and a gauge dips while the motors pull; a good flight is
# off its height, leans without moving or is pushed by air for a second, too; limits are sent again
# until they are confirmed; motors are cut only on what has surely stood down; a drift is told at
# once and may come back; windows over the drone's own way have to fill.
SLOWER = {
    "motors_running": 4.0,
    "not_configured": 5.0,
    "battery_low": 1.0,
    "flight_time_over": 1.0,
    "tracking_drifted": 5.0,
    "height_error": 2.0,
    "height_not_reached": 10.0,
    "stuck": 1.5,
    "blown_about": 1.0,
    "battery_return": 1.0,
    "flight_time": 1.0,
    "battery_weak": 1.0,
    "tracking_unchecked": 3.0,
}


def test_every_rule_is_told_within_half_a_second_but_those_that_may_be_slower() -> None:
    assert {
        code: rule.debounce for code, rule in RULES.items() if rule.debounce > AFTER_MAX
    } == SLOWER


@pytest.mark.parametrize(
    "unknown", [{"position": None}, {"velocity": None}, {"pose_age": 0.3}, {"telemetry": None}]
)
def test_a_take_off_is_not_cut_short_for_a_drift_that_nobody_saw(
    unknown: dict[str, object],
) -> None:
    def blown(inputs: GateInputs, t: float) -> GateInputs:
        return replace(taking_off(0.4, 0.1)(inputs, t), **unknown)  # type: ignore[arg-type]

    assert times("take_off_aborted", blown, 0.5) == []


def test_the_motors_of_a_drone_that_was_not_told_to_land_are_not_cut_on_the_floor() -> None:
    def waiting(inputs: GateInputs, t: float) -> GateInputs:
        status, phase = DroneStatus.TAKING_OFF, Phase.TAKING_OFF
        return replace(lying()(inputs, t), status=status, phase=phase)

    assert times("motors_running", waiting, RULES["motors_running"].debounce + 1.0) == []


def test_a_noisy_velocity_is_no_drift_and_one_hard_stop_no_gusts() -> None:
    def noisy(inputs: GateInputs, t: float) -> GateInputs:
        side = 0.12 if round(t / TICK) % 2 else -0.12
        return replace(taking_off(0.05, 0.15)(inputs, t), velocity=(side, 0.0, 0.2))

    def stopping(inputs: GateInputs, t: float) -> GateInputs:
        return replace(inputs, velocity=(max(0.0, 0.8 - t), 0.0, 0.0))

    assert times("take_off_drift", noisy, 1.0) == []
    assert times("blown_about", stopping, 5.0) == []


def test_a_height_that_was_carried_on_through_blindness_is_not_told_as_seen() -> None:
    assert times("too_high", at(2.6, pose_age=0.3), 1.0) == []
    assert times("too_high", at(float("nan"), pose_age=0.3), 1.0)


@pytest.mark.parametrize("code", sorted(RULES))
def test_what_is_just_within_its_bounds_is_not_told(code: str) -> None:
    _, fine, observable = BROKEN[code]
    seconds = RULES[code].debounce + min(observable, 62.0) + 5.0
    assert times(code, fine, seconds) == []


@pytest.mark.parametrize("code", sorted(set(RULES) - {"flight_time_over"}))
def test_what_is_broken_has_words_with_no_number_that_is_none(code: str) -> None:
    change, _, observable = BROKEN[code]
    found = assessed(change, RULES[code].debounce + observable + 0.6)
    words = [rule.words for _, each in found for rule in each.broken if rule.code == code]
    assert all(words) and not any("nan" in word or "inf " in word for word in words)


def test_a_normal_flight_of_seconds_breaks_nothing() -> None:
    assert all(each.mode is SafetyMode.NOMINAL for _, each in assessed(now(), 5.0))


def test_the_clock_ends_a_flight_that_the_gauge_does_not() -> None:
    gate, first = Gate(LIMITS, FENCE, AIRFRAME), {}
    gate.assess(replace(STOOD, now=0.0, battery=0.5))
    for n in range(1, 251):
        each = gate.assess(replace(FINE, now=float(n), battery=0.5))
        for rule in each.broken:
            first.setdefault(rule.code, n)
    usable = (0.5 - LIMITS.battery_floor) * LIMITS.flight_time
    assert first["battery_gauge"] == pytest.approx(62, abs=1)
    assert first["flight_time"] == pytest.approx(usable - 35.0 + 2.0, abs=1.1)
    assert first["flight_time_over"] == pytest.approx(usable + 2.0, abs=1.1)


def test_a_gauge_that_stood_still_is_known_on_the_ground_until_it_shows_another_number() -> None:
    gate = Gate(LIMITS, FENCE, AIRFRAME)
    gate.assess(replace(STOOD, now=0.0, battery=0.5))
    assert not gate.gauge_stuck
    for n in range(1, 71):
        gate.assess(replace(FINE, now=float(n), battery=0.5))
    gate.assess(replace(STOOD, now=71.0, battery=0.5))
    assert gate.gauge_stuck
    gate.assess(replace(STOOD, now=72.0, battery=0.9))
    assert not gate.gauge_stuck


def test_a_battery_that_empties_faster_than_expected_turns_home_sooner() -> None:
    gate = Gate(LIMITS, FENCE, AIRFRAME)
    gate.assess(replace(STOOD, now=0.0))
    for n in range(1, 200):
        charge = 0.9 - 0.005 * n
        each = gate.assess(replace(FINE, now=float(n), battery=charge))
        if each.mode is SafetyMode.RETURN:
            break
    assert each.code == "battery_return"
    assert charge - 0.005 * (20.0 + 15.0) == pytest.approx(LIMITS.battery_floor, abs=0.07)
    assert charge - 0.005 * (20.0 + 15.0) > LIMITS.battery_floor


@pytest.mark.parametrize("velocity", [(0.56, 0.0, 0.0), (0.0, -0.56, 0.0)])
def test_a_velocity_that_is_suddenly_another_is_a_blow(velocity: tuple[float, ...]) -> None:
    reference = Reference(HERE, velocity, 0.0)  # type: ignore[arg-type]
    assert times("contact", now(velocity=velocity, reference=reference), 0.2)
    slow = tuple(0.9 * each for each in velocity)
    assert not times("contact", now(velocity=slow, reference=reference), 0.2)


def test_the_same_change_of_velocity_is_none_when_it_takes_its_time() -> None:
    def braking(inputs: GateInputs, t: float) -> GateInputs:
        speed = min(0.8, 2.0 * t)
        return moving(speed)(inputs, t)

    assert not times("contact", braking, 0.4)


def test_a_rule_that_is_broken_now_and_then_starts_anew_each_time() -> None:
    assert times("control_error", pulsed(0.6, 0.4, off(0.6)), 5.0) == []


def test_an_answer_lasts_as_long_as_its_rule_says() -> None:
    found = times("loop_late", lambda i, t: replace(i, late=0.3 if t < 0.04 else 0.0), 2.0)
    assert found[-1] == pytest.approx(RULES["loop_late"].lasts, abs=0.06)


def test_the_table_is_worst_first_and_names_each_rule_once() -> None:
    ranks = [MODE_SEVERITY[rule.mode] for rule in SAFETY_RULES]
    assert ranks == sorted(ranks, reverse=True)
    assert len(RULES) == len(SAFETY_RULES)


def test_the_page_shows_the_table_of_the_code() -> None:
    page = Path(__file__).parents[3] / "docs" / "safety.md"
    assert rules_table() in page.read_text(encoding="utf-8")


def test_the_page_says_at_what_drift_it_is_told_and_landed() -> None:
    page = (Path(__file__).parents[3] / "docs" / "safety.md").read_text(encoding="utf-8")
    assert f"told at {DRIFT_WARN:g} m" in page and f"landing begins at {DRIFT_LAND:g} m" in page


def broken(code: str, seen_so_far: FlightObservations, **changes: object) -> bool:
    """Return what a rule says of these inputs and of what was observed before."""
    inputs = replace(FINE, **changes)  # type: ignore[arg-type]
    return RULES[code].is_broken(RuleContext(inputs, seen_so_far, LIMITS, FENCE, AIRFRAME))


def test_what_was_never_observed_breaks_no_rule_in_flight_and_moves_in_no_direction() -> None:
    assert [code for code in RULES if broken(code, NOTHING_OBSERVED)] == ["not_on_floor"]
    unknown = replace(FINE, velocity=None)
    assert vertical_speed(RuleContext(unknown, NOTHING_OBSERVED, LIMITS, FENCE, AIRFRAME)) == 0.0
    assert FlightObservations() == FlightObservations(
        0.0, 0.0, 0.0, None, None, 0.0, nan, nan, 0.0, 0.0, inf, 0.0, 0.0, 0, 0.0, False, NO_ENERGY
    )
    assert EnergyBudget(0.0, inf, 0.0, 0.0, 0.0, 0.0) == NO_ENERGY


def test_what_is_exactly_at_its_bound_is_not_broken_yet() -> None:
    longest, standing = LIMITS.landing_timeout, {"status": DroneStatus.LANDED}
    rising = {"status": DroneStatus.TAKING_OFF, "position": (TAKE_OFF_DRIFT, 0.0, 0.05)}
    started = FlightObservations(start=(0.0, 0.0), take_off_velocity=(0.0, 0.0))
    drifts = {d: TrackingConsistency(drift=d) for d in (DRIFT_LAND, DRIFT_LAND + 0.01)}
    assert not broken("landing_refused", FlightObservations(landing_for=longest))
    assert broken("landing_refused", FlightObservations(landing_for=longest + 0.01))
    assert not broken("take_off_drift", started, **rising)
    assert broken("take_off_drift", replace(started, start=(-0.01, 0.0)), **rising)
    assert [
        broken("tracking_on_ground", NOTHING_OBSERVED, consistency=known, **standing)
        for known in drifts.values()
    ] == [False, True]


@pytest.mark.parametrize(
    ("own_height", "told_for", "still_up"),
    [
        (0.25, 60.0, True),  # its sonar sees the floor far below
        (0.24, 25.6, True),  # low by its sonar: a descent from the ceiling takes 10.7 s
        (0.24, 25.7, False),
        (None, 25.6, True),
        (None, 25.7, False),
    ],
)
def test_a_landing_that_tracking_does_not_see_is_judged_by_sonar_and_time(
    own_height: float | None, told_for: float, still_up: bool
) -> None:
    report = None if own_height is None else replace(REPORT, height=own_height)
    seen = FlightObservations(landing_for=told_for)
    assert broken("landing_refused", seen, pose_age=inf, telemetry=report) is still_up


@pytest.mark.parametrize("report", [None, replace(REPORT, acceleration=None)])
def test_a_drone_that_tells_little_breaks_nothing(report: Telemetry | None) -> None:
    assert all(
        each.mode is SafetyMode.NOMINAL
        for _, each in assessed(now(telemetry=report, reference=None, flown=None), 3.0)
    )


def test_a_drone_that_is_nowhere_breaks_only_what_is_about_that() -> None:
    lost = now(position=None, velocity=None, reference=None, pose_age=inf, flight_height=nan)
    found = [each for _, each in assessed(lost, 1.0)]
    codes = {rule.code for each in found for rule in each.broken}
    assert codes == {"tracking_lost", "tracking_old"}
    assert "tracking has not shown the drone yet" in found[-1].reason


@dataclass
class RuleEnding:
    """A flight in which one rule was broken; ``go_on`` flies it on once its inputs are fine.

    Attributes:
        code: of the rule.
        gate: that judges.
        clock: time [s].
        told_at: when the rule was last told [s].
        held_at: when its condition last held [s].
    """

    code: str
    gate: Gate
    clock: float = -TICK
    told_at: float = -inf
    held_at: float = -inf

    def go_on(
        self, seconds: float, change: Change = UNCHANGED, until_told: bool = False
    ) -> list[GateAssessment]:
        """Return what the gate finds in so many more seconds [s]."""
        found, begin = [], self.clock
        while self.clock - begin < seconds - 1e-9 and not (
            until_told and self.told_at == self.clock
        ):
            self.clock += TICK
            inputs = change(drained(replace(FINE, now=self.clock)), self.clock - begin - TICK)
            found.append(self.gate.assess(inputs))
            if any(rule.code == self.code for rule in found[-1].broken):
                self.told_at = self.clock
        return found


def broken_in_flight(code: str) -> RuleEnding:
    """Return a flight in which a rule has just been told, and the last of what broke it is gone."""
    limits = LimitsConfig(flight_time=30.0) if code == "flight_time_over" else LIMITS
    rule = RULES[code]

    def noted(c: RuleContext) -> bool:
        holds = rule.is_broken(c)
        flight.held_at = c.inputs.now if holds else flight.held_at
        return holds

    rules = tuple(
        replace(each, is_broken=noted) if each.code == code else each
        for each in SAFETY_RULES
        # The charge of a case falls at once.
        if each.code == code or each.code not in ("battery_cliff", *SUDDEN.get(code, ()))
    )
    flight = RuleEnding(code, Gate(limits, FENCE, AIRFRAME, rules))
    flight.gate.assess(replace(STOOD, now=flight.clock))
    flight.go_on(SETTLED)
    flight.go_on(70.0, BROKEN[code][0], until_told=True)
    assert flight.told_at == flight.clock
    return flight


def ending(clearing: Clearing) -> list[str]:
    return sorted(rule.code for rule in SAFETY_RULES if rule.clears is clearing)


@pytest.mark.parametrize("code", ending(Clearing.ITSELF))
def test_what_ends_by_itself_ends_with_its_condition_or_so_long_after_it(code: str) -> None:
    flight = broken_in_flight(code)
    found = flight.go_on(15.0)
    assert flight.told_at - flight.held_at == pytest.approx(
        max(0.0, RULES[code].lasts - TICK), abs=TICK / 2
    )
    assert found[-1].mode is SafetyMode.NOMINAL


@pytest.mark.parametrize("code", ending(Clearing.GROUND))
def test_a_landing_is_kept_until_the_drone_stands_whatever_became_of_its_cause(code: str) -> None:
    flight = broken_in_flight(code)
    for found in flight.go_on(LIMITS.landing_timeout - 2.0):
        assert flight.gate.landing
        assert found.mode in (SafetyMode.LAND, SafetyMode.DESCEND)
    stood = flight.go_on(1.0, now(status=DroneStatus.LANDED, phase=Phase.IDLE, position=FLOOR))
    assert not flight.gate.landing and stood[-1].mode is SafetyMode.NOMINAL
    flight.go_on(TICK)
    assert not flight.gate.landing


def test_stop_holds_until_a_person_resumes_in_the_air_and_on_the_ground() -> None:
    (code,) = ending(Clearing.RESUME)
    flight = broken_in_flight(code)
    standing = {"status": DroneStatus.LANDED, "position": FLOOR}
    for latched in (now(stopped=True), now(stopped=True, **standing), now(stopped=True)):
        assert {found.mode for found in flight.go_on(60.0, latched)} == {SafetyMode.STOPPED}
    assert flight.go_on(TICK)[-1].mode is SafetyMode.NOMINAL


@pytest.mark.parametrize("code", ending(Clearing.ORDER))
def test_a_return_is_wanted_until_the_drone_stands_whatever_became_of_its_cause(code: str) -> None:
    flight = broken_in_flight(code)
    for _ in range(20):
        flight.go_on(1.0)
        assert flight.gate.returning
    flight.go_on(TICK, now(status=DroneStatus.LANDED, phase=Phase.IDLE, position=FLOOR))
    assert not flight.gate.returning
    assert flight.go_on(1.0)[-1].mode is SafetyMode.NOMINAL and not flight.gate.returning


@pytest.mark.parametrize("code", ending(Clearing.RESET))
def test_after_a_cut_nothing_but_a_reset_passes_until_the_drone_was_reset(code: str) -> None:
    flight = broken_in_flight(code)
    fallen = now(status=DroneStatus.EMERGENCY, phase=Phase.IDLE, position=FLOOR)
    for found in flight.go_on(20.0, fallen):
        assert found.mode is SafetyMode.CUT
        numbers = GatedCommand(found.severity, False, 0.0, 0.0, 0.0, 0.0)
        passed = {action: gate_verdict(action, numbers, found).command.action for action in Action}
        assert passed.pop(Action.RESET) is Action.RESET
        assert set(passed.values()) == {Action.IDLE}
    reset = flight.go_on(1.0, now(status=DroneStatus.LANDED, phase=Phase.IDLE, position=FLOOR))
    assert reset[-1].mode is SafetyMode.NOMINAL


STEERED = """
    TELEMETRY_LOST DRONE_FAULT BATTERY_LOW BATTERY_CLIFF FLIGHT_TIME_OVER HELD_TOO_OFTEN
    FLOW_WRONG OUTSIDE_FENCE TOO_HIGH TOO_LOW HEIGHT_ERROR HEIGHT_NOT_REACHED CONTACT
    CONTROL_LOST BLOWN_ABOUT STOPPED NEAR_FENCE CONTROL_ERROR DRIFTING TOO_FAST
"""
WAITING = "HELD_TOO_OFTEN TRACKING_LOST POSES_REFUSED_LONG"


def test_only_what_leaves_place_and_commands_alone_is_steered_or_waits() -> None:
    # Written down a second time, by hand: what is steered trusts the very thing that may be wrong.
    assert {code.name for code, rule in RULES.items() if rule.may_steer} == set(STEERED.split())
    assert {code.name for code, rule in RULES.items() if rule.may_wait} == set(WAITING.split())
