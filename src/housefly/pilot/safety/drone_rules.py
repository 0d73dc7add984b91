"""Rules of the last gate about the drone itself: orders, its own word, charge, clock, our loop."""

from __future__ import annotations

from math import hypot, inf

from housefly.messages.event_code import EventCode
from housefly.messages.sensing import DroneStatus
from housefly.messages.steering import Clearing, SafetyMode
from housefly.messages.words import Words, figure, joined, percentage
from housefly.pilot.behavior.drone_faults import LANDING_FAULTS, fault_list
from housefly.pilot.safety.energy import CLIFF_SPAN, GAUGE_STILL_TIME
from housefly.pilot.safety.limits import DESCENT_RATE, too_old
from housefly.pilot.safety.observer import HOLD_SPAN, LATE_SPAN
from housefly.pilot.safety.rule import Counting, RuleContext, SafetyRule
from housefly.pilot.safety.rule_words import (
    above_time,
    coming_home,
    holding_itself,
    landing,
    slowly,
)

C, M, N = EventCode, SafetyMode, Counting

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
    sonar, told = c.airframe.sonar, c.now.telemetry
    is_high = sonar is not None and told is not None and told.height >= sonar.floor_reading_max
    return is_high or c.seen.landing_for < c.limits.landing_timeout + descent_time(c)


def _complaints(c: RuleContext, *, ends_flight: bool) -> Words:
    return fault_list(one for one in c.now.faults if (one in LANDING_FAULTS) is ends_flight)


