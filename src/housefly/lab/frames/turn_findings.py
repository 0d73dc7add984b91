"""What is wrong with headings while the drone is turned."""

from __future__ import annotations

from math import radians

from housefly.lab.frames.findings import FrameFault, FrameFinding
from housefly.lab.frames.plan import QUARTER_TURN, CarryStep
from housefly.lab.frames.plausibility import onboard_turn, turned_words
from housefly.lab.frames.samples import FrameSample
from housefly.numeric import wrapped


def turn_findings(
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
