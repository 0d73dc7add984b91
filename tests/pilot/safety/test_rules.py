"""Every row of the last gate, each way: told in time when broken, never when just within bounds."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import inf, nan
from pathlib import Path

import pytest
from gate_flight import FENCE, FINE, HERE, LIMITS, REPORT, RULES
from gate_words import rules_table

from housefly.config.limits import LimitsConfig
from housefly.messages import (
    Action,
    DroneStatus,
    Phase,
    Reference,
    SafetyMode,
    Setpoint,
    Telemetry,
)
from housefly.pilot.behavior.mission import PEOPLE_SILENCE_MAX, PeopleSilence
from housefly.pilot.estimation.consistency import TrackingConsistency
from housefly.pilot.safety.energy import NO_ENERGY, EnergyBudget
from housefly.pilot.safety.gate import Gate, GateAssessment, released
from housefly.pilot.safety.inputs import GateInputs
from housefly.pilot.safety.limits import GatedCommand
from housefly.pilot.safety.motion_rules import TILT_WRONG_MAX, vertical_speed
from housefly.pilot.safety.observer import NOTHING_OBSERVED, FlightObservations
from housefly.pilot.safety.rule import Clearing, RuleContext
from housefly.pilot.safety.rules import MODE_SEVERITY, SAFETY_RULES
from housefly.pilot.safety.tracking_rules import (
    DRIFT_LAND,
    DRIFT_WARN,
    FRAME_ERROR_MAX,
    LATENCY_HOLD,
    LATENCY_SLOW,
)
from housefly.pilot.safety.wind_rules import TAKE_OFF_DRIFT

FLOOR = (5.0, 2.0, 0.05)
STOOD = replace(FINE, status=DroneStatus.LANDED, phase=Phase.IDLE, position=FLOOR)
TICK = 0.05
SETTLED = 8.0
Change = Callable[[GateInputs, float], GateInputs]
"""What becomes of the inputs so long [s] after everything was fine."""


def drained(inputs: GateInputs) -> GateInputs:
    """A battery that lasts for ten minutes, as its gauge shows it."""
    return replace(inputs, battery=round(inputs.battery - inputs.now / 600.0, 2))


def now(**changes: object) -> Change:
    """These values from the first moment on."""
    return lambda inputs, _: replace(inputs, **changes)  # type: ignore[arg-type]


def told(**changes: object) -> Change:
    """The drone reports these values."""
    report = replace(REPORT, **changes)  # type: ignore[arg-type]
    return lambda inputs, _: replace(inputs, telemetry=report)


def seen(**changes: object) -> Change:
    """Tracking against the drone's own report."""
    return now(consistency=TrackingConsistency(**changes))  # type: ignore[arg-type]


def at(z: float, **changes: object) -> Change:
    """The drone is at this height."""
    return now(position=(5.0, 2.0, z), **changes)


def off(distance: float) -> Change:
    """The drone is so far from where it should be."""
    return now(position=(5.0 + distance, 2.0, 1.1))


def moving(vx: float, vz: float = 0.0, **changes: object) -> Change:
    """The drone moves along x and z; the reference with it, if not told otherwise."""
    reference = Reference(HERE, (vx, 0.0, 0.0), 0.0)
    return now(**{"velocity": (vx, 0.0, vz), "reference": reference, **changes})


def pulsed(period: float, length: float, change: Change) -> Change:
    """A change that comes for a length and goes, once a period [s]."""
    return lambda inputs, t: change(inputs, t) if t % period < length - 1e-9 else inputs


def lying(speed: float = 0.0, z: float = 0.06) -> Change:
    """It lies on the floor, or nearly so, told to land."""
    still = replace(REPORT, velocity=(speed, 0.0, 0.0), height=0.0)
    return now(position=(5.0, 2.0, z), phase=Phase.LANDING, telemetry=still)


def taking_off(aside: float, z: float) -> Change:
    """It takes off and is so far aside, drifting at 0.1 m/s, so high by tracking and by itself."""
    report = replace(REPORT, status=DroneStatus.TAKING_OFF, height=z - 0.05)
    return now(
        status=DroneStatus.TAKING_OFF,
        phase=Phase.TAKING_OFF,
        position=(5.0 + aside, 2.0, z),
        velocity=(0.1, 0.0, 0.2),
        reference=None,
        telemetry=report,
    )


