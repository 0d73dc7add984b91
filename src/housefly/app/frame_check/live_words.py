"""What tracking and drone say now, in one line, beside what was asked."""

from __future__ import annotations

from math import degrees

from housefly.app.frame_check.frame_log import FrameLog
from housefly.lab.frames.guide import CarryGuide
from housefly.lab.frames.plausibility import direction_words
from housefly.lab.frames.samples import SEEN_AGE_MAX
from housefly.numeric import wrapped


def live_words(guide: CarryGuide, log: FrameLog, now: float) -> str:
    """Return what is seen now [s]: how far from the last sample, and which way it looks."""
    return f"{_tracked(guide, log, now)}; {_onboard(guide, log, now)}"


def _tracked(guide: CarryGuide, log: FrameLog, now: float) -> str:
    body, point = guide.tracking.body, log.newest(guide.tracking.body)
    if point is None or now - point.at > SEEN_AGE_MAX:
        others = [repr(name) for name in log.names(now - SEEN_AGE_MAX) if name != body]
        return f"tracking: {body!r} not seen (seen: {', '.join(others) or 'nothing'})"
    x, y, z = point.position
    last = guide.samples[-1] if guide.samples else None
    if last is None or last.position is None:
        nose = degrees(wrapped(point.yaw - guide.plan.heading))
        return f"tracking: at ({x:.2f}, {y:.2f}, {z:.2f}) m, nose {nose:+.0f} deg off the pad's"
    ax, ay, az = last.position
    nose = degrees(wrapped(point.yaw - last.yaw))
    way = direction_words(guide.plan, (x - ax, y - ay, 0.0))
    return f"tracking: {way}, {z - az + 0.0:+.2f} m up, turned {nose:+.0f} deg"


def _onboard(guide: CarryGuide, log: FrameLog, now: float) -> str:
    point = log.newest_onboard
    if point is None or now - point.at > 1.0:
        return "the drone: silent"
    last = guide.samples[-1] if guide.samples else None
    if last is None or last.psi is None:
        return f"the drone: {point.height:.2f} m high"
    turned = degrees(wrapped(point.psi - last.psi))
    return f"the drone: turned {turned:+.0f} deg, {point.height:.2f} m high"
