"""By what a hold, a STOP or a landing is flown: the one table of what is believed.

Where tracking is believed, our setpoint brakes, keeps the place and sinks there. The drone's own
hover flies by optical flow, and nobody checks that but us: it is left to itself only where flow is
believed. Where neither is, our setpoint brakes by the motion that was known last, and sinks.
"""

from __future__ import annotations

from enum import Enum
from math import isfinite

from housefly.messages.sensing import DroneFault, DroneStatus
from housefly.pilot.safety.drone_rules import ON_FLOOR_HEIGHT, descent_time, height_above_standing
from housefly.pilot.safety.limits import too_old
from housefly.pilot.safety.observer import control_error
from housefly.pilot.safety.rule import RuleContext
from housefly.pilot.safety.tracking_rules import LATENCY_HOLD, is_disproved, is_mirrored, seems_low

STEERED_LANDING_TIME_MAX = 8.0
"""A landing that the pilot steers has to be near the floor after this [s]."""
STEERED_LANDING_ERROR_MAX = 0.8
"""Farther from its spot than this the pilot does not steer what it believes to steer [m]."""
STEERED_TOUCHDOWN_HEIGHT = 0.04
"""A landing that the pilot steers to the floor ends so near to it [m]."""


class ControlSource(Enum):
    """Who flies, and by what."""

    TRACKING = "our setpoint, by tracking"
    ONBOARD_HOVER = "the drone's own hover, by optical flow"
    LEVEL = "our setpoint, level, by what was known last"


CONTROL_SOURCES: dict[tuple[bool, bool], ControlSource] = {
    (True, True): ControlSource.TRACKING,
    (True, False): ControlSource.TRACKING,
    (False, True): ControlSource.ONBOARD_HOVER,
    (False, False): ControlSource.LEVEL,
}
"""By whether the place is believed, and whether the drone's own hover is."""


def knows_place(c: RuleContext) -> bool:
    """Return whether there is a fresh place to believe."""
    known, position = c.inputs.consistency, c.inputs.position
    is_seen = position is not None and all(map(isfinite, position))
    is_fresh = is_seen and not too_old(c.inputs.pose_age, c.limits.pose_age_level)
    is_doubtful = is_disproved(known) or known.latency_error > LATENCY_HOLD
    return is_fresh and tracking_is_believed(c) and not is_doubtful


def tracking_is_believed(c: RuleContext) -> bool:
    """Return whether tracking shows neither a mirror image nor a height that cannot be."""
    return not (seems_low(c) or is_mirrored(c))


def hover_is_believed(c: RuleContext) -> bool:
    """Return whether the drone has a hover of its own, and the speed it flies by is believed."""
    return c.airframe.capabilities.hovers and c.inputs.consistency.flow_believed


def knows_height(c: RuleContext) -> bool:
    """Return whether the drone can be trusted to find the floor by itself."""
    return (
        c.airframe.sonar is not None
        and DroneFault.ULTRASOUND_DEAF not in c.inputs.faults
        and not seems_low(c)
    )


def source_for_hold(c: RuleContext, steered: bool) -> ControlSource:
    """Return by what a hold is flown.

    Args:
        c: what is known.
        steered: what is wrong leaves commands and place alone. Else the drone's own hover is better
            while it is believed.
    """
    if not _is_ours(c):
        return ControlSource.ONBOARD_HOVER
    is_own = hover_is_believed(c)
    return CONTROL_SOURCES[knows_place(c) and (steered or not is_own), is_own]


def source_for_landing(c: RuleContext, steered: bool) -> ControlSource:
    """Return by what a landing goes on; arguments as above. The last bit is the drone's own."""
    is_own = not lands_on_floor(c) if _is_ours(c) else knows_height(c)
    if is_own or _is_down(c):
        is_steered = steered and _is_ours(c) and knows_place(c) and _can_steer(c)
        return (
            ControlSource.TRACKING
            if is_steered and not _is_down(c)
            else ControlSource.ONBOARD_HOVER
        )
    return CONTROL_SOURCES[_is_ours(c) and knows_place(c), c.airframe.lands_itself]


def lands_on_floor(c: RuleContext) -> bool:
    """Return whether our setpoint must sink to the floor: the drone's own last bit is in doubt."""
    return not (c.inputs.consistency.flow_believed and knows_height(c))


def _is_ours(c: RuleContext) -> bool:
    """Return whether our setpoints count: mode paper has none, take-off and landing obey none."""
    return c.inputs.steers and c.inputs.status is DroneStatus.FLYING


def _can_steer(c: RuleContext) -> bool:
    """Return whether the pilot still steers a landing whose last bit is the drone's own."""
    lowest = c.limits.landing_height + 0.05
    is_high = c.inputs.position is not None and c.inputs.position[2] > lowest
    is_in_time = c.seen.landing_for < STEERED_LANDING_TIME_MAX and not c.seen.late_steps
    return is_high and is_in_time and control_error(c.inputs) < STEERED_LANDING_ERROR_MAX


def _is_down(c: RuleContext) -> bool:
    """Return whether the drone is on the floor, or must be by the time that it sinks."""
    low = ON_FLOOR_HEIGHT if c.inputs.consistency.flow_believed else STEERED_TOUCHDOWN_HEIGHT
    return height_above_standing(c) < low or c.seen.landing_for > descent_time(c)