DRONE_RULES: tuple[SafetyRule, ...] = (
    SafetyRule(
        code=C.CUT,
        mode=M.CUT,
        counts=N.ALWAYS,
        condition="someone ordered it",
        broken=lambda c: c.now.cutting,
        words=lambda _: Words("motors are being cut by order"),
        clears=Clearing.RESET,
    ),
    SafetyRule(
        code=C.EMERGENCY,
        mode=M.CUT,
        counts=N.ALWAYS,
        condition="the drone says so",
        broken=lambda c: c.now.status is DroneStatus.EMERGENCY,
        words=lambda _: Words("the motors are cut: reset when nobody is near"),
        clears=Clearing.RESET,
    ),
    SafetyRule(
        code=C.MOTORS_RUNNING,
        mode=M.CUT,
        counts=N.LANDING,
        condition="it lies still on the floor, told to land",
        broken=_lies_still,
        words=lambda _: Words(
            "on the floor for {n} s with its motors running: cutting them",
            n=figure(LYING_TIME, ".0f"),
        ),
        after=LYING_TIME,
        clears=Clearing.RESET,
    ),
    SafetyRule(
        code=C.LANDING_REFUSED,
        mode=M.DESCEND,
        counts=N.LANDING,
        condition="not on the floor so long after it was told to land",
        broken=lambda c: (
            c.seen.landing_for > c.limits.landing_timeout
            and not too_old(c.now.telemetry_age, c.limits.telemetry_age)
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
        code=C.TELEMETRY_LOST,
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="no word from the drone",
        broken=lambda c: too_old(c.now.telemetry_age, c.limits.telemetry_age),
        words=lambda c: landing(
            above_time(
                Words("the drone is silent for {n} s", n=figure(c.now.telemetry_age, ".1f")),
                c.limits.telemetry_age,
            )
        ),
        clears=Clearing.GROUND,
        steered=True,
    ),
    SafetyRule(
        code=C.DRONE_FAULT,
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="a complaint of the drone that ends a flight",
        broken=lambda c: bool(_complaints(c, ends_flight=True)),
        words=lambda c: Words(
            "the drone says: {what}; landing", what=_complaints(c, ends_flight=True)
        ),
        clears=Clearing.GROUND,
        steered=True,
    ),
    SafetyRule(
        code=C.NOT_CONFIGURED,
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="its limits are not confirmed for so long",
        broken=lambda c: c.now.telemetry is not None and not c.now.telemetry.configured,
        words=lambda _: landing(
            Words(
                "the drone has not confirmed its limits for {n} s", n=figure(CONFIGURING_TIME, "g")
            )
        ),
        after=CONFIGURING_TIME,
        clears=Clearing.GROUND,
    ),
    SafetyRule(
        code=C.BATTERY_LOW,
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="charge below the floor, or not a number",
        broken=lambda c: not c.now.battery >= c.limits.battery_floor,
        words=lambda c: landing(
            Words(
                "battery {p}% is below {q}%",
                p=percentage(c.now.battery),
                q=percentage(c.limits.battery_floor),
            )
        ),
        after=BATTERY_DEBOUNCE,
        clears=Clearing.GROUND,
        steered=True,
    ),
    SafetyRule(
        code=C.BATTERY_CLIFF,
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="the charge falls all at once",
        broken=lambda c: c.seen.energy.charge_lost > CLIFF_CHARGE,
        words=lambda c: landing(
            Words(
                "the battery lost {p}% in {n} s (limit {q}%)",
                p=percentage(c.seen.energy.charge_lost),
                n=figure(CLIFF_SPAN, ".0f"),
                q=percentage(CLIFF_CHARGE),
            )
        ),
        after=0.4,
        clears=Clearing.GROUND,
        steered=True,
    ),
    SafetyRule(
        code=C.FLIGHT_TIME_OVER,
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="the charge at take-off is used up, by the clock",
        broken=lambda c: c.seen.energy.time_left <= 0.0,
        words=lambda c: landing(
            Words(
                "in the air for {n} s, as long as the charge at take-off allows"
                " (limits.flight_time {m} s)",
                n=figure(c.seen.energy.airborne_for, ".0f"),
                m=figure(c.limits.flight_time, ".0f"),
            )
        ),
        after=BATTERY_DEBOUNCE,
        clears=Clearing.GROUND,
        steered=True,
    ),
    SafetyRule(
        code=C.LOOP_STALLED,
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="the pilot ran far too late",
        broken=lambda c: too_old(c.now.late, LATE_LAND),
        words=lambda c: landing(
            above_time(Words("the pilot ran {n} s late", n=figure(c.now.late, ".1f")), LATE_LAND)
        ),
        clears=Clearing.GROUND,
    ),
    SafetyRule(
        code=C.HELD_TOO_OFTEN,
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="held for too much of the last 10 s",
        broken=lambda c: c.seen.held_for > HELD_TIME_MAX,
        words=lambda c: landing(
            above_time(
                Words(
                    "held for {n} of the last {m} s",
                    n=figure(c.seen.held_for, ".1f"),
                    m=figure(HOLD_SPAN, ".0f"),
                ),
                HELD_TIME_MAX,
            )
        ),
        clears=Clearing.GROUND,
        steered=True,
        waits=True,
    ),
    SafetyRule(
        code=C.STOPPED,
        mode=M.STOPPED,
        counts=N.ALWAYS,
        condition="STOP is latched",
        broken=lambda c: c.now.stopped,
        words=lambda _: Words("STOP: hovering until resumed"),
        clears=Clearing.RESUME,
        steered=True,
    ),
    SafetyRule(
        code=C.BATTERY_RETURN,
        mode=M.RETURN,
        counts=N.AIRBORNE,
        condition="charge for no more than the planner's way home, at the measured drain",
        broken=lambda c: c.now.battery < c.seen.energy.charge_needed,
        words=lambda c: coming_home(
            Words(
                "battery {p}%, the way home ({n} s) needs {q}%",
                p=percentage(c.now.battery),
                n=figure(c.now.home_time, ".0f"),
                q=percentage(c.seen.energy.charge_needed),
            )
        ),
        after=BATTERY_DEBOUNCE,
        clears=Clearing.ORDER,
    ),
    SafetyRule(
        code=C.FLIGHT_TIME,
        mode=M.RETURN,
        counts=N.AIRBORNE,
        condition="time for no more than the way home, by the clock",
        broken=lambda c: c.seen.energy.time_left < c.seen.energy.time_needed,
        words=lambda c: coming_home(
            Words(
                "{n} s of flight left by the clock, the way home needs {m} s",
                n=figure(max(0.0, c.seen.energy.time_left), ".0f"),
                m=figure(c.seen.energy.time_needed, ".0f"),
            )
        ),
        after=BATTERY_DEBOUNCE,
        clears=Clearing.ORDER,
    ),
    SafetyRule(
        code=C.CONFIGURING,
        mode=M.HOLD,
        counts=N.AIRBORNE,
        condition="its limits are not confirmed",
        broken=lambda c: c.now.telemetry is not None and not c.now.telemetry.configured,
        words=lambda _: Words(
            "{why}: it holds itself", why=Words("the drone has not confirmed its limits")
        ),
    ),
    SafetyRule(
        code=C.COMMANDS_UNHEARD,
        mode=M.HOLD,
        counts=N.AIRBORNE,
        condition="the drone hears no commands, by its own word",
        broken=lambda c: c.now.telemetry is not None and not c.now.telemetry.hears_us,
        words=lambda _: Words(
            "{why}: it holds itself",
            why=above_time(Words("commands reach the drone late or not at all"), COMMANDS_GAP),
        ),
        after=COMMANDS_GAP,
        lasts=COMMANDS_LATE_FOR,
    ),
    SafetyRule(
        code=C.LOOP_LATE,
        mode=M.HOLD,
        counts=N.AIRBORNE,
        condition="the pilot ran too late",
        broken=lambda c: too_old(c.now.late, LATE_HOLD),
        words=lambda _: holding_itself(
            Words("the pilot runs more than {n} s late", n=figure(LATE_HOLD, "g"))
        ),
        lasts=1.0,
    ),
    SafetyRule(
        code=C.LOOP_SLOW,
        mode=M.SLOW,
        counts=N.AIRBORNE,
        condition="the pilot often runs late",
        broken=lambda c: c.seen.late_steps >= LATE_STEPS_MAX,
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
        code=C.PEOPLE_UNSEEN,
        mode=M.SLOW,
        counts=N.AIRBORNE,
        condition="a sensor that looks for people is silent",
        broken=lambda c: c.now.silence.is_too_long,
        words=lambda c: slowly(above_time(c.now.silence.consequence, c.now.silence.limit)),
    ),
    SafetyRule(
        code=C.DRONE_COMPLAINS,
        mode=M.WARN,
        counts=N.ALWAYS,
        condition="any other complaint of the drone",
        broken=lambda c: bool(_complaints(c, ends_flight=False)),
        words=lambda c: Words("the drone says: {what}", what=_complaints(c, ends_flight=False)),
    ),
    SafetyRule(
        code=C.DRONE_SETTINGS,
        mode=M.WARN,
        counts=N.ALWAYS,
        condition="settings or sensors not as they should be",
        broken=lambda c: c.now.telemetry is not None and bool(c.now.telemetry.notes),
        words=lambda c: joined("; ", c.now.telemetry.notes if c.now.telemetry else ()),
    ),
    SafetyRule(
        code=C.BATTERY_WEAK,
        mode=M.WARN,
        counts=N.AIRBORNE,
        condition="charge soon for no more than the way home",
        broken=lambda c: c.now.battery < c.seen.energy.charge_needed + CHARGE_WARNING,
        words=lambda c: Words(
            "battery {p}%: it turns home at {q}%",
            p=percentage(c.now.battery),
            q=percentage(c.seen.energy.charge_needed),
        ),
        after=BATTERY_DEBOUNCE,
    ),
    SafetyRule(
        code=C.BATTERY_GAUGE,
        mode=M.WARN,
        counts=N.AIRBORNE,
        condition="the charge has not changed for so long",
        broken=lambda c: c.seen.energy.gauge_still_for >= GAUGE_STILL_TIME,
        words=lambda c: Words(
            "the battery has shown {p}% for {n} s (limit {m} s): flying by the clock, {k} s left",
            p=percentage(c.now.battery),
            n=figure(c.seen.energy.gauge_still_for, ".0f"),
            m=figure(GAUGE_STILL_TIME, ".0f"),
            k=figure(c.seen.energy.time_left, ".0f"),
        ),
    ),
)
