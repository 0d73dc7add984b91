"""Rules of the last gate about the drone itself: orders, its own word, charge, clock, our loop."""

from __future__ import annotations

from math import hypot, inf

from housefly.messages.sensing import DroneStatus
from housefly.messages.steering import Clearing, SafetyMode
from housefly.pilot.behavior.drone_faults import LANDING_FAULTS, fault_list
from housefly.pilot.safety.energy import CLIFF_SPAN, GAUGE_STILL_TIME
from housefly.pilot.safety.limits import DESCENT_RATE, too_old
from housefly.pilot.safety.observer import HOLD_SPAN, LATE_SPAN
from housefly.pilot.safety.rule import Counting, RuleContext, SafetyRule

M, N = SafetyMode, Counting

LOW_HEIGHT = 0.1
"""A drone is on the floor when no higher than this above where it stood [m] ..."""
STILL_SPEED = 0.1
"""... and lies still when slower than this, by tracking and by its own word [m/s]."""
DESCENT_MARGIN = 3.0
"""A descent takes no longer than from the ceiling at ``DESCENT_RATE``, and so much more [s]."""
LYING_TIME = 4.0
"""A drone that lies still on the floor this long, told to land, has its motors cut [s]."""
CONFIGURING_TIME = 5.0
"""A drone in the air whose limits are not confirmed after this is landed [s]."""
BATTERY_DEBOUNCE = 1.0
"""The battery must be below the floor for this long [s]: the voltage dips when the motors pull."""
CLIFF_CHARGE = 0.15
"""A charge that falls by more than this within ``CLIFF_SPAN`` falls off a cliff."""
CHARGE_WARNING = 0.05
"""People are told when the charge is this near to that for the way home."""
LATE_HOLD, LATE_LAND = 0.25, 1.0
"""A step is late by this: hold, land [s]."""
COMMANDS_GAP = 0.3
"""A drone that hears no commands for longer than this is held [s] ..."""
COMMANDS_LATE_FOR = 1.0
"""... and for so long after it hears them again: what was sent before may come late [s]."""
LATE_STEPS_MAX = 3
"""So many late steps within ``LATE_SPAN`` slow the drone down."""
HELD_TIME_MAX = 3.5
"""A drone that was held for longer than this within ``HOLD_SPAN`` is landed [s]."""


def descent_time(c: RuleContext) -> float:
    """Return how long a descent from wherever the drone may be takes at most [s]."""
    return c.fence.ceiling / DESCENT_RATE + DESCENT_MARGIN


def rise(c: RuleContext) -> float:
    """Return how far above where it stood the drone is [m]; infinite where that is unknown."""
    if c.now.position is None or too_old(c.now.pose_age, c.limits.pose_age_level):
        return inf
    return c.now.position[2] - c.seen.standing_height


def lies_on_floor(c: RuleContext) -> bool:
    """Return whether tracking sees the drone as low as it stood before."""
    return rise(c) < LOW_HEIGHT


def _lies_still(c: RuleContext) -> bool:
    heard, velocity = c.now.telemetry, c.now.velocity
    if heard is None or velocity is None or too_old(c.now.telemetry_age, c.limits.telemetry_age):
        return False
    is_still = hypot(*velocity) < STILL_SPEED and hypot(*heard.velocity[:2]) < STILL_SPEED
    return is_still and lies_on_floor(c)


def _is_still_up(c: RuleContext) -> bool:
    """Return whether it is above the floor; without a fresh pose by its sonar, and by time."""
    if not too_old(c.now.pose_age, c.limits.pose_age_level):
        return not lies_on_floor(c)
    low = c.airframe.sonar.floor_reading_max
    is_high = c.now.telemetry is not None and c.now.telemetry.height >= low
    return is_high or c.seen.landing_for < c.limits.landing_timeout + descent_time(c)


def _complaints(c: RuleContext, *, ends_flight: bool) -> str:
    return fault_list(one for one in c.now.faults if (one in LANDING_FAULTS) is ends_flight)


