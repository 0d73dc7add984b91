"""Rules of the safety gate about tracking: its age, and what the drone's own report says to it."""

from __future__ import annotations

from math import degrees, isfinite, isnan, radians

from housefly.config.airframe import Ability
from housefly.messages.event_code import EventCode
from housefly.messages.sensing import DroneStatus
from housefly.messages.steering import Clearing, SafetyMode
from housefly.messages.words import Words, figure
from housefly.pilot.estimation.consistency import TrackingConsistency
from housefly.pilot.safety.limits import too_old
from housefly.pilot.safety.rule import RuleContext, RuleScope, SafetyRule
from housefly.pilot.safety.rule_words import (
    holding_itself,
    landing,
    slowly,
    with_angle_limit,
    with_length_limit,
    with_time_limit,
)

REFUSED_HOLD, REFUSED_LAND = 0.3, 2.0
"""Poses are refused for so long because onboard motion disagrees: hold, land [s]."""
DRIFT_WARN, DRIFT_LAND = 0.05, 0.15
"""The tracked way leaves the drone's own by this: warn, land [m]."""
DRIFT_LASTS = 5.0
"""... and lands, too, when it has not come back within this [s]."""
UNCHECKED_AFTER = 3.0
"""Tracking may be held against nothing for this long [s]: windows have to fill."""
FRAME_ERROR_MAX = radians(25.0)
"""The tracked body may be turned against the drone by this [rad]."""
LATENCY_SLOW, LATENCY_HOLD = 0.12, 0.22
"""Poses are older than their stamps say by this: slow, hold [s]."""
HEIGHT_DISAGREES = 0.3
"""Tracked and onboard height may differ by this [m]."""
_UNCHECKED = Words("the drone does not tell how it moves: tracking is not checked")
_FLOW_UNTOLD = Words("the drone does not see how it moves: it cannot hold itself")


def seems_low(c: RuleContext) -> bool:
    """Return whether tracking says that the drone is lower than its own sensor can be wrong by.

    The other way round something may stand below the drone, which only its own sensor sees.
    """
    return c.inputs.consistency.height_error < -HEIGHT_DISAGREES


def is_mirrored(c: RuleContext) -> bool:
    """Return whether tracking shows the mirror image of how the drone moves, or of how it leans."""
    return c.inputs.consistency.mirrored or c.seen.leans_mirrored


def is_disproved(known: TrackingConsistency) -> bool:
    """Return whether the drone's own motion shows that tracking or its frame is wrong."""
    return (
        known.drift > DRIFT_LAND
        or abs(known.frame_error) > FRAME_ERROR_MAX
        or known.mirrored
        or known.refused_for > REFUSED_LAND
    )


def is_misplaced_on_ground(c: RuleContext) -> bool:
    """Return whether tracking shows a standing drone where it cannot stand."""
    known = c.inputs.consistency
    return abs(known.height_error) > HEIGHT_DISAGREES or known.drift > DRIFT_LAND


def _is_unseen_by_itself(c: RuleContext) -> bool:
    is_by_itself = c.inputs.status is not DroneStatus.FLYING
    return is_by_itself and too_old(c.inputs.pose_age, c.limits.pose_age_level)


def _knows_nothing(c: RuleContext) -> bool:
    is_old = too_old(c.inputs.pose_age, c.limits.pose_age_level)
    return c.inputs.steers and is_old and not c.inputs.consistency.flow_believed


def _tracking_lost(age: float, limit: float) -> Words:
    if isfinite(age):
        return with_time_limit(Words("tracking lost for {n} s", n=figure(age, ".1f")), limit)
    return with_time_limit(Words("tracking has not shown the drone yet"), limit)


def _height_words(c: RuleContext) -> Words:
    off = Words(
        "the tracked height is off by {d} m from the drone's own",
        d=figure(c.inputs.consistency.height_error, "+.2f"),
    )
    return with_length_limit(off, HEIGHT_DISAGREES)


