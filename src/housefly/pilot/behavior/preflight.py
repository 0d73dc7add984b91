"""The pre-flight checks: what must be right before a take-off, with value, limit, why and mend.

A check that is required and fails refuses the take-off; the others are told.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import degrees, hypot, isfinite, radians

from housefly.config.airframe import Ability
from housefly.config.limits import LimitsConfig
from housefly.messages.flight import OrderOutcome
from housefly.messages.preflight import (
    FRAMES_NOT_NEEDED,
    FrameCheckState,
    FramesKnown,
    PreflightCheck,
)
from housefly.messages.sensing import DroneStatus
from housefly.messages.words import UNSAID, Words, figure, joined, percentage, said
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
        take_off_fault: who or what stands above or beside it, in words, or UNSAID.
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
    take_off_fault: Words = UNSAID
    sees_people: bool = True
    frames: FramesKnown = FRAMES_NOT_NEEDED
    lacks: frozenset[Ability] = frozenset()

    @property
    def unknown(self) -> Words:
        """What the drone does not have that others have, in words."""
        return joined(", ", (said(one) for one in Ability if one in self.lacks & _MISSED))

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
    def notes(self) -> Words:
        """What is not as it should be with the drone's settings and sensors."""
        told = self.vehicle.telemetry
        return joined("; ", told.notes if told else ())

    @property
    def moved(self) -> float:
        """How far tracking has moved it since it came to rest [m]; 0 when unknown."""
        drift = self.vehicle.consistency.drift
        return drift if isfinite(drift) else 0.0

    @property
    def on_pad(self) -> Words:
        """How tracking has the drone on its pad, in words."""
        return Words(
            "{d} m from it, turned by {n} deg",
            d=figure(self.off_pad, ".2f"),
            n=figure(degrees(self.turned), ".0f"),
        )

    @property
    def sight(self) -> Words:
        """Whether people without markers are seen, in words."""
        if not self.sees_people:
            return Words("no sensor")
        return self.vehicle.silence.words if self.vehicle.silence.is_too_long else Words("yes")

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
        applies: whether it is looked at at all.
        required: no take-off without it ...
        waived: ... but here, where it is told only.
        says: what is the matter here, where that says more than ``fault`` and ``value``.
        mend_waived: what to do there, where that differs.
    """

    code: str
    title: Words
    fault: Words
    passes: Callable[[PreflightInputs], bool]
    value: Callable[[PreflightInputs], Words]
    limit: Callable[[PreflightInputs], Words]
    why: Words
    mend: Words
    applies: Callable[[PreflightInputs], bool] = lambda _: True
    required: bool = True
    waived: Callable[[PreflightInputs], bool] = lambda _: False
    mend_waived: Words = UNSAID
    says: Callable[[PreflightInputs], Words] = lambda _: UNSAID

    def check(self, inputs: PreflightInputs) -> PreflightCheck:
        """Return what the check finds."""
        waived = self.waived(inputs)
        return PreflightCheck(
            code=self.code,
            title=self.title,
            fault=self.says(inputs) or self.fault,
            passed=self.passes(inputs),
            required=self.required and not waived,
            value=self.value(inputs),
            limit=self.limit(inputs),
            why=self.why,
            mend=(waived and self.mend_waived) or self.mend,
        )


_MISSED = frozenset({Ability.HOVER, Ability.HEIGHT, Ability.VELOCITY, Ability.ATTITUDE})
"""What counts before a take-off: a camera does not, and every form of setpoints is flown."""
CHARGE_CHECK = "charge"
"""Code of the check of the battery."""

PREFLIGHT_RULES: tuple[PreflightRule, ...] = (
    PreflightRule(
        "drone_answers",
        Words("the drone answers"),
        Words("the drone does not answer"),
        lambda i: i.vehicle.telemetry_age <= i.limits.telemetry_age,
        lambda i: _age(i.vehicle.telemetry_age),
        lambda i: Words("at most {n} s ago", n=figure(i.limits.telemetry_age, "g")),
        Words("a drone that is not heard cannot be stopped"),
        Words("switch it on, join its Wi-Fi, and see `housefly doctor`"),
    ),
    PreflightRule(
        "drone_landed",
        Words("it stands, by its own word"),
        Words("the drone does not say that it stands"),
        lambda i: i.vehicle.status is DroneStatus.LANDED,
        lambda i: said(i.vehicle.status),
        lambda _: Words("landed"),
        Words("only a drone that stands can take off"),
        Words("press RESET when it is in its emergency state and nobody is near"),
    ),
    PreflightRule(
        "drone_upright",
        Words("it stands on its feet"),
        Words("the drone leans"),
        lambda i: i.tilt <= TILT_ON_PAD_MAX,
        lambda i: Words("{n} deg", n=figure(degrees(i.tilt), ".0f")),
        lambda _: Words("at most {n} deg", n=figure(degrees(TILT_ON_PAD_MAX), ".0f")),
        Words("a drone that leans takes off sideways"),
        Words("put it level on its pad"),
    ),
    PreflightRule(
        "drone_still",
        Words("it stands still, by its own word"),
        Words("the drone says that it moves while it stands"),
        lambda i: i.own_speed <= OWN_SPEED_ON_PAD_MAX,
        lambda i: Words("{d} m/s", d=figure(i.own_speed, ".2f")),
        lambda _: Words("at most {d} m/s", d=figure(OWN_SPEED_ON_PAD_MAX, "g")),
        Words("it takes off and holds itself by that speed"),
        Words("look at its bottom camera and the floor below, then switch it off and on"),
    ),
    PreflightRule(
        "drone_configured",
        Words("it has confirmed its limits"),
        Words("the drone has not confirmed its limits"),
        lambda i: i.vehicle.configured is True,
        lambda i: Words("confirmed") if i.vehicle.configured else Words("not yet"),
        lambda _: Words("confirmed"),
        Words("its own limits of tilt, height and speed hold when everything else fails"),
        Words("wait a few seconds, or switch it off and on"),
    ),
    PreflightRule(
        "drone_healthy",
        Words("it complains about nothing"),
        Words("the drone complains"),
        lambda i: not i.vehicle.grounding_faults,
        lambda i: i.vehicle.grounding_faults or Words("nothing"),
        lambda _: Words("nothing"),
        Words("it would land, or fall, in the middle of its flight"),
        Words("look at propellers, motors and battery, then switch it off and on"),
    ),
    PreflightRule(
        CHARGE_CHECK,
        Words("the battery is charged"),
        Words("the battery is too low"),
        lambda i: i.vehicle.battery >= i.charge_needed,
        lambda i: _charge(i.vehicle.battery),
        lambda i: Words("at least {p}%, and more for a long way", p=percentage(i.charge_needed)),
        Words("it has to come home, and to land"),
        Words("charge it, or change the battery"),
    ),
    PreflightRule(
        "gauge",
        Words("the battery's gauge moves"),
        Words("the battery's gauge stood still"),
        lambda i: not i.vehicle.gauge_stuck,
        lambda i: (
            Words("stuck at {p}%", p=percentage(i.vehicle.battery))
            if i.vehicle.gauge_stuck
            else Words("moving")
        ),
        lambda _: Words("moving"),
        Words("nobody knows how much charge is left"),
        Words("change the battery or restart the drone: take off once it shows another number"),
    ),
    PreflightRule(
        "tracking",
        Words("tracking sees it"),
        Words("tracking does not see the drone"),
        lambda i: i.vehicle.pose_age <= i.limits.pose_age_level,
        lambda i: _age(i.vehicle.pose_age),
        lambda i: Words("at most {n} s ago", n=figure(i.limits.pose_age_level, "g")),
        Words("it flies by where tracking sees it"),
        Words(
            "look at the tracking system: is it running, does it stream the body under this name?"
            " if it is only slow, housefly gains says which limits.pose_age_level it needs"
        ),
    ),
    PreflightRule(
        "tracked_height",
        Words("tracking has it where it stands"),
        Words("tracking has the drone at another height"),
        lambda i: abs(i.vehicle.height_error) <= HEIGHT_ERROR_MAX,
        lambda i: Words("{d} m", d=figure(i.vehicle.height_error, "+.2f")),
        lambda _: Words("within {d} m", d=figure(HEIGHT_ERROR_MAX, "g")),
        Words("a floor at another height is a room at another height"),
        Words("set the tracking system's origin on the floor, and define the drone's body anew"),
    ),
    PreflightRule(
        "tracked_place",
        Words("tracking leaves it where it stands"),
        Words("tracking moves the drone although it stands"),
        lambda i: not i.vehicle.consistency.drift > MOVED_ON_GROUND_MAX,
        lambda i: Words("moved by {d} m", d=figure(i.moved, ".2f")),
        lambda _: Words("at most {d} m", d=figure(MOVED_ON_GROUND_MAX, "g")),
        Words("tracking that drifts on the ground drifts in the air"),
        Words("see whether another body has its name; lift it once to show where it is"),
    ),
    PreflightRule(
        "origin",
        Words("tracking has seen it on its pad"),
        Words("tracking has not seen the drone on its pad"),
        lambda i: i.origin_confirmed,
        lambda i: i.on_pad,
        lambda i: Words(
            "once within {d} m and {n} deg of it",
            d=figure(i.origin_distance_max, "g"),
            n=figure(degrees(PAD_HEADING_MAX), ".0f"),
        ),
        Words("where tracking and map disagree, walls are not where they seem"),
        Words(
            "put it on its pad, its nose along it; if it stands so: `housefly preflight --frames`"
        ),
    ),
    PreflightRule(
        "stop",
        Words("nobody has pressed STOP"),
        Words("STOP is latched"),
        lambda i: not i.stopped,
        lambda i: Words("pressed") if i.stopped else Words("not pressed"),
        lambda _: Words("not pressed"),
        Words("STOP is latched until a person resumes"),
        Words("press Resume when all is well"),
    ),
    PreflightRule(
        "take_off_column",
        Words("nobody and nothing is above or beside it"),
        Words("the way up is not free"),
        lambda i: not i.take_off_fault,
        lambda i: UNSAID if i.take_off_fault else Words("clear"),
        lambda _: Words("clear"),
        Words("it climbs straight up from where it stands"),
        Words("make room around the drone"),
        says=lambda i: i.take_off_fault,
    ),
    PreflightRule(
        "settings",
        Words("its settings and sensors are as they should be"),
        Words("a setting or sensor of the drone is wrong"),
        lambda i: not i.notes,
        lambda i: i.notes or Words("yes"),
        lambda _: Words("yes"),
        Words("it may fly otherwise than planned"),
        Words("see the drone's page of the manual"),
        required=False,
    ),
    PreflightRule(
        "abilities",
        Words("it has what others have"),
        Words("the drone lacks what others have"),
        lambda i: not i.unknown,
        lambda i: i.unknown or Words("nothing"),
        lambda _: Words("nothing"),
        Words("rules that need it do not count, and where tracking fails it sinks and lands"),
        Words("fly it where tracking is sure, and keep people away"),
        applies=lambda i: bool(i.unknown),
        required=False,
    ),
    PreflightRule(
        "pad",
        Words("it stands on its pad"),
        Words("the drone is not on its pad"),
        lambda i: i.off_pad <= PAD_DISTANCE_MAX,
        lambda i: Words("{d} m from it", d=figure(i.off_pad, ".2f")),
        lambda _: Words("within {d} m", d=figure(PAD_DISTANCE_MAX, "g")),
        Words(
            "if it does stand there, tracking and map disagree, and walls are not where they seem"
        ),
        Words(
            "put it on its pad; if it is there, compare the tracking system's origin with the map"
        ),
        required=False,
    ),
    PreflightRule(
        "sees_people",
        Words("a sensor sees people without markers"),
        Words("people without markers are unseen"),
        lambda i: i.sees_people and not i.vehicle.silence.is_too_long,
        lambda i: i.sight,
        lambda i: Words("heard within {n} s", n=figure(i.vehicle.silence.limit, "g")),
        Words("it stops for people, and makes way, only where a sensor sees them"),
        Words("see `housefly sensors`: is each one on, in this network and uncovered?"),
        waived=lambda i: not i.sees_people,
        mend_waived=Words(
            "keep people out of the room, or add a scanner or a depth camera to the site"
        ),
    ),
    PreflightRule(
        "frames_right",
        Words("the last frame check found nothing wrong"),
        Words("the last frame check found tracking wrong"),
        lambda i: i.frames.state is not FrameCheckState.WRONG,
        lambda i: (
            i.frames.words if i.frames.state is FrameCheckState.WRONG else Words("nothing known")
        ),
        lambda _: Words("nothing"),
        Words("it would fly where it should not, and land or strike something"),
        Words("mend it as the check said, and check again: `housefly preflight --frames`"),
    ),
    PreflightRule(
        "frames_checked",
        Words("frames checked"),
        Words("frames not checked"),
        lambda i: i.frames.state not in (FrameCheckState.NEVER, FrameCheckState.STALE),
        lambda i: i.frames.said,
        lambda _: Words("since [tracking] was changed"),
        Words("mirrored, turned or shifted axes are noticed only after the drone has moved"),
        Words("carry the drone once, two minutes: `housefly preflight --frames`"),
        required=False,
    ),
)
"""All checks, in the order in which a person would look."""


def preflight(inputs: PreflightInputs) -> tuple[PreflightCheck, ...]:
    """Return what every check finds."""
    return tuple(rule.check(inputs) for rule in PREFLIGHT_RULES if rule.applies(inputs))


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


def _refusal_words(check: PreflightCheck, checks: tuple[PreflightCheck, ...]) -> Words:
    busy = next((c for c in checks if c.code == MACHINE_CHECK and not c.passed), None)
    if busy is None or check.code not in _LATE_WHEN_BUSY:
        return check.refusal
    return Words(
        "{why}: {found}, must be {limit}; likely cause: {cause} ({value}): {mend}",
        why=check.fault,
        found=check.value,
        limit=check.limit,
        cause=busy.fault,
        value=busy.value,
        mend=busy.mend,
    )


def _age(seconds: float) -> Words:
    if not isfinite(seconds):
        return Words("never")
    return Words("last {n} s ago", n=figure(seconds, ".1f"))


def _charge(charge: float) -> Words:
    return Words("{p}%", p=percentage(charge)) if isfinite(charge) else Words("unknown")
