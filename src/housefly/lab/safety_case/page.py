"""``safety-case.html``: each row of the fault matrix with its flights and its negative control."""

from __future__ import annotations

import html
from collections.abc import Sequence
from math import log10
from pathlib import Path

from housefly.lab.safety_case.fault_phase import FaultPhase
from housefly.lab.safety_case.outcome_bounds import OutcomeBounds, bounds_of, missed_bounds
from housefly.lab.safety_case.plan import FAULT_FREE
from housefly.lab.safety_case.statistics import RowFigures, Spread, row_figures, row_number
from housefly.lab.safety_case.trial import PersonOrder, TrialResult
from housefly.lab.safety_case.wired_flight import WiredResult
from housefly.record.report_parts import SCROLLS
from housefly.record.report_style import REPORT_CSS
from housefly.twin.faults.catalogue import FAULT_CATALOGUE
from housefly.twin.faults.fault_row import FaultRow

PAGE_FILE = "safety-case.html"
_UNSAFE_LISTED = 60
_MISSED_LISTED = 100
_CSS = """
main { max-width: 1280px; }
.wide { overflow-x: auto; }
.wide table { min-width: 1080px; }
.mark { font-weight: 600; white-space: nowrap; }
.safe { color: var(--good); } .unsafe { color: var(--fault); } .none { color: var(--muted); }
td.number { text-align: right; white-space: nowrap; }
td p { font-size: 12.5px; margin: 0; }
td:nth-child(n+3):nth-child(-n+7) { white-space: nowrap; }
td[colspan] { white-space: normal !important; }
.strip { display: block; width: 180px; height: 34px; }
"""
_NONE = "-"
_HEADINGS = (
    "row", "what happens, and how it must end", "unsafe", "told after", "on the floor after",
    "from the path", "clearance", "told, by seconds", "without guards", "in real processes",
)  # fmt: skip

_WIDTH, _HEIGHT = 180.0, 34.0
_FIRST, _LAST = 0.05, 60.0
"""Times at the left and right edge [s]; the scale is logarithmic."""


def write_safety_case(
    folder: Path,
    results: Sequence[TrialResult],
    wired: Sequence[WiredResult],
    made: dict[str, str],
) -> Path:
    """Write the page and return it."""
    rows = "".join(_row(row, results, wired) for row in FAULT_CATALOGUE)
    headings = "".join(f"<th>{words}</th>" for words in _HEADINGS)
    body = (
        _head(results, wired, made)
        + '<section><h2>The fault matrix</h2><div class="wide" tabindex="0">'
        f"<table><tr>{headings}</tr>{rows}</table></div></section>"
        + _pairs(results)
        + _fault_free(results)
        + _unsafe(results, wired)
        + _missed(results)
    )
    path = folder / PAGE_FILE
    path.write_text(
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        '<meta name="color-scheme" content="light dark">\n<title>Safety case</title>\n'
        f"<style>{REPORT_CSS}{_CSS}</style>\n</head>\n<body>\n<main>\n{body}\n</main>\n</body>\n"
        "</html>\n",
        encoding="utf-8",
    )
    return path


def _head(
    results: Sequence[TrialResult], wired: Sequence[WiredResult], made: dict[str, str]
) -> str:
    guarded = [result for result in results if result.key.guarded]
    unsafe = sum(r.unsafe for r in guarded) + sum(r.unsafe for r in wired)
    kind = "bad" if unsafe else "good"
    lines = "".join(
        f"<div><dt>{_text(name)}</dt><dd>{_text(words)}</dd></div>" for name, words in made.items()
    )
    return (
        "<header><h1>Safety case</h1>"
        f'<p class="outcome {kind}">{unsafe} of {len(guarded) + len(wired)} flights unsafe</p>'
        "<p>Every flight is one service in the simulated room, in lock step, with a fault that"
        " begins in a phase drawn from its seed. It is judged on the truth: contacts, fence,"
        " commands, motors, and whether it ends. Those in real processes are flown in real time,"
        " over real sockets; there a process may be killed, too. The bound is the share of unsafe"
        " flights that is exceeded with 5 % confidence only. Counted by themselves are people who"
        " walked into a drone that was taking off, too late for any steering to avoid them, and"
        " flights that harmed nobody and missed a number that their row promises."
        " Nothing here was flown on hardware.</p>"
        f"<dl>{lines}</dl></header>"
    )