def landing(aside: float, height: float) -> Change:
    """It lands and moves aside so fast, so far above the floor by tracking and by itself."""
    report = replace(REPORT, status=DroneStatus.LANDING, height=height)
    return now(
        status=DroneStatus.LANDING,
        phase=Phase.LANDING,
        position=(5.0, 2.0, height),
        velocity=(aside, 0.0, -0.3),
        reference=None,
        telemetry=report,
    )


UNCHANGED = now()
CONFIGURED_LATE = told(configured=False)
DAWDLING = now(flown=Setpoint(theta=0.12))

BROKEN: dict[str, tuple[Change, Change, float]] = {
    # code: (broken, just within bounds, how long after it begins it is wrong by its condition [s])
    "cut": (now(cutting=True), now(), 0.0),
    "emergency": (now(status=DroneStatus.EMERGENCY), now(), 0.0),
    "motors_running": (lying(), lying(speed=0.12), 0.0),
    "landing_refused": (now(phase=Phase.LANDING), lying(), LIMITS.landing_timeout),
    "telemetry_lost": (now(telemetry_age=1.01), now(telemetry_age=1.0), 0.0),
    "drone_fault": (told(faults=("motors problem",)), told(faults=("ultrasound deaf",)), 0.0),
    "not_configured": (CONFIGURED_LATE, pulsed(5.0, 4.9, CONFIGURED_LATE), 0.0),
    "battery_low": (now(battery=0.149), now(battery=0.151), 0.0),
    "battery_cliff": (now(battery=0.72), now(battery=0.75), 0.0),
    "flight_time_over": (now(), now(), inf),
    "loop_stalled": (now(late=1.01), now(late=1.0), 0.0),
    "held_too_often": (
        pulsed(0.5, 0.25, now(pose_age=0.5)),
        pulsed(0.5, 0.15, now(pose_age=0.5)),
        7.0,
    ),
    "stopped": (now(stopped=True), now(), 0.0),
    "battery_return": (now(battery=0.227), now(battery=0.24), 0.0),
    "flight_time": (now(home_time=440.0), now(home_time=350.0), 0.0),
    "configuring": (CONFIGURED_LATE, now(), 0.0),
    "commands_unheard": (told(hears_us=False), pulsed(0.4, 0.25, told(hears_us=False)), 0.3),
    "loop_late": (now(late=0.26), now(late=0.25), 0.0),
    "loop_slow": (pulsed(0.3, 0.05, now(late=0.06)), pulsed(0.6, 0.05, now(late=0.06)), 0.6),
    "people_unseen": (
        now(silence=PeopleSilence(inf)),
        now(silence=PeopleSilence(PEOPLE_SILENCE_MAX)),
        0.0,
    ),
    "drone_complains": (told(faults=("ultrasound deaf",)), told(faults=("motors problem",)), 0.0),
    "drone_settings": (told(notes=("tilt limit refused",)), now(), 0.0),
    "battery_weak": (now(battery=0.27), now(battery=0.29), 0.0),
    "battery_gauge": (now(battery=0.8), now(), 60.0),
    "tracking_lost": (now(pose_age=2.01), now(pose_age=2.0), 0.0),
    "poses_refused_long": (seen(refused_for=2.01), seen(refused_for=2.0), 0.0),
    "tracking_drift": (seen(drift=DRIFT_LAND + 0.01), seen(drift=DRIFT_LAND), 0.0),
    "tracking_frame": (
        seen(frame_error=-FRAME_ERROR_MAX - 0.01),
        seen(frame_error=FRAME_ERROR_MAX - 0.01),
        0.0,
    ),
    "tracking_mirrored": (seen(mirrored=True), seen(), 0.0),
    "tracking_height": (seen(height_error=-0.31), seen(height_error=-0.29), 0.0),
    "tracking_old": (now(pose_age=0.26), now(pose_age=0.25), 0.0),
    "poses_refused": (seen(refused_for=0.31), seen(refused_for=0.3), 0.0),
    "tracking_late": (
        seen(latency_error=LATENCY_HOLD + 0.01),
        seen(latency_error=LATENCY_HOLD),
        0.0,
    ),
    "tracking_slow": (
        seen(latency_error=LATENCY_SLOW + 0.01),
        seen(latency_error=LATENCY_SLOW),
        0.0,
    ),
    "tracking_drifting": (seen(drift=DRIFT_WARN + 0.01), seen(drift=DRIFT_WARN), 0.0),
    "tracking_gap": (
        now(status=DroneStatus.TAKING_OFF, pose_age=0.26),
        now(status=DroneStatus.TAKING_OFF, pose_age=0.25),
        0.0,
    ),
    "tracking_on_ground": (
        now(status=DroneStatus.LANDED, consistency=TrackingConsistency(height_error=0.31)),
        now(status=DroneStatus.LANDED, consistency=TrackingConsistency(height_error=0.29)),
        0.0,
    ),
    "tracking_height_off": (seen(height_error=0.31), seen(height_error=0.29), 0.0),
    "outside_fence": (now(position=(11.01, 2.0, 1.1)), now(position=(10.99, 2.0, 1.1)), 0.0),
    "too_high": (at(2.31), at(2.3), 0.0),
    "take_off_drift": (taking_off(0.09, 0.15), taking_off(0.07, 0.15), 0.0),
    "take_off_aborted": (taking_off(0.15, 0.07), taking_off(0.15, 0.18), 0.0),
    "landing_drift": (landing(0.26, 0.05), landing(0.26, 0.1), 0.0),
    "blown_about": (now(velocity=(0.2, 0.0, 0.0)), now(velocity=(0.0, -0.14, 0.0)), 3.4),
    "too_low": (at(0.29), at(0.31), 0.0),
    "height_error": (at(1.51), at(1.49), 0.0),
    "height_not_reached": (at(0.84), at(0.86), 0.0),
    "vertical_speed": (moving(0.0, 1.11), moving(0.0, -1.09), 0.0),
    "tilt_error": (told(phi=-0.21), told(phi=0.19), 0.0),
    "tilt_lost": (told(phi=-0.21), pulsed(2.0, 0.15, told(phi=0.21)), TILT_WRONG_MAX),
    "contact": (told(acceleration=(6.0, 0.0, 15.0)), told(acceleration=(4.0, 0.0, 14.0)), 0.0),
    "stuck": (DAWDLING, now(flown=Setpoint(theta=0.12), velocity=(0.09, 0.0, 0.0)), 0.4),
    "control_lost": (off(1.01), off(0.99), 0.0),
    "near_fence": (
        moving(0.5, position=(9.9, 2.0, 1.1), reference=None),
        moving(0.5, position=(9.8, 2.0, 1.1), reference=None),
        0.0,
    ),
    "control_error": (off(0.51), off(-0.49), 0.0),
    "drifting": (
        now(velocity=(0.0, 0.31, 0.0)),
        moving(0.3, reference=Reference(HERE, (0.01, 0.0, 0.0), 0.0)),
        0.0,
    ),
    "height_off": (at(1.36), at(1.34), 0.0),
    "not_on_floor": (
        now(status=DroneStatus.LANDED, position=(5.0, 2.0, 0.21)),
        now(status=DroneStatus.LANDED, position=(5.0, 2.0, 0.19)),
        0.0,
    ),
}


