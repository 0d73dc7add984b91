"""The state of the drone in one line: a shape, a few words, and what more there is to say."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import dist

from housefly.messages import DroneStatus, Phase, SafetyMode
from housefly.web.console_knowledge import ConsoleKnowledge, last_seen, place_in_words
from housefly.web.lost_contact import NOBODY_TOLD, goal_title
from housefly.web.verdict_message import FlightObjection, HeadlineShape, Standing, StopProgress


@dataclass(frozen=True, slots=True)
class Headline:
    """One line."""

    shape: HeadlineShape
    text: str
    detail: str = ""


def headline(known: ConsoleKnowledge, reasons: tuple[FlightObjection, ...]) -> Headline:
    """Return the line for what is known; the worst that is true comes first."""
    if known.step is None:
        return Headline(HeadlineShape.LOST, "Waiting for the pilot")
    if not known.pilot_is_heard:
        detail = f"for {known.step_age:.0f} s; {_last_status(known)}"
        return Headline(HeadlineShape.LOST, "No contact with the pilot", detail)
    if not known.drone_is_heard:
        return _without_drone(known)
    if known.last_status is DroneStatus.EMERGENCY:
        detail = f"{place_in_words(known)}; reset before the next flight"
        return Headline(HeadlineShape.WARNING, "Motors are cut", detail)
    if line := _stopped(known) or _held_back(known):
        return line
    return _in_flight(known) if known.airborne else _on_the_ground(known, reasons)


def _without_drone(known: ConsoleKnowledge) -> Headline:
    if known.may_be_airborne:
        detail = f"for {known.telemetry_age:.0f} s; {_last_status(known)}"
        return Headline(HeadlineShape.LOST, "No contact with the drone", detail)
    notes = known.link.notes if known.link else ()
    assert known.step is not None
    detail = next(iter(notes), known.step.outputs.reason)
    return Headline(HeadlineShape.WARNING, "Waiting for the drone", detail)


def _last_status(known: ConsoleKnowledge) -> str:
    """Return what the drone was last known to do."""
    if not known.may_be_airborne:
        is_known = known.last_status is not DroneStatus.UNKNOWN
        return "it was on the ground" if is_known else NOBODY_TOLD
    if known.hand_motion:
        return f"it was {known.hand_motion}"
    return f"it was {_DOING[known.drone.phase].format(goal=goal_title(known))}"


_DOING: dict[Phase, str] = {
    Phase.IDLE: "hovering",
    Phase.TAKING_OFF: "taking off",
    Phase.OUTBOUND: "flying to {goal}",
    Phase.LOOKING: "looking at {goal}",
    Phase.HOLDING: "hovering",
    Phase.RETURNING: "coming home",
    Phase.LANDING: "landing",
}

_HELD_BACK: dict[SafetyMode, str] = {
    SafetyMode.HOLD: "HOLDING FOR SAFETY",
    SafetyMode.RETURN: "Coming home for safety",
    SafetyMode.LAND: "Landing for safety",
    SafetyMode.DESCEND: "Sinking for safety",
    SafetyMode.CUT: "Cutting motors",
}


def _stopped(known: ConsoleKnowledge) -> Headline | None:
    assert known.step is not None
    landing = known.step.outputs.safety in (SafetyMode.LAND, SafetyMode.DESCEND, SafetyMode.CUT)
    if known.stop.progress is not StopProgress.CONFIRMED or landing:
        return None
    place = "hovers" if known.airborne else f"{place_in_words(known)}; stays down"
    return Headline(HeadlineShape.STOPPED, "Stopped", f"{place} until you resume")


def _held_back(known: ConsoleKnowledge) -> Headline | None:
    assert known.step is not None
    out = known.step.outputs
    text = _HELD_BACK.get(out.safety) if known.airborne else None
    return Headline(HeadlineShape.WARNING, text, out.reason) if text else None


def _on_the_ground(known: ConsoleKnowledge, reasons: tuple[FlightObjection, ...]) -> Headline:
    place = place_in_words(known)
    if reasons and reasons[0].code == "checks":
        text = "On the pad" if known.standing is Standing.ON_PAD else "On the ground"
        return Headline(HeadlineShape.HOLDING, text, "looking whether all is well")
    if reasons:
        more = f"; {place}" if known.standing is Standing.OFF_PAD else ""
        return Headline(HeadlineShape.WARNING, "Not ready", f"{reasons[0].words}{more}")
    if known.standing is Standing.ON_PAD:
        return Headline(HeadlineShape.READY, "Ready on the pad", "motors are off")
    return Headline(HeadlineShape.WARNING, "Not on the pad", f"{place}; may take off from there")


def _in_flight(known: ConsoleKnowledge) -> Headline:
    assert known.step is not None
    out, goal = known.step.outputs, goal_title(known)
    slowly = out.reason if out.safety in (SafetyMode.SLOW, SafetyMode.WARN) else ""
    line = {
        Phase.TAKING_OFF: Headline(HeadlineShape.MOVING, "Taking off"),
        Phase.OUTBOUND: Headline(HeadlineShape.MOVING, f"Flying to {goal}", _left(known)),
        Phase.LOOKING: Headline(
            HeadlineShape.HOLDING, f"Looking at {goal}", "comes home by itself"
        ),
        Phase.RETURNING: Headline(HeadlineShape.MOVING, "Coming home", _left(known)),
        Phase.LANDING: Headline(HeadlineShape.MOVING, "Landing"),
    }.get(out.phase, _at_rest(known))
    if not known.is_seen:
        return Headline(HeadlineShape.WARNING, line.text, f"tracking {last_seen(known)}")
    return Headline(line.shape, line.text, slowly) if slowly else line


def _at_rest(known: ConsoleKnowledge) -> Headline:
    if moved := known.hand_motion:
        text = f"{moved[0].upper()}{moved[1:]}"
        return Headline(HeadlineShape.MOVING, text, "hovers when it is let go")
    return Headline(HeadlineShape.HOLDING, "Hovering", "waiting for an order")


def _left(known: ConsoleKnowledge) -> str:
    """Return how far and how long the path still goes, in words; "" when nobody sees it fly."""
    assert known.step is not None
    out = known.step.outputs
    if known.position is None or out.path is None:
        return ""
    way = (known.position, *out.path.waypoints[out.waypoint :])
    metres = sum(dist(a, b) for a, b in pairwise(way))
    speed = known.room.limits.get("speed", 0.0) if known.room else 0.0
    return f"{metres:.1f} m, {metres / speed:.0f} s left" if speed else f"{metres:.1f} m left"
