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
        notice: what differs from what was planned, as a sentence; "" when nothing does.
        wide: whether it needs the whole width of a page.
    """

    number: str
    title: str
    stem: str
    paper: str
    caption: str
    notice: str = ""
    wide: bool = False


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
class OpposingCases:
    """The strongest case for a claim and the strongest against it, with the numbers of this run."""

    speaks_for: str
    speaks_against: str


@dataclass(frozen=True, slots=True)
class CounterFinding:
    """The finding on a claim in a world in which one thing is another.

    Attributes:
        changed: what is another there.
        verdict: there.
        evidence: with the numbers behind it.
    """

    changed: str
    verdict: Verdict
    evidence: str


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
        cases: for and against, where they oppose each other.
        elsewhere: the finding in a world that changes the verdict; None: none was flown.
    """

    key: str
    section: str
    claim: str
    verdict: Verdict
    evidence: str
    figures: tuple[str, ...] = ()
    cases: OpposingCases | None = None
    elsewhere: CounterFinding | None = None