def _row(row: FaultRow, results: Sequence[TrialResult], wired: Sequence[WiredResult]) -> str:
    own = [r for r in results if row_number(r) == row.number and r.key.guarded]
    control = [r for r in results if row_number(r) == row.number and not r.key.guarded]
    title = f"<strong>{_text(row.title)}</strong><p>{_text(row.safe_outcome)}</p>"
    real = _wired([result for result in wired if result.key.row.startswith(row.number)])
    if not own and real != _NONE:
        covered = _text(row.covered_by)
        return (
            f'<tr id="{row.number}"><td>{row.number}</td><td>{title}</td>'
            f'<td colspan="7" class="none">in real processes only<p>{covered}</p></td>'
            f"<td>{real}</td></tr>"
        )
    if not own:
        covered = _text(row.covered_by or "not flown")
        return (
            f'<tr id="{row.number}"><td>{row.number}</td><td>{title}</td>'
            f'<td colspan="8" class="none">not in this campaign; {covered}</td></tr>'
        )
    figures = row_figures(own)
    cells = (
        row.number, title, _share(figures) + _kept(own), _seconds(figures.told),
        _seconds(figures.safe), _metres(figures.deviation), _clearance(figures),
        _strip_plot(own), _control(row, control), real,
    )  # fmt: skip
    return f'<tr id="{row.number}">' + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>"


def _share(figures: RowFigures) -> str:
    kind, mark = ("unsafe", "✕") if figures.unsafe else ("safe", "✓")
    return (
        f'<span class="mark {kind}">{mark} {figures.unsafe}/{figures.flights}</span>'
        f"<p>below {100 * figures.bound:.1f} %</p>"
        + (f"<p>{figures.walked_into} walked into</p>" if figures.walked_into else "")
    )


def _kept(own: Sequence[TrialResult]) -> str:
    """Return how many flights missed a number that their row promises."""
    if all(bounds_of(result.key.row) == OutcomeBounds() for result in own):
        return ""
    missed = sum(bool(missed_bounds(result)) for result in own)
    return f'<p class="{"unsafe" if missed else "safe"}">{missed} not as promised</p>'


def _control(row: FaultRow, control: Sequence[TrialResult]) -> str:
    if not control:
        return '<span class="none">not harmful by itself</span>' if not row.harmful else "-"
    harmed = sum(result.unsafe for result in control)
    expected = bool(harmed) or not row.harmful
    kind, mark = "none" if expected else "unsafe", "harm" if harmed else "no harm"
    return f'<span class="mark {kind}">{mark} {harmed}/{len(control)}</span>'


def _wired(wired: Sequence[WiredResult]) -> str:
    if not wired:
        return _NONE
    unsafe = sum(result.unsafe for result in wired)
    kind, mark = ("unsafe", "✕") if unsafe else ("safe", "✓")
    return f'<span class="mark {kind}">{mark} {unsafe}/{len(wired)}</span>'


def _seconds(times: Spread | None) -> str:
    if times is None:
        return '<span class="none">never</span>'
    return f"{times.median:.1f} s<p>95 %: {times.p95:.1f}, most {times.largest:.1f}</p>"


def _metres(lengths: Spread | None) -> str:
    return "-" if lengths is None else f"{lengths.median:.2f} m<p>most {lengths.largest:.2f}</p>"


def _clearance(figures: RowFigures) -> str:
    room = "-" if figures.room_clearance is None else f"{figures.room_clearance:.2f} m"
    people = figures.person_clearance
    return room + ("" if people is None else f"<p>people {people:.2f} m</p>")


def _pairs(results: Sequence[TrialResult]) -> str:
    pairs = [r for r in results if "+" in r.key.row]
    if not pairs:
        return ""
    figures = row_figures(pairs)
    return f"<section><h2>Two faults at once</h2><p>{_share(figures)}</p></section>"


def _fault_free(results: Sequence[TrialResult]) -> str:
    calm = [r for r in results if r.key.row == FAULT_FREE]
    if not calm:
        return ""
    told = [r for r in calm if r.told_after is not None]
    hours = sum(r.safe_after or 0.0 for r in calm) / 3600.0
    words = "".join(f"<li>{_text(r.told)} ({_again(r)})</li>" for r in told[:_UNSAFE_LISTED])
    return (
        f"<section><h2>Without a fault</h2><p>{len(told)} false alarms in {len(calm)} flights,"
        f" {hours:.1f} hours; {sum(r.unsafe for r in calm)} unsafe.</p><ul>{words}</ul></section>"
    )


