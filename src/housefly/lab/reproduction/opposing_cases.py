"""The section "What would change our mind": cases for and against, and worlds that decide anew."""

from __future__ import annotations

import html
from collections.abc import Callable

from housefly.lab.reproduction.exhibit import ClaimFinding, Verdict

OPPOSING_CSS = """
.opposed{margin:1rem 0 1.4rem} .opposed h3{margin:0 0 .2rem;font-size:1rem}
.sides{display:grid;grid-template-columns:repeat(2,minmax(0,1fr));gap:1rem;margin-top:.4rem}
.sides>div{border-top:2px solid var(--line);padding-top:.3rem}
.sides h4{margin:0;font-size:.85rem;color:var(--muted)} .sides p{margin:.15rem 0}
.counter{display:grid;grid-template-columns:minmax(0,1fr) minmax(0,1fr) 13rem minmax(0,1.5fr);
gap:.2rem 1rem;padding:.5rem 0;border-bottom:1px solid var(--line)}
@media (max-width:820px){.sides,.counter{grid-template-columns:minmax(0,1fr)}}
"""
"""Style of the section; joins the page's."""

_INTRODUCTION = (
    "A verdict is worth what could overturn it. First the claims for which measurements speak on"
    " both sides; then, for every verdict that was measured, one world that should overturn it:"
    " another drone, room, stream, gain or air. What decides the verdict is flown, mapped or"
    " evaluated anew there, in this run, by the same code; any other number of the sentence is this"
    " world's. The sentence keeps its words: where it says as printed, 0.2 deg or beta = 5.29, and"
    " the world has something else in its place, the number is that of the world."
)


def opposing_section(findings: tuple[ClaimFinding, ...], mark: Callable[[Verdict], str]) -> str:
    """Return the section, empty when no finding has cases or a counter-world.

    Args:
        findings: of this run, in the order of the paper.
        mark: returns a verdict as HTML.
    """
    opposed = "".join(_sides(finding, mark) for finding in findings if finding.cases)
    counters = "".join(_counter(finding, mark) for finding in findings if finding.elsewhere)
    if not opposed and not counters:
        return ""
    heading = "<h3>A world against each verdict</h3>" if counters else ""
    return (
        '<section id="change-our-mind"><h2>What would change our mind</h2>'
        f"<p>{_INTRODUCTION}</p>{opposed}{heading}{counters}</section>"
    )


def _sides(finding: ClaimFinding, mark: Callable[[Verdict], str]) -> str:
    assert finding.cases is not None
    return (
        f'<div class="opposed"><h3>{_text(finding.claim)}</h3>{mark(finding.verdict)}'
        f' <span class="small">{_text(finding.section)}</span><div class="sides">'
        f"<div><h4>Speaks for it</h4><p>{_text(finding.cases.speaks_for)}</p></div>"
        f"<div><h4>Speaks against it</h4><p>{_text(finding.cases.speaks_against)}</p></div>"
        "</div></div>"
    )


def _counter(finding: ClaimFinding, mark: Callable[[Verdict], str]) -> str:
    assert finding.elsewhere is not None
    there = finding.elsewhere
    return (
        f'<div class="counter"><span>{_text(finding.claim)}<br>{mark(finding.verdict)}</span>'
        f"<span>With {_text(there.changed)}:</span>{mark(there.verdict)}"
        f'<span class="small">{_text(there.evidence)}</span></div>'
    )


def _text(value: str) -> str:
    return html.escape(value)
