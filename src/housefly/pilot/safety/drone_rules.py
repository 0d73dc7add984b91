"""Rules of the safety gate about the drone itself: orders, its word, charge, clock, our loop."""

from __future__ import annotations

from math import hypot, inf

from housefly.messages.event_code import EventCode
from housefly.messages.sensing import DroneStatus
from housefly.messages.steering import Clearing, SafetyMode
from housefly.messages.words import UNSAID, Words, figure, joined, percentage
from housefly.pilot.behavior.drone_faults import LANDING_FAULTS, fault_list
from housefly.pilot.safety.energy import CLIFF_SPAN, GAUGE_STILL_TIME
from housefly.pilot.safety.limits import DESCENT_RATE, too_old
from housefly.pilot.safety.observer import HOLD_SPAN, LATE_SPAN
from housefly.pilot.safety.rule import RuleContext, RuleScope, SafetyRule
from housefly.pilot.safety.rule_words import (
    coming_home,
    holding_itself,
    landing,
    slowly,
    with_time_limit,
)

ON_FLOOR_HEIGHT = 0.1
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


def height_above_standing(c: RuleContext) -> float:
    """Return how far above where it stood the drone is [m]; infinite where that is unknown."""
    if c.inputs.position is None or too_old(c.inputs.pose_age, c.limits.pose_age_level):
        return inf
    return c.inputs.position[2] - c.seen.standing_height


def lies_on_floor(c: RuleContext) -> bool:
    """Return whether tracking sees the drone as low as it stood before."""
    return height_above_standing(c) < ON_FLOOR_HEIGHT


def _lies_still(c: RuleContext) -> bool:
    heard, velocity = c.inputs.telemetry, c.inputs.velocity
    if heard is None or velocity is None or too_old(c.inputs.telemetry_age, c.limits.telemetry_age):
        return False
    is_still = hypot(*velocity) < STILL_SPEED and hypot(*heard.velocity[:2]) < STILL_SPEED
    return is_still and lies_on_floor(c)


def _is_still_up(c: RuleContext) -> bool:
    """Return whether it is above the floor; without a fresh pose by its sonar, and by time."""
    if not too_old(c.inputs.pose_age, c.limits.pose_age_level):
        return not lies_on_floor(c)
    sonar, told = c.airframe.sonar, c.inputs.telemetry
    is_high = sonar is not None and told is not None and told.height >= sonar.floor_reading_max
    return is_high or c.seen.landing_for < c.limits.landing_timeout + descent_time(c)


def _complaints(c: RuleContext, *, ends_flight: bool) -> Words:
    if not c.inputs.faults:
        return UNSAID
    return fault_list(one for one in c.inputs.faults if (one in LANDING_FAULTS) is ends_flight)


