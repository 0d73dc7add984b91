"""Rules of the safety gate about motion: where the drone is, how it moves, and what was asked."""

from __future__ import annotations

from math import degrees, dist, hypot, isfinite

from housefly.config.airframe import Ability
from housefly.config.limits import LimitsConfig
from housefly.geometry import GRAVITY
from housefly.messages.event_code import EventCode
from housefly.messages.steering import Clearing, PositionSetpoint, SafetyMode, VelocitySetpoint
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
from housefly.pilot.safety.rule import RuleContext, RuleScope, SafetyRule
from housefly.pilot.safety.rule_words import (
    held,
    holding_itself,
    landing,
    with_angle_limit,
    with_length_limit,
    with_speed_limit,
    with_time_limit,
)

CEILING_SLACK = 0.5
"""The drone may rise this far above ``limits.height_max`` before it is landed [m]."""
CEILING_CLEARANCE = 0.3
"""No higher than this below the ceiling of the room [m]."""
HEIGHT_ERROR_WARN, HEIGHT_ERROR_LAND = 0.25, 0.4
"""Off the wanted height by this: warn, land [m]."""
CLIMB_TIME = 6.0
"""After a take-off, and when another height is wanted, it has this long to reach it [s]."""
VERTICAL_SPEED_SLACK = 0.4
"""A drone may climb or sink this much faster than ``limits.vertical_speed_max`` [m/s]."""
SPEED_SLACK = 0.5
"""A drone may fly this much faster than its cruise speed, and than it makes way at most [m/s]."""
TAKE_OFF_TURN_MAX = 0.8
"""Who has turned by more than this while it takes off has a weak motor or propeller [rad]."""
TILT_HOLD_TIME = 1.5
"""A drone that leans otherwise than told holds itself for this long [s]: a link that lagged has
then passed on what was said to it ...
"""
TILT_WRONG_MAX = 0.8
"""... and who leaned so for longer than this in the last ``HOLD_SPAN`` lands [s]."""
IMPACT_ACCELERATION = 6.0
"""A specific force that differs from gravity by more than this is an impact [m/s^2] ..."""
IMPACT_SPEED_CHANGE = 0.55
"""... and so is a change of velocity within 0.2 s by more than this [m/s] ..."""
UNEXPLAINED_SPEED_CHANGE = 0.25
"""... of which the lean of the drone, that brakes after a gust, leaves more than this [m/s]."""
STUCK_TILT, STUCK_SPEED = 0.1, 0.12
"""Stuck is who is tilted by more than this [rad] and slower than this [m/s] ..."""
STUCK_SPEED_ASKED = 0.4
"""... and so is who is steered by velocity and told to fly faster than this [m/s] ..."""
STUCK_DISTANCE = 0.25
"""... or by places, and told one that is farther away than this [m]."""
CONTROL_ERROR_HOLD, CONTROL_ERROR_LAND = 0.5, 1.0
"""Distance to the reference: hold, land [m]."""
VELOCITY_ERROR_MAX = 0.3
"""The velocity may differ from that of the reference by this [m/s] ..."""
TAKE_OVER_TIME = 1.5
"""... once the pilot has had so long to stop what the take-off left it with [s]."""
FENCE_OVERSHOOT_MAX = 0.1
"""A drone is held that would come to rest this much farther outside [m]."""


def height_error(c: RuleContext) -> float:
    """Return how far above its height the drone is [m]; 0 where that is unknown or too early."""
    is_old = too_old(c.inputs.pose_age, c.limits.pose_age_level)
    if c.inputs.position is None or is_old or c.seen.climbing_for < CLIMB_TIME:
        return 0.0
    off = c.inputs.position[2] - c.inputs.flight_height
    return off if isfinite(off) else 0.0


def impact(c: RuleContext) -> float:
    """Return the specific force beyond gravity in the drone's report [m/s^2]; 0 where unknown."""
    if c.inputs.telemetry is None or c.inputs.telemetry.acceleration is None:
        return 0.0
    return abs(hypot(*c.inputs.telemetry.acceleration) - GRAVITY)


def _is_thrown(c: RuleContext) -> bool:
    """Return whether its velocity is suddenly another, and not because it leans."""
    seen = c.seen
    return (
        seen.velocity_change > IMPACT_SPEED_CHANGE
        and seen.unexplained_change > UNEXPLAINED_SPEED_CHANGE
    )


def vertical_speed(c: RuleContext) -> float:
    """Return how fast the drone climbs by tracking [m/s]; 0 where unknown."""
    return c.inputs.velocity[2] if c.inputs.velocity else 0.0


def level_speed(c: RuleContext) -> float:
    """Return how fast the drone flies in the plane, by tracking [m/s]; 0 where unknown."""
    return hypot(*c.inputs.velocity[:2]) if c.inputs.velocity else 0.0


