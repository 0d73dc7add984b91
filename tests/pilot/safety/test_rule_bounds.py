"""Every rule of the last gate at its bound, to the last bit: which side the bound belongs to."""

from __future__ import annotations

from dataclasses import fields, replace
from math import inf

import pytest
from gate_flight import AIRFRAME, FENCE, FINE, HERE, LIMITS, REPORT, RULES

from housefly.geometry import GRAVITY
from housefly.messages import (
    DroneFault,
    DroneStatus,
    Phase,
    PositionSetpoint,
    Reference,
    SafetyMode,
    VelocitySetpoint,
)
from housefly.pilot.behavior.braking import EVASION_SPEED
from housefly.pilot.behavior.mission import NO_SILENCE
from housefly.pilot.behavior.standing import STANDS_HIGH
from housefly.pilot.estimation.consistency import NOTHING_KNOWN, TrackingConsistency
from housefly.pilot.safety.control_source import (
    STEERED_LANDING_ERROR_MAX,
    STEERED_LANDING_TIME_MAX,
    ControlSource,
    source_for_landing,
)
from housefly.pilot.safety.drone_rules import (
    CHARGE_WARNING,
    CLIFF_CHARGE,
    HELD_TIME_MAX,
    LATE_HOLD,
    LATE_LAND,
    LATE_STEPS_MAX,
    ON_FLOOR_HEIGHT,
    STILL_SPEED,
    descent_time,
    lies_on_floor,
)
from housefly.pilot.safety.energy import GAUGE_STILL_TIME, NO_ENERGY, EnergyBudget
from housefly.pilot.safety.fallbacks import possible_mode
from housefly.pilot.safety.gate import Gate
from housefly.pilot.safety.inputs import GateInputs, Geofence
from housefly.pilot.safety.motion_rules import (
    CONTROL_ERROR_HOLD,
    CONTROL_ERROR_LAND,
    HEIGHT_ERROR_LAND,
    HEIGHT_ERROR_WARN,
    IMPACT_ACCELERATION,
    IMPACT_SPEED_CHANGE,
    SPEED_SLACK,
    STUCK_DISTANCE,
    STUCK_SPEED,
    STUCK_SPEED_ASKED,
    STUCK_TILT,
    TAKE_OVER_TIME,
    TILT_WRONG_MAX,
    UNEXPLAINED_SPEED_CHANGE,
    VELOCITY_ERROR_MAX,
    VERTICAL_SPEED_SLACK,
    height_error,
)
from housefly.pilot.safety.observer import (
    NOTHING_OBSERVED,
    TILT_ERROR_MAX,
    FlightObservations,
)
from housefly.pilot.safety.rule import IN_SCOPE, RuleContext, RuleScope
from housefly.pilot.safety.tracking_rules import (
    DRIFT_LAND,
    DRIFT_WARN,
    FRAME_ERROR_MAX,
    HEIGHT_DISAGREES,
    LATENCY_HOLD,
    LATENCY_SLOW,
    REFUSED_HOLD,
    REFUSED_LAND,
)
from housefly.pilot.safety.wind_rules import BLOWN_ABOUT, LANDING_DRIFT

ZERO = (0.0, 0.0, 0.0)
AT_ORIGIN = Reference(ZERO, ZERO, 0.0)
FLOWN = replace(NOTHING_OBSERVED, cruising_for=60.0, climbing_for=60.0)
PARTS = {field.name for field in fields(GateInputs)}
BUDGET = {field.name for field in fields(EnergyBudget)}
KNOWN = {field.name for field in fields(TrackingConsistency)}
LATE_LANDING = LIMITS.landing_timeout + 1.0
LATEST_LANDING = LIMITS.landing_timeout + descent_time(
    RuleContext(FINE, NOTHING_OBSERVED, LIMITS, FENCE, AIRFRAME)
)


