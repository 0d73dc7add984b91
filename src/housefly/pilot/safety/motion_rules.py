"""Rules of the last gate about motion: where the drone is, how it moves, and what was asked."""

from __future__ import annotations

from math import degrees, hypot, isfinite

from housefly.config.airframe import Ability
from housefly.config.limits import LimitsConfig
from housefly.geometry import GRAVITY
from housefly.messages.event_code import EventCode
from housefly.messages.steering import Clearing, SafetyMode
from housefly.messages.words import Words, figure
from housefly.pilot.behavior.braking import EVASION_SPEED
from housefly.pilot.behavior.standing import STANDS_HIGH
from housefly.pilot.safety.limits import too_old
from housefly.pilot.safety.observer import (
    HOLD_SPAN,
    TILT_ERROR_MAX,
    control_error,
    velocity_error,
)
from housefly.pilot.safety.rule import Counting, RuleContext, SafetyRule
from housefly.pilot.safety.rule_words import (
    above_angle,
    above_length,
    above_speed,
    above_time,
    held,
    holding_itself,
    landing,
)

A, C, M, N = Ability, EventCode, SafetyMode, Counting

CEILING_SLACK = 0.5
"""The drone may rise this far above ``limits.height_max`` before it is landed [m]."""
CEILING_CLEARANCE = 0.3
"""No higher than this below the ceiling of the room [m]."""
HEIGHT_OFF, HEIGHT_FAR = 0.25, 0.4
"""Off the wanted height by this: warn, land [m]."""
CLIMB_TIME = 6.0
"""After a take-off, and when another height is wanted, it has this long to reach it [s]."""
VERTICAL_SPEED_SLACK = 0.4
"""A drone may climb or sink this much faster than ``limits.vertical_speed_max`` [m/s]."""
SPEED_SLACK = 0.5
"""A drone may fly this much faster than its cruise speed, and than it makes way at most [m/s]."""
TILT_HOLD_TIME = 1.5
"""A drone that leans otherwise than told holds itself for this long [s]: a link that lagged has
then passed on what was said to it ...
"""
TILT_WRONG_MAX = 0.8
"""... and who leaned so for longer than this in the last ``HOLD_SPAN`` lands [s]."""
BLOW_ACCELERATION = 6.0
"""A specific force that differs from gravity by more than this is a blow [m/s^2] ..."""
BLOW_SPEED = 0.55
"""... and so is a change of velocity within 0.2 s by more than this [m/s] ..."""
UNEXPLAINED_SPEED = 0.25
"""... of which the lean of the drone, that brakes after a gust, leaves more than this [m/s]."""
STUCK_TILT, STUCK_SPEED = 0.1, 0.08
"""Stuck is who is tilted by more than this [rad] and slower than this [m/s]."""
CONTROL_ERROR_HOLD, CONTROL_ERROR_LAND = 0.5, 1.0
"""Distance to the reference: hold, land [m]."""
VELOCITY_ERROR_MAX = 0.3
"""The velocity may differ from that of the reference by this [m/s] ..."""
TAKE_OVER_TIME = 1.5
"""... once the pilot has had so long to stop what the take-off left it with [s]."""
LEAVING_MAX = 0.1
"""A drone is held that would come to rest this much farther outside [m]."""


def height_off(c: RuleContext) -> float:
    """Return how far above its height the drone is [m]; 0 where that is unknown or too early."""
    is_old = too_old(c.now.pose_age, c.limits.pose_age_level)
    if c.now.position is None or is_old or c.seen.climbing_for < CLIMB_TIME:
        return 0.0
    off = c.now.position[2] - c.now.flight_height
    return off if isfinite(off) else 0.0


def blow(c: RuleContext) -> float:
    """Return the specific force beyond gravity in the drone's report [m/s^2]; 0 where unknown."""
    if c.now.telemetry is None or c.now.telemetry.acceleration is None:
        return 0.0
    return abs(hypot(*c.now.telemetry.acceleration) - GRAVITY)


