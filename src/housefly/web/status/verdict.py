"""The console's verdict: a pure function of what its server knows, and all that a page renders."""

from __future__ import annotations

from dataclasses import replace

from housefly.messages.words import UNSAID, Words, figure, literal, parts_of, said
from housefly.web.messages.verdict_message import ConsoleVerdict
from housefly.web.status.console_knowledge import ConsoleKnowledge, place_in_words
from housefly.web.status.headline import headline
from housefly.web.status.lost_contact import if_page_is_lost, without_word
from housefly.web.status.next_order import next_order
from housefly.web.status.order_objections import (
    check_in_words,
    order_objections,
    take_off_objections,
)
from housefly.web.status.watching import watching_verdict


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
        is_showing=known.is_showing,
    )


def says_the_same(one: ConsoleVerdict, other: ConsoleVerdict) -> bool:
    """Return whether two verdicts differ in nothing but their time."""
    return replace(one, at=other.at) == other


def _banner(known: ConsoleKnowledge) -> Words:
    if known.step is None or (known.pilot_is_heard and known.drone_is_heard):
        return UNSAID
    if known.pilot_is_heard and not known.may_be_airborne:
        return UNSAID
    then = without_word(known)
    if known.pilot_is_heard:
        return Words(
            "No word from the drone for {n} s: {then}. STOP and Land are still sent.",
            n=figure(known.telemetry_age, ".0f"),
            then=then,
        )
    return Words(
        "No word from the pilot for {n} s: {then}. STOP and Land are still sent.",
        n=figure(known.step_age, ".0f"),
        then=then,
    )


def _what_else(known: ConsoleKnowledge) -> tuple[Words, ...]:
    """Return what forbids nothing but should be known, each thing once."""
    checks = () if known.airborne else known.preflight.checks
    failing = [one for one in checks if not one.passed]
    told = [check_in_words(one) for one in failing if not one.required]
    said_already = {part for one in failing for part in parts_of(check_in_words(one))}
    drone, notes = known.telemetry, known.link.notes if known.link else ()
    if drone is not None:
        notes = (*notes, *map(literal, drone.notes), *map(said, drone.faults))
    told += [note for note in dict.fromkeys(notes) if note not in said_already]
    return tuple(told)
