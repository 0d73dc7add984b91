"""Figures, tables, and findings about the paper's claims."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


@dataclass(frozen=True, slots=True)
class Exhibit:
    """One figure of the paper, made again.

    Attributes:
        number: of the figure in the paper, for example "12".
        title: what it shows.
        stem: name of its files, without ``.png`` and ``.svg``.
        paper: what the paper shows there, in our words.
        caption: what is seen here, with the numbers.
    """

    number: str
    title: str
    stem: str
    paper: str
    caption: str


@dataclass(frozen=True, slots=True)
class Table:
    """Numbers that the paper does not give.

    Attributes:
        title: what was measured.
        headings: with units.
        rows: one cell a heading, as text.
        note: how it was measured; how many flights; what the intervals are.
    """

    title: str
    headings: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    note: str


class Verdict(Enum):
    """The outcome for a claim."""

    HOLDS = "holds"
    CONDITION = "holds with a condition"
    FAILS = "does not hold"
    NOT_TESTABLE = "not testable here"


@dataclass(frozen=True, slots=True)
class ClaimFinding:
    """A claim of the paper and what the measurements say.

    Attributes:
        key: short name.
        section: of the paper.
        claim: what it says there.
        verdict: ours.
        evidence: one or two sentences with the numbers behind it.
        figures: numbers of the figures that it belongs to.
    """

    key: str
    section: str
    claim: str
    verdict: Verdict
    evidence: str
    figures: tuple[str, ...] = ()
