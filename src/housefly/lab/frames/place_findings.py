"""What is wrong with angles and places of the frame of tracking, and with the way back."""

from __future__ import annotations

from math import dist, hypot, radians

from housefly.config.tracking import TrackingConfig
from housefly.lab.frames.corrections import lines_words
from housefly.lab.frames.findings import FrameFault, FrameFinding, FrameMeasures
from housefly.lab.frames.plan import CarryStep
from housefly.lab.frames.plausibility import turned_words
from housefly.lab.frames.samples import FrameSample
from housefly.numeric import wrapped

ANGLE_MAX = radians(15.0)
"""A frame or body turned by more than this is wrong [rad]; people lay and carry to about 8 deg."""
ORIGIN_MAX = 0.3
"""A pad that is seen farther than this from the pad of the map is wrong [m]."""
FLOOR_HEIGHT_MAX = 0.15
"""A drone on the floor that is seen so far from where it stands is wrong [m]."""
BACK_MAX = 0.3
"""The way back ends so near to its beginning [m]."""


def angle_and_place_findings(
    measures: FrameMeasures, tracking: TrackingConfig, mended: dict[str, float | str]
) -> list[FrameFinding]:
    """Return what is wrong with angles and places; a mend names the lines of the site file."""
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


def back_findings(by_step: dict[CarryStep, FrameSample], scale: float) -> list[FrameFinding]:
    """Return whether the way back ended where the first began."""
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
