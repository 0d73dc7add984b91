"""``flight-quality.html``: the rows of the gate, their limits, the ways side by side."""

from __future__ import annotations

import html
import platform
import time
from collections.abc import Sequence
from dataclasses import replace
from importlib import metadata
from pathlib import Path

from housefly.record.report_style import REPORT_CSS
from quality_gate.flown_row import FlownRow
from quality_gate.gate import GateResult
from quality_gate.plots import row_svg
from quality_gate.rooms import gate_site
from quality_gate.rows import GATE_ROWS
from quality_gate.scenario import Scenario
from quality_gate.tables import (
    Table,
    ablation_table,
    finding_words,
    measure_table,
)
from quality_gate.verdict import Finding

PAGE_FILE = "flight-quality.html"
_CSS = """
main { max-width: 1280px; }
.wide { overflow-x: auto; } .wide table { min-width: 1180px; }
td, th { white-space: nowrap; font-size: 12.5px; }
td:last-child { white-space: normal; min-width: 160px; }
li.kept { color: var(--muted); } li.red { color: var(--fault); font-weight: 600; }
dd { font-size: 14px; overflow-wrap: anywhere; }
ul { margin: 6px 0 12px; padding-left: 20px; font-size: 13px; }
"""
_ABOUT = (
    "Every flight is one of the simulated room, in lock step, and is scored on the truth: true"
    " places and contacts, not the tracked ones. The shortest time is that of a straight line as"
    " long as the way that was flown, from rest to rest with the site's speed, tilt and drag."
    " Clearance counts from the drone's middle, the hull's as it was turned. Nothing here was"
    " flown on hardware."
)


def write_quality_page(folder: Path, result: GateResult, command: str) -> Path:
    """Write the page into a folder, which is made when absent, and return it."""
    rows = [row for row in GATE_ROWS if any(flown.row == row.name for flown in result.flown)]
    body = (
        _head(result, command)
        + _section("All rows", _table(measure_table(result.flown)))
        + "".join(_row(row, result) for row in rows)
        + _ablations(result)
    )
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / PAGE_FILE
    path.write_text(
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        '<meta name="color-scheme" content="light dark">\n<title>Flight quality</title>\n'
        f"<style>{REPORT_CSS}{_CSS}</style>\n</head>\n<body>\n<main>\n{body}\n</main>\n</body>\n"
        "</html>\n",
        encoding="utf-8",
    )
    return path


def _head(result: GateResult, command: str) -> str:
    red, every = len(result.red), len(result.findings)
    kind = "bad" if red else "good"
    made = {
        "made by": command,
        "on": time.strftime("%Y-%m-%d %H:%M"),
        "processor time": f"{sum(row.processor_s for row in result.flown):.0f} s",
        "versions": f"Housefly {metadata.version('housefly')}, Python {platform.python_version()}",
    }
    if result.left_out:
        made["not flown"] = f"{', '.join(result.left_out)}: the map is not here"
    lines = "".join(
        f"<div><dt>{_text(name)}</dt><dd>{_text(words)}</dd></div>" for name, words in made.items()
    )
    red_lines = "".join(f'<li class="red">{_text(finding_words(f))}</li>' for f in result.red)
    return (
        "<header><h1>Flight quality</h1>"
        f'<p class="outcome {kind}">{red} of {every} limits not kept</p>'
        f"<p>{_ABOUT}</p><ul>{red_lines}</ul><dl>{lines}</dl></header>"
    )


def _row(row: Scenario, result: GateResult) -> str:
    flown = [one for one in result.flown if one.row == row.name]
    limits = "".join(_limit(f) for f in result.findings if f.row == row.name)
    picture = row_svg(gate_site(row.room).room, _one_room(row, flown), f"{row.name}: {row.title}")
    return _section(
        f"{row.name}: {row.title}",
        f'{_table(measure_table(flown))}<ul>{limits}</ul><div class="plot">{picture}</div>',
    )


def _one_room(row: Scenario, flown: Sequence[FlownRow]) -> list[FlownRow]:
    """Return the legs that were flown in the first of a row's rooms: that is the one drawn."""
    each = len(row.goals) if row.rooms > 1 else None
    return [replace(one, legs=one.legs[:each]) for one in flown]


def _ablations(result: GateResult) -> str:
    if not result.ablated:
        return ""
    words = "<p>Five errands in a draught of 0.5 m/s, 5 % heavier, one thing off at a time.</p>"
    table = _table(ablation_table(result.ablated))
    return _section("What each part is good for", words + table)


def _limit(finding: Finding) -> str:
    kind = "kept" if finding.holds else "red"
    return f'<li class="{kind}">{_text(finding_words(finding))}</li>'


def _table(table: Table) -> str:
    headings, lines = table
    head = "".join(f"<th>{_text(words)}</th>" for words in headings)
    body = "".join(
        "<tr>" + "".join(f"<td>{_text(cell)}</td>" for cell in line) + "</tr>" for line in lines
    )
    return f'<div class="wide"><table><tr>{head}</tr>{body}</table></div>'


def _section(title: str, inside: str) -> str:
    return f"<section><h2>{_text(title)}</h2>{inside}</section>"


def _text(words: str) -> str:
    return html.escape(words)
