"""Rules of the last gate about tracking: its age, and what the drone's own report says to it."""

from __future__ import annotations

from math import degrees, isfinite, isnan, radians

from housefly.messages.sensing import DroneStatus
from housefly.messages.steering import Clearing, SafetyMode
from housefly.pilot.estimation.consistency import TrackingConsistency
from housefly.pilot.safety.limits import too_old
from housefly.pilot.safety.rule import Counting, RuleContext, SafetyRule

M, N = SafetyMode, Counting

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


def seems_low(c: RuleContext) -> bool:
    """Return whether tracking says that the drone is lower than its own sensor can be wrong by.

    The other way round something may stand below the drone, which only its own sensor sees.
    """
    return c.now.consistency.height_error < -HEIGHT_DISAGREES


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
    known = c.now.consistency
    return abs(known.height_error) > HEIGHT_DISAGREES or known.drift > DRIFT_LAND


def _is_unseen_by_itself(c: RuleContext) -> bool:
    is_by_itself = c.now.status is not DroneStatus.FLYING
    return is_by_itself and too_old(c.now.pose_age, c.limits.pose_age_level)


def _knows_nothing(c: RuleContext) -> bool:
    is_old = too_old(c.now.pose_age, c.limits.pose_age_level)
    return c.now.steers and is_old and not c.now.consistency.flow_believed


def _tracking_lost(age: float, limit: float) -> str:
    since = f"lost for {age:.1f} s" if isfinite(age) else "has not shown the drone yet"
    return f"tracking {since} (limit {limit:g} s)"


def _height_words(c: RuleContext) -> str:
    error = c.now.consistency.height_error
    limit = f"(limit {HEIGHT_DISAGREES} m)"
    return f"the tracked height is off by {error:+.2f} m from the drone's own {limit}"


def _drift_words(c: RuleContext) -> str:
    return f"tracking has left the drone's own way by {c.now.consistency.drift:.2f} m"


def _ground_words(c: RuleContext) -> str:
    error = c.now.consistency.height_error
    if abs(error) > HEIGHT_DISAGREES:
        what = f"{error:+.2f} m from the floor (limit {HEIGHT_DISAGREES} m)"
    else:
        what = f"moved by {c.now.consistency.drift:.2f} m (limit {DRIFT_LAND} m)"
    return f"the drone stands, and tracking shows it {what}: it stays down"


def _latency_words(c: RuleContext) -> str:
    return f"poses are {c.now.consistency.latency_error:.2f} s older than they say"


