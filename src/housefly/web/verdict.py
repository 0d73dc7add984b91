"""The console's verdict: a pure function of what its server knows, and all that a page renders."""

from __future__ import annotations

from dataclasses import replace

from housefly.web.console_knowledge import ConsoleKnowledge, place_in_words
from housefly.web.headline import headline
from housefly.web.lost_contact import if_page_is_lost, without_word
from housefly.web.next_order import next_order
from housefly.web.order_objections import check_in_words, order_objections, take_off_objections
from housefly.web.verdict_message import ConsoleVerdict
from housefly.web.watching import watching_verdict

SAID_BY_A_CHECK = "nothing here sees people"
"""How the pilot's note begins that one of the checks says as well."""


def console_verdict(known: ConsoleKnowledge) -> ConsoleVerdict:
    """Return what is to be said of the drone now."""
    if not known.has_drone:
        return watching_verdict(known)
    reasons = take_off_objections(known)
    orders = order_objections(known, reasons)
    line = headline(known, reasons)
    away = known.pad_distance
    return ConsoleVerdict(
        at=known.now,
        shape=line.shape,
        headline=line.text,
        detail=line.detail,
        banner=_banner(known),
        standing=known.standing,
        place=place_in_words(known),
        pad_distance=None if away is None else round(away, 1),
        airborne=known.airborne,
        may_be_airborne=known.may_be_airborne,
        is_cut=known.is_cut,
        pose_is_old=not known.is_seen,
        may_take_off=not reasons,
        reasons=reasons,
        known=_what_else(known),
        orders=orders,
        next_order=next_order(known, reasons, orders),
        if_contact_lost=if_page_is_lost(known),
        stop=known.stop,
        pilot=known.pilot,
        control=known.control,
    )


def says_the_same(one: ConsoleVerdict, other: ConsoleVerdict) -> bool:
    """Return whether two verdicts differ in nothing but their time."""
    return replace(one, at=other.at) == other


def _banner(known: ConsoleKnowledge) -> str:
    if known.step is None or (known.pilot_is_heard and known.drone_is_heard):
        return ""
    if known.pilot_is_heard:
        silent, age = "drone", known.telemetry_age
        if not known.may_be_airborne:
            return ""
    else:
        silent, age = "pilot", known.step_age
    words = without_word(known)
    return f"No word from the {silent} for {age:.0f} s: {words}. STOP and Land are still sent."


def _what_else(known: ConsoleKnowledge) -> tuple[str, ...]:
    """Return what forbids nothing but should be known, each thing once."""
    checks = () if known.airborne else known.preflight.checks
    failing = [one for one in checks if not one.passed]
    told = [check_in_words(one) for one in failing if not one.required]
    drone, link = known.telemetry, known.link
    faults = (fault.value for fault in drone.faults) if drone else ()
    for note in [*(link.notes if link else ()), *(drone.notes if drone else ()), *faults]:
        is_check = bool(checks) and note.startswith(SAID_BY_A_CHECK)
        if not is_check and not any(note in one for one in (*told, *(c.value for c in failing))):
            told.append(note)
    return tuple(told)