def context(**changes: object) -> RuleContext:
    """A flight where all is well but these: of the step, of the charge, of tracking, or seen."""

    def of(names: set[str]) -> dict[str, object]:
        return {name: changes.pop(name) for name in tuple(changes) if name in names}

    now = replace(FINE, **of(PARTS))  # type: ignore[arg-type]
    if known := of(KNOWN):
        now = replace(now, consistency=TrackingConsistency(**known))  # type: ignore[arg-type]
    seen = replace(FLOWN, energy=replace(NO_ENERGY, **of(BUDGET)))  # type: ignore[arg-type]
    seen = replace(seen, **changes)  # type: ignore[arg-type]
    return RuleContext(now, seen, LIMITS, FENCE, AIRFRAME)


def placed(x: float = 0.0, z: float = 0.0, **changes: object) -> RuleContext:
    """So far from a reference at the origin, where differences are exact."""
    return context(position=(x, 0.0, z), reference=AT_ORIGIN, flight_height=0.0, **changes)


def landing(**changes: object) -> RuleContext:
    """A landing has been wanted for long."""
    return context(**{"landing_for": LATE_LANDING, "phase": Phase.LANDING, **changes})


def blown_off(z: float, **changes: object) -> RuleContext:
    """It takes off and is blown away, so high; tracking does not tell how fast."""
    report = replace(REPORT, height=z)
    status = DroneStatus.TAKING_OFF
    known = context(status=status, position=(5.0, 2.0, z), velocity=None, telemetry=report)
    blown = {"start": (5.0, 2.0), "take_off_velocity": (0.8, 0.0)}
    seen = replace(known.seen, **{**blown, **changes})  # type: ignore[arg-type]
    return replace(known, seen=seen)


STILL = replace(REPORT, velocity=ZERO, height=0.0)
ON_FLOOR = {"position": (5.0, 2.0, 0.0), "telemetry": STILL}