TRACKING_RULES: tuple[SafetyRule, ...] = (
    SafetyRule(
        code="nothing_believed",
        mode=M.DESCEND,
        counts=N.FLYING,
        condition="no place to believe, and the drone's own speed is not either",
        broken=_knows_nothing,
        words=lambda c: (
            f"{_tracking_lost(c.now.pose_age, c.limits.pose_age_level)}, and the drone's own speed"
            " is not believed: sinking level"
        ),
        after=0.25,
        clears=Clearing.GROUND,
    ),
    SafetyRule(
        code="flow_wrong",
        mode=M.LAND,
        counts=N.FLYING,
        condition="the drone's own speed is neither what tracking sees nor how it leans",
        broken=lambda c: c.now.consistency.flow_wrong,
        words=lambda _: (
            "the drone's own speed is not what tracking sees and how it leans: it cannot hold"
            " itself, landing by tracking"
        ),
        after=0.2,
        clears=Clearing.GROUND,
        steered=True,
    ),
    SafetyRule(
        code="tracking_lost",
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="pose too old",
        broken=lambda c: too_old(c.now.pose_age, c.limits.pose_age_land),
        words=lambda c: f"{_tracking_lost(c.now.pose_age, c.limits.pose_age_land)}: landing",
        clears=Clearing.GROUND,
        waits=True,
    ),
    SafetyRule(
        code="poses_refused_long",
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="poses refused for long, because onboard motion disagrees",
        broken=lambda c: c.now.consistency.refused_for > REFUSED_LAND,
        words=lambda c: (
            f"poses disagree with the drone for {c.now.consistency.refused_for:.1f} s"
            f" (limit {REFUSED_LAND:g} s): landing"
        ),
        clears=Clearing.GROUND,
        waits=True,
    ),
    SafetyRule(
        code="tracking_drift",
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="the tracked way has left the drone's own",
        broken=lambda c: c.now.consistency.drift > DRIFT_LAND,
        words=lambda c: f"{_drift_words(c)} (limit {DRIFT_LAND} m): landing",
        clears=Clearing.GROUND,
    ),
    SafetyRule(
        code="tracking_drifted",
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="the tracked way has begun to leave the drone's own, and does not come back",
        broken=lambda c: c.now.consistency.drift > DRIFT_WARN,
        words=lambda c: f"{_drift_words(c)} (limit {DRIFT_WARN} m): landing",
        after=DRIFT_LASTS,
        clears=Clearing.GROUND,
    ),
    SafetyRule(
        code="tracking_frame",
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="the tracked body is turned against the drone",
        broken=lambda c: abs(c.now.consistency.frame_error) > FRAME_ERROR_MAX,
        words=lambda c: (
            "the tracked body is turned by"
            f" {degrees(c.now.consistency.frame_error):.0f} degrees against the drone"
            f" (limit {degrees(FRAME_ERROR_MAX):.0f}): landing"
        ),
        clears=Clearing.GROUND,
    ),
    SafetyRule(
        code="tracking_mirrored",
        mode=M.LAND,
        counts=N.AIRBORNE,
        condition="tracked motion is the mirror image of the drone's own",
        broken=lambda c: c.now.consistency.mirrored,
        words=lambda _: "tracking is the mirror image of how the drone moves: landing",
        clears=Clearing.GROUND,
    ),
    SafetyRule(
        code="tracking_height",
        mode=M.LAND,
        counts=N.CRUISE,
        condition="the tracked height is below the drone's own",
        broken=seems_low,
        words=lambda c: f"{_height_words(c)}: landing",
        after=0.3,
        clears=Clearing.GROUND,
    ),
    SafetyRule(
        code="tracking_height_drift",
        mode=M.LAND,
        counts=N.CRUISE,
        condition="the tracked height has risen above the drone's own, without a step of the floor",
        broken=lambda c: c.now.consistency.height_drift > HEIGHT_DISAGREES,
        words=lambda c: (
            f"the tracked height rose by {c.now.consistency.height_drift:.2f} m"
            f" (limit {HEIGHT_DISAGREES} m) without a step of the floor: landing"
        ),
        after=0.5,
        clears=Clearing.GROUND,
    ),
    SafetyRule(
        code="tracking_old",
        mode=M.HOLD,
        counts=N.FLYING,
        condition="pose old",
        broken=lambda c: too_old(c.now.pose_age, c.limits.pose_age_level),
        words=lambda c: (
            f"{_tracking_lost(c.now.pose_age, c.limits.pose_age_level)}: the drone holds itself"
        ),
    ),
    SafetyRule(
        code="poses_refused",
        mode=M.HOLD,
        counts=N.FLYING,
        condition="poses refused, because onboard motion disagrees",
        broken=lambda c: c.now.consistency.refused_for > REFUSED_HOLD,
        words=lambda c: (
            f"poses disagree with the drone for {c.now.consistency.refused_for:.1f} s"
            f" (limit {REFUSED_HOLD:g} s): the drone holds itself"
        ),
    ),
    SafetyRule(
        code="tracking_on_ground",
        mode=M.HOLD,
        counts=N.GROUND,
        condition="tracking shows the standing drone in the air, in the floor, or moving",
        broken=is_misplaced_on_ground,
        words=_ground_words,
        after=0.3,
    ),
    SafetyRule(
        code="tracking_late",
        mode=M.HOLD,
        counts=N.FLYING,
        condition="poses much older than they say",
        broken=lambda c: c.now.consistency.latency_error > LATENCY_HOLD,
        words=lambda c: f"{_latency_words(c)} (limit {LATENCY_HOLD} s): the drone holds itself",
    ),
    SafetyRule(
        code="tracking_slow",
        mode=M.SLOW,
        counts=N.FLYING,
        condition="poses older than they say",
        broken=lambda c: c.now.consistency.latency_error > LATENCY_SLOW,
        words=lambda c: f"{_latency_words(c)} (limit {LATENCY_SLOW} s): slowly",
    ),
    SafetyRule(
        code="tracking_gap",
        mode=M.WARN,
        counts=N.AIRBORNE,
        condition="pose old while the drone takes off or lands by itself",
        broken=_is_unseen_by_itself,
        words=lambda c: _tracking_lost(c.now.pose_age, c.limits.pose_age_level),
    ),
    SafetyRule(
        code="tracking_drifting",
        mode=M.WARN,
        counts=N.AIRBORNE,
        condition="the tracked way begins to leave the drone's own",
        broken=lambda c: c.now.consistency.drift > DRIFT_WARN,
        words=lambda c: f"{_drift_words(c)} (limit {DRIFT_WARN} m)",
    ),
    SafetyRule(
        code="tracking_unchecked",
        mode=M.WARN,
        counts=N.FLYING,
        condition="the drone does not tell its own motion: tracking is held against nothing",
        broken=lambda c: isnan(c.now.consistency.drift),
        words=lambda _: "the drone does not tell how it moves: tracking is not checked",
        after=UNCHECKED_AFTER,
    ),
    SafetyRule(
        code="flow_untold",
        mode=M.WARN,
        counts=N.FLYING,
        condition="the drone does not see how it moves, or says the same to the last bit",
        broken=lambda c: c.now.consistency.flow_untold,
        words=lambda _: "the drone does not see how it moves: it cannot hold itself",
        after=0.3,
    ),
    SafetyRule(
        code="tracking_height_off",
        mode=M.SLOW,
        counts=N.CRUISE,
        condition="the tracked height is above the drone's own: it is wrong, or something is below",
        broken=lambda c: c.now.consistency.height_error > HEIGHT_DISAGREES,
        words=lambda c: f"{_height_words(c)}, or something is below: slowly",
        after=0.3,
    ),
)