def _is_thrown(c: RuleContext) -> bool:
    """Return whether its velocity is suddenly another, and not because it leans."""
    seen = c.seen
    return seen.velocity_change > BLOW_SPEED and seen.unexplained_change > UNEXPLAINED_SPEED


def vertical_speed(c: RuleContext) -> float:
    """Return how fast the drone climbs by tracking [m/s]; 0 where unknown."""
    return c.now.velocity[2] if c.now.velocity else 0.0


def level_speed(c: RuleContext) -> float:
    """Return how fast the drone flies in the plane, by tracking [m/s]; 0 where unknown."""
    return hypot(*c.now.velocity[:2]) if c.now.velocity else 0.0


def speed_bound(limits: LimitsConfig) -> float:
    """Return the speed in the plane that no flight of this site needs [m/s]."""
    return max(limits.speed, EVASION_SPEED) + SPEED_SLACK


def _is_stuck(c: RuleContext) -> bool:
    if not c.seen.tilt_asked > STUCK_TILT or c.now.velocity is None:
        return False
    onboard = hypot(*c.now.telemetry.velocity[:2]) if c.now.telemetry else 0.0
    return max(hypot(*c.now.velocity[:2]), onboard) < STUCK_SPEED


def _leaving(c: RuleContext) -> float:
    if c.now.position is None or c.now.velocity is None:
        return 0.0
    return c.fence.leaving(c.now.position, c.now.velocity, c.airframe.braking)


def _is_drifting(c: RuleContext) -> bool:
    is_taken_over = c.seen.cruising_for > TAKE_OVER_TIME
    return is_taken_over and velocity_error(c.now) > VELOCITY_ERROR_MAX


def _is_too_high(c: RuleContext) -> bool:
    """Return whether it is seen above the ceiling: a height carried on for long is a guess."""
    if c.now.position is None or c.now.position[2] <= c.fence.ceiling:
        return False
    is_guessed = c.now.pose_age > c.limits.pose_age_level
    return not (is_guessed and isfinite(c.now.position[2]))


def _stands_above(c: RuleContext) -> float:
    if c.now.position is None or too_old(c.now.pose_age, c.limits.pose_age_level):
        return 0.0
    return c.now.position[2] - c.seen.standing_height


def _contact_words(c: RuleContext) -> Words:
    if blow(c) > BLOW_ACCELERATION:
        return Words(
            "struck something: a blow of {d} m/s^2 (limit {m} m/s^2), landing",
            d=figure(blow(c), ".0f"),
            m=figure(BLOW_ACCELERATION, "g"),
        )
    return Words(
        "struck something, or tracking jumped: {d} m/s faster or slower at once"
        " (limit {m} m/s), landing",
        d=figure(c.seen.velocity_change, ".1f"),
        m=figure(BLOW_SPEED, "g"),
    )


def _height_words(c: RuleContext) -> Words:
    off, height = height_off(c), figure(c.now.flight_height, ".2f")
    by = figure(abs(off), ".2f")
    if off > 0.0:
        return Words("{d} m above its height of {m} m", d=by, m=height)
    return Words("{d} m below its height of {m} m", d=by, m=height)


def _error_words(c: RuleContext, limit: float) -> Words:
    error = figure(control_error(c.now), ".1f")
    return above_length(Words("{d} m from where it should be", d=error), limit, "g")


