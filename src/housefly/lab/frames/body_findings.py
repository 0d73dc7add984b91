"""Whether the body that tracking calls the drone is the drone at all."""

from __future__ import annotations

from itertools import pairwise
from math import dist

from housefly.config.tracking import TrackingConfig
from housefly.geometry import Vec3
from housefly.lab.frames.findings import FrameFault, FrameFinding
from housefly.lab.frames.plan import CarryPlan, CarryStep
from housefly.lab.frames.samples import FrameSample

STILL_MAX = 0.2
"""A body that moved less than this on every way was not carried [m]."""
_CARRIED = (0.6, 1.6)
"""A body that went so far was carried, in shares of the ways that were asked."""
_LEGS = (CarryStep.PAD, CarryStep.AHEAD, CarryStep.SIDE, CarryStep.LIFT)


def body_findings(
    plan: CarryPlan, tracking: TrackingConfig, by_step: dict[CarryStep, FrameSample]
) -> tuple[FrameFinding, ...]:
    """Return what is wrong with the body, or nothing when it was carried as asked."""
    places = [by_step[step].position for step in _LEGS]
    seen = [place for place in places if place is not None]
    if len(seen) == len(places) and max(_ways(seen)) >= STILL_MAX:
        return ()
    carried = _carried_body(plan, by_step)
    state = "stayed where it was" if seen else "was not seen"
    if carried:
        return (
            FrameFinding(
                FrameFault.WRONG_BODY,
                f"While the drone was carried, the body {tracking.body!r} {state}, and"
                f" {carried!r} was carried",
                f'the drone bears the wrong name; in the site file: [tracking] body = "{carried}"'
                " (or exchange the names in the tracking system)",
            ),
        )
    if len(seen) < len(places):
        others = ", ".join(repr(name) for name, _ in by_step[CarryStep.PAD].others) or "none"
        return (
            FrameFinding(
                FrameFault.NOT_SEEN,
                f"The body {tracking.body!r} was not seen; other bodies seen: {others}",
                "start the streaming of rigid bodies, and name the drone's body so; or set"
                " [tracking] body in the site file to the name that it has",
            ),
        )
    return (
        FrameFinding(
            FrameFault.NO_MOVEMENT,
            f"While the drone was carried, the body {tracking.body!r} stayed where it was, and no"
            " other body was carried",
            "is the tracking system live (not paused, not a recording)? Is the body defined with"
            " the drone's own markers, and streamed in metres?",
        ),
    )


def _ways(places: list[Vec3]) -> list[float]:
    return [dist(a, b) for a, b in pairwise(places)]


def _carried_body(plan: CarryPlan, by_step: dict[CarryStep, FrameSample]) -> str:
    """Return the other body that went as the drone should have, or ""."""
    tables = [dict(by_step[step].others) for step in _LEGS]
    names = set(tables[0]).intersection(*tables[1:])
    best, found = "", _CARRIED[1]
    for name in sorted(names):
        ahead, side, _ = _ways([table[name] for table in tables])
        scales = ahead / abs(plan.forward), side / abs(plan.left)
        off = sum(abs(scale - 1.0) for scale in scales)
        if all(_CARRIED[0] <= scale <= _CARRIED[1] for scale in scales) and off < found:
            best, found = name, off
    return best
