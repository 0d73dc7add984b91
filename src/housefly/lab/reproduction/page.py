"""``reproduction.html``: the figures beside the paper's words, the verdicts, and the tables."""

from __future__ import annotations

import base64
import html
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from housefly.lab.reproduction.exhibit import ClaimFinding, Exhibit, Table, Verdict
from housefly.record.report_style import REPORT_CSS

_MARKS = {Verdict.HOLDS: "✓", Verdict.CONDITION: "◐", Verdict.FAILS: "✕", Verdict.NOT_TESTABLE: "?"}
_CLASSES = {
    Verdict.HOLDS: "holds",
    Verdict.CONDITION: "condition",
    Verdict.FAILS: "fails",
    Verdict.NOT_TESTABLE: "none",
}
_OWN_CSS = """
.verdict{display:inline-block;white-space:nowrap;font-weight:600}
.verdict span{display:inline-block;width:1.3em;text-align:center}
.holds{color:var(--good)} .fails{color:var(--fault)}
.condition{color:var(--warn)} .none{color:var(--muted)}
figure img{display:block;width:100%;height:auto;background:#fff;border-radius:6px}
@media (max-width:820px){.plot img{min-width:640px} .above .plot img{min-width:1000px}}
.beside{display:grid;grid-template-columns:minmax(0,1.7fr) minmax(0,1fr);
gap:1.2rem;align-items:start}
@media (max-width:820px){.beside{grid-template-columns:minmax(0,1fr)}}
.beside figure{position:sticky;top:1rem}
.above>div{columns:2;column-gap:1.6rem;margin-top:.8rem}
.above .finding,.above .said{break-inside:avoid}
@media (max-width:820px){.beside figure{position:static} .above>div{columns:1}}
.said{border-left:3px solid var(--line);padding-left:.8rem;margin:0 0 .8rem}
.notice{border:1px solid var(--warn);border-left-width:4px;border-radius:4px;padding:.5rem .8rem;
margin:.4rem 0 .8rem;color:var(--ink)}
.finding{margin:0 0 .9rem} .finding p{margin:.15rem 0}
.claim{display:grid;grid-template-columns:3.2rem minmax(0,1fr) 14rem minmax(0,1.8fr);gap:.2rem 1rem;
padding:.55rem 0;border-bottom:1px solid var(--line)}
@media (max-width:820px){.claim{grid-template-columns:minmax(0,1fr)}}
.says{color:var(--ink)} dl dd{font-size:15px}
.small{color:var(--muted);font-size:.9em}
.count{display:flex;flex-wrap:wrap;gap:.4rem 1.4rem;margin:.6rem 0}
.wide{overflow-x:auto} .wide table{font-variant-numeric:tabular-nums}
.wide td,.wide th{white-space:nowrap}
code{overflow-wrap:anywhere}
"""

_OPPOSING_CSS = """
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


@dataclass(frozen=True, slots=True)
class RunNotes:
    """How the page was made.

    Attributes:
        lines: pairs of a name and a text.
        notices: what a reader must know first, as sentences.
    """

    lines: tuple[tuple[str, str], ...]
    notices: tuple[str, ...] = ()


def write_page(
    folder: Path,
    exhibits: tuple[Exhibit, ...],
    tables: tuple[Table, ...],
    findings: tuple[ClaimFinding, ...],
    made: RunNotes,
) -> Path:
    """Write the page, with the figures embedded, into the folder of the figures and return it."""
    parts = [
        _head(findings, made),
        *(_exhibit(folder, exhibit, findings) for exhibit in exhibits),
        _claims(findings),
        opposing_section(findings, _verdict),
        *(_table(number, table) for number, table in enumerate(tables, 1)),
    ]
    body = "\n".join(parts)
    path = folder / "reproduction.html"
    path.write_text(
        f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>The paper, made again</title>
<style>{REPORT_CSS}{_OWN_CSS}{_OPPOSING_CSS}</style>
</head>
<body>
<main>
{body}
</main>
</body>
</html>
""",
        encoding="utf-8",
    )
    return path