AT_BOUND: list[tuple[str, RuleContext, bool]] = [
    ("battery_low", context(battery=LIMITS.battery_floor), False),
    ("battery_cliff", context(charge_lost=CLIFF_CHARGE), False),
    ("flight_time_over", context(time_left=0.0), True),
    ("held_too_often", context(held_for=HELD_TIME_MAX), False),
    ("battery_return", context(battery=0.5, charge_needed=0.5), False),
    ("battery_weak", context(battery=0.5 + CHARGE_WARNING, charge_needed=0.5), False),
    ("flight_time", context(time_left=35.0, time_needed=35.0), False),
    ("battery_gauge", context(gauge_still_for=GAUGE_STILL_TIME), True),
    ("loop_slow", context(late_steps=LATE_STEPS_MAX), True),
    ("loop_slow", context(late_steps=LATE_STEPS_MAX - 1), False),
    ("loop_late", context(late=LATE_HOLD), False),
    ("loop_stalled", context(late=LATE_LAND), False),
    ("landing_refused", landing(landing_for=LIMITS.landing_timeout), False),
    ("landing_refused", landing(), True),
    ("landing_refused", landing(position=(5.0, 2.0, ON_FLOOR_HEIGHT)), True),
    ("motors_running", landing(**ON_FLOOR, velocity=(STILL_SPEED, 0.0, 0.0)), False),
    ("motors_running", landing(**ON_FLOOR, velocity=(0.5 * STILL_SPEED, 0.0, 0.0)), True),
    (
        "motors_running",
        landing(
            position=(5.0, 2.0, 0.0), telemetry=replace(STILL, velocity=(0.0, STILL_SPEED, 0.0))
        ),
        False,
    ),
    ("blown_about", context(velocity_error=BLOWN_ABOUT), False),
    (
        "landing_drift",
        landing(**ON_FLOOR, velocity=(LANDING_DRIFT, 0.0, 0.0)),
        False,
    ),
    ("tilt_error", context(tilt_error=TILT_ERROR_MAX), False),
    ("tilt_lost", context(tilt_wrong_for=TILT_WRONG_MAX), False),
    ("contact", context(velocity_change=IMPACT_SPEED_CHANGE), False),
    ("contact", context(velocity_change=3.0, unexplained_change=UNEXPLAINED_SPEED_CHANGE), False),
    (
        "contact",
        context(velocity_change=3.0, unexplained_change=UNEXPLAINED_SPEED_CHANGE + 0.01),
        True,
    ),
    ("stuck", context(tilt_asked=STUCK_TILT), False),
    ("stuck", context(tilt_asked=1.5 * STUCK_TILT), True),
    ("stuck", context(tilt_asked=1.5 * STUCK_TILT, velocity=(STUCK_SPEED, 0.0, 0.0)), False),
    ("stuck", context(tilt_asked=1.5 * STUCK_TILT, telemetry=None), True),
    ("stuck", context(flown=PositionSetpoint(HERE[0], HERE[1] + STUCK_DISTANCE, 1.1)), False),
    ("stuck", context(flown=PositionSetpoint(HERE[0], HERE[1] + 0.3, 1.1)), True),
    ("stuck", context(flown=PositionSetpoint(HERE[0], HERE[1], 2.1)), False),
    ("stuck", context(flown=VelocitySetpoint(0.0, -STUCK_SPEED_ASKED)), False),
    ("stuck", context(flown=VelocitySetpoint(0.3, -STUCK_SPEED_ASKED)), True),
    (
        "stuck",
        context(flown=VelocitySetpoint(1.0), velocity=(STUCK_SPEED, 0.0, 0.0)),
        False,
    ),
    ("stuck", context(tilt_asked=1.5 * STUCK_TILT, velocity=(0.0, 0.0, 0.5)), True),
    (
        "stuck",
        context(tilt_asked=1.5 * STUCK_TILT, telemetry=replace(REPORT, velocity=(0.0, 0.0, 0.5))),
        True,
    ),
    ("take_off_aborted", blown_off(0.05), True),
    ("take_off_aborted", blown_off(0.2), False),
    ("take_off_aborted", blown_off(0.0, start=None), False),
    ("take_off_aborted", blown_off(0.0, take_off_velocity=None), False),
    ("outside_fence", context(position=(10.0 + LIMITS.fence_margin, 2.0, 1.1)), False),
    ("too_high", context(position=(5.0, 2.0, FENCE.ceiling)), False),
    ("too_high", context(position=(5.0, 2.0, 2.5)), True),
    ("too_high", context(position=(5.0, 2.0, 2.5), pose_age=LIMITS.pose_age_level), True),
    ("too_low", context(position=(5.0, 2.0, LIMITS.height_min)), False),
    ("too_low", context(position=(5.0, 2.0, 0.27), flight_height=0.5), False),
    ("too_low", context(position=(5.0, 2.0, 0.24), flight_height=0.5), True),
    (
        "contact",
        context(telemetry=replace(REPORT, acceleration=(IMPACT_ACCELERATION + GRAVITY, 0.0, 0.0))),
        False,
    ),
    ("height_error", placed(z=HEIGHT_ERROR_LAND), False),
    ("height_not_reached", placed(z=HEIGHT_ERROR_WARN), False),
    ("height_off", placed(z=HEIGHT_ERROR_WARN), False),
    (
        "vertical_speed",
        context(velocity=(0.0, 0.0, LIMITS.vertical_speed_max + VERTICAL_SPEED_SLACK)),
        False,
    ),
    ("control_lost", placed(CONTROL_ERROR_LAND), False),
    ("control_error", placed(CONTROL_ERROR_HOLD), False),
    ("drifting", placed(velocity=(VELOCITY_ERROR_MAX, 0.0, 0.0)), False),
    ("drifting", placed(velocity=(0.5, 0.0, 0.0), cruising_for=TAKE_OVER_TIME), False),
    ("drifting", placed(velocity=(0.5, 0.0, 0.0)), True),
    ("too_fast", context(velocity=(EVASION_SPEED + SPEED_SLACK, 0.0, 0.0)), False),
    ("not_on_floor", placed(z=STANDS_HIGH, status=DroneStatus.LANDED), False),
    ("poses_refused", context(refused_for=REFUSED_HOLD), False),
    ("poses_refused_long", context(refused_for=REFUSED_LAND), False),
    ("tracking_drift", context(drift=DRIFT_LAND), False),
    ("tracking_drifting", context(drift=DRIFT_WARN), False),
    ("tracking_height_drift", context(height_drift=HEIGHT_DISAGREES), False),
    ("tracking_frame", context(frame_error=FRAME_ERROR_MAX), False),
    ("tracking_late", context(latency_error=LATENCY_HOLD), False),
    ("tracking_slow", context(latency_error=LATENCY_SLOW), False),
    ("tracking_height", context(height_error=-HEIGHT_DISAGREES), False),
    ("tracking_height_off", context(height_error=HEIGHT_DISAGREES), False),
]