def speed_bound(limits: LimitsConfig) -> float:
    """Return the speed in the plane that no flight of this site needs [m/s]."""
    return max(limits.speed, EVASION_SPEED) + SPEED_SLACK


def _speed_asked(c: RuleContext) -> float:
    """Return how fast a drone that is steered by velocity is to fly in the plane [m/s]; else 0."""
    asked = c.inputs.flown
    return hypot(asked.forward, asked.left) if isinstance(asked, VelocitySetpoint) else 0.0


def _distance_asked(c: RuleContext) -> float:
    """Return how far a drone that is steered by places is told to fly, in the plane [m]; else 0."""
    asked, here = c.inputs.flown, c.inputs.position
    if not isinstance(asked, PositionSetpoint) or here is None:
        return 0.0
    return dist((asked.x, asked.y), here[:2])


def _is_stuck(c: RuleContext) -> bool:
    is_driven = (
        c.seen.tilt_asked > STUCK_TILT
        or _speed_asked(c) > STUCK_SPEED_ASKED
        or _distance_asked(c) > STUCK_DISTANCE
    )
    if not is_driven or c.inputs.velocity is None:
        return False
    onboard = hypot(*c.inputs.telemetry.velocity[:2]) if c.inputs.telemetry else 0.0
    return max(hypot(*c.inputs.velocity[:2]), onboard) < STUCK_SPEED


def _fence_overshoot(c: RuleContext) -> float:
    if c.inputs.position is None or c.inputs.velocity is None:
        return 0.0
    return c.fence.overshoot(c.inputs.position, c.inputs.velocity, c.airframe.braking)


def _is_drifting(c: RuleContext) -> bool:
    is_taken_over = c.seen.cruising_for > TAKE_OVER_TIME
    return is_taken_over and velocity_error(c.inputs) > VELOCITY_ERROR_MAX


def _is_too_high(c: RuleContext) -> bool:
    """Return whether it is seen above the ceiling: a height carried on for long is a guess."""
    if c.inputs.position is None or c.inputs.position[2] <= c.fence.ceiling:
        return False
    is_guessed = c.inputs.pose_age > c.limits.pose_age_level
    return not (is_guessed and isfinite(c.inputs.position[2]))


def _stands_above(c: RuleContext) -> float:
    if c.inputs.position is None or too_old(c.inputs.pose_age, c.limits.pose_age_level):
        return 0.0
    return c.inputs.position[2] - c.seen.standing_height


def _contact_words(c: RuleContext) -> Words:
    if impact(c) > IMPACT_ACCELERATION:
        return Words(
            "struck something: a blow of {d} m/s^2 (limit {m} m/s^2), landing",
            d=figure(impact(c), ".0f"),
            m=figure(IMPACT_ACCELERATION, "g"),
        )
    return Words(
        "struck something, or tracking jumped: {d} m/s faster or slower at once"
        " (limit {m} m/s), landing",
        d=figure(c.seen.velocity_change, ".1f"),
        m=figure(IMPACT_SPEED_CHANGE, "g"),
    )


def _stuck_words(c: RuleContext) -> Words:
    if _speed_asked(c) > STUCK_SPEED_ASKED:
        words = Words("told {d} m/s and does not move", d=figure(_speed_asked(c), ".1f"))
        return landing(with_speed_limit(words, STUCK_SPEED_ASKED, "g"))
    if _distance_asked(c) > STUCK_DISTANCE:
        return landing(_off_words(_distance_asked(c), STUCK_DISTANCE))
    return Words(
        "leans {n} degrees and does not move (limit {m}): stuck on something, landing",
        n=figure(degrees(c.seen.tilt_asked), ".0f"),
        m=figure(degrees(STUCK_TILT), ".0f"),
    )


def _height_words(c: RuleContext) -> Words:
    off, height = height_error(c), figure(c.inputs.flight_height, ".2f")
    by = figure(abs(off), ".2f")
    if off > 0.0:
        return Words("{d} m above its height of {m} m", d=by, m=height)
    return Words("{d} m below its height of {m} m", d=by, m=height)


def _off_words(off: float, limit: float) -> Words:
    words = Words("{d} m from where it should be", d=figure(off, ".1f"))
    return with_length_limit(words, limit, "g")


