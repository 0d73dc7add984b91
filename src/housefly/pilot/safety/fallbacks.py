"""What becomes of an answer that needs more knowledge than there is: return, land, descend.

RETURN needs a way home and a place that is fresh and consistent, else it is LAND; LAND needs a
drone that knows its own height, else it is DESCEND, a level descent by our own setpoint, until the
drone is on the floor or must be.
"""

from __future__ import annotations

from housefly.messages.steering import SafetyMode
from housefly.pilot.behavior.drone_faults import DEAF_SONAR
from housefly.pilot.safety.drone_rules import lies_on_floor
from housefly.pilot.safety.limits import DESCENT_RATE, too_old
from housefly.pilot.safety.rule import RuleContext
from housefly.pilot.safety.tracking_rules import seems_low

DESCENT_MARGIN = 3.0
"""A descent takes no longer than from the ceiling at ``DESCENT_RATE``, and so much more [s]."""


def knows_way_home(c: RuleContext) -> bool:
    """Return whether the drone can be flown home: a way, and a place to believe."""
    known = c.now.consistency
    is_believed = known.refused_for == 0.0 and not (seems_low(c) or known.mirrored)
    is_fresh = not too_old(c.now.pose_age, c.limits.pose_age_level)
    return c.now.has_way_home and is_fresh and is_believed


def knows_height(c: RuleContext) -> bool:
    """Return whether the drone can be trusted to find the floor by itself."""
    return DEAF_SONAR not in c.now.faults and not seems_low(c)


def possible_mode(mode: SafetyMode, c: RuleContext) -> SafetyMode:
    """Return the mode that takes the place of one, for want of knowledge."""
    if mode is SafetyMode.RETURN and not knows_way_home(c):
        mode = SafetyMode.LAND
    if mode is not SafetyMode.LAND or knows_height(c):
        return mode
    longest = c.fence.ceiling / DESCENT_RATE + DESCENT_MARGIN
    is_down = lies_on_floor(c) or c.seen.landing_for > longest
    return SafetyMode.LAND if is_down else SafetyMode.DESCEND
