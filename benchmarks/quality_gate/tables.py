"""The gate in tables: cells of words, for Markdown and for the page."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite, isnan

from quality_gate.flown_row import FlownRow, RowMeasures
from quality_gate.verdict import Finding

Table = tuple[list[str], list[list[str]]]
HEADINGS = (
    "row", "way", "there", "time [s]", "shortest on its way [s]", "ratio", "clearance [m]",
    "hull [m]", "off reference rms / max [mm]", "off line rms / max [mm]", "overshoot [mm]",
    "height [mm]", "whole [s]", "touchdown [mm]", "outcome",
)  # fmt: skip
_SECONDS = ("time", "whole")
_COUNTS = ("arrived", "legs", "contacts", "ratio", "top_speed")


def measure_table(flown: Sequence[FlownRow]) -> Table:
    """Return headings and a line for each row and way."""
    return list(HEADINGS), [[row.row, row.way, *_cells(row)] for row in flown]


def ablation_table(ablated: Sequence[tuple[str, FlownRow | None]]) -> Table:
    """Return headings and a line for each thing switched off."""
    headings = ["switched off", *HEADINGS[1:]]
    lines = [
        [name, "not offered by this tree", *[""] * (len(HEADINGS) - 2)]
        if row is None
        else [name, row.way, *_cells(row)]
        for name, row in ablated
    ]
    return headings, lines


def finding_words(finding: Finding) -> str:
    """Return a limit and what was flown, in words."""
    limit, name = finding.limit, finding.limit.measure
    bound = limit.most if limit.most is not None else limit.least
    assert bound is not None
    sign = "at most" if limit.most is not None else "at least"
    value, wanted = (_with_unit(name, number) for number in (finding.value, bound))
    where = f"{finding.row} / {finding.way}"
    return f"{where}: {name} {value}, wanted {sign} {wanted} ({limit.source})"


def _cells(row: FlownRow) -> list[str]:
    m: RowMeasures = row.measures
    return [
        f"{m.arrived:.0f} of {m.legs:.0f}",
        _number(m.time, 1),
        _number(m.bound, 1) if m.bound else "-",
        _number(m.ratio, 2),
        _number(m.clearance, 3),
        _number(m.gap, 3),
        f"{_mm(m.reference_rms)} / {_mm(m.reference_max)}",
        f"{_mm(m.path_rms)} / {_mm(m.path_max)}",
        _mm(m.overshoot),
        f"{_mm(m.height_max)}, at the end {_mm(m.height_end)}",
        _number(m.whole, 1),
        _mm(m.touchdown),
        row.outcome or "-",
    ]


def _with_unit(name: str, value: float) -> str:
    if name in _SECONDS:
        return f"{value:.1f} s"
    return f"{value:.2f}" if name in _COUNTS else f"{1000 * value:.0f} mm"


def _number(value: float, digits: int) -> str:
    return "-" if isnan(value) else f"{value:.{digits}f}" if isfinite(value) else "never"


def _mm(value: float) -> str:
    return "-" if isnan(value) else f"{1000 * value:.0f}"
