"""From samples of a carried drone to what is wrong with its frames; pure.

What makes all else meaningless is told alone: a body that is not seen or not the drone, an axis
that does not point up. Then mirrors, then scale, then angles and offsets, then the delay.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import acos, atan2, degrees, dist, hypot, pi, radians

from housefly.config.tracking import TrackingConfig
from housefly.geometry import Vec3
from housefly.lab.frames.body_findings import body_findings
from housefly.lab.frames.doubts import onboard_turn, turned_words
from housefly.lab.frames.findings import FrameFault, FrameFinding, FrameMeasures, FrameVerdict
from housefly.lab.frames.mends import (
    late_mend,
    lines_words,
    mended_keys,
    mirrored_words,
    scale_mend,
    snapped,
    up_axis_finding,
)
from housefly.lab.frames.plan import QUARTER_TURN, CarryPlan, CarryStep
from housefly.lab.frames.samples import FrameSample, middle_angle
from housefly.numeric import wrapped

ANGLE_MAX = radians(15.0)
"""A frame or body turned by more than this is wrong [rad]; people lay and carry to about 8 deg."""
ORIGIN_MAX = 0.3
"""A pad that is seen farther than this from the pad of the map is wrong [m]."""
FLOOR_HEIGHT_MAX = 0.15
"""A drone on the floor that is seen so far from where it stands is wrong [m]."""
SCALE_RANGE = (0.8, 1.25)
"""Seen over true length that a tape and a person come to."""
EVEN_RANGE = (0.7, 1.43)
"""Ratio of the two seen ways that a tape and a person come to."""
LAG_ALLOWED = 0.1
"""Longest delay of tracking that is right [s]."""
EARLY_ALLOWED = 0.25
"""Reports of a drone come later than this only over a bad link [s]."""
BACK_MAX = 0.3
"""The way back ends so near to its beginning [m]."""
UPRIGHT_MAX = radians(40.0)
STANDING = 0.05
"""Height of the drone's body above the floor on which it lies [m], about."""


@dataclass(frozen=True, slots=True)
class _Ways:
    """The ways as seen, and as they were [m]."""

    ahead: Vec3
    side: Vec3
    lift: Vec3
    asked: tuple[float, float]
    """Headings of the two ways over the floor on the map [rad]."""
    true: tuple[float, float]
    """Their lengths [m]."""

    @property
    def scales(self) -> tuple[float, float]:
        """Seen over true lengths of the two ways."""
        return hypot(*self.ahead) / self.true[0], hypot(*self.side) / self.true[1]

    @property
    def seen(self) -> tuple[float, float]:
        """Headings of the two ways as seen [rad]."""
        return atan2(self.ahead[1], self.ahead[0]), atan2(self.side[1], self.side[0])

    @property
    def is_mirrored(self) -> bool:
        turned, asked = (wrapped(b - a) for a, b in (self.seen, self.asked))
        return turned * asked < 0.0


def frame_verdict(
    plan: CarryPlan,
    tracking: TrackingConfig,
    samples: tuple[FrameSample, ...],
    lag: float | None = None,
) -> FrameVerdict:
    """Return what is wrong.

    Args:
        plan: what was asked.
        tracking: as configured while the samples were taken.
        samples: one of each step, in their order.
        lag: of tracking against the drone's own heading [s], None when unknown.
    """
    by_step = {sample.step: sample for sample in samples}
    found = body_findings(plan, tracking, by_step)
    if found:
        return FrameVerdict(found)
    ways = _ways_of(plan, by_step)
    if acos(max(-1.0, min(1.0, ways.lift[2] / hypot(*ways.lift)))) > UPRIGHT_MAX:
        return FrameVerdict((up_axis_finding(ways.lift, tracking),))
    findings, notes = _turn_findings(by_step)
    scale = sum(ways.scales) / 2
    if ways.is_mirrored:
        findings.insert(0, _mirrored(ways, findings))
    findings += _length_findings(ways, scale)
    measures = FrameMeasures(scale=scale, lag=lag)
    mended: dict[str, float | str] = {}
    if not findings or all(found.fault is FrameFault.HEADING_UNCLEAR for found in findings):
        measures = _measures(plan, by_step, ways, scale, lag)
        mended = _mended(plan, tracking, by_step[CarryStep.PAD], measures)
        findings += _angle_and_place_findings(measures, tracking, mended)
    findings += _lag_findings(lag, tracking, mended)
    if lag is None:
        notes.append(
            "the delay of tracking was not measured: the drone itself told of no turn, or tracking"
            " lost it meanwhile"
        )
    findings += _back_findings(by_step, scale)
    return FrameVerdict(tuple(findings), measures, mended, tuple(notes))


