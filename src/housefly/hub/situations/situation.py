"""What holds now, and what a detector believes at one moment."""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite
from typing import Protocol

from housefly.messages import Facts, Happening, Observation

Item = Observation | Happening
"""What sensors tell."""
OURS = "situations/"
"""How the sources of our own happenings begin; no sensor can be called so."""


@dataclass(frozen=True, slots=True)
class Situation:
    """Something that holds now.

    Attributes:
        kind: what, in words of a small vocabulary: "person sitting", "bed occupied", "someone at
            the entrance".
        thing: id of the person, thing or device that it holds for.
        since: when it began, by the evidence [s, Unix time].
        confidence: 0 to 1; falls while a source is silent.
        evidence: which sources say so and what, for people.
        facts: the numbers.
    """

    kind: str
    thing: str
    since: float
    confidence: float
    evidence: tuple[str, ...] = ()
    facts: Facts = ()


@dataclass(frozen=True, slots=True)
class Finding:
    """What the evidence of one moment says; its absence means that nothing is known.

    Attributes:
        kind: of the situation that holds, "" for none of them.
        confidence: 0 to 1.
        since: since when the evidence says so [s, Unix time]; None for since this moment.
        evidence: which sources say so and what.
        facts: the numbers.
        cause: id of who brought it about, "" when unknown.
    """

    kind: str
    confidence: float
    since: float | None = None
    evidence: tuple[str, ...] = ()
    facts: Facts = ()
    cause: str = ""


class Detector(Protocol):
    """Turns what sensors tell into situations; time comes with the data and with ``after``."""

    def take(self, item: Item) -> None:
        """Take one item; items come in order of time."""
        ...

    def after(self, now: float) -> tuple[Happening, ...]:
        """Return what began, ended or happened up to a time [s, Unix time]; times do not run
        backwards.
        """
        ...

    def holds(self) -> tuple[Situation, ...]:
        """Return what holds since the last call of ``after``."""
        ...


def time_of(item: Item) -> float:
    """Return when an item was so [s, Unix time]."""
    return item.captured_at if isinstance(item, Observation) else item.at


def fact(item: Item, name: str) -> str | float | bool | None:
    """Return one fact of an item, None when it does not say it."""
    return next((value for key, value in item.facts if key == name), None)


def number(item: Item, name: str) -> float | None:
    """Return a fact that is a finite number, None when it is absent or something else."""
    value = fact(item, name)
    return (
        float(value)
        if isinstance(value, int | float) and not isinstance(value, bool) and isfinite(value)
        else None
    )


def flag(item: Item, name: str) -> bool | None:
    """Return a fact that is a truth value, None when it is absent or something else."""
    value = fact(item, name)
    return value if isinstance(value, bool) else None
