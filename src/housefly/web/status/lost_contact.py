"""What the drone does without this page, or without its pilot: ``docs/safety.md`` in a sentence.

Whoever loses contact cannot see what comes next; these words are what held at the last moment.
"""

from __future__ import annotations

from housefly.messages import Phase, SafetyMode
from housefly.messages.sensing import AIRBORNE_STATUSES, DroneStatus
from housefly.messages.words import Number, Words, figure
from housefly.web.status.console_knowledge import ConsoleKnowledge
from housefly.web.status.goal_words import goal_words

_SECONDS_BY_ITSELF = 120.0
"""``limits.hold_timeout`` where the room does not tell it [s]."""
NOBODY_TOLD = Words("nobody has told yet what the drone does")

_BY_SAFETY: dict[SafetyMode, Words] = {
    SafetyMode.HOLD: Words(
        "it hovers until what is wrong is over, and lands by itself if that lasts"
    ),
    SafetyMode.RETURN: Words("it goes on coming home for safety, and lands"),
    SafetyMode.STOPPED: Words(
        "it hovers where it is until somebody resumes, and lands by itself when charge or time run"
        " out"
    ),
    SafetyMode.LAND: Words("it goes on landing where it is"),
    SafetyMode.DESCEND: Words("it goes on sinking to the floor where it is"),
    SafetyMode.CUT: Words("its motors are being cut: it falls"),
}


def if_page_is_lost(known: ConsoleKnowledge) -> Words:
    """Return what the drone does when this page, or the server of it, is gone: the pilot goes on.

    The sentence has no subject but "it"; UNSAID is never returned.
    """
    if not known.pilot_is_heard or not known.drone_is_heard:
        return without_word(known)
    if not known.airborne:
        return Words("it stays on the ground: nothing moves it without a fresh order")
    return _going_on(known)


def without_word(known: ConsoleKnowledge) -> Words:
    """Return what is to be reckoned with while pilot or drone are silent."""
    is_unknown = known.last_status is DroneStatus.UNKNOWN
    if known.step is None or (is_unknown and not known.may_be_airborne):
        return NOBODY_TOLD
    if not known.may_be_airborne:
        return Words(
            "the drone was on the ground when it was last heard; without a pilot nothing moves it"
        )
    if known.pilot_is_heard or known.step.outputs.phase is Phase.IDLE:
        if known.last_status not in AIRBORNE_STATUSES:
            return NOBODY_TOLD
        return Words(
            "it was in the air when it was last heard; landing is asked on, and a drone that hears"
            " nobody brakes and lands by itself"
        )
    return Words(
        "if the pilot has ended, the drone brakes and lands by itself within seconds; if only its"
        " word is lost, {then}",
        then=_going_on(known),
    )


def _going_on(known: ConsoleKnowledge) -> Words:
    """Return what a pilot that goes on makes the drone do."""
    assert known.step is not None
    out = known.step.outputs
    return _BY_SAFETY.get(out.safety) or _by_phase(known, out.phase)


def _by_phase(known: ConsoleKnowledge, phase: Phase) -> Words:
    assert known.step is not None
    goal = goal_title(known)
    wait = known.room.limits.get("hold_timeout") if known.room else None
    n = figure(wait or _SECONDS_BY_ITSELF, ".0f")
    if phase is Phase.TAKING_OFF or known.last_status is DroneStatus.TAKING_OFF:
        return _after_take_off(goal, n) if known.step.outputs.goal_name else _after_rising(n)
    match phase:
        case Phase.OUTBOUND:
            return Words(
                "it flies on to {goal}, then comes home and lands by itself within {n} s",
                goal=goal,
                n=n,
            )
        case Phase.LOOKING:
            return Words("it looks to the end, then comes home and lands by itself")
        case Phase.RETURNING:
            return Words("it flies on home and lands by itself")
        case Phase.LANDING:
            return Words("it goes on landing")
    return Words("it hovers where it is, then comes home and lands by itself within {n} s", n=n)


def _after_take_off(goal: str, n: Number) -> Words:
    return Words(
        "it goes on taking off, flies on to {goal}, then comes home and lands by itself within"
        " {n} s",
        goal=goal,
        n=n,
    )


def _after_rising(n: Number) -> Words:
    return Words(
        "it goes on taking off, hovers, then comes home and lands by itself within {n} s", n=n
    )


def goal_title(known: ConsoleKnowledge) -> str:
    """Return the title of where the mission goes."""
    name = known.step.outputs.goal_name if known.step else ""
    places = known.room.places if known.room else ()
    return goal_words(name, places, known.task_subject) or Words("its goal")