def _ways_of(plan: CarryPlan, by_step: dict[CarryStep, FrameSample]) -> _Ways:
    place = {step: sample.position or (0.0, 0.0, 0.0) for step, sample in by_step.items()}
    ahead, side = (plan.displacement(step) for step in (CarryStep.AHEAD, CarryStep.SIDE))
    return _Ways(
        ahead=_from_to(place[CarryStep.PAD], place[CarryStep.AHEAD]),
        side=_from_to(place[CarryStep.AHEAD], place[CarryStep.SIDE]),
        lift=_from_to(place[CarryStep.SIDE], place[CarryStep.LIFT]),
        asked=(atan2(ahead[1], ahead[0]), atan2(side[1], side[0])),
        true=(hypot(*ahead), hypot(*side)),
    )


def _mirrored(ways: _Ways, turns: list[FrameFinding]) -> FrameFinding:
    twice = middle_angle([seen + asked for seen, asked in zip(ways.seen, ways.asked, strict=True)])
    headings_too = any(found.fault is FrameFault.TURN_MIRRORED for found in turns)
    what, mend = mirrored_words(twice, headings_too)
    return FrameFinding(FrameFault.MIRRORED, what, mend)


def _turn_findings(
    by_step: dict[CarryStep, FrameSample],
) -> tuple[list[FrameFinding], list[str]]:
    """Return what is wrong with headings on a turn, and what could not be checked."""
    before, after = by_step[CarryStep.LIFT], by_step[CarryStep.TURN]
    seen, said = wrapped(after.yaw - before.yaw), onboard_turn(before, after)
    notes = []
    if said is None:
        notes.append("the drone did not tell its heading: the turn is believed as it was asked")
    true = QUARTER_TURN if said is None else said
    if abs(true) < radians(30.0):
        return [], [*notes, "the drone was hardly turned: headings were not checked"]
    tolerance = radians(30.0)
    if abs(wrapped(seen - true)) < tolerance:
        return [], notes
    words = f"turned {turned_words(true)}, it is seen to turn {turned_words(seen)}"
    if abs(wrapped(seen + true)) < tolerance:
        return [
            FrameFinding(
                FrameFault.TURN_MIRRORED,
                f"Headings are mirrored: {words}",
                "the tracking system streams left-handed axes, or quaternions in another order:"
                " choose right-handed axes there",
            )
        ], notes
    if abs(seen) < radians(12.0):
        return [
            FrameFinding(
                FrameFault.NO_HEADING,
                f"Tracking has no heading of it: {words}",
                "define the body with four or more markers that are not symmetric, and stream its"
                " rotation too",
            )
        ], notes
    return [
        FrameFinding(
            FrameFault.HEADING_UNCLEAR,
            f"Headings disagree: {words}",
            "check again; if it comes again, define the body anew: its markers may be symmetric",
        )
    ], notes


def _length_findings(ways: _Ways, scale: float) -> list[FrameFinding]:
    first, second = ways.scales
    if not EVEN_RANGE[0] <= first / second <= EVEN_RANGE[1]:
        return [
            FrameFinding(
                FrameFault.UNEVEN,
                f"One way is seen {first:.2f} times as long as it was, the other {second:.2f}"
                " times",
                "measure with a tape and check again; if it comes again, calibrate the cameras",
            )
        ]
    angle = abs(wrapped(ways.seen[1] - ways.seen[0]))
    if abs(angle - pi / 2) > radians(35.0):
        return [
            FrameFinding(
                FrameFault.UNEVEN,
                f"Two ways at a right angle are seen {degrees(angle):.0f} deg apart",
                "check again; if it comes again, calibrate the cameras",
            )
        ]
    if SCALE_RANGE[0] <= scale <= SCALE_RANGE[1]:
        return []
    words = f"Ways are seen {scale:.4g} times as long as they are"
    return [FrameFinding(FrameFault.SCALE, words, scale_mend(scale))]


def _measures(
    plan: CarryPlan,
    by_step: dict[CarryStep, FrameSample],
    ways: _Ways,
    scale: float,
    lag: float | None,
) -> FrameMeasures:
    rotation = middle_angle(
        [seen - asked for seen, asked in zip(ways.seen, ways.asked, strict=True)]
    )
    pad, ahead, side = (by_step[step] for step in (CarryStep.PAD, CarryStep.AHEAD, CarryStep.SIDE))
    noses = [middle_angle([a.yaw, b.yaw]) for a, b in ((pad, ahead), (ahead, side))]
    body_yaw = middle_angle(
        [
            nose - (seen - asked + plan.heading)
            for nose, seen, asked in zip(noses, ways.seen, ways.asked, strict=True)
        ]
    )
    x, y, z = pad.position or (0.0, 0.0, 0.0)
    return FrameMeasures(
        scale=scale,
        rotation=rotation,
        body_yaw=body_yaw,
        origin=(x - plan.home[0], y - plan.home[1]),
        height=z - STANDING,
        lag=lag,
    )