DRONE_RULES: tuple[SafetyRule, ...] = (
    SafetyRule(
        code="cut",
        mode=M.CUT,
        counts=N.ALWAYS,
        condition="someone ordered it",
        broken=lambda c: c.now.cutting,
        words=lambda _: "motors are being cut by order",
        clears=Clearing.RESET,
    ),
    SafetyRule(
        code="emergency",
        mode=M.CUT,
        counts=N.ALWAYS,
        condition="the drone says so",
        broken=lambda c: c.now.status is DroneStatus.EMERGENCY,
        words=lambda _: "the motors are cut: reset when nobody is near",
        clears=Clearing.RESET,
    ),
    SafetyRule(
        code="motors_running",
        mode=M.CUT,
        counts=N.LANDING,
        condition="it lies still on the floor, told to land",
        broken=_lies_still,
        words=lambda _: (
            f"on the floor for {LYING_TIME:.0f} s with its motors running: cutting them"
        ),
        after=LYING_TIME,
        clears=Clearing.RESET,
    ),
    SafetyRule(
        code="landing_refused",
        mode=M.DESCEND,
        counts=N.LANDING,
        condition="not on the floor so long after it was told to land",
        broken=lambda c: (
            c.seen.landing_for > c.limits.landing_timeout
            and not too_old(c.now.telemetry_age, c.limits.telemetry_age)
            and _is_still_up(c)
        ),
        words=lambda c: (
            f"told to land for {c.seen.landing_for:.0f} s (limit"
            f" {c.limits.landing_timeout:.0f} s) and still up: sinking by our own setpoint"
        ),
        clears=Clearing.GROUND,
    ),
    SafetyRule(
        code="telemetry_lost",
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="no word from the drone",
        broken=lambda c: too_old(c.now.telemetry_age, c.limits.telemetry_age),
        words=lambda c: (
            f"the drone is silent for {c.now.telemetry_age:.1f} s"
            f" (limit {c.limits.telemetry_age:g} s): landing"
        ),
        clears=Clearing.GROUND,
        steered=True,
    ),
    SafetyRule(
        code="drone_fault",
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="a complaint of the drone that ends a flight",
        broken=lambda c: bool(_complaints(c, ends_flight=True)),
        words=lambda c: f"the drone says: {_complaints(c, ends_flight=True)}; landing",
        clears=Clearing.GROUND,
        steered=True,
    ),
    SafetyRule(
        code="not_configured",
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="its limits are not confirmed for so long",
        broken=lambda c: c.now.telemetry is not None and not c.now.telemetry.configured,
        words=lambda _: (
            f"the drone has not confirmed its limits for {CONFIGURING_TIME:g} s: landing"
        ),
        after=CONFIGURING_TIME,
        clears=Clearing.GROUND,
    ),
    SafetyRule(
        code="battery_low",
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="charge below the floor, or not a number",
        broken=lambda c: not c.now.battery >= c.limits.battery_floor,
        words=lambda c: (
            f"battery {c.now.battery:.0%} is below {c.limits.battery_floor:.0%}: landing"
        ),
        after=BATTERY_DEBOUNCE,
        clears=Clearing.GROUND,
        steered=True,
    ),
    SafetyRule(
        code="battery_cliff",
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="the charge falls all at once",
        broken=lambda c: c.seen.energy.charge_lost > CLIFF_CHARGE,
        words=lambda c: (
            f"the battery lost {c.seen.energy.charge_lost:.0%} in {CLIFF_SPAN:.0f} s"
            f" (limit {CLIFF_CHARGE:.0%}): landing"
        ),
        after=0.4,
        clears=Clearing.GROUND,
        steered=True,
    ),
    SafetyRule(
        code="flight_time_over",
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="the charge at take-off is used up, by the clock",
        broken=lambda c: c.seen.energy.time_left <= 0.0,
        words=lambda c: (
            f"in the air for {c.seen.energy.airborne_for:.0f} s, as long as the charge at take-off"
            f" allows (limits.flight_time {c.limits.flight_time:.0f} s): landing"
        ),
        after=BATTERY_DEBOUNCE,
        clears=Clearing.GROUND,
        steered=True,
    ),
    SafetyRule(
        code="loop_stalled",
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="the pilot ran far too late",
        broken=lambda c: too_old(c.now.late, LATE_LAND),
        words=lambda c: f"the pilot ran {c.now.late:.1f} s late (limit {LATE_LAND:g} s): landing",
        clears=Clearing.GROUND,
    ),
    SafetyRule(
        code="held_too_often",
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="held for too much of the last 10 s",
        broken=lambda c: c.seen.held_for > HELD_TIME_MAX,
        words=lambda c: (
            f"held for {c.seen.held_for:.1f} of the last {HOLD_SPAN:.0f} s"
            f" (limit {HELD_TIME_MAX:g} s): landing"
        ),
        clears=Clearing.GROUND,
        steered=True,
        waits=True,
    ),
    SafetyRule(
        code="stopped",
        mode=M.STOPPED,
        counts=N.ALWAYS,
        condition="STOP is latched",
        broken=lambda c: c.now.stopped,
        words=lambda _: "STOP: hovering until resumed",
        clears=Clearing.RESUME,
        steered=True,
    ),
    SafetyRule(
        code="battery_return",
        mode=M.RETURN,
        counts=N.AIRBORNE,
        condition="charge for no more than the planner's way home, at the measured drain",
        broken=lambda c: c.now.battery < c.seen.energy.charge_needed,
        words=lambda c: (
            f"battery {c.now.battery:.0%}, the way home ({c.now.home_time:.0f} s) needs"
            f" {c.seen.energy.charge_needed:.0%}: coming home"
        ),
        after=BATTERY_DEBOUNCE,
        clears=Clearing.ORDER,
    ),
    SafetyRule(
        code="flight_time",
        mode=M.RETURN,
        counts=N.AIRBORNE,
        condition="time for no more than the way home, by the clock",
        broken=lambda c: c.seen.energy.time_left < c.seen.energy.time_needed,
        words=lambda c: (
            f"{max(0.0, c.seen.energy.time_left):.0f} s of flight left by the clock, the way home"
            f" needs {c.seen.energy.time_needed:.0f} s: coming home"
        ),
        after=BATTERY_DEBOUNCE,
        clears=Clearing.ORDER,
    ),
    SafetyRule(
        code="configuring",
        mode=M.HOLD,
        counts=N.AIRBORNE,
        condition="its limits are not confirmed",
        broken=lambda c: c.now.telemetry is not None and not c.now.telemetry.configured,
        words=lambda _: "the drone has not confirmed its limits: it holds itself",
    ),
    SafetyRule(
        code="commands_unheard",
        mode=M.HOLD,
        counts=N.AIRBORNE,
        condition="the drone hears no commands, by its own word",
        broken=lambda c: c.now.telemetry is not None and not c.now.telemetry.hears_us,
        words=lambda _: (
            f"commands reach the drone late or not at all (limit {COMMANDS_GAP:g} s):"
            " it holds itself"
        ),
        after=COMMANDS_GAP,
        lasts=COMMANDS_LATE_FOR,
    ),
    SafetyRule(
        code="loop_late",
        mode=M.HOLD,
        counts=N.AIRBORNE,
        condition="the pilot ran too late",
        broken=lambda c: too_old(c.now.late, LATE_HOLD),
        words=lambda _: f"the pilot runs more than {LATE_HOLD:g} s late: the drone holds itself",
        lasts=1.0,
    ),
    SafetyRule(
        code="loop_slow",
        mode=M.SLOW,
        counts=N.AIRBORNE,
        condition="the pilot often runs late",
        broken=lambda c: c.seen.late_steps >= LATE_STEPS_MAX,
        words=lambda c: (
            f"the pilot is often late ({LATE_STEPS_MAX} times within {LATE_SPAN:g} s): slowly"
        ),
        lasts=2.0,
    ),
    SafetyRule(
        code="people_unseen",
        mode=M.SLOW,
        counts=N.AIRBORNE,
        condition="a sensor that looks for people is silent",
        broken=lambda c: c.now.silence.is_too_long,
        words=lambda c: (
            f"people may be unseen: a sensor that looks for them {c.now.silence.predicate}"
            f" (limit {c.now.silence.limit:g} s): slowly"
        ),
    ),
    SafetyRule(
        code="drone_complains",
        mode=M.WARN,
        counts=N.ALWAYS,
        condition="any other complaint of the drone",
        broken=lambda c: bool(_complaints(c, ends_flight=False)),
        words=lambda c: f"the drone says: {_complaints(c, ends_flight=False)}",
    ),
    SafetyRule(
        code="drone_settings",
        mode=M.WARN,
        counts=N.ALWAYS,
        condition="settings or sensors not as they should be",
        broken=lambda c: c.now.telemetry is not None and bool(c.now.telemetry.notes),
        words=lambda c: "; ".join(c.now.telemetry.notes if c.now.telemetry else ()),
    ),
    SafetyRule(
        code="battery_weak",
        mode=M.WARN,
        counts=N.AIRBORNE,
        condition="charge soon for no more than the way home",
        broken=lambda c: c.now.battery < c.seen.energy.charge_needed + CHARGE_WARNING,
        words=lambda c: (
            f"battery {c.now.battery:.0%}: it turns home at {c.seen.energy.charge_needed:.0%}"
        ),
        after=BATTERY_DEBOUNCE,
    ),
    SafetyRule(
        code="battery_gauge",
        mode=M.WARN,
        counts=N.AIRBORNE,
        condition="the charge has not changed for so long",
        broken=lambda c: c.seen.energy.gauge_still_for >= GAUGE_STILL_TIME,
        words=lambda c: (
            f"the battery has shown {c.now.battery:.0%} for {c.seen.energy.gauge_still_for:.0f} s"
            f" (limit {GAUGE_STILL_TIME:.0f} s): flying by the clock,"
            f" {c.seen.energy.time_left:.0f} s left"
        ),
    ),
)