def assessed(change: Change, seconds: float) -> list[tuple[float, GateAssessment]]:
    """Return what a gate finds in the time after the change, on top of a flight that is fine."""
    gate = Gate(LIMITS, FENCE)
    gate.assess(replace(STOOD, now=-TICK))
    found = []
    for n in range(round((SETTLED + seconds) / TICK)):
        inputs = drained(replace(FINE, now=TICK * n))
        since = inputs.now - SETTLED
        if since >= -1e-9:
            found.append((since, gate.assess(change(inputs, max(since, 0.0)))))
        else:
            assert gate.assess(inputs).mode is SafetyMode.NOMINAL
    return found


def times(code: str, change: Change, seconds: float) -> list[float]:
    """Return when a rule was broken after a change [s]."""
    found = assessed(change, seconds)
    return [at for at, each in found if any(rule.code == code for rule in each.broken)]


def test_every_rule_has_its_case() -> None:
    assert set(BROKEN) == set(RULES)


@pytest.mark.parametrize("code", sorted(set(RULES) - {"flight_time_over"}))
def test_what_is_broken_is_told_half_a_second_after_its_time_and_never_sooner(code: str) -> None:
    change, _, observable = BROKEN[code]
    due = RULES[code].after + observable
    found = times(code, change, due + 0.6)
    assert found and found[0] <= due + 0.5
    assert found[0] >= RULES[code].after - 1e-6


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

    assert times("motors_running", waiting, RULES["motors_running"].after + 1.0) == []


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
    seconds = RULES[code].after + min(observable, 62.0) + 5.0
    assert times(code, fine, seconds) == []


