"""What becomes of an answer that needs more knowledge than there is: return, land, descend.

RETURN needs a way home and a place that is not lost, else it is LAND: what is in doubt for a moment
only holds the drone, by a rule of its own. LAND needs a place, or a drone that knows its own height
and speed (``control_source``); else it is DESCEND, a level descent by our own setpoint, until the
drone is on the floor or must be. One that tells no height of its own is told to land itself then:
nobody else knows of the floor. One whose own loops land it level and at rest is told to at once: it
goes on where we fall silent, too.
"""

from __future__ import annotations

from housefly.config.airframe import Ability
from housefly.messages.sensing import DroneStatus
from housefly.messages.steering import SafetyMode
from housefly.pilot.safety.control_source import (
    ControlSource,
    source_for_landing,
    tracking_is_believed,
)
from housefly.pilot.safety.drone_rules import descent_time
from housefly.pilot.safety.limits import too_old
from housefly.pilot.safety.rule import RuleContext
from housefly.pilot.safety.tracking_rules import REFUSED_LAND


def knows_way_home(c: RuleContext) -> bool:
    """Return whether the drone can be flown home, now or once what holds it is over."""
    is_unseen = too_old(c.inputs.pose_age, c.limits.pose_age_land)
    is_lost = is_unseen or too_old(c.inputs.consistency.refused_for, REFUSED_LAND)
    return c.inputs.has_way_home and not is_lost and tracking_is_believed(c)


def can_wait_to_land(c: RuleContext) -> bool:
    """Return whether a landing without tracking waits, because something stands below."""
    is_heard = not too_old(c.inputs.telemetry_age, c.limits.telemetry_age)
    is_flying = c.inputs.status is DroneStatus.FLYING and is_heard
    holds = is_flying and c.inputs.consistency.flow_believed
    return holds and bool(c.inputs.landing_blocker) and not c.seen.late_steps


def possible_mode(mode: SafetyMode, c: RuleContext) -> SafetyMode:
    """Return the mode that takes the place of one, for want of knowledge."""
    if mode is SafetyMode.RETURN and not knows_way_home(c):
        mode = SafetyMode.LAND
    must_be_down = c.seen.landing_for > descent_time(c) and Ability.HEIGHT in c.airframe.lacks
    if mode is SafetyMode.DESCEND and (must_be_down or c.airframe.lands_itself):
        mode = SafetyMode.LAND
    is_level = (
        mode is SafetyMode.LAND and source_for_landing(c, steered=False) is ControlSource.LEVEL
    )
    return SafetyMode.DESCEND if is_level else mode
