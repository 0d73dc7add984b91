"""The rules of the safety gate as one table, worst first; docs/safety.md shows it."""

from __future__ import annotations

from housefly.messages.event_code import EventCode
from housefly.messages.steering import SafetyMode
from housefly.pilot.safety.drone_rules import DRONE_RULES
from housefly.pilot.safety.motion_rules import MOTION_RULES
from housefly.pilot.safety.rule import SafetyRule
from housefly.pilot.safety.tracking_rules import TRACKING_RULES
from housefly.pilot.safety.wind_rules import WIND_RULES

MODE_SEVERITY = {mode: rank for rank, mode in enumerate(SafetyMode)}
"""Rank of each mode; a higher one wins."""

SAFETY_RULES: tuple[SafetyRule, ...] = tuple(
    sorted(
        (*DRONE_RULES, *TRACKING_RULES, *MOTION_RULES, *WIND_RULES),
        key=lambda rule: MODE_SEVERITY[rule.mode],
        reverse=True,
    )
)
"""Worst first; of two that are equally bad the first one is told first."""

_ORDERED = frozenset({EventCode.CUT, EventCode.EMERGENCY, EventCode.STOPPED})
ORDER_RULES = tuple(rule for rule in SAFETY_RULES if rule.code in _ORDERED)
"""What people order, and nothing else: the negative control of every other rule."""