def _mended(
    plan: CarryPlan, tracking: TrackingConfig, pad: FrameSample, measures: FrameMeasures
) -> dict[str, float | str]:
    """Return the keys of the site file that mend angles and places that are wrong."""
    rotation, body_yaw, height = measures.rotation, measures.body_yaw, measures.height
    assert rotation is not None and body_yaw is not None and height is not None
    assert measures.origin is not None and pad.position is not None
    turn = snapped(rotation) if abs(rotation) > ANGLE_MAX else 0.0
    nose = snapped(body_yaw) if abs(body_yaw) > ANGLE_MAX else 0.0
    is_moved = turn != 0.0 or hypot(*measures.origin) > ORIGIN_MAX
    rise = height if abs(height) > FLOOR_HEIGHT_MAX else 0.0
    return mended_keys(tracking, pad.position, plan.home if is_moved else None, turn, nose, rise)


def _angle_and_place_findings(
    measures: FrameMeasures, tracking: TrackingConfig, mended: dict[str, float | str]
) -> list[FrameFinding]:
    rotation, body_yaw, height = measures.rotation, measures.body_yaw, measures.height
    assert rotation is not None and body_yaw is not None and height is not None
    assert measures.origin is not None
    x, y = measures.origin
    found = []
    if abs(rotation) > ANGLE_MAX:
        found.append(
            FrameFinding(
                FrameFault.ROTATED,
                f"The frame of tracking is turned {turned_words(rotation)} against the map",
                f"set its axes along the map's, or: {lines_words(mended, 'yaw', 'x', 'y')}",
            )
        )
    if abs(body_yaw) > ANGLE_MAX:
        found.append(
            FrameFinding(
                FrameFault.BODY_YAW,
                f"The tracked body {tracking.body!r} is defined turned: its x axis points"
                f" {turned_words(body_yaw)} of the drone's nose",
                "define the body anew with the nose along x, or:"
                f" {lines_words(mended, 'body_yaw')}",
            )
        )
    if hypot(x, y) > ORIGIN_MAX:
        found.append(
            FrameFinding(
                FrameFault.ORIGIN,
                f"The pad is seen {hypot(x, y):.2f} m from the pad of the map: x {x:+.2f} m,"
                f" y {y:+.2f} m",
                f"put the origin where the map has it, or: {lines_words(mended, 'x', 'y')}",
            )
        )
    if abs(height) > FLOOR_HEIGHT_MAX:
        found.append(
            FrameFinding(
                FrameFault.HEIGHT,
                f"A drone on the floor is seen {height:+.2f} m from where it stands",
                f"set the origin on the floor, or: {lines_words(mended, 'z')}",
            )
        )
    return found


def _lag_findings(
    lag: float | None, tracking: TrackingConfig, mended: dict[str, float | str]
) -> list[FrameFinding]:
    if lag is None or -EARLY_ALLOWED <= lag <= LAG_ALLOWED:
        return []
    if lag > 0.0:
        words = (
            f"Tracking sees a turn {lag:.2f} s after the drone feels it, and says that its poses"
            " are fresh"
        )
        return [FrameFinding(FrameFault.LATE, words, late_mend(lag, tracking, mended))]
    return [
        FrameFinding(
            FrameFault.EARLY,
            f"The drone tells of a turn {-lag:.2f} s after tracking sees it",
            "its radio link is slow, or tracking.latency is set too long: go nearer with the"
            " computer, choose a free Wi-Fi channel, and check again",
        )
    ]


def _back_findings(by_step: dict[CarryStep, FrameSample], scale: float) -> list[FrameFinding]:
    first, last = by_step[CarryStep.PAD], by_step.get(CarryStep.BACK)
    if last is None or first.position is None or last.position is None:
        return []
    off, turned = dist(first.position, last.position), wrapped(last.yaw - first.yaw)
    if off <= BACK_MAX * max(1.0, scale) and abs(turned) <= radians(30.0):
        return []
    return [
        FrameFinding(
            FrameFault.NOT_BACK,
            f"Back on its pad it is seen {off:.2f} m and {turned_words(turned)} from where it was"
            " at first",
            "tracking jumped, or took another body for it on the way: calibrate the cameras, define"
            " the body with markers that are not symmetric, and check again",
        )
    ]


def _from_to(a: Vec3, b: Vec3) -> Vec3:
    return b[0] - a[0], b[1] - a[1], b[2] - a[2]
