"""The rules of the last gate as a table: what is wrong, how bad it is, the words for it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from housefly.config.limits import LimitsConfig
from housefly.geometry import Vec3
from housefly.messages.sensing import DroneStatus
from housefly.messages.steering import SafetyMode
from housefly.pilot.safety.limits import too_old

AIRBORNE_STATUSES = frozenset({DroneStatus.TAKING_OFF, DroneStatus.FLYING, DroneStatus.LANDING})
"""States in which the propellers carry the drone."""


@dataclass(frozen=True, slots=True)
class GateInputs:
    """What is known at one step.

    Attributes:
        now: time [s].
        status: the drone's last word about itself.
        battery: charge, 0 to 1; NaN counts as empty.
        pose_age, telemetry_age: [s]; infinite before the first.
        position: estimated place [m], None before the first sighting.
        stopped: STOP is latched.
        cutting: the motors are to be cut.
    """

    now: float
    status: DroneStatus
    battery: float
    pose_age: float
    telemetry_age: float
    position: Vec3 | None
    stopped: bool
    cutting: bool

    @property
    def airborne(self) -> bool:
        """Whether the propellers carry the drone, by its last word."""
        return self.status in AIRBORNE_STATUSES


@dataclass(frozen=True, slots=True)
class Geofence:
    """The box to stay in: x_min, y_min, x_max, y_max, and the ceiling above the floor [m]."""

    bounds: tuple[float, float, float, float]
    ceiling: float

    def outside(self, position: Vec3) -> float:
        """Return how far a point lies outside in the plane [m]; infinite when it is no number."""
        x, y, _ = position
        x_min, y_min, x_max, y_max = self.bounds
        gaps = (x_min - x, x - x_max, y_min - y, y - y_max)
        return max(0.0, *gaps) if x == x and y == y else float("inf")


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
        SafetyMode.HOLD,
        lambda f, limits, _: (
            f.status is DroneStatus.FLYING and too_old(f.pose_age, limits.pose_age_level)
        ),
        lambda f, _: f"tracking lost for {f.pose_age:.1f} s: the drone holds itself",
    ),
)
"""Worst first."""

MODE_SEVERITY = {mode: rank for rank, mode in enumerate(SafetyMode)}
"""Rank of each mode; a higher one wins."""
