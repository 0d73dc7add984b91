"""Reads faults as people write them: ``F13@20s``, ``mocap:wrong@20s+5s=0.3``."""

from __future__ import annotations

import re
from dataclasses import replace
from math import inf
from typing import TypeVar

from housefly.config.faults import FAULT_PATTERN, ROW_PATTERN
from housefly.config.site import Site
from housefly.errors import ConfigError
from housefly.twin.faults.catalogue import row_of
from housefly.twin.faults.fault import Fault, FaultSchedule
from housefly.twin.faults.vocabulary import FaultComponent, FaultKind

Word = TypeVar("Word", FaultComponent, FaultKind)

_HOW = (
    "write a row of docs/faults.md as F13@20s (or F13/5cm@20s), or a component as"
    " mocap:wrong@20s+5s=0.3: what.side:how@start+duration=size#seed"
)


def parse_fault(text: str, key: str = "--fault") -> tuple[Fault, ...]:
    """Return the faults that a text means: one, or those of a row of the catalogue.

    Args:
        text: ``ROW[/VARIANT][@START][+DURATION][#SEED]`` or
            ``COMPONENT[.SIDE]:KIND[@START][+DURATION][=SIZE][#SEED]``; times in seconds. In front
            of it may stand the name of a drone and ``": "``.
        key: names the value in errors.

    Raises:
        ConfigError: it cannot be read, is not known, or is out of range.
    """
    try:
        return _parsed(text.strip())
    except ConfigError as error:
        raise ConfigError(key, f"{text!r}: {error.problem}") from error


def faults_of(site: Site) -> FaultSchedule:
    """Return the schedule of a site's ``[[faults]]``; raises ConfigError naming the entry."""
    faults: list[Fault] = []
    for number, entry in enumerate(site.faults):
        faults += parse_fault(entry.fault, f"faults.{number}.fault")
    return FaultSchedule().with_faults(faults)


def _parsed(text: str) -> tuple[Fault, ...]:
    if row := re.fullmatch(ROW_PATTERN, text):
        return _row_faults(row)
    if single := re.fullmatch(FAULT_PATTERN, text):
        return (_single_fault(single),)
    raise ConfigError("fault", f"cannot be read; {_HOW}")


def _row_faults(found: re.Match[str]) -> tuple[Fault, ...]:
    faults = row_of(found["row"]).faults_of(found["variant"] or "")
    start, seed = _number(found["start"], 0.0), int(found["seed"] or 1)
    shifted = (
        replace(fault.shifted(start), seed=seed + number, drone=found["drone"] or "")
        for number, fault in enumerate(faults)
    )
    if found["duration"] is None:
        return tuple(shifted)
    lasting = _number(found["duration"], inf)
    return tuple(replace(fault, duration=lasting) for fault in shifted)


def _single_fault(found: re.Match[str]) -> Fault:
    return Fault(
        _word(FaultComponent, found["component"], "component"),
        _word(FaultKind, found["kind"], "kind"),
        found["aspect"] or "",
        _number(found["start"], 0.0),
        _number(found["duration"], inf),
        None if found["size"] is None else float(found["size"]),
        int(found["seed"] or 1),
        found["drone"] or "",
    )


def _word(words: type[Word], text: str, what: str) -> Word:
    try:
        return words(text)
    except ValueError as error:
        known = ", ".join(word.value for word in words)
        raise ConfigError("fault", f"{text!r} is no {what}; known: {known}") from error


def _number(text: str | None, otherwise: float) -> float:
    return otherwise if text is None else float(text)
