"""Whether somebody moves the drone by hand now, and who, as the pilot tells it."""

from __future__ import annotations

from housefly.messages import EventCode, Phase, PilotStep


def moved_by(before: str | None, step: PilotStep) -> str | None:
    """Return who moves the drone by hand, "" without a name; None while nobody does.

    Args:
        before: what was returned of the step before; None at a pilot's first.
        step: the newest step.
    """
    who = before
    for event in step.outputs.events:
        if event.code is EventCode.NUDGE_BEGAN:
            who = event.text.value("who")
        elif event.code is EventCode.NUDGE_ENDED:
            who = None
    return who if step.outputs.phase is Phase.HOLDING else None
