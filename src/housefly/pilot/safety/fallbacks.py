"""What becomes of an answer that needs more knowledge than there is: return, land, descend.

RETURN needs a way home and a place that is not lost, else it is LAND: what is in doubt for a moment
only holds the drone, by a rule of its own. LAND needs a drone that knows its own height, else it is
DESCEND, a level descent by our own setpoint, until the drone is on the floor or must be.
"""

from __future__ import annotations

from housefly.messages.sensing import DroneStatus
from housefly.messages.steering import SafetyMode
from housefly.pilot.behavior.drone_faults import DEAF_SONAR
from housefly.pilot.safety.drone_rules import descent_time, lies_on_floor
from housefly.pilot.safety.limits import too_old
from housefly.pilot.safety.observer import control_error
from housefly.pilot.safety.rule import RuleContext
from housefly.pilot.safety.tracking_rules import REFUSED_LAND, seems_low

STEERED_MAX = 8.0
"""A landing that the pilot steers has to be near the floor after this [s]."""
STEERED_ERROR_MAX = 0.8
"""Farther from its spot than this the pilot does not steer what it believes to steer [m]."""


def knows_place(c: RuleContext) -> bool:
    """Return whether there is a fresh place to believe."""
    is_fresh = not too_old(c.now.pose_age, c.limits.pose_age_level)
    return is_fresh and c.now.consistency.refused_for == 0.0 and _is_believed(c)


def knows_way_home(c: RuleContext) -> bool:
    """Return whether the drone can be flown home, now or once what holds it is over."""
    is_unseen = too_old(c.now.pose_age, c.limits.pose_age_land)
    is_lost = is_unseen or too_old(c.now.consistency.refused_for, REFUSED_LAND)
    return c.now.has_way_home and not is_lost and _is_believed(c)


def _is_believed(c: RuleContext) -> bool:
    return not (seems_low(c) or c.now.consistency.mirrored)


def can_steer_landing(c: RuleContext) -> bool:
    """Return whether the pilot can still steer a landing; the last bit is the drone's own."""
    is_flying = c.now.status is DroneStatus.FLYING and c.now.position is not None
    lowest = c.limits.landing_height + 0.05
    is_high = c.now.position is not None and c.now.position[2] > lowest
    is_in_time = c.seen.landing_for < STEERED_MAX and not c.seen.late_steps
    is_near = control_error(c.now) < STEERED_ERROR_MAX
    is_free = is_flying and not c.now.stopped
    return is_free and is_high and is_in_time and is_near and knows_place(c)


def can_wait_to_land(c: RuleContext) -> bool:
    """Return whether a landing without tracking waits, because something stands below."""
    is_heard = not too_old(c.now.telemetry_age, c.limits.telemetry_age)
    is_flying = c.now.status is DroneStatus.FLYING and is_heard
    return is_flying and bool(c.now.below) and not c.seen.late_steps


def knows_height(c: RuleContext) -> bool:
    """Return whether the drone can be trusted to find the floor by itself."""
    return DEAF_SONAR not in c.now.faults and not seems_low(c)


def possible_mode(mode: SafetyMode, c: RuleContext) -> SafetyMode:
    """Return the mode that takes the place of one, for want of knowledge."""
    if mode is SafetyMode.RETURN and not knows_way_home(c):
        mode = SafetyMode.LAND
    if mode is not SafetyMode.LAND or knows_height(c):
        return mode
    is_down = lies_on_floor(c) or c.seen.landing_for > descent_time(c)
    return SafetyMode.LAND if is_down else SafetyMode.DESCEND
