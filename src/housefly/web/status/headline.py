"""The state of the drone in one line: a shape, a few words, and what more there is to say."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from math import dist

from housefly.messages import DroneStatus, Phase, SafetyMode
from housefly.messages.words import UNSAID, Words, figure, joined
from housefly.web.messages.verdict_message import (
    FlightObjection,
    HeadlineShape,
    Standing,
    StopProgress,
)
from housefly.web.status.console_knowledge import ConsoleKnowledge, last_seen, place_in_words
from housefly.web.status.goal_words import goal_words
from housefly.web.status.lost_contact import NOBODY_TOLD, goal_title


@dataclass(frozen=True, slots=True)
class Headline:
    """One line."""

    shape: HeadlineShape
    text: Words
    detail: Words = UNSAID


def headline(known: ConsoleKnowledge, reasons: tuple[FlightObjection, ...]) -> Headline:
    """Return the line for what is known; the worst that is true comes first."""
    if known.step is None:
        return Headline(HeadlineShape.LOST, Words("Waiting for the pilot"))
    if not known.pilot_is_heard:
        detail = _since(known.step_age, _last_status(known))
        return Headline(HeadlineShape.LOST, Words("No contact with the pilot"), detail)
    if not known.drone_is_heard:
        return _without_drone(known)
    if known.last_status is DroneStatus.EMERGENCY:
        place = place_in_words(known)
        detail = Words("{place}; reset before the next flight", place=place)
        return Headline(HeadlineShape.WARNING, Words("Motors are cut"), detail)
    if line := _stopped(known) or _held_back(known):
        return line
    return _in_flight(known) if known.airborne else _on_the_ground(known, reasons)


def _without_drone(known: ConsoleKnowledge) -> Headline:
    if known.may_be_airborne:
        detail = _since(known.telemetry_age, _last_status(known))
        return Headline(HeadlineShape.LOST, Words("No contact with the drone"), detail)
    notes = known.link.notes if known.link else ()
    assert known.step is not None
    detail = next(iter(notes), known.step.outputs.reason)
    return Headline(HeadlineShape.WARNING, Words("Waiting for the drone"), detail)


def _since(seconds: float, then: Words) -> Words:
    return Words("for {n} s; {then}", n=figure(seconds, ".0f"), then=then)


def _last_status(known: ConsoleKnowledge) -> Words:
    """Return what the drone was last known to do."""
    if not known.may_be_airborne:
        is_known = known.last_status is not DroneStatus.UNKNOWN
        return Words("it was on the ground") if is_known else NOBODY_TOLD
    if known.hand_motion:
        return Words("it was moved by hand by {who}", who=known.hand_motion)
    if known.hand_motion is not None:
        return Words("it was moved by hand")
    return _DOING[known.drone.phase](goal_title(known))


_DOING: dict[Phase, Callable[[str], Words]] = {
    Phase.IDLE: lambda _: Words("it was hovering"),
    Phase.TAKING_OFF: lambda _: Words("it was taking off"),
    Phase.OUTBOUND: lambda goal: Words("it was flying to {goal}", goal=goal),
    Phase.LOOKING: lambda goal: Words("it was looking at {goal}", goal=goal),
    Phase.HOLDING: lambda _: Words("it was hovering"),
    Phase.RETURNING: lambda _: Words("it was coming home"),
    Phase.LANDING: lambda _: Words("it was landing"),
}

_PAUSED = Words("waits until you press Go on")

_HELD_BACK: dict[SafetyMode, Words] = {
    SafetyMode.HOLD: Words("HOLDING FOR SAFETY"),
    SafetyMode.RETURN: Words("Coming home for safety"),
    SafetyMode.LAND: Words("Landing for safety"),
    SafetyMode.DESCEND: Words("Sinking for safety"),
    SafetyMode.CUT: Words("Cutting motors"),
}


def _stopped(known: ConsoleKnowledge) -> Headline | None:
    assert known.step is not None
    landing = known.step.outputs.safety in (SafetyMode.LAND, SafetyMode.DESCEND, SafetyMode.CUT)
    if known.stop.progress is not StopProgress.CONFIRMED or landing:
        return None
    detail = Words("hovers until you resume")
    if not known.airborne:
        detail = Words("{place}; stays down until you resume", place=place_in_words(known))
    return Headline(HeadlineShape.STOPPED, Words("Stopped"), detail)


def _held_back(known: ConsoleKnowledge) -> Headline | None:
    assert known.step is not None
    out = known.step.outputs
    text = _HELD_BACK.get(out.safety) if known.airborne else None
    return Headline(HeadlineShape.WARNING, text, out.reason) if text else None


def _on_the_ground(known: ConsoleKnowledge, reasons: tuple[FlightObjection, ...]) -> Headline:
    place = place_in_words(known)
    if reasons and reasons[0].code == "checks":
        is_on_pad = known.standing is Standing.ON_PAD
        text = Words("On the pad") if is_on_pad else Words("On the ground")
        return Headline(HeadlineShape.HOLDING, text, Words("looking whether all is well"))
    if reasons:
        more = (place,) if known.standing is Standing.OFF_PAD else ()
        detail = joined("; ", (reasons[0].words, *more))
        return Headline(HeadlineShape.WARNING, Words("Not ready"), detail)
    if known.standing is Standing.ON_PAD:
        return Headline(HeadlineShape.READY, Words("Your drone is home"), Words("motors are off"))
    detail = Words("{place}; may take off from there", place=place)
    return Headline(HeadlineShape.WARNING, Words("Not on the pad"), detail)


def _in_flight(known: ConsoleKnowledge) -> Headline:
    assert known.step is not None
    out, goal = known.step.outputs, goal_title(known)
    at_task = _at_task(known)
    slowly = out.reason if out.safety in (SafetyMode.SLOW, SafetyMode.WARN) else UNSAID
    line = {
        Phase.TAKING_OFF: Headline(HeadlineShape.MOVING, Words("Taking off")),
        Phase.OUTBOUND: at_task
        or Headline(HeadlineShape.MOVING, Words("Flying to {goal}", goal=goal), _left(known)),
        Phase.HOLDING: at_task or _at_rest(known),
        Phase.LOOKING: Headline(
            HeadlineShape.HOLDING,
            Words("Looking at {goal}", goal=goal),
            Words("comes home by itself"),
        ),
        Phase.RETURNING: Headline(HeadlineShape.MOVING, Words("Coming home"), _left(known)),
        Phase.LANDING: Headline(HeadlineShape.MOVING, Words("Landing")),
    }.get(out.phase, _at_rest(known))
    if not known.is_seen:
        return Headline(HeadlineShape.WARNING, line.text, last_seen(known))
    return Headline(line.shape, line.text, slowly) if slowly else line


def _at_task(known: ConsoleKnowledge) -> Headline | None:
    """Return what the task that has the drone does where it looks, or waits for a person."""
    look = known.task_look
    if known.hand_motion is not None:
        return None
    shown = _look_in_words(known, look.words) if look is not None else UNSAID
    if known.task_is_paused:
        detail = joined("; ", (shown, _PAUSED) if shown else (_PAUSED,))
        return Headline(HeadlineShape.HOLDING, Words("Paused"), detail)
    if look is None:
        return None
    left = UNSAID
    if look.until is not None:
        left = Words("{n} s left", n=figure(max(0.0, look.until - known.unix), ".0f"))
    return Headline(HeadlineShape.HOLDING, shown, left)


def _look_in_words(known: ConsoleKnowledge, words: Words) -> Words:
    """Return what a task does; a place has the title by which the page calls it everywhere."""
    goal = words.value("goal")
    if not goal:
        return words
    places = known.room.places if known.room else ()
    return Words("Looking at {goal}", goal=goal_words(goal, places))


def _at_rest(known: ConsoleKnowledge) -> Headline:
    if (who := known.hand_motion) is None:
        # Between two steps of a task nobody is waited for.
        detail = UNSAID if known.task_subject else Words("waiting for an order")
        return Headline(HeadlineShape.HOLDING, Words("Hovering"), detail)
    text = Words("Moved by hand by {who}", who=who) if who else Words("Moved by hand")
    return Headline(HeadlineShape.MOVING, text, Words("hovers when it is let go"))


def _left(known: ConsoleKnowledge) -> Words:
    """Return how far and how long the path still goes, in words; UNSAID when nobody sees it fly."""
    assert known.step is not None
    out = known.step.outputs
    if known.position is None or out.path is None:
        return UNSAID
    way = (known.position, *out.path.waypoints[out.waypoint :])
    metres = sum(dist(a, b) for a, b in pairwise(way))
    speed = known.room.limits.get("speed", 0.0) if known.room else 0.0
    d = figure(metres, ".1f")
    if not speed:
        return Words("{d} m left", d=d)
    return Words("{d} m, {n} s left", d=d, n=figure(metres / speed, ".0f"))
