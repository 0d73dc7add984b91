"""The pre-flight checks: what must be right before a take-off, with value, limit, why and mend.

A check that is required and fails refuses the take-off; the others are told.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import degrees, hypot, isfinite, radians

from housefly.config.limits import LimitsConfig
from housefly.messages.flight import OrderOutcome
from housefly.messages.preflight import (
    FRAMES_NOT_NEEDED,
    FrameCheckState,
    FramesKnown,
    PreflightCheck,
)
from housefly.messages.sensing import DroneStatus
from housefly.pilot.behavior.mission import Refused, VehicleStatus
from housefly.pilot.behavior.order_checks import (
    HEIGHT_ERROR_MAX,
    MOVED_ON_GROUND_MAX,
    TAKE_OFF_RESERVE,
)
from housefly.pilot.behavior.origin import PAD_DISTANCE_MAX, PAD_HEADING_MAX

TILT_ON_PAD_MAX = radians(6.0)
"""A drone that leans more than this slides off its pad as it takes off, from 8 degrees on [rad]."""
OWN_SPEED_ON_PAD_MAX = 0.15
"""A drone that stands and says that it moves faster than this cannot hold itself [m/s]."""


@dataclass(frozen=True, slots=True)
class PreflightInputs:
    """What the checks look at.

    Attributes:
        vehicle: the drone.
        limits: of the site.
        off_pad, turned: how far tracking has it from its pad [m], and turned against it [rad].
        origin_confirmed: tracking has shown it on its pad, or somebody compared the frames.
        origin_distance_max: from its place on the pad, to be confirmed [m].
        stopped: STOP is latched.
        take_off_fault: who or what stands above or beside it, in words, or "".
        sees_people: a sensor of the room sees people here.
        frames: what is known of the frames of tracking, drone and map.
    """

    vehicle: VehicleStatus
    limits: LimitsConfig
    off_pad: float = 0.0
    turned: float = 0.0
    origin_confirmed: bool = True
    origin_distance_max: float = PAD_DISTANCE_MAX
    stopped: bool = False
    take_off_fault: str = ""
    sees_people: bool = True
    frames: FramesKnown = FRAMES_NOT_NEEDED

    @property
    def tilt(self) -> float:
        """How far the drone leans by its own word [rad]; 0 before the first."""
        told = self.vehicle.telemetry
        return max(abs(told.phi), abs(told.theta)) if told else 0.0

    @property
    def own_speed(self) -> float:
        """How fast the drone moves by its own word [m/s]; 0 before the first."""
        told = self.vehicle.telemetry
        return hypot(*told.velocity[:2]) if told else 0.0

    @property
    def notes(self) -> str:
        """What is not as it should be with the drone's settings and sensors."""
        told = self.vehicle.telemetry
        return "; ".join(told.notes) if told else ""

    @property
    def moved(self) -> float:
        """How far tracking has moved it since it came to rest [m]; 0 when unknown."""
        drift = self.vehicle.consistency.drift
        return drift if isfinite(drift) else 0.0

    @property
    def on_pad(self) -> str:
        """How tracking has the drone on its pad, in words."""
        return f"{self.off_pad:.2f} m from it, turned by {degrees(self.turned):.0f} deg"

    @property
    def sight(self) -> str:
        """Whether people without markers are seen, in words."""
        if not self.sees_people:
            return "no sensor"
        return self.vehicle.silence.words if self.vehicle.silence.is_too_long else "yes"

    @property
    def charge_needed(self) -> float:
        """Smallest charge for a take-off, 0 to 1."""
        return self.limits.battery_floor + TAKE_OFF_RESERVE


@dataclass(frozen=True, slots=True)
class PreflightRule:
    """One check: what is looked at, what is allowed, why, and how to mend it.

    Attributes:
        code: short name.
        title: in words.
        fault: what is the matter when it fails, in words.
        passes: whether all is well.
        value, limit: in words.
        why: what would happen otherwise.
        mend: what to do.
        required: no take-off without it ...
        waived: ... but here, where it is told only.
        mend_waived: what to do there, where that differs.
    """

    code: str
    title: str
    fault: str
    passes: Callable[[PreflightInputs], bool]
    value: Callable[[PreflightInputs], str]
    limit: Callable[[PreflightInputs], str]
    why: str
    mend: str
    required: bool = True
    waived: Callable[[PreflightInputs], bool] = lambda _: False
    mend_waived: str = ""

    def check(self, inputs: PreflightInputs) -> PreflightCheck:
        """Return what the check finds."""
        waived = self.waived(inputs)
        return PreflightCheck(
            code=self.code,
            title=self.title,
            fault=self.fault,
            passed=self.passes(inputs),
            required=self.required and not waived,
            value=self.value(inputs),
            limit=self.limit(inputs),
            why=self.why,
            mend=(waived and self.mend_waived) or self.mend,
        )


CHARGE_CHECK = "charge"
"""Code of the check of the battery."""