def _refused_words(c: RuleContext, limit: float) -> Words:
    age = figure(c.inputs.consistency.refused_for, ".1f")
    return with_time_limit(Words("poses disagree with the drone for {n} s", n=age), limit)


def _drift_words(c: RuleContext, limit: float) -> Words:
    drift = figure(c.inputs.consistency.drift, ".2f")
    return with_length_limit(
        Words("tracking has left the drone's own way by {d} m", d=drift), limit
    )


def _ground_words(c: RuleContext) -> Words:
    error = c.inputs.consistency.height_error
    if abs(error) > HEIGHT_DISAGREES:
        return Words(
            "the drone stands, and tracking shows it {d} m from the floor (limit {m} m):"
            " it stays down",
            d=figure(error, "+.2f"),
            m=figure(HEIGHT_DISAGREES),
        )
    return Words(
        "the drone stands, and tracking shows it moved by {d} m (limit {m} m): it stays down",
        d=figure(c.inputs.consistency.drift, ".2f"),
        m=figure(DRIFT_LAND),
    )


def _latency_words(c: RuleContext, limit: float) -> Words:
    age = figure(c.inputs.consistency.latency_error, ".2f")
    return with_time_limit(Words("poses are {n} s older than they say", n=age), limit, "")


TRACKING_RULES: tuple[SafetyRule, ...] = (
    SafetyRule(
        code=EventCode.NOTHING_BELIEVED,
        mode=SafetyMode.DESCEND,
        scope=RuleScope.FLYING,
        condition="no place to believe, and the drone's own speed is not either",
        is_broken=_knows_nothing,
        words=lambda c: Words(
            "{why}, and the drone's own speed is not believed: sinking level",
            why=_tracking_lost(c.inputs.pose_age, c.limits.pose_age_level),
        ),
        debounce=0.25,
        clears=Clearing.GROUND,
    ),
    SafetyRule(
        code=EventCode.FLOW_WRONG,
        mode=SafetyMode.LAND,
        scope=RuleScope.FLYING,
        condition="the drone's own speed is neither what tracking sees nor how it leans",
        is_broken=lambda c: c.inputs.consistency.flow_wrong,
        words=lambda _: Words(
            "the drone's own speed is not what tracking sees and how it leans: it cannot hold"
            " itself, landing by tracking"
        ),
        debounce=0.2,
        clears=Clearing.GROUND,
        may_steer=True,
        needs=frozenset({Ability.VELOCITY, Ability.ATTITUDE}),
        instead="nothing flies by that velocity",
    ),
    SafetyRule(
        code=EventCode.TRACKING_LOST,
        mode=SafetyMode.LAND,
        scope=RuleScope.AIRBORNE,
        condition="pose too old",
        is_broken=lambda c: too_old(c.inputs.pose_age, c.limits.pose_age_land),
        words=lambda c: landing(_tracking_lost(c.inputs.pose_age, c.limits.pose_age_land)),
        clears=Clearing.GROUND,
        may_wait=True,
    ),
    SafetyRule(
        code=EventCode.POSES_REFUSED_LONG,
        mode=SafetyMode.LAND,
        scope=RuleScope.AIRBORNE,
        condition="poses refused for long, because onboard motion disagrees",
        is_broken=lambda c: c.inputs.consistency.refused_for > REFUSED_LAND,
        words=lambda c: landing(_refused_words(c, REFUSED_LAND)),
        clears=Clearing.GROUND,
        may_wait=True,
        needs=frozenset({Ability.VELOCITY}),
        instead="the estimator's gate refuses jumps; `tracking_lost` counts them",
    ),
    SafetyRule(
        code=EventCode.TRACKING_DRIFT,
        mode=SafetyMode.LAND,
        scope=RuleScope.AIRBORNE,
        condition="the tracked way has left the drone's own",
        is_broken=lambda c: c.inputs.consistency.drift > DRIFT_LAND,
        words=lambda c: landing(_drift_words(c, DRIFT_LAND)),
        clears=Clearing.GROUND,
        needs=frozenset({Ability.VELOCITY}),
        instead="nothing: a slow drift of tracking is not seen",
    ),
    SafetyRule(
        code=EventCode.TRACKING_DRIFTED,
        mode=SafetyMode.LAND,
        scope=RuleScope.AIRBORNE,
        condition="the tracked way has begun to leave the drone's own, and does not come back",
        is_broken=lambda c: c.inputs.consistency.drift > DRIFT_WARN,
        words=lambda c: landing(_drift_words(c, DRIFT_WARN)),
        debounce=DRIFT_LASTS,
        clears=Clearing.GROUND,
        needs=frozenset({Ability.VELOCITY}),
        instead="nothing: a slow drift of tracking is not seen",
    ),
    SafetyRule(
        code=EventCode.TRACKING_FRAME,
        mode=SafetyMode.LAND,
        scope=RuleScope.AIRBORNE,
        condition="the tracked body is turned against the drone",
        is_broken=lambda c: abs(c.inputs.consistency.frame_error) > FRAME_ERROR_MAX,
        words=lambda c: landing(
            with_angle_limit(
                Words(
                    "the tracked body is turned by {n} degrees against the drone",
                    n=figure(degrees(c.inputs.consistency.frame_error), ".0f"),
                ),
                degrees(FRAME_ERROR_MAX),
            )
        ),
        clears=Clearing.GROUND,
        needs=frozenset({Ability.VELOCITY}),
        instead="`control_error`: it flies away from its reference",
    ),
    SafetyRule(
        code=EventCode.TRACKING_MIRRORED,
        mode=SafetyMode.LAND,
        scope=RuleScope.AIRBORNE,
        condition="tracked motion is the mirror image of the drone's own, or of how it leans",
        is_broken=is_mirrored,
        words=lambda _: landing(Words("tracking is the mirror image of how the drone moves")),
        clears=Clearing.GROUND,
    ),
    SafetyRule(
        code=EventCode.TRACKING_HEIGHT,
        mode=SafetyMode.LAND,
        scope=RuleScope.CRUISE,
        condition="the tracked height is below the drone's own",
        is_broken=seems_low,
        words=lambda c: landing(_height_words(c)),
        debounce=0.3,
        clears=Clearing.GROUND,
        needs=frozenset({Ability.HEIGHT}),
        instead="`too_low` and the frame check on the ground",
    ),
    SafetyRule(
        code=EventCode.TRACKING_HEIGHT_DRIFT,
        mode=SafetyMode.LAND,
        scope=RuleScope.CRUISE,
        condition="the tracked height has risen above the drone's own, without a step of the floor",
        is_broken=lambda c: c.inputs.consistency.height_drift > HEIGHT_DISAGREES,
        words=lambda c: landing(
            Words(
                "the tracked height rose by {d} m (limit {m} m) without a step of the floor",
                d=figure(c.inputs.consistency.height_drift, ".2f"),
                m=figure(HEIGHT_DISAGREES),
            )
        ),
        debounce=0.5,
        clears=Clearing.GROUND,
        needs=frozenset({Ability.HEIGHT}),
        instead="`too_low` and `too_high`",
    ),
    SafetyRule(
        code=EventCode.TRACKING_OLD,
        mode=SafetyMode.HOLD,
        scope=RuleScope.FLYING,
        condition="pose old",
        is_broken=lambda c: too_old(c.inputs.pose_age, c.limits.pose_age_level),
        words=lambda c: holding_itself(_tracking_lost(c.inputs.pose_age, c.limits.pose_age_level)),
    ),
    SafetyRule(
        code=EventCode.POSES_REFUSED,
        mode=SafetyMode.HOLD,
        scope=RuleScope.FLYING,
        condition="poses refused, because onboard motion disagrees",
        is_broken=lambda c: c.inputs.consistency.refused_for > REFUSED_HOLD,
        words=lambda c: holding_itself(_refused_words(c, REFUSED_HOLD)),
        needs=frozenset({Ability.VELOCITY}),
        instead="the estimator's gate refuses jumps; `tracking_old` counts them",
    ),
    SafetyRule(
        code=EventCode.TRACKING_ON_GROUND,
        mode=SafetyMode.HOLD,
        scope=RuleScope.GROUND,
        condition="tracking shows the standing drone in the air, in the floor, or moving",
        is_broken=is_misplaced_on_ground,
        words=_ground_words,
        debounce=0.3,
    ),
    SafetyRule(
        code=EventCode.TRACKING_LATE,
        mode=SafetyMode.HOLD,
        scope=RuleScope.FLYING,
        condition="poses much older than they say",
        is_broken=lambda c: c.inputs.consistency.latency_error > LATENCY_HOLD,
        words=lambda c: holding_itself(_latency_words(c, LATENCY_HOLD)),
        needs=frozenset({Ability.VELOCITY}),
        instead="the latency that the tracking system states",
    ),
    SafetyRule(
        code=EventCode.TRACKING_SLOW,
        mode=SafetyMode.SLOW,
        scope=RuleScope.FLYING,
        condition="poses older than they say",
        is_broken=lambda c: c.inputs.consistency.latency_error > LATENCY_SLOW,
        words=lambda c: slowly(_latency_words(c, LATENCY_SLOW)),
        needs=frozenset({Ability.VELOCITY}),
        instead="the latency that the tracking system states",
    ),
    SafetyRule(
        code=EventCode.TRACKING_GAP,
        mode=SafetyMode.WARN,
        scope=RuleScope.AIRBORNE,
        condition="pose old while the drone takes off or lands by itself",
        is_broken=_is_unseen_by_itself,
        words=lambda c: _tracking_lost(c.inputs.pose_age, c.limits.pose_age_level),
    ),
    SafetyRule(
        code=EventCode.TRACKING_DRIFTING,
        mode=SafetyMode.WARN,
        scope=RuleScope.AIRBORNE,
        condition="the tracked way begins to leave the drone's own",
        is_broken=lambda c: c.inputs.consistency.drift > DRIFT_WARN,
        words=lambda c: _drift_words(c, DRIFT_WARN),
        needs=frozenset({Ability.VELOCITY}),
        instead="nothing: a slow drift of tracking is not seen",
    ),
    SafetyRule(
        code=EventCode.TRACKING_UNCHECKED,
        mode=SafetyMode.WARN,
        scope=RuleScope.FLYING,
        condition="the drone does not tell its own motion: tracking is held against nothing",
        is_broken=lambda c: isnan(c.inputs.consistency.drift),
        words=lambda _: _UNCHECKED,
        debounce=UNCHECKED_AFTER,
        needs=frozenset({Ability.VELOCITY}),
        instead="the list before the take-off says that it tells none",
    ),
    SafetyRule(
        code=EventCode.FLOW_UNTOLD,
        mode=SafetyMode.WARN,
        scope=RuleScope.FLYING,
        condition="the drone does not see how it moves, or says the same to the last bit",
        is_broken=lambda c: c.inputs.consistency.flow_untold,
        words=lambda _: _FLOW_UNTOLD,
        debounce=0.3,
        needs=frozenset({Ability.VELOCITY}),
        instead="the list before the take-off says that it tells none",
    ),
    SafetyRule(
        code=EventCode.TRACKING_HEIGHT_OFF,
        mode=SafetyMode.SLOW,
        scope=RuleScope.CRUISE,
        condition="the tracked height is above the drone's own: it is wrong, or something is below",
        is_broken=lambda c: c.inputs.consistency.height_error > HEIGHT_DISAGREES,
        words=lambda c: Words("{why}, or something is below: slowly", why=_height_words(c)),
        debounce=0.3,
        needs=frozenset({Ability.HEIGHT}),
        instead="furniture and people that the map and the sensors show",
    ),
)