def _head(findings: tuple[ClaimFinding, ...], made: RunNotes) -> str:
    counts = "".join(
        f"<div>{_verdict(verdict)} {sum(f.verdict is verdict for f in findings)}</div>"
        for verdict in Verdict
    )
    lines = "".join(
        f"<div><dt>{_text(name)}</dt><dd>{_text(words)}</dd></div>" for name, words in made.lines
    )
    notices = "".join(_notice(words) for words in made.notices)
    return (
        "<header><h1>The paper, made again</h1>"
        "<p>The figures of <em>Control Architecture for Service Drone in Informationally"
        " Structured Environment</em> (Ghallabi, "
        "Kawamura, Pyo, Tsuji, Kurazume) that show a design or a measurement (7, 10 to 13, 15 to"
        " 17), the numbers that it lacks, and what became of each of its"
        " claims. All flights are "
        "simulated: whole services and the steps of Fig. 11 on a twin with rigid bodies and the"
        " drone's firmware, everything that needs many drones on a model of the same drone with"
        " lag, drag and delays.</p>"
        f'{notices}<div class="count">{counts}</div><dl>{lines}</dl></header>'
    )


def _exhibit(folder: Path, exhibit: Exhibit, findings: tuple[ClaimFinding, ...]) -> str:
    picture = base64.b64encode((folder / f"{exhibit.stem}.png").read_bytes()).decode()
    own = "".join(_finding(finding) for finding in findings if exhibit.number in finding.figures)
    layout = "above" if exhibit.wide else "beside"
    number = (
        f"Fig. {exhibit.number}"
        if exhibit.number.isdigit()
        else f"Figure {exhibit.number}, not in the paper"
    )
    return (
        f'<section id="fig{exhibit.number}"><h2>{number}: {_text(exhibit.title)}</h2><div'
        f' class="{layout}"><figure><div class="plot"><img src="data:image/png;base64,{picture}"'
        f' alt="{_text(exhibit.title)}"></div><figcaption>{_notice(exhibit.notice)}'
        f"{_text(exhibit.caption)} <a"
        f' href="{exhibit.stem}.png">PNG</a> <a'
        f' href="{exhibit.stem}.svg">SVG</a></figcaption></figure><div><p class="said"><span'
        f' class="small">In the paper:</span> {_text(exhibit.paper)}</p>{own}</div></div></section>'
    )


def _notice(words: str) -> str:
    return f'<p class="notice">{_text(words)}</p>' if words else ""


def _finding(finding: ClaimFinding) -> str:
    return (
        f'<div class="finding">{_verdict(finding.verdict)} <span'
        f' class="small">{_text(finding.section)}</span><p'
        f' class="says">{_text(finding.claim)}</p><p'
        f' class="small">{_text(finding.evidence)}</p></div>'
    )


def _claims(findings: tuple[ClaimFinding, ...]) -> str:
    rows = "".join(
        '<div class="claim"><span'
        f' class="small">{_text(f.section)}</span><span>{_text(f.claim)}</span>'
        f'{_verdict(f.verdict)}<span class="small">{_text(f.evidence)}</span></div>'
        for f in findings
    )
    return (
        "<section><h2>Every claim</h2><p>The claims are in our words, in the order of the paper;"
        f" each number was computed in this run.</p>{rows}</section>"
    )


def _table(number: int, table: Table) -> str:
    head = "".join(f"<th>{_text(heading)}</th>" for heading in table.headings)
    rows = "".join(
        "<tr>" + "".join(f"<td>{_text(cell)}</td>" for cell in row) + "</tr>" for row in table.rows
    )
    return (
        f"<section><h2>Table {number}: {_text(table.title)}</h2><div"
        f' class="wide"><table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table></div><p'
        f' class="small">{_text(table.note)}</p></section>'
    )


def _verdict(verdict: Verdict) -> str:
    return (
        f'<span class="verdict {_CLASSES[verdict]}"><span aria-hidden="true">'
        f"{_MARKS[verdict]}</span> {verdict.value}</span>"
    )


def _text(value: str) -> str:
    return html.escape(value)


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
