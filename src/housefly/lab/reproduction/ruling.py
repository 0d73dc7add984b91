"""A claim of the paper, and the ruling on it by the evidence."""

from __future__ import annotations

from collections.abc import Callable
from math import isfinite
from typing import NamedTuple

from housefly.lab.experiments.intervals import IntervalEstimate
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.exhibit import ClaimFinding, OpposingCases, Verdict


class Ruling(NamedTuple):
    """A verdict, the numbers behind it, and the cases for and against where they oppose."""

    verdict: Verdict
    evidence: str
    cases: OpposingCases | None = None


class Claim(NamedTuple):
    """One sentence of the paper.

    Attributes:
        key: short name.
        section: of the paper.
        says: the sentence in other words.
        judge: rules on the evidence.
        figures: numbers of the figures that it belongs to.
    """

    key: str
    section: str
    says: str
    judge: Callable[[Evidence], Ruling]
    figures: tuple[str, ...] = ()


def finding_of(claim: Claim, evidence: Evidence) -> ClaimFinding:
    """Return the finding on a claim."""
    verdict, text, cases = claim.judge(evidence)
    return ClaimFinding(claim.key, claim.section, claim.says, verdict, text, claim.figures, cases)


def untestable(reason: str) -> Callable[[Evidence], Ruling]:
    """Return a judge that gives the reason why a claim cannot be tested here."""
    return lambda evidence: Ruling(Verdict.NOT_TESTABLE, reason)


def where_found(found: dict[str, bool]) -> str:
    """Return "Holds ..., not ..." for the places where something was found and was not."""
    yes, no = ([place for place, true in found.items() if true is seen] for seen in (True, False))
    if not yes:
        return f"Holds nowhere: not {', nor '.join(no)}."
    return f"Holds {', '.join(yes)}{', not ' + ', nor '.join(no) if no else ''}."


def percent(share: float) -> str:
    """Return a share as a percentage."""
    return f"{100 * share:.0f} %"


def percents(share: IntervalEstimate) -> str:
    """Return a share with its interval as percentages."""
    return f"{percent(share.value)} ({100 * share.low:.0f} to {100 * share.high:.0f})"


def rad_per_s(frequency: IntervalEstimate) -> str:
    """Return a frequency [rad/s] with its interval."""
    return f"{frequency.value:.1f} ({frequency.low:.1f} to {frequency.high:.1f}) rad/s"


def centimetres(length: IntervalEstimate) -> str:
    """Return a mean length [m] with half its interval, in cm."""
    half = f" ± {100 * length.half:.1f}" if isfinite(length.half) else ""
    return f"{100 * length.value:.1f}{half} cm"