PREFLIGHT_RULES: tuple[PreflightRule, ...] = (
    PreflightRule(
        "drone_answers",
        "the drone answers",
        "the drone does not answer",
        lambda i: i.vehicle.telemetry_age <= i.limits.telemetry_age,
        lambda i: _age(i.vehicle.telemetry_age),
        lambda i: f"at most {i.limits.telemetry_age:g} s ago",
        "a drone that is not heard cannot be stopped",
        "switch it on, join its Wi-Fi, and see `housefly doctor`",
    ),
    PreflightRule(
        "drone_landed",
        "it stands, by its own word",
        "the drone does not say that it stands",
        lambda i: i.vehicle.status is DroneStatus.LANDED,
        lambda i: i.vehicle.status.value,
        lambda _: "landed",
        "only a drone that stands can take off",
        "press RESET when it is in its emergency state and nobody is near",
    ),
    PreflightRule(
        "drone_upright",
        "it stands on its feet",
        "the drone leans",
        lambda i: i.tilt <= TILT_ON_PAD_MAX,
        lambda i: f"{degrees(i.tilt):.0f} deg",
        lambda _: f"at most {degrees(TILT_ON_PAD_MAX):.0f} deg",
        "a drone that leans takes off sideways",
        "put it level on its pad",
    ),
    PreflightRule(
        "drone_still",
        "it stands still, by its own word",
        "the drone says that it moves while it stands",
        lambda i: i.own_speed <= OWN_SPEED_ON_PAD_MAX,
        lambda i: f"{i.own_speed:.2f} m/s",
        lambda _: f"at most {OWN_SPEED_ON_PAD_MAX:g} m/s",
        "it takes off and holds itself by that speed",
        "look at its bottom camera and the floor below, then switch it off and on",
    ),
    PreflightRule(
        "drone_configured",
        "it has confirmed its limits",
        "the drone has not confirmed its limits",
        lambda i: i.vehicle.configured is True,
        lambda i: "confirmed" if i.vehicle.configured else "not yet",
        lambda _: "confirmed",
        "its own limits of tilt, height and speed hold when everything else fails",
        "wait a few seconds, or switch it off and on",
    ),
    PreflightRule(
        "drone_healthy",
        "it complains about nothing",
        "the drone complains",
        lambda i: not i.vehicle.grounding_faults,
        lambda i: i.vehicle.grounding_faults or "nothing",
        lambda _: "nothing",
        "it would land, or fall, in the middle of its flight",
        "look at propellers, motors and battery, then switch it off and on",
    ),
    PreflightRule(
        CHARGE_CHECK,
        "the battery is charged",
        "the battery is too low",
        lambda i: i.vehicle.battery >= i.charge_needed,
        lambda i: f"{i.vehicle.battery:.0%}" if isfinite(i.vehicle.battery) else "unknown",
        lambda i: f"at least {i.charge_needed:.0%}, and more for a long way",
        "it has to come home, and to land",
        "charge it, or change the battery",
    ),
    PreflightRule(
        "gauge",
        "the battery's gauge moves",
        "the battery's gauge stood still",
        lambda i: not i.vehicle.gauge_stuck,
        lambda i: f"stuck at {i.vehicle.battery:.0%}" if i.vehicle.gauge_stuck else "moving",
        lambda _: "moving",
        "nobody knows how much charge is left",
        "change the battery or restart the drone: take off once it shows another number",
    ),
    PreflightRule(
        "tracking",
        "tracking sees it",
        "tracking does not see the drone",
        lambda i: i.vehicle.pose_age <= i.limits.pose_age_level,
        lambda i: _age(i.vehicle.pose_age),
        lambda i: f"at most {i.limits.pose_age_level:g} s ago",
        "it flies by where tracking sees it",
        "look at the tracking system: is it running, does it stream the body under this name? if it"
        " is only slow, housefly gains says which limits.pose_age_level it needs",
    ),
    PreflightRule(
        "tracked_height",
        "tracking has it where it stands",
        "tracking has the drone at another height",
        lambda i: abs(i.vehicle.height_error) <= HEIGHT_ERROR_MAX,
        lambda i: f"{i.vehicle.height_error:+.2f} m",
        lambda _: f"within {HEIGHT_ERROR_MAX:g} m",
        "a floor at another height is a room at another height",
        "set the tracking system's origin on the floor, and define the drone's body anew",
    ),
    PreflightRule(
        "tracked_place",
        "tracking leaves it where it stands",
        "tracking moves the drone although it stands",
        lambda i: not i.vehicle.consistency.drift > MOVED_ON_GROUND_MAX,
        lambda i: f"moved by {i.moved:.2f} m",
        lambda _: f"at most {MOVED_ON_GROUND_MAX:g} m",
        "tracking that drifts on the ground drifts in the air",
        "see whether another body has its name; lift it once to show where it is",
    ),
    PreflightRule(
        "origin",
        "tracking has seen it on its pad",
        "tracking has not seen the drone on its pad",
        lambda i: i.origin_confirmed,
        lambda i: i.on_pad,
        lambda i: (
            f"once within {i.origin_distance_max:g} m and {degrees(PAD_HEADING_MAX):.0f} deg of it"
        ),
        "where tracking and map disagree, walls are not where they seem",
        "put it on its pad, its nose along it; if it stands so: `housefly preflight --frames`",
    ),
    PreflightRule(
        "stop",
        "nobody has pressed STOP",
        "STOP is latched",
        lambda i: not i.stopped,
        lambda i: "pressed" if i.stopped else "not pressed",
        lambda _: "not pressed",
        "STOP is latched until a person resumes",
        "press Resume when all is well",
    ),
    PreflightRule(
        "take_off_column",
        "nobody and nothing is above or beside it",
        "the way up is not free",
        lambda i: not i.take_off_fault,
        lambda i: i.take_off_fault or "clear",
        lambda _: "clear",
        "it climbs straight up from where it stands",
        "clear the pad",
    ),
    PreflightRule(
        "settings",
        "its settings and sensors are as they should be",
        "a setting or sensor of the drone is wrong",
        lambda i: not i.notes,
        lambda i: i.notes or "yes",
        lambda _: "yes",
        "it may fly otherwise than planned",
        "see the drone's page of the manual",
        required=False,
    ),
    PreflightRule(
        "pad",
        "it stands on its pad",
        "the drone is not on its pad",
        lambda i: i.off_pad <= PAD_DISTANCE_MAX,
        lambda i: f"{i.off_pad:.2f} m from it",
        lambda _: f"within {PAD_DISTANCE_MAX:g} m",
        "if it does stand there, tracking and map disagree, and walls are not where they seem",
        "put it on its pad; if it is there, compare the tracking system's origin with the map",
        required=False,
    ),
    PreflightRule(
        "sees_people",
        "a sensor sees people without markers",
        "people without markers are unseen",
        lambda i: i.sees_people and not i.vehicle.silence.is_too_long,
        lambda i: i.sight,
        lambda i: f"heard within {i.vehicle.silence.limit:g} s",
        "it stops for people, and makes way, only where a sensor sees them",
        "see `housefly sensors`: is each one on, in this network and uncovered?",
        waived=lambda i: not i.sees_people,
        mend_waived="keep people out of the room, or add a scanner or a depth camera to the site",
    ),
    PreflightRule(
        "frames_right",
        "the last frame check found nothing wrong",
        "the last frame check found tracking wrong",
        lambda i: i.frames.state is not FrameCheckState.WRONG,
        lambda i: i.frames.words if i.frames.state is FrameCheckState.WRONG else "nothing known",
        lambda _: "nothing",
        "it would fly where it should not, and land or strike something",
        "mend it as the check said, and check again: `housefly preflight --frames`",
    ),
    PreflightRule(
        "frames_checked",
        "frames checked",
        "frames not checked",
        lambda i: i.frames.state not in (FrameCheckState.NEVER, FrameCheckState.STALE),
        lambda i: i.frames.said,
        lambda _: "since [tracking] was changed",
        "mirrored, turned or shifted axes are noticed only after the drone has moved",
        "carry the drone once, two minutes: `housefly preflight --frames`",
        required=False,
    ),
)
"""All checks, in the order in which a person would look."""


