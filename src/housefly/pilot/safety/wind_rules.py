"""Rules of the safety gate about wind: a take-off that is blown away, a flight that is blown about.

A take-off cannot be steered, and a landing near the floor drifts on for seconds: what counts is
where the drone would stand if it landed now, not where it is.
"""

from __future__ import annotations

from math import dist, inf, sqrt

from housefly.geometry import GRAVITY
from housefly.messages.event_code import EventCode
from housefly.messages.sensing import DroneStatus
from housefly.messages.steering import Clearing, SafetyMode
from housefly.messages.words import Words, figure
from housefly.pilot.safety.drone_rules import height_above_standing
from housefly.pilot.safety.motion_rules import level_speed
from housefly.pilot.safety.observer import VELOCITY_ERROR_TIME_CONSTANT
from housefly.pilot.safety.rule import RuleContext, RuleScope, SafetyRule
from housefly.pilot.safety.rule_words import landing, with_length_limit, with_speed_limit

TAKE_OFF_DRIFT = 0.3
"""Who takes off and would stand farther aside than this if it landed now is blown away [m]."""
HARMLESS_FALL = 1.3
"""Who is blown away where a fall ends no faster than this is stopped at once, because a landing
drifts on for 2 s [m/s] ...
"""
LANDING_DRIFT = 0.25
"""... and so is who lands and is blown along faster than this [m/s]."""
BLOWN_ABOUT = 0.15
"""A velocity error above this for seconds (rms) is wind; still air leaves 0.03 [m/s]."""


def _own_height(c: RuleContext) -> float:
    """Return how high the drone says it is [m]; infinite where it says nothing."""
    is_told = c.inputs.telemetry is not None and c.airframe.sonar is not None
    return c.inputs.telemetry.height if c.inputs.telemetry and is_told else inf


def _touchdown_offset(c: RuleContext) -> float:
    """Return how far from where it took off a drone that landed now would stand [m].

    0 where that is unknown, and where climbing on until it can be steered is the shorter way.
    """
    start, position, velocity = c.seen.start, c.inputs.position, c.seen.take_off_velocity
    if start is None or position is None or velocity is None:
        return 0.0
    climb, turn = c.airframe.take_off, c.airframe.landing
    landing = turn.turn_time + (height_above_standing(c) + turn.turn_rise) / turn.turn_sink_rate
    if landing > (climb.steerable_height_min - position[2]) / climb.climb_rate_min:
        return 0.0
    rest = (p + landing * v for p, v in zip(position[:2], velocity, strict=True))
    return dist(tuple(rest), start)


def _is_just_above_floor(c: RuleContext) -> bool:
    """Return whether a fall from here does no harm, by tracking and by the drone's own height."""
    height = max(height_above_standing(c), _own_height(c), 0.0)
    sink = c.inputs.velocity[2] if c.inputs.velocity else 0.0
    return sqrt(sink * sink + 2.0 * GRAVITY * height) < HARMLESS_FALL


WIND_RULES: tuple[SafetyRule, ...] = (
    SafetyRule(
        code=EventCode.TAKE_OFF_DRIFT,
        mode=SafetyMode.LAND,
        scope=RuleScope.AIRBORNE,
        condition="blown aside while it takes off",
        is_broken=lambda c: (
            c.inputs.status is DroneStatus.TAKING_OFF and _touchdown_offset(c) > TAKE_OFF_DRIFT
        ),
        words=lambda c: landing(
            with_length_limit(
                Words("blown {d} m from where it took off", d=figure(_touchdown_offset(c), ".2f")),
                TAKE_OFF_DRIFT,
            )
        ),
        clears=Clearing.GROUND,
    ),
    SafetyRule(
        code=EventCode.TAKE_OFF_ABORTED,
        mode=SafetyMode.CUT,
        scope=RuleScope.AIRBORNE,
        condition="blown aside with its feet hardly off the floor",
        is_broken=lambda c: (
            c.inputs.status is DroneStatus.TAKING_OFF
            and _touchdown_offset(c) > TAKE_OFF_DRIFT
            and _is_just_above_floor(c)
        ),
        words=lambda c: Words(
            "blown {d} m from where it took off (limit {m} m) and only {k} m up:"
            " cutting the motors",
            d=figure(_touchdown_offset(c), ".2f"),
            m=figure(TAKE_OFF_DRIFT),
            k=figure(max(height_above_standing(c), 0.0), ".2f"),
        ),
        clears=Clearing.RESET,
    ),
    SafetyRule(
        code=EventCode.LANDING_DRIFT,
        mode=SafetyMode.CUT,
        scope=RuleScope.LANDING,
        condition="blown along just above the floor while it lands",
        is_broken=lambda c: _is_just_above_floor(c) and level_speed(c) > LANDING_DRIFT,
        words=lambda c: Words(
            "blown along at {d} m/s (limit {m} m/s) and only {k} m above the floor:"
            " cutting the motors",
            d=figure(level_speed(c), ".1f"),
            m=figure(LANDING_DRIFT, "g"),
            k=figure(max(height_above_standing(c), 0.0), ".2f"),
        ),
        clears=Clearing.RESET,
    ),
    SafetyRule(
        code=EventCode.BLOWN_ABOUT,
        mode=SafetyMode.LAND,
        scope=RuleScope.CRUISE,
        condition="gusts: it moves otherwise than told for seconds",
        is_broken=lambda c: c.seen.velocity_error > BLOWN_ABOUT,
        words=lambda c: landing(
            with_speed_limit(
                Words(
                    "blown about: {d} m/s off the wanted velocity for {n} s",
                    d=figure(c.seen.velocity_error, ".2f"),
                    n=figure(VELOCITY_ERROR_TIME_CONSTANT, ".0f"),
                ),
                BLOWN_ABOUT,
                "g",
            )
        ),
        debounce=1.0,
        clears=Clearing.GROUND,
        may_steer=True,
    ),
)