@pytest.mark.parametrize("code", sorted(set(RULES) - {"flight_time_over"}))
def test_what_is_broken_has_words_with_no_number_that_is_none(code: str) -> None:
    change, _, observable = BROKEN[code]
    found = assessed(change, RULES[code].after + observable + 0.6)
    words = [rule.words for _, each in found for rule in each.broken if rule.code == code]
    assert all(words) and not any("nan" in word or "inf " in word for word in words)


def test_a_normal_flight_of_seconds_breaks_nothing() -> None:
    assert all(each.mode is SafetyMode.NOMINAL for _, each in assessed(now(), 5.0))


def test_the_clock_ends_a_flight_that_the_gauge_does_not() -> None:
    gate, first = Gate(LIMITS, FENCE), {}
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
    gate = Gate(LIMITS, FENCE)
    gate.assess(replace(STOOD, now=0.0, battery=0.5))
    assert not gate.gauge_stuck
    for n in range(1, 71):
        gate.assess(replace(FINE, now=float(n), battery=0.5))
    gate.assess(replace(STOOD, now=71.0, battery=0.5))
    assert gate.gauge_stuck
    gate.assess(replace(STOOD, now=72.0, battery=0.9))
    assert not gate.gauge_stuck


def test_a_battery_that_empties_faster_than_expected_turns_home_sooner() -> None:
    gate = Gate(LIMITS, FENCE)
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
    return RULES[code].broken(RuleContext(inputs, seen_so_far, LIMITS, FENCE))


def test_what_was_never_observed_breaks_no_rule_in_flight_and_moves_in_no_direction() -> None:
    assert [code for code in RULES if broken(code, NOTHING_OBSERVED)] == ["not_on_floor"]
    unknown = replace(FINE, velocity=None)
    assert vertical_speed(RuleContext(unknown, NOTHING_OBSERVED, LIMITS, FENCE)) == 0.0
    assert FlightObservations() == FlightObservations(
        0.0, 0.0, 0.0, None, None, nan, nan, 0.0, 0.0, 0.0, 0.0, 0, 0.0, NO_ENERGY
    )
    assert EnergyBudget(0.0, inf, 0.0, 0.0, 0.0, 0.0) == NO_ENERGY


def test_what_is_exactly_at_its_bound_is_not_broken_yet() -> None:
    longest, standing = LIMITS.landing_timeout, {"status": DroneStatus.LANDED}
    rising = {"status": DroneStatus.TAKING_OFF, "position": (TAKE_OFF_DRIFT, 0.0, 0.05)}
    started = FlightObservations(start=(0.0, 0.0), drift=(0.0, 0.0))
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
        holds = rule.broken(c)
        flight.held_at = c.now.now if holds else flight.held_at
        return holds

    rules = tuple(
        replace(each, broken=noted) if each.code == code else each
        for each in SAFETY_RULES
        if each.code == code or each.code != "battery_cliff"  # the charge of a case falls at once
    )
    flight = RuleEnding(code, Gate(limits, FENCE, rules))
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
        passed = {action: released(action, numbers, found).command.action for action in Action}
        assert passed.pop(Action.RESET) is Action.RESET
        assert set(passed.values()) == {Action.IDLE}
    reset = flight.go_on(1.0, now(status=DroneStatus.LANDED, phase=Phase.IDLE, position=FLOOR))
    assert reset[-1].mode is SafetyMode.NOMINAL
