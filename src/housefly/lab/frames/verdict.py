"""From samples of a carried drone to what is wrong with its frames; pure.

What makes all else meaningless is told alone: a body that is not seen or not the drone, an axis
that does not point up. Then mirrors, then scale, then angles and offsets, then the delay.
"""

from __future__ import annotations

from math import acos, hypot, radians

from housefly.config.tracking import TrackingConfig
from housefly.lab.frames.body_findings import body_findings
from housefly.lab.frames.corrections import (
    corrected_keys,
    mirrored_words,
    snapped,
    up_axis_finding,
)
from housefly.lab.frames.delay_findings import lag_findings
from housefly.lab.frames.findings import FrameFault, FrameFinding, FrameMeasures, FrameVerdict
from housefly.lab.frames.place_findings import (
    ANGLE_MAX,
    FLOOR_HEIGHT_MAX,
    ORIGIN_MAX,
    angle_and_place_findings,
    back_findings,
)
from housefly.lab.frames.plan import CarryPlan, CarryStep
from housefly.lab.frames.samples import FrameSample, middle_angle
from housefly.lab.frames.turn_findings import turn_findings
from housefly.lab.frames.ways import CarriedWays, carried_ways, length_findings

UPRIGHT_MAX = radians(40.0)
STANDING = 0.05
"""Height of the drone's body above the floor on which it lies [m], about."""


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
    ways = carried_ways(plan, by_step)
    if acos(max(-1.0, min(1.0, ways.lift[2] / hypot(*ways.lift)))) > UPRIGHT_MAX:
        return FrameVerdict((up_axis_finding(ways.lift, tracking),))
    findings, notes = turn_findings(by_step)
    scale = sum(ways.scales) / 2
    if ways.is_mirrored:
        findings.insert(0, _mirrored(ways, findings))
    findings += length_findings(ways, scale)
    measures = FrameMeasures(scale=scale, lag=lag)
    mended: dict[str, float | str] = {}
    if not findings or all(found.fault is FrameFault.HEADING_UNCLEAR for found in findings):
        measures = _measures(plan, by_step, ways, scale, lag)
        mended = _mended(plan, tracking, by_step[CarryStep.PAD], measures)
        findings += angle_and_place_findings(measures, tracking, mended)
    findings += lag_findings(lag, tracking, mended)
    if lag is None:
        notes.append(
            "the delay of tracking was not measured: the drone itself told of no turn, or tracking"
            " lost it meanwhile"
        )
    findings += back_findings(by_step, scale)
    return FrameVerdict(tuple(findings), measures, mended, tuple(notes))


def _mirrored(ways: CarriedWays, turns: list[FrameFinding]) -> FrameFinding:
    twice = middle_angle([seen + asked for seen, asked in zip(ways.seen, ways.asked, strict=True)])
    headings_too = any(found.fault is FrameFault.TURN_MIRRORED for found in turns)
    what, mend = mirrored_words(twice, headings_too)
    return FrameFinding(FrameFault.MIRRORED, what, mend)


def _measures(
    plan: CarryPlan,
    by_step: dict[CarryStep, FrameSample],
    ways: CarriedWays,
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
    return corrected_keys(tracking, pad.position, plan.home if is_moved else None, turn, nose, rise)
