"""Situations, assessments of one moment, and the detectors that produce them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import isfinite
from typing import Protocol

from housefly.hub.situations.kinds import SituationKind
from housefly.messages import Facts, Observation, RoomEvent

DetectorInput = Observation | RoomEvent
"""What detectors consume."""
SOURCE_PREFIX = "situations/"
"""Prefix of the sources of our own events; no sensor may be called so."""


@dataclass(frozen=True, slots=True)
class Evidence:
    """One report that speaks for a situation.

    Attributes:
        report: in words.
        source: id of the sensor that reports it, "" where a detector concludes it.
    """

    report: str
    source: str = ""


@dataclass(frozen=True, slots=True)
class Situation:
    """Something that holds now.

    Attributes:
        kind: what holds.
        thing: id of the person, thing or device that it holds for.
        since: when it began, by the evidence [s, Unix time].
        confidence: 0 to 1; falls while a source is silent.
        evidence: which sources report what.
        facts: the numbers.
    """

    kind: SituationKind
    thing: str
    since: float
    confidence: float
    evidence: tuple[Evidence, ...] = ()
    facts: Facts = ()


@dataclass(frozen=True, slots=True)
class Assessment:
    """What the evidence says at one moment; None instead of an assessment means unknown.

    Attributes:
        kind: of the situation that holds, None for none.
        confidence: 0 to 1.
        since: since when the evidence says so [s, Unix time]; None for this moment.
        evidence: which sources report what.
        facts: the numbers.
        cause: id of who caused it, "" if unknown.
    """

    kind: SituationKind | None
    confidence: float
    since: float | None = None
    evidence: tuple[Evidence, ...] = ()
    facts: Facts = ()
    cause: str = ""


class Detector(Protocol):
    """Turns sensor data into situations; time comes with the data and with ``update``."""

    def add(self, item: DetectorInput) -> None:
        """Add one item; items come in order of time."""
        ...

    def update(self, now: float) -> tuple[RoomEvent, ...]:
        """Return what began, ended or happened up to a time [s, Unix time], which never falls."""
        ...

    def active(self) -> tuple[Situation, ...]:
        """Return the situations that hold since the last ``update``."""
        ...


def evidence_words(evidence: Iterable[Evidence]) -> str:
    """Return which sources report what, for people."""
    return "; ".join(
        f"{one.source}: {one.report}" if one.source else one.report for one in evidence
    )


def sources_of(evidence: Iterable[Evidence]) -> tuple[str, ...]:
    """Return the ids of the sources, each once."""
    return tuple(dict.fromkeys(one.source for one in evidence if one.source))


def evidence_facts(evidence: Iterable[Evidence]) -> Facts:
    """Return the evidence as the facts of an event."""
    told = tuple(evidence)
    return ("evidence", evidence_words(told)), ("sources", ",".join(sources_of(told)))


def time_of(item: DetectorInput) -> float:
    """Return the time of an item [s, Unix time]."""
    return item.captured_at if isinstance(item, Observation) else item.at


def fact(item: DetectorInput, name: str) -> str | float | bool | None:
    """Return one fact of an item, None if absent."""
    return next((value for key, value in item.facts if key == name), None)


def number(item: DetectorInput, name: str) -> float | None:
    """Return a fact that is a finite number, None if it is absent or something else."""
    value = fact(item, name)
    return (
        float(value)
        if isinstance(value, int | float) and not isinstance(value, bool) and isfinite(value)
        else None
    )


def is_undated(sample: Observation) -> bool:
    """Return whether the broker kept a report from nobody knows when."""
    return flag(sample, "retained") is True and sample.captured_at == sample.received_at


def is_refused(item: DetectorInput) -> bool:
    """Return whether a device says of itself something that was not understood."""
    return fact(item, "refused") is not None and item.thing == item.source


def flag(item: DetectorInput, name: str) -> bool | None:
    """Return a fact that is a boolean, None if it is absent or something else."""
    value = fact(item, name)
    return value if isinstance(value, bool) else None