def preflight(inputs: PreflightInputs) -> tuple[PreflightCheck, ...]:
    """Return what every check finds."""
    return tuple(rule.check(inputs) for rule in PREFLIGHT_RULES)


MACHINE_CHECK = "machine"
"""Code of the check of whoever runs the pilot: whether the machine keeps up."""
_LATE_WHEN_BUSY = frozenset({"drone_answers", "drone_configured", "tracking", "sees_people"})
"""Codes of the checks that fail where the machine does not keep up."""


def preflight_refusal(checks: tuple[PreflightCheck, ...]) -> Refused | None:
    """Return why no take-off is allowed, with the likely cause; None where it is."""
    failing = next((one for one in checks if one.required and not one.passed), None)
    if failing is None:
        return None
    outcome = OrderOutcome.BATTERY if failing.code == CHARGE_CHECK else OrderOutcome.PREFLIGHT
    return Refused(outcome, _refusal_words(failing, checks))


def _refusal_words(check: PreflightCheck, checks: tuple[PreflightCheck, ...]) -> str:
    busy = next((c for c in checks if c.code == MACHINE_CHECK and not c.passed), None)
    words = f"{check.fault}: {check.value}, must be {check.limit}"
    if busy is None or check.code not in _LATE_WHEN_BUSY:
        return f"{words}; {check.mend}"
    return f"{words}; likely cause: {busy.fault} ({busy.value}): {busy.mend}"


def _age(seconds: float) -> str:
    return f"last {seconds:.1f} s ago" if isfinite(seconds) else "never"
