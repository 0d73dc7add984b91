"""Why the drone may not take off, each with its mend, and why an order would come to nothing."""

from __future__ import annotations

from collections.abc import Callable

from housefly.messages import OrderKind, Phase, PreflightCheck, SafetyMode
from housefly.messages.sensing import DroneStatus
from housefly.messages.words import UNSAID, Words
from housefly.web.messages.verdict_message import (
    ConsoleVerdict,
    FlightObjection,
    OrderObjection,
    StopProgress,
)
from housefly.web.status.console_knowledge import ConsoleKnowledge, drone_last_seen

_LANDING = {
    SafetyMode.RETURN: Words("it comes home for safety"),
    SafetyMode.LAND: Words("it lands for safety"),
    SafetyMode.DESCEND: Words("it lands for safety"),
    SafetyMode.CUT: Words("its motors are being cut"),
}
_NO_CHECKS = Words("the checks before a take-off are not in yet")


def take_off_objections(known: ConsoleKnowledge) -> tuple[FlightObjection, ...]:
    """Return everything that speaks against a take-off, worst first; empty when it may."""
    if not known.pilot_is_heard:
        mend = Words("it is started again by itself: wait, or see its log in the run's folder")
        return (FlightObjection("pilot", Words("no contact with the pilot"), mend),)
    if known.airborne:
        return (FlightObjection("airborne", Words("the drone is already flying"), UNSAID),)
    own = tuple(_own_objections(known))
    codes = {one.code for one in own}
    checks = known.preflight.checks
    failing = [one for one in checks if one.required and not one.passed and one.code not in codes]
    told = tuple(FlightObjection(one.code, check_in_words(one), one.mend) for one in failing)
    if not own and not told and not known.preflight.ready:
        told = (FlightObjection("checks", _NO_CHECKS, Words("they come within seconds")),)
    return own + told


def _own_objections(known: ConsoleKnowledge) -> list[FlightObjection]:
    """Return what the newest step says already, a second before the checks do."""
    found: list[FlightObjection] = []
    if not known.drone_is_heard:
        mend = Words("switch it on, join its Wi-Fi, and see `housefly doctor`")
        found.append(FlightObjection("drone_answers", Words("the drone does not answer"), mend))
    elif known.last_status is DroneStatus.EMERGENCY:
        mend = Words("see that nobody is near and that it is whole, then hold Reset")
        found.append(FlightObjection("drone_landed", Words("its motors are cut"), mend))
    if known.stop.progress is not StopProgress.NONE:
        mend = Words("hold Resume when all is well")
        found.append(FlightObjection("stop", Words("STOP is latched"), mend))
    if known.drone_is_heard and not known.is_seen:
        mend = Words(
            "look at the tracking system: is it running, does it stream the body under this name?"
        )
        found.append(FlightObjection("tracking", drone_last_seen(known), mend))
    if known.caught_in:
        words = Words("it stands under, on or in {thing}", thing=known.caught_in)
        found.append(FlightObjection("caught", words, Words("carry it to its pad")))
    return found


def check_in_words(check: PreflightCheck) -> Words:
    """Return a check that failed, with what was found."""
    if not check.value:
        return check.fault
    return Words("{why} ({found})", why=check.fault, found=check.value)


def order_objections(
    known: ConsoleKnowledge, reasons: tuple[FlightObjection, ...]
) -> tuple[OrderObjection, ...]:
    """Return the first objection to each order that would come to nothing now."""
    found = ((kind, _RULES[kind](known, reasons)) for kind in _RULES)
    return tuple(OrderObjection(kind, words) for kind, words in found if words)


def order_objection_now(order: OrderKind, verdict: ConsoleVerdict) -> Words:
    """Return the verdict's objection to an order, in words, or UNSAID."""
    return next((one.words for one in verdict.orders if one.order is order), UNSAID)


_Rule = Callable[[ConsoleKnowledge, tuple[FlightObjection, ...]], Words]


def _ready(known: ConsoleKnowledge) -> Words:
    if not known.pilot_is_heard:
        return Words("No contact with the pilot.")
    if known.last_status is DroneStatus.EMERGENCY:
        return Words("Motors are cut: hold Reset first.")
    if known.stop.progress is not StopProgress.NONE:
        return Words("Stopped: hold Resume first.")
    return UNSAID if known.drone_is_heard else Words("The drone does not answer yet.")


def _forced(known: ConsoleKnowledge) -> Words:
    words = _LANDING.get(known.step.outputs.safety) if known.step and known.airborne else None
    return Words("Not now: {why}.", why=words) if words else UNSAID


def _take_off(known: ConsoleKnowledge, reasons: tuple[FlightObjection, ...]) -> Words:
    if words := _ready(known):
        return words
    return Words("The drone is already flying.") if known.airborne else _not_ready(reasons)


def _send(known: ConsoleKnowledge, reasons: tuple[FlightObjection, ...]) -> Words:
    return _ready(known) or (_forced(known) if known.airborne else _not_ready(reasons))


def _not_ready(reasons: tuple[FlightObjection, ...]) -> Words:
    return Words("Not ready: {why}.", why=reasons[0].words) if reasons else UNSAID


def _steer(known: ConsoleKnowledge, reasons: tuple[FlightObjection, ...]) -> Words:
    return (
        _ready(known)
        or (UNSAID if known.airborne else Words("The drone is on the ground."))
        or _forced(known)
    )


def _land(known: ConsoleKnowledge, reasons: tuple[FlightObjection, ...]) -> Words:
    """Land is open to whatever may be in the air: silence is no reason."""
    surely_down = not known.may_be_airborne and known.drone_is_heard
    return Words("The drone is on the ground.") if surely_down else UNSAID


def _resume(known: ConsoleKnowledge, reasons: tuple[FlightObjection, ...]) -> Words:
    if known.stop.progress is StopProgress.NONE:
        return Words("Only after STOP.")
    return UNSAID if known.pilot_is_heard else Words("No contact with the pilot.")


def _reset(known: ConsoleKnowledge, reasons: tuple[FlightObjection, ...]) -> Words:
    return UNSAID if known.pilot_is_heard else Words("No contact with the pilot.")


def _move_by_hand(known: ConsoleKnowledge, reasons: tuple[FlightObjection, ...]) -> Words:
    if known.room is not None and known.room.limits.get("nudge_speed", 0.0) <= 0.0:
        return Words("Moving by hand is switched off here.")
    if words := _steer(known, reasons):
        return words
    if known.step is not None and known.step.outputs.phase is not Phase.HOLDING:
        return Words("The drone flies somewhere: press Hover first.")
    return Words("A task flies the drone: press Hover first.") if known.task_subject else UNSAID


_RULES: dict[OrderKind, _Rule] = {
    OrderKind.TAKE_OFF: _take_off,
    OrderKind.GO: _send,
    OrderKind.SERVICE: _send,
    OrderKind.HOVER: _steer,
    OrderKind.HOME: _steer,
    OrderKind.LAND: _land,
    OrderKind.RESUME: _resume,
    OrderKind.RESET: _reset,
    OrderKind.NUDGE: _move_by_hand,
}
"""STOP and Cut are never objected to."""