MOTION_RULES: tuple[SafetyRule, ...] = (
    SafetyRule(
        code=C.OUTSIDE_FENCE,
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="too far outside the map",
        broken=lambda c: (
            c.now.position is not None and c.fence.outside(c.now.position) > c.limits.fence_margin
        ),
        words=lambda c: landing(
            Words("more than {d} m outside the map", d=figure(c.limits.fence_margin))
        ),
        clears=Clearing.GROUND,
        steered=True,
    ),
    SafetyRule(
        code=C.TOO_HIGH,
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="above the highest height plus slack, or too near to the ceiling of the room",
        broken=_is_too_high,
        words=lambda c: landing(Words("higher than {d} m", d=figure(c.fence.ceiling, ".1f"))),
        clears=Clearing.GROUND,
        steered=True,
    ),
    SafetyRule(
        code=C.TOO_LOW,
        mode=M.LAND,
        counts=N.CRUISE,
        condition="below the lowest height",
        broken=lambda c: (
            c.now.position is not None
            and c.now.position[2] < min(c.limits.height_min, c.now.flight_height - HEIGHT_OFF)
        ),
        words=lambda c: landing(
            Words(
                "lower than {d} m",
                d=figure(min(c.limits.height_min, c.now.flight_height - HEIGHT_OFF), ".2f"),
            )
        ),
        after=0.4,
        clears=Clearing.GROUND,
        steered=True,
    ),
    SafetyRule(
        code=C.HEIGHT_ERROR,
        mode=M.LAND,
        counts=N.CRUISE,
        condition="far from its height",
        broken=lambda c: abs(height_off(c)) > HEIGHT_FAR,
        words=lambda c: landing(above_length(_height_words(c), HEIGHT_FAR)),
        after=2.0,
        clears=Clearing.GROUND,
        steered=True,
    ),
    SafetyRule(
        code=C.HEIGHT_NOT_REACHED,
        mode=M.LAND,
        counts=N.CRUISE,
        condition="off its height for long",
        broken=lambda c: abs(height_off(c)) > HEIGHT_OFF,
        words=lambda c: landing(
            Words("{why} for long (limit {d} m)", why=_height_words(c), d=figure(HEIGHT_OFF))
        ),
        after=10.0,
        clears=Clearing.GROUND,
        steered=True,
    ),
    SafetyRule(
        code=C.VERTICAL_SPEED,
        mode=M.LAND,
        counts=N.CRUISE,
        condition="climbs or sinks faster than the largest climb rate plus slack",
        broken=lambda c: (
            abs(vertical_speed(c)) > c.limits.vertical_speed_max + VERTICAL_SPEED_SLACK
        ),
        words=lambda c: landing(
            above_speed(
                Words("climbs at {d} m/s", d=figure(vertical_speed(c), "+.1f")),
                c.limits.vertical_speed_max + VERTICAL_SPEED_SLACK,
                ".1f",
            )
        ),
        after=0.2,
        clears=Clearing.GROUND,
    ),
    SafetyRule(
        code=C.TILT_LOST,
        mode=M.LAND,
        counts=N.CRUISE,
        condition="leans otherwise than told, again",
        broken=lambda c: c.seen.tilt_wrong_for > TILT_WRONG_MAX,
        words=lambda c: landing(
            above_time(
                Words(
                    "leaned otherwise than told for {d} of the last {n} s",
                    d=figure(c.seen.tilt_wrong_for, ".1f"),
                    n=figure(HOLD_SPAN, ".0f"),
                ),
                TILT_WRONG_MAX,
            )
        ),
        clears=Clearing.GROUND,
        needs=frozenset({A.ATTITUDE, A.TILT}),
        instead="`control_lost`: where it is, not how it leans",
    ),
    SafetyRule(
        code=C.CONTACT,
        mode=M.LAND,
        counts=N.CRUISE,
        condition="a blow: acceleration, or a velocity that is suddenly another",
        broken=lambda c: blow(c) > BLOW_ACCELERATION or _is_thrown(c),
        words=_contact_words,
        clears=Clearing.GROUND,
        steered=True,
    ),
    SafetyRule(
        code=C.STUCK,
        mode=M.LAND,
        counts=N.CRUISE,
        condition="it leans as told and neither tracking nor its own report sees it move",
        broken=_is_stuck,
        words=lambda c: Words(
            "leans {n} degrees and does not move (limit {m}): stuck on something, landing",
            n=figure(degrees(c.seen.tilt_asked), ".0f"),
            m=figure(degrees(STUCK_TILT), ".0f"),
        ),
        after=1.5,
        clears=Clearing.GROUND,
        needs=frozenset({A.TILT}),
        instead="`control_lost`: it falls behind its reference",
    ),
    SafetyRule(
        code=C.CONTROL_LOST,
        mode=M.LAND,
        counts=N.CRUISE,
        condition="very far from where it should be",
        broken=lambda c: control_error(c.now) > CONTROL_ERROR_LAND,
        words=lambda c: landing(_error_words(c, CONTROL_ERROR_LAND)),
        clears=Clearing.GROUND,
        steered=True,
    ),
    SafetyRule(
        code=C.NEAR_FENCE,
        mode=M.HOLD,
        counts=N.CRUISE,
        condition="would come to rest outside the map, or at its ceiling (v^2 / 2a and reaction)",
        broken=lambda c: _leaving(c) > LEAVING_MAX,
        words=lambda c: held(
            Words("about to leave the map by {d} m", d=figure(_leaving(c), ".1f"))
        ),
        lasts=0.5,
        steered=True,
    ),
    SafetyRule(
        code=C.TILT_ERROR,
        mode=M.HOLD,
        counts=N.CRUISE,
        condition="leans otherwise than told",
        broken=lambda c: c.seen.tilt_error > TILT_ERROR_MAX,
        words=lambda c: holding_itself(
            above_angle(
                Words(
                    "leans {n} degrees otherwise than told",
                    n=figure(degrees(c.seen.tilt_error), ".0f"),
                ),
                degrees(TILT_ERROR_MAX),
            )
        ),
        after=0.5,
        lasts=TILT_HOLD_TIME,
        needs=frozenset({A.ATTITUDE, A.TILT}),
        instead="`control_error`: where it is, not how it leans",
    ),
    SafetyRule(
        code=C.CONTROL_ERROR,
        mode=M.HOLD,
        counts=N.CRUISE,
        condition="far from where it should be",
        broken=lambda c: control_error(c.now) > CONTROL_ERROR_HOLD,
        words=lambda c: held(_error_words(c, CONTROL_ERROR_HOLD)),
        after=0.5,
        steered=True,
    ),
    SafetyRule(
        code=C.DRIFTING,
        mode=M.HOLD,
        counts=N.CRUISE,
        condition="moves otherwise than told",
        broken=_is_drifting,
        words=lambda _: held(
            Words("moves more than {d} m/s otherwise than told", d=figure(VELOCITY_ERROR_MAX, "g"))
        ),
        after=0.5,
        lasts=1.0,
        steered=True,
    ),
    SafetyRule(
        code=C.TOO_FAST,
        mode=M.HOLD,
        counts=N.CRUISE,
        condition="faster than it cruises and makes way, plus slack",
        broken=lambda c: level_speed(c) > speed_bound(c.limits),
        words=lambda c: held(
            Words(
                "flies at {d} m/s (limit {m} m/s)",
                d=figure(level_speed(c), ".1f"),
                m=figure(speed_bound(c.limits), ".1f"),
            )
        ),
        after=0.2,
        lasts=1.0,
        steered=True,
    ),
    SafetyRule(
        code=C.HEIGHT_OFF,
        mode=M.WARN,
        counts=N.CRUISE,
        condition="off its height",
        broken=lambda c: abs(height_off(c)) > HEIGHT_OFF,
        words=lambda c: above_length(_height_words(c), HEIGHT_OFF),
        after=0.5,
    ),
    SafetyRule(
        code=C.NOT_ON_FLOOR,
        mode=M.WARN,
        counts=N.GROUND,
        condition="it stands higher than it did",
        broken=lambda c: _stands_above(c) > STANDS_HIGH,
        words=lambda c: Words(
            "stands {d} m above the floor (limit {m} m): on something",
            d=figure(_stands_above(c), ".2f"),
            m=figure(STANDS_HIGH),
        ),
    ),
)
