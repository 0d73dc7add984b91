"""The rules of the last gate as a table: what is wrong, how bad it is, and the words for it. The
worst wins.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from housefly.config.limits import LimitsConfig
from housefly.messages import DroneStatus, SafetyMode
from housefly.pilot.safety.gate_inputs import GateInputs, Geofence
from housefly.pilot.safety.limits import too_old

CEILING_SLACK = 0.5
"""The drone may rise this far above ``limits.height_max`` before it is landed [m]."""
BATTERY_DEBOUNCE = 1.0
"""The battery must be below the floor for this long [s]: the voltage dips when the motors pull."""


@dataclass(frozen=True, slots=True)
class SafetyRule:
    """One thing that may be wrong.

    Attributes:
        code: short name for events.
        mode: how bad it is.
        broken: whether it is wrong now.
        words: for people.
        after: it counts once it was wrong for this long [s].
    """

    code: str
    mode: SafetyMode
    broken: Callable[[GateInputs, LimitsConfig, Geofence], bool]
    words: Callable[[GateInputs, LimitsConfig], str]
    after: float = 0.0


SAFETY_RULES: tuple[SafetyRule, ...] = (
    SafetyRule(
        "cut",
        SafetyMode.CUT,
        lambda f, _, __: f.cutting,
        lambda _, __: "motors are being cut by order",
    ),
    SafetyRule(
        "emergency",
        SafetyMode.CUT,
        lambda f, _, __: f.status is DroneStatus.EMERGENCY,
        lambda _, __: "the motors are cut: reset when nobody is near",
    ),
    SafetyRule(
        "telemetry_lost",
        SafetyMode.LAND,
        lambda f, limits, _: f.airborne and too_old(f.telemetry_age, limits.telemetry_age),
        lambda f, _: f"the drone is silent for {f.telemetry_age:.1f} s: landing",
    ),
    SafetyRule(
        "battery_low",
        SafetyMode.LAND,
        lambda f, limits, _: f.airborne and not f.battery >= limits.battery_floor,
        lambda f, limits: f"battery {f.battery:.0%} is below {limits.battery_floor:.0%}: landing",
        after=BATTERY_DEBOUNCE,
    ),
    SafetyRule(
        "tracking_lost",
        SafetyMode.LAND,
        lambda f, limits, _: f.airborne and too_old(f.pose_age, limits.pose_age_land),
        lambda f, _: f"tracking lost for {f.pose_age:.1f} s: landing",
    ),
    SafetyRule(
        "outside_fence",
        SafetyMode.LAND,
        lambda f, limits, fence: (
            f.airborne
            and f.position is not None
            and fence.outside(f.position) > limits.fence_margin
        ),
        lambda _, limits: f"more than {limits.fence_margin} m outside the map: landing",
    ),
    SafetyRule(
        "too_high",
        SafetyMode.LAND,
        lambda f, _, fence: (
            f.airborne and f.position is not None and not f.position[2] <= fence.ceiling
        ),
        lambda f, limits: f"higher than {limits.height_max + CEILING_SLACK:.1f} m: landing",
    ),
    SafetyRule(
        "stopped",
        SafetyMode.STOPPED,
        lambda f, _, __: f.stopped,
        lambda _, __: "STOP: hovering until resumed",
    ),
    SafetyRule(
        "tracking_old",
        SafetyMode.LEVEL,
        lambda f, limits, _: (
            f.status is DroneStatus.FLYING and too_old(f.pose_age, limits.pose_age_level)
        ),
        lambda f, _: f"tracking lost for {f.pose_age:.1f} s: the drone holds itself",
    ),
)
"""Worst first."""

MODE_SEVERITY = {mode: rank for rank, mode in enumerate(SafetyMode)}
"""Rank of each mode; a higher one wins."""