def _unsafe(results: Sequence[TrialResult], wired: Sequence[WiredResult]) -> str:
    unsafe = [r for r in results if r.unsafe and r.key.guarded]
    unsafe_wired = [r for r in wired if r.unsafe]
    if not unsafe and not unsafe_wired:
        return ""
    rows = "".join(
        f"<tr><td>{_text(r.key.row)}</td><td>{_text(r.phase.value)}</td>"
        f"<td>{_text('; '.join(r.violations))}</td><td>{_text(r.told)}</td>"
        f"<td><code>{_again(r)}</code></td></tr>"
        for r in unsafe[:_UNSAFE_LISTED]
    )
    rows += "".join(
        f"<tr><td>{_text(r.key.row)}</td><td>{r.began_at:.1f} s</td>"
        f"<td>{_text('; '.join(r.violations))}</td><td>{_text(r.outcome)}</td>"
        f"<td>in real processes, seed {r.key.seed}</td></tr>"
        for r in unsafe_wired
    )
    more = len(unsafe) - _UNSAFE_LISTED
    rest = f"<p>and {more} more</p>" if more > 0 else ""
    return (
        f"<section><h2>Unsafe flights</h2>{SCROLLS}<table><tr><th>row</th><th>phase</th>"
        f"<th>what</th><th>told</th><th>again</th></tr>{rows}</table></div>{rest}</section>"
    )


def _missed(results: Sequence[TrialResult]) -> str:
    safe = (r for r in results if r.key.guarded and not r.unsafe)
    found = [(r, words) for r in safe if (words := missed_bounds(r))]
    if not found:
        return ""
    rows = "".join(
        f"<tr><td>{_text(r.key.row or 'without a fault')}</td><td>{_text(r.phase.value)}</td>"
        f"<td>{_text('; '.join(words))}</td><td><code>{_again(r)}</code></td></tr>"
        for r, words in found[:_MISSED_LISTED]
    )
    more = len(found) - _MISSED_LISTED
    rest = f"<p>and {more} more</p>" if more > 0 else ""
    return (
        f"<section><h2>Safe, and not as promised</h2>{SCROLLS}<table><tr><th>row</th>"
        f"<th>phase</th><th>what</th><th>again</th></tr>{rows}</table></div>{rest}</section>"
    )


def _again(result: TrialResult) -> str:
    order = result.key.order
    ordered = "" if order is PersonOrder.NOTHING else f" --order '{order.value}'"
    return f"housefly safety --again {result.key.row or 'calm'} --seed {result.key.seed}{ordered}"


def _text(words: str) -> str:
    return html.escape(words)


def _strip_plot(results: Sequence[TrialResult]) -> str:
    """Return an SVG: a row of dots per phase, from 0.05 s to a minute; ✕ is unsafe."""
    lines = "".join(
        f'<line x1="{_x(at):.1f}" x2="{_x(at):.1f}" y1="0" y2="{_HEIGHT}" stroke="var(--line)"/>'
        for at in (0.1, 0.5, 1.0, 10.0)
    )
    dots = "".join(_dot(result) for result in sorted(results, key=lambda r: r.unsafe))
    title = "seconds until a person was told, one row per phase; lines at 0.1, 0.5, 1 and 10 s"
    return (
        f'<svg class="strip" viewBox="0 0 {_WIDTH:g} {_HEIGHT:g}" role="img" aria-label="{title}">'
        f"<title>{title}</title>{lines}{dots}</svg>"
    )


def _x(seconds: float) -> float:
    kept = min(max(seconds, _FIRST), _LAST)
    return 3.0 + (_WIDTH - 6.0) * log10(kept / _FIRST) / log10(_LAST / _FIRST)


def _dot(result: TrialResult) -> str:
    row = list(FaultPhase).index(result.phase)
    y = (row + 0.5) * _HEIGHT / len(FaultPhase)
    x = _x(_LAST if result.told_after is None else result.told_after)
    if result.unsafe:
        return (
            f'<path d="M{x - 2:.1f} {y - 2:.1f}l4 4m0-4l-4 4" stroke="var(--fault)"'
            ' stroke-width="1.5" fill="none"/>'
        )
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="1.4" fill="var(--accent)" opacity="0.6"/>'
