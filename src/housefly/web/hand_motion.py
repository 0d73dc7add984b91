"""Whether somebody moves the drone by hand now, and who: the pilot's own words, as they come."""

from __future__ import annotations

from housefly.messages import EventCode, Phase, PilotStep


def hand_motion_words(before: str, step: PilotStep) -> str:
    """Return the pilot's words while the drone is moved by hand; "" while nobody moves it.

    Args:
        before: what was returned of the step before; "" at a pilot's first.
        step: the newest step.
    """
    words = before
    for event in step.outputs.events:
        if event.code is EventCode.NUDGE_BEGAN:
            words = event.text
        elif event.code is EventCode.NUDGE_ENDED:
            words = ""
    return words if step.outputs.phase is Phase.HOLDING else ""
