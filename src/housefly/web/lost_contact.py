"""What the drone does without this page, or without its pilot: ``docs/safety.md`` in a sentence.

Whoever loses contact cannot see what comes next; these words are what held at the last moment.
"""

from __future__ import annotations

from housefly.messages import Phase, SafetyMode
from housefly.messages.sensing import AIRBORNE_STATUSES, DroneStatus
from housefly.web.console_knowledge import ConsoleKnowledge
from housefly.web.goal_words import goal_words

_SECONDS_BY_ITSELF = 120.0
"""``limits.hold_timeout`` where the room does not tell it [s]."""
NOBODY_TOLD = "nobody has told yet what the drone does"
_HOME = "comes home and lands by itself"

_BY_SAFETY: dict[SafetyMode, str] = {
    SafetyMode.HOLD: "it hovers until what is wrong is over, and lands by itself if that lasts",
    SafetyMode.RETURN: "it goes on coming home for safety, and lands",
    SafetyMode.STOPPED: "it hovers where it is until somebody resumes, and lands by itself when"
    " charge or time run out",
    SafetyMode.LAND: "it goes on landing where it is",
    SafetyMode.DESCEND: "it goes on sinking to the floor where it is",
    SafetyMode.CUT: "its motors are being cut: it falls",
}


def if_page_is_lost(known: ConsoleKnowledge) -> str:
    """Return what the drone does when this page, or the server of it, is gone: the pilot goes on.

    The sentence has no subject but "it"; "" is never returned.
    """
    if not known.pilot_is_heard or not known.drone_is_heard:
        return without_word(known)
    if not known.airborne:
        return "it stays on the ground: nothing moves it without a fresh order"
    return _going_on(known)


def without_word(known: ConsoleKnowledge) -> str:
    """Return what is to be reckoned with while pilot or drone are silent."""
    is_unknown = known.last_status is DroneStatus.UNKNOWN
    if known.step is None or (is_unknown and not known.may_be_airborne):
        return NOBODY_TOLD
    if not known.may_be_airborne:
        return (
            "the drone was on the ground when it was last heard; without a pilot nothing moves it"
        )
    if known.pilot_is_heard or known.step.outputs.phase is Phase.IDLE:
        if known.last_status not in AIRBORNE_STATUSES:
            return NOBODY_TOLD
        return (
            "it was in the air when it was last heard; landing is asked on, and a drone that hears"
            " nobody brakes and lands by itself"
        )
    return (
        "if the pilot has ended, the drone brakes and lands by itself within seconds; if only its"
        f" word is lost, {_going_on(known)}"
    )


def _going_on(known: ConsoleKnowledge) -> str:
    """Return what a pilot that goes on makes the drone do."""
    assert known.step is not None
    out = known.step.outputs
    return _BY_SAFETY.get(out.safety) or _by_phase(known, out.phase)


def _by_phase(known: ConsoleKnowledge, phase: Phase) -> str:
    assert known.step is not None
    goal = goal_title(known)
    wait = known.room.limits.get("hold_timeout") if known.room else None
    waits = f"within {(wait or _SECONDS_BY_ITSELF):.0f} s"
    if phase is Phase.TAKING_OFF or known.last_status is DroneStatus.TAKING_OFF:
        then = f"flies on to {goal}" if known.step.outputs.goal_name else "hovers"
        return f"it goes on taking off, {then}, then {_HOME} {waits}"
    return {
        Phase.OUTBOUND: f"it flies on to {goal}, then {_HOME} {waits}",
        Phase.LOOKING: f"it looks to the end, then {_HOME}",
        Phase.RETURNING: "it flies on home and lands by itself",
        Phase.LANDING: "it goes on landing",
    }.get(phase, f"it hovers where it is, then {_HOME} {waits}")


def goal_title(known: ConsoleKnowledge) -> str:
    """Return the title of where the mission goes."""
    name = known.step.outputs.goal_name if known.step else ""
    places = known.room.places if known.room else ()
    return goal_words(name, places, known.task_subject) or "its goal"