def broken(code: str, seen: RuleContext) -> bool:
    """Whether a rule counts and is broken."""
    return IN_SCOPE[RULES[code].scope](seen) and RULES[code].is_broken(seen)


@pytest.mark.parametrize(("code", "seen", "is_broken"), AT_BOUND)
def test_a_bound_belongs_to_the_side_that_the_page_says(
    code: str, seen: RuleContext, is_broken: bool
) -> None:
    assert broken(code, seen) is is_broken


def test_who_lands_untracked_counts_as_up_by_its_sonar_and_until_a_descent_has_had_its_time() -> (
    None
):
    def untracked(height: float, landing_for: float) -> bool:
        report = replace(REPORT, height=height)
        return broken(
            "landing_refused",
            context(pose_age=inf, telemetry=report, landing_for=landing_for, phase=Phase.LANDING),
        )

    assert untracked(AIRFRAME.sonar.floor_reading_max, LATEST_LANDING + 60.0)
    assert not untracked(0.9 * AIRFRAME.sonar.floor_reading_max, LATEST_LANDING)
    assert untracked(0.9 * AIRFRAME.sonar.floor_reading_max, 0.999 * LATEST_LANDING)


def test_a_landing_counts_from_its_first_moment() -> None:
    assert not IN_SCOPE[RuleScope.LANDING](context(landing_for=0.0))
    assert IN_SCOPE[RuleScope.LANDING](context(landing_for=1e-9))


def test_the_floor_ends_where_a_drone_counts_as_up() -> None:
    assert not lies_on_floor(placed(z=ON_FLOOR_HEIGHT))
    assert lies_on_floor(placed(z=0.99 * ON_FLOOR_HEIGHT))


def test_a_height_counts_from_the_moment_at_which_it_should_be_reached() -> None:
    assert height_error(placed(z=1.0, climbing_for=6.0)) == 1.0
    assert height_error(placed(z=1.0, climbing_for=5.99)) == 0.0


def can_steer_landing(c: RuleContext) -> bool:
    return source_for_landing(c, steered=True) is ControlSource.TRACKING


def test_a_landing_is_steered_up_to_its_bounds() -> None:
    lowest = LIMITS.landing_height + 0.05
    assert can_steer_landing(context())
    assert not can_steer_landing(context(position=(*HERE[:2], lowest), reference=None))
    assert can_steer_landing(context(position=(*HERE[:2], lowest + 0.01), reference=None))
    assert not can_steer_landing(context(landing_for=STEERED_LANDING_TIME_MAX))
    assert not can_steer_landing(context(late_steps=1))
    above = Reference((0.0, 0.0, 1.0), ZERO, 0.0)
    assert not can_steer_landing(
        context(reference=above, position=(STEERED_LANDING_ERROR_MAX, 0.0, 1.0))
    )


def test_a_deaf_drone_that_has_sunk_for_long_enough_may_land_by_itself() -> None:
    deaf = replace(REPORT, faults=(DroneFault.ULTRASOUND_DEAF,))
    enough = descent_time(context())
    modes = [
        possible_mode(SafetyMode.LAND, context(telemetry=deaf, landing_for=t, pose_age=0.3))
        for t in (enough, enough + 0.01)
    ]
    assert modes == [SafetyMode.DESCEND, SafetyMode.LAND]