MOTION_RULES: tuple[SafetyRule, ...] = (
    SafetyRule(
        code=EventCode.OUTSIDE_FENCE,
        mode=SafetyMode.LAND,
        scope=RuleScope.AIRBORNE,
        condition="too far outside the map",
        is_broken=lambda c: (
            c.inputs.position is not None
            and c.fence.outside(c.inputs.position) > c.limits.fence_margin
        ),
        words=lambda c: landing(
            Words("more than {d} m outside the map", d=figure(c.limits.fence_margin))
        ),
        clears=Clearing.GROUND,
        may_steer=True,
    ),
    SafetyRule(
        code=EventCode.TOO_HIGH,
        mode=SafetyMode.LAND,
        scope=RuleScope.AIRBORNE,
        condition="above the highest height plus slack, or too near to the ceiling of the room",
        is_broken=_is_too_high,
        words=lambda c: landing(Words("higher than {d} m", d=figure(c.fence.ceiling, ".1f"))),
        clears=Clearing.GROUND,
        may_steer=True,
    ),
    SafetyRule(
        code=EventCode.TOO_LOW,
        mode=SafetyMode.LAND,
        scope=RuleScope.CRUISE,
        condition="below the lowest height",
        is_broken=lambda c: (
            c.inputs.position is not None
            and c.inputs.position[2]
            < min(c.limits.height_min, c.inputs.flight_height - HEIGHT_ERROR_WARN)
        ),
        words=lambda c: landing(
            Words(
                "lower than {d} m",
                d=figure(
                    min(c.limits.height_min, c.inputs.flight_height - HEIGHT_ERROR_WARN), ".2f"
                ),
            )
        ),
        debounce=0.4,
        clears=Clearing.GROUND,
        may_steer=True,
    ),
    SafetyRule(
        code=EventCode.HEIGHT_ERROR,
        mode=SafetyMode.LAND,
        scope=RuleScope.CRUISE,
        condition="far from its height",
        is_broken=lambda c: abs(height_error(c)) > HEIGHT_ERROR_LAND,
        words=lambda c: landing(with_length_limit(_height_words(c), HEIGHT_ERROR_LAND)),
        debounce=2.0,
        clears=Clearing.GROUND,
        may_steer=True,
    ),
    SafetyRule(
        code=EventCode.HEIGHT_NOT_REACHED,
        mode=SafetyMode.LAND,
        scope=RuleScope.CRUISE,
        condition="off its height for long",
        is_broken=lambda c: abs(height_error(c)) > HEIGHT_ERROR_WARN,
        words=lambda c: landing(
            Words("{why} for long (limit {d} m)", why=_height_words(c), d=figure(HEIGHT_ERROR_WARN))
        ),
        debounce=10.0,
        clears=Clearing.GROUND,
        may_steer=True,
    ),
    SafetyRule(
        code=EventCode.VERTICAL_SPEED,
        mode=SafetyMode.LAND,
        scope=RuleScope.CRUISE,
        condition="climbs or sinks faster than the largest climb rate plus slack",
        is_broken=lambda c: (
            abs(vertical_speed(c)) > c.limits.vertical_speed_max + VERTICAL_SPEED_SLACK
        ),
        words=lambda c: landing(
            with_speed_limit(
                Words("climbs at {d} m/s", d=figure(vertical_speed(c), "+.1f")),
                c.limits.vertical_speed_max + VERTICAL_SPEED_SLACK,
                ".1f",
            )
        ),
        debounce=0.2,
        clears=Clearing.GROUND,
    ),
    SafetyRule(
        code=EventCode.TAKE_OFF_TURN,
        mode=SafetyMode.LAND,
        scope=RuleScope.AIRBORNE,
        condition="turns round while it takes off",
        is_broken=lambda c: c.seen.take_off_turn > TAKE_OFF_TURN_MAX,
        words=lambda c: landing(
            with_angle_limit(
                Words(
                    "turned {n} degrees while it took off",
                    n=figure(degrees(c.seen.take_off_turn), ".0f"),
                ),
                degrees(TAKE_OFF_TURN_MAX),
            )
        ),
        debounce=0.1,
        clears=Clearing.GROUND,
    ),
    SafetyRule(
        code=EventCode.TILT_LOST,
        mode=SafetyMode.LAND,
        scope=RuleScope.CRUISE,
        condition="leans otherwise than told, again",
        is_broken=lambda c: c.seen.tilt_wrong_for > TILT_WRONG_MAX,
        words=lambda c: landing(
            with_time_limit(
                Words(
                    "leaned otherwise than told for {d} of the last {n} s",
                    d=figure(c.seen.tilt_wrong_for, ".1f"),
                    n=figure(HOLD_SPAN, ".0f"),
                ),
                TILT_WRONG_MAX,
            )
        ),
        clears=Clearing.GROUND,
        needs=frozenset({Ability.ATTITUDE, Ability.TILT}),
        instead="`control_lost`: where it is, not how it leans",
    ),
    SafetyRule(
        code=EventCode.CONTACT,
        mode=SafetyMode.LAND,
        scope=RuleScope.CRUISE,
        condition="a blow: acceleration, or a velocity that is suddenly another",
        is_broken=lambda c: impact(c) > IMPACT_ACCELERATION or _is_thrown(c),
        words=_contact_words,
        clears=Clearing.GROUND,
        may_steer=True,
    ),
    SafetyRule(
        code=EventCode.STUCK,
        mode=SafetyMode.LAND,
        scope=RuleScope.CRUISE,
        condition="it is told to move and neither tracking nor its own report sees it do so",
        is_broken=_is_stuck,
        words=_stuck_words,
        debounce=1.5,
        clears=Clearing.GROUND,
    ),
    SafetyRule(
        code=EventCode.CONTROL_LOST,
        mode=SafetyMode.LAND,
        scope=RuleScope.CRUISE,
        condition="very far from where it should be",
        is_broken=lambda c: control_error(c.inputs) > CONTROL_ERROR_LAND,
        words=lambda c: landing(_off_words(control_error(c.inputs), CONTROL_ERROR_LAND)),
        clears=Clearing.GROUND,
        may_steer=True,
    ),
    SafetyRule(
        code=EventCode.NEAR_FENCE,
        mode=SafetyMode.HOLD,
        scope=RuleScope.CRUISE,
        condition="would come to rest outside the map, or at its ceiling (v^2 / 2a and reaction)",
        is_broken=lambda c: _fence_overshoot(c) > FENCE_OVERSHOOT_MAX,
        words=lambda c: held(
            Words("about to leave the map by {d} m", d=figure(_fence_overshoot(c), ".1f"))
        ),
        lasts=0.5,
        may_steer=True,
    ),
    SafetyRule(
        code=EventCode.TILT_ERROR,
        mode=SafetyMode.HOLD,
        scope=RuleScope.CRUISE,
        condition="leans otherwise than told",
        is_broken=lambda c: c.seen.tilt_error > TILT_ERROR_MAX,
        words=lambda c: holding_itself(
            with_angle_limit(
                Words(
                    "leans {n} degrees otherwise than told",
                    n=figure(degrees(c.seen.tilt_error), ".0f"),
                ),
                degrees(TILT_ERROR_MAX),
            )
        ),
        debounce=0.5,
        lasts=TILT_HOLD_TIME,
        needs=frozenset({Ability.ATTITUDE, Ability.TILT}),
        instead="`control_error`: where it is, not how it leans",
    ),
    SafetyRule(
        code=EventCode.CONTROL_ERROR,
        mode=SafetyMode.HOLD,
        scope=RuleScope.CRUISE,
        condition="far from where it should be",
        is_broken=lambda c: control_error(c.inputs) > CONTROL_ERROR_HOLD,
        words=lambda c: held(_off_words(control_error(c.inputs), CONTROL_ERROR_HOLD)),
        debounce=0.5,
        may_steer=True,
    ),
    SafetyRule(
        code=EventCode.DRIFTING,
        mode=SafetyMode.HOLD,
        scope=RuleScope.CRUISE,
        condition="moves otherwise than told",
        is_broken=_is_drifting,
        words=lambda _: held(
            Words("moves more than {d} m/s otherwise than told", d=figure(VELOCITY_ERROR_MAX, "g"))
        ),
        debounce=0.5,
        lasts=1.0,
        may_steer=True,
    ),
    SafetyRule(
        code=EventCode.TOO_FAST,
        mode=SafetyMode.HOLD,
        scope=RuleScope.CRUISE,
        condition="faster than it cruises and makes way, plus slack",
        is_broken=lambda c: level_speed(c) > speed_bound(c.limits),
        words=lambda c: held(
            Words(
                "flies at {d} m/s (limit {m} m/s)",
                d=figure(level_speed(c), ".1f"),
                m=figure(speed_bound(c.limits), ".1f"),
            )
        ),
        debounce=0.2,
        lasts=1.0,
        may_steer=True,
    ),
    SafetyRule(
        code=EventCode.HEIGHT_OFF,
        mode=SafetyMode.WARN,
        scope=RuleScope.CRUISE,
        condition="off its height",
        is_broken=lambda c: abs(height_error(c)) > HEIGHT_ERROR_WARN,
        words=lambda c: with_length_limit(_height_words(c), HEIGHT_ERROR_WARN),
        debounce=0.5,
    ),
    SafetyRule(
        code=EventCode.NOT_ON_FLOOR,
        mode=SafetyMode.WARN,
        scope=RuleScope.GROUND,
        condition="it stands higher than it did",
        is_broken=lambda c: _stands_above(c) > STANDS_HIGH,
        words=lambda c: Words(
            "stands {d} m above the floor (limit {m} m): on something",
            d=figure(_stands_above(c), ".2f"),
            m=figure(STANDS_HIGH),
        ),
    ),
)