DRONE_RULES: tuple[SafetyRule, ...] = (
    SafetyRule(
        code=EventCode.CUT,
        mode=SafetyMode.CUT,
        scope=RuleScope.ALWAYS,
        condition="someone ordered it",
        is_broken=lambda c: c.inputs.cutting,
        words=lambda _: Words("motors are being cut by order"),
        clears=Clearing.RESET,
    ),
    SafetyRule(
        code=EventCode.EMERGENCY,
        mode=SafetyMode.CUT,
        scope=RuleScope.ALWAYS,
        condition="the drone says so",
        is_broken=lambda c: c.inputs.status is DroneStatus.EMERGENCY,
        words=lambda _: Words("the motors are cut: reset when nobody is near"),
        clears=Clearing.RESET,
    ),
    SafetyRule(
        code=EventCode.MOTORS_RUNNING,
        mode=SafetyMode.CUT,
        scope=RuleScope.LANDING,
        condition="it lies still on the floor, told to land",
        is_broken=_lies_still,
        words=lambda _: Words(
            "on the floor for {n} s with its motors running: cutting them",
            n=figure(LYING_TIME, ".0f"),
        ),
        debounce=LYING_TIME,
        clears=Clearing.RESET,
    ),
    SafetyRule(
        code=EventCode.LANDING_REFUSED,
        mode=SafetyMode.DESCEND,
        scope=RuleScope.LANDING,
        condition="not on the floor so long after it was told to land",
        is_broken=lambda c: (
            c.seen.landing_for > c.limits.landing_timeout
            and not too_old(c.inputs.telemetry_age, c.limits.telemetry_age)
            and _is_still_up(c)
        ),
        words=lambda c: Words(
            "told to land for {n} s (limit {m} s) and still up: sinking by our own setpoint",
            n=figure(c.seen.landing_for, ".0f"),
            m=figure(c.limits.landing_timeout, ".0f"),
        ),
        clears=Clearing.GROUND,
    ),
    SafetyRule(
        code=EventCode.TELEMETRY_LOST,
        mode=SafetyMode.LAND,
        scope=RuleScope.AIRBORNE,
        condition="no word from the drone",
        is_broken=lambda c: too_old(c.inputs.telemetry_age, c.limits.telemetry_age),
        words=lambda c: landing(
            with_time_limit(
                Words("the drone is silent for {n} s", n=figure(c.inputs.telemetry_age, ".1f")),
                c.limits.telemetry_age,
            )
        ),
        clears=Clearing.GROUND,
        may_steer=True,
    ),
    SafetyRule(
        code=EventCode.DRONE_FAULT,
        mode=SafetyMode.LAND,
        scope=RuleScope.AIRBORNE,
        condition="a complaint of the drone that ends a flight",
        is_broken=lambda c: bool(_complaints(c, ends_flight=True)),
        words=lambda c: Words(
            "the drone says: {what}; landing", what=_complaints(c, ends_flight=True)
        ),
        clears=Clearing.GROUND,
        may_steer=True,
    ),
    SafetyRule(
        code=EventCode.NOT_CONFIGURED,
        mode=SafetyMode.LAND,
        scope=RuleScope.AIRBORNE,
        condition="its limits are not confirmed for so long",
        is_broken=lambda c: c.inputs.telemetry is not None and not c.inputs.telemetry.configured,
        words=lambda _: landing(
            Words(
                "the drone has not confirmed its limits for {n} s", n=figure(CONFIGURING_TIME, "g")
            )
        ),
        debounce=CONFIGURING_TIME,
        clears=Clearing.GROUND,
    ),
    SafetyRule(
        code=EventCode.BATTERY_LOW,
        mode=SafetyMode.LAND,
        scope=RuleScope.AIRBORNE,
        condition="charge below the floor, or not a number",
        is_broken=lambda c: not c.inputs.battery >= c.limits.battery_floor,
        words=lambda c: landing(
            Words(
                "battery {p}% is below {q}%",
                p=percentage(c.inputs.battery),
                q=percentage(c.limits.battery_floor),
            )
        ),
        debounce=BATTERY_DEBOUNCE,
        clears=Clearing.GROUND,
        may_steer=True,
    ),
    SafetyRule(
        code=EventCode.BATTERY_CLIFF,
        mode=SafetyMode.LAND,
        scope=RuleScope.AIRBORNE,
        condition="the charge falls all at once",
        is_broken=lambda c: c.seen.energy.charge_lost > CLIFF_CHARGE,
        words=lambda c: landing(
            Words(
                "the battery lost {p}% in {n} s (limit {q}%)",
                p=percentage(c.seen.energy.charge_lost),
                n=figure(CLIFF_SPAN, ".0f"),
                q=percentage(CLIFF_CHARGE),
            )
        ),
        debounce=0.4,
        clears=Clearing.GROUND,
        may_steer=True,
    ),
    SafetyRule(
        code=EventCode.FLIGHT_TIME_OVER,
        mode=SafetyMode.LAND,
        scope=RuleScope.AIRBORNE,
        condition="the charge at take-off is used up, by the clock",
        is_broken=lambda c: c.seen.energy.time_left <= 0.0,
        words=lambda c: landing(
            Words(
                "in the air for {n} s, as long as the charge at take-off allows"
                " (limits.flight_time {m} s)",
                n=figure(c.seen.energy.airborne_for, ".0f"),
                m=figure(c.limits.flight_time, ".0f"),
            )
        ),
        debounce=BATTERY_DEBOUNCE,
        clears=Clearing.GROUND,
        may_steer=True,
    ),
    SafetyRule(
        code=EventCode.LOOP_STALLED,
        mode=SafetyMode.LAND,
        scope=RuleScope.AIRBORNE,
        condition="the pilot ran far too late",
        is_broken=lambda c: too_old(c.inputs.late, LATE_LAND),
        words=lambda c: landing(
            with_time_limit(
                Words("the pilot ran {n} s late", n=figure(c.inputs.late, ".1f")), LATE_LAND
            )
        ),
        clears=Clearing.GROUND,
    ),
    SafetyRule(
        code=EventCode.HELD_TOO_OFTEN,
        mode=SafetyMode.LAND,
        scope=RuleScope.AIRBORNE,
        condition="held for too much of the last 10 s",
        is_broken=lambda c: c.seen.held_for > HELD_TIME_MAX,
        words=lambda c: landing(
            with_time_limit(
                Words(
                    "held for {n} of the last {m} s",
                    n=figure(c.seen.held_for, ".1f"),
                    m=figure(HOLD_SPAN, ".0f"),
                ),
                HELD_TIME_MAX,
            )
        ),
        clears=Clearing.GROUND,
        may_steer=True,
        may_wait=True,
    ),
    SafetyRule(
        code=EventCode.STOPPED,
        mode=SafetyMode.STOPPED,
        scope=RuleScope.ALWAYS,
        condition="STOP is latched",
        is_broken=lambda c: c.inputs.stopped,
        words=lambda _: Words("STOP: hovering until resumed"),
        clears=Clearing.RESUME,
        may_steer=True,
    ),
    SafetyRule(
        code=EventCode.BATTERY_RETURN,
        mode=SafetyMode.RETURN,
        scope=RuleScope.AIRBORNE,
        condition="charge for no more than the planner's way home, at the measured drain",
        is_broken=lambda c: c.inputs.battery < c.seen.energy.charge_needed,
        words=lambda c: coming_home(
            Words(
                "battery {p}%, the way home ({n} s) needs {q}%",
                p=percentage(c.inputs.battery),
                n=figure(c.inputs.home_time, ".0f"),
                q=percentage(c.seen.energy.charge_needed),
            )
        ),
        debounce=BATTERY_DEBOUNCE,
        clears=Clearing.ORDER,
    ),
    SafetyRule(
        code=EventCode.FLIGHT_TIME,
        mode=SafetyMode.RETURN,
        scope=RuleScope.AIRBORNE,
        condition="time for no more than the way home, by the clock",
        is_broken=lambda c: c.seen.energy.time_left < c.seen.energy.time_needed,
        words=lambda c: coming_home(
            Words(
                "{n} s of flight left by the clock, the way home needs {m} s",
                n=figure(max(0.0, c.seen.energy.time_left), ".0f"),
                m=figure(c.seen.energy.time_needed, ".0f"),
            )
        ),
        debounce=BATTERY_DEBOUNCE,
        clears=Clearing.ORDER,
    ),
    SafetyRule(
        code=EventCode.CONFIGURING,
        mode=SafetyMode.HOLD,
        scope=RuleScope.AIRBORNE,
        condition="its limits are not confirmed",
        is_broken=lambda c: c.inputs.telemetry is not None and not c.inputs.telemetry.configured,
        words=lambda _: Words(
            "{why}: it holds itself", why=Words("the drone has not confirmed its limits")
        ),
    ),
    SafetyRule(
        code=EventCode.COMMANDS_UNHEARD,
        mode=SafetyMode.HOLD,
        scope=RuleScope.AIRBORNE,
        condition="the drone hears no commands, by its own word",
        is_broken=lambda c: c.inputs.telemetry is not None and not c.inputs.telemetry.hears_us,
        words=lambda _: Words(
            "{why}: it holds itself",
            why=with_time_limit(Words("commands reach the drone late or not at all"), COMMANDS_GAP),
        ),
        debounce=COMMANDS_GAP,
        lasts=COMMANDS_LATE_FOR,
    ),
    SafetyRule(
        code=EventCode.LOOP_LATE,
        mode=SafetyMode.HOLD,
        scope=RuleScope.AIRBORNE,
        condition="the pilot ran too late",
        is_broken=lambda c: too_old(c.inputs.late, LATE_HOLD),
        words=lambda _: holding_itself(
            Words("the pilot runs more than {n} s late", n=figure(LATE_HOLD, "g"))
        ),
        lasts=1.0,
    ),
    SafetyRule(
        code=EventCode.LOOP_SLOW,
        mode=SafetyMode.SLOW,
        scope=RuleScope.AIRBORNE,
        condition="the pilot often runs late",
        is_broken=lambda c: c.seen.late_steps >= LATE_STEPS_MAX,
        words=lambda c: slowly(
            Words(
                "the pilot is often late ({k} times within {n} s)",
                k=figure(LATE_STEPS_MAX),
                n=figure(LATE_SPAN, "g"),
            )
        ),
        lasts=2.0,
    ),
    SafetyRule(
        code=EventCode.PEOPLE_UNSEEN,
        mode=SafetyMode.SLOW,
        scope=RuleScope.AIRBORNE,
        condition="a sensor that looks for people is silent",
        is_broken=lambda c: c.inputs.silence.is_too_long,
        words=lambda c: slowly(
            with_time_limit(c.inputs.silence.consequence, c.inputs.silence.limit)
        ),
    ),
    SafetyRule(
        code=EventCode.DRONE_COMPLAINS,
        mode=SafetyMode.WARN,
        scope=RuleScope.ALWAYS,
        condition="any other complaint of the drone",
        is_broken=lambda c: bool(_complaints(c, ends_flight=False)),
        words=lambda c: Words("the drone says: {what}", what=_complaints(c, ends_flight=False)),
    ),
    SafetyRule(
        code=EventCode.DRONE_SETTINGS,
        mode=SafetyMode.WARN,
        scope=RuleScope.ALWAYS,
        condition="settings or sensors not as they should be",
        is_broken=lambda c: c.inputs.telemetry is not None and bool(c.inputs.telemetry.notes),
        words=lambda c: joined("; ", c.inputs.telemetry.notes if c.inputs.telemetry else ()),
    ),
    SafetyRule(
        code=EventCode.BATTERY_WEAK,
        mode=SafetyMode.WARN,
        scope=RuleScope.AIRBORNE,
        condition="charge soon for no more than the way home",
        is_broken=lambda c: c.inputs.battery < c.seen.energy.charge_needed + CHARGE_WARNING,
        words=lambda c: Words(
            "battery {p}%: it turns home at {q}%",
            p=percentage(c.inputs.battery),
            q=percentage(c.seen.energy.charge_needed),
        ),
        debounce=BATTERY_DEBOUNCE,
    ),
    SafetyRule(
        code=EventCode.BATTERY_GAUGE,
        mode=SafetyMode.WARN,
        scope=RuleScope.AIRBORNE,
        condition="the charge has not changed for so long",
        is_broken=lambda c: c.seen.energy.gauge_still_for >= GAUGE_STILL_TIME,
        words=lambda c: Words(
            "the battery has shown {p}% for {n} s (limit {m} s): flying by the clock, {k} s left",
            p=percentage(c.inputs.battery),
            n=figure(c.seen.energy.gauge_still_for, ".0f"),
            m=figure(GAUGE_STILL_TIME, ".0f"),
            k=figure(c.seen.energy.time_left, ".0f"),
        ),
    ),
)