def test_nothing_observed_breaks_no_rule() -> None:
    seen = RuleContext(FINE, FlightObservations(), LIMITS, FENCE, AIRFRAME)
    assert not [code for code in RULES if broken(code, seen)]


def test_words_say_what_is_left_and_what_struck() -> None:
    clock = context(time_left=21.4, time_needed=35.0)
    assert RULES["flight_time"].words(clock).startswith("21 s of flight left")
    over = context(time_left=-3.0, time_needed=35.0)
    assert RULES["flight_time"].words(over).startswith("0 s of flight left")
    struck = replace(REPORT, acceleration=(IMPACT_ACCELERATION + GRAVITY, 0.0, 0.0))
    words = RULES["contact"].words(context(telemetry=struck, velocity_change=0.6))
    assert words.startswith("struck something, or tracking jumped: 0.6 m/s faster")
    low = landing(position=(5.0, 2.0, 0.04), velocity=(0.3, 0.0, 0.0))
    assert "only 0.04 m above the floor" in RULES["landing_drift"].words(low)
    sunk = landing(position=(5.0, 2.0, -0.04), velocity=(0.3, 0.0, 0.0))
    assert "only 0.00 m above the floor" in RULES["landing_drift"].words(sunk)


@pytest.mark.parametrize("axis", [0, 1])
@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_who_flies_towards_any_side_of_the_room_leaves_it_by_the_way_it_needs_to_rest(
    axis: int, side: float
) -> None:
    fence, speed = Geofence((-2.0, -2.0, 2.0, 2.0), 2.5), 1.0
    place, velocity = [0.0, 0.0], [0.0, 0.0]
    place[axis], velocity[axis] = 1.5 * side, speed * side
    way = AIRFRAME.braking.way_to_rest(speed)
    inside = fence.overshoot((*place, 1.0), (*velocity, 0.0), AIRFRAME.braking)  # type: ignore[arg-type]
    assert inside == pytest.approx(1.5 + way - 2.0)
    away = fence.overshoot((*place, 1.0), (*(-v for v in velocity), 0.0), AIRFRAME.braking)  # type: ignore[arg-type]
    assert away <= 0.0
    place[axis] = 3.0 * side  # outside already: only what comes on top
    beyond = fence.overshoot((*place, 1.0), (*velocity, 0.0), AIRFRAME.braking)  # type: ignore[arg-type]
    assert beyond == pytest.approx(way)


def test_who_rises_leaves_the_room_by_its_ceiling() -> None:
    fence = Geofence((-2.0, -2.0, 2.0, 2.0), 2.5)
    way = AIRFRAME.braking.way_to_rest(0.5)
    assert fence.overshoot((0.0, 0.0, 2.4), (0.0, 0.0, 0.5), AIRFRAME.braking) == pytest.approx(
        2.4 + way - 2.5
    )
    assert fence.overshoot((0.0, 0.0, 2.7), (0.0, 0.0, 0.5), AIRFRAME.braking) == pytest.approx(way)
    assert fence.overshoot((0.0, 0.0, 2.7), (0.0, 0.0, -0.5), AIRFRAME.braking) == 0.0
    assert fence.overshoot((0.0, 0.0, 2.4), (0.0, 0.0, -0.5), AIRFRAME.braking) == 0.0


def test_nothing_is_assumed_of_a_step_that_says_nothing() -> None:
    bare = GateInputs(0.0, DroneStatus.FLYING, 0.9, 0.0, 0.0, None, False, False)
    assert bare.home_time == bare.late == 0.0 and bare.has_way_home
    assert not bare.faults and bare.consistency == NOTHING_KNOWN and bare.silence == NO_SILENCE
    assert Gate(LIMITS, FENCE, AIRFRAME).standing_height == 0.0
