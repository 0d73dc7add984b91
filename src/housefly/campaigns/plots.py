"""Pictures of a campaign: a line for one axis of the grid, heat maps for two, small multiples for more."""

from __future__ import annotations

from itertools import product
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
from matplotlib.figure import Figure

from housefly.campaigns.spec import Spec
from housefly.campaigns.summary import SHARES, Cell, shown
from housefly.experiments.cases import BY_NAME
from housefly.experiments.outcomes import MEASURES

STYLE: Any = {
    "font.size": 9,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.titlesize": 9,
    "svg.fonttype": "none",
    "svg.hashsalt": "housefly",
}
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000")
"""Okabe and Ito: told apart by everybody."""
MARKERS = "osD^vPX"
LINES_MOST = 6
"""An axis with more values than this is not drawn as lines but as a heat map."""
PANELS_MOST = 24
_MEASURES = {measure.name: measure for measure in MEASURES}


def draw_campaign(spec: Spec, cells: tuple[Cell, ...], measure: str, stem: Path) -> tuple[Path, ...]:
    """Draw one measure over the grid as ``stem.png`` and ``stem.svg``; returns the files, none for a grid of one point."""
    axes = sorted((name for name, values in spec.grid.items() if len(values) > 1), key=lambda name: -len(spec.grid[name]))
    if not axes:
        return ()
    with matplotlib.rc_context(STYLE):
        figure = _drawn(spec, cells, measure, axes)
        files = (stem.with_suffix(".png"), stem.with_suffix(".svg"))
        figure.savefig(files[0], dpi=150)
        figure.savefig(files[1], metadata={"Date": None})
    return files


def _drawn(spec: Spec, cells: tuple[Cell, ...], measure: str, axes: list[str]) -> Figure:
    """Draw the longest axis along x, the next as lines or as rows of a map, the rest as panels."""
    across, *others = axes
    lines = others[0] if others and len(spec.grid[others[0]]) <= LINES_MOST else None
    rows = others[0] if others and lines is None else None
    split = others[1:]
    panels = list(product(*(spec.grid[name] for name in split)))[:PANELS_MOST]
    columns = min(3, len(panels))
    height = -(-len(panels) // columns)
    figure = Figure(figsize=(max(5.6, 3.4 * columns), 3.6 if height == 1 else 2.7 * height), layout="constrained")
    grid = figure.subplots(height, columns, squeeze=False, sharex=True, sharey=True).ravel()
    for panel, values in zip(grid, panels, strict=False):
        chosen = [cell for cell in cells if _is_at(spec, cell, dict(zip(split, values, strict=True)))]
        if rows is None:
            _lines(panel, spec, chosen, measure, across, lines)
        else:
            _heat_map(figure, panel, spec, chosen, measure, across, rows)
        panel.set_title(", ".join(f"{name} {shown(name, _number(value))}" for name, value in zip(split, values, strict=True)))
    for panel in grid[len(panels) :]:
        panel.set_visible(False)
    meaning = _MEASURES[measure].meaning
    figure.suptitle(
        f"{spec.name}: {measure}\n{meaning}" if len(meaning) < 60 * columns else f"{spec.name}: {measure}", fontsize=9
    )
    return figure


def _lines(panel: Any, spec: Spec, cells: list[Cell], measure: str, across: str, lines: str | None) -> None:
    for index, value in enumerate(spec.grid[lines] if lines else (None,)):
        own = [cell for cell in cells if lines is None or _is_at(spec, cell, {lines: value})]
        own.sort(key=lambda cell: _value(spec, cell, across))
        x = [_value(spec, cell, across) for cell in own]
        middle, low, high = (np.array([cell.estimates[measure][part] for cell in own]) for part in range(3))
        colour = COLOURS[index % len(COLOURS)]
        label = None if lines is None else shown(lines, _number(value))
        panel.plot(x, middle, color=colour, marker=MARKERS[index % len(MARKERS)], markersize=4, linewidth=1.4, label=label)
        panel.fill_between(x, low, high, color=colour, alpha=0.2, linewidth=0)
    panel.set_xlabel(_axis_label(across))
    panel.set_ylabel(_measure_label(measure))
    if measure in SHARES:
        panel.set_ylim(-0.03, 1.03)
    if lines is not None:
        panel.legend(title=_axis_label(lines), fontsize=8, title_fontsize=8, frameon=False)
    panel.grid(alpha=0.25)


def _heat_map(figure: Figure, panel: Any, spec: Spec, cells: list[Cell], measure: str, across: str, rows: str) -> None:
    xs, ys = (sorted(_number(value) for value in spec.grid[name]) for name in (across, rows))
    field = np.full((len(ys), len(xs)), np.nan)
    for cell in cells:
        field[ys.index(_value(spec, cell, rows)), xs.index(_value(spec, cell, across))] = cell.estimates[measure].value
    picture = panel.imshow(
        field, origin="lower", aspect="auto", cmap="cividis", vmin=0.0, vmax=1.0 if measure in SHARES else None
    )
    for axis, name, values in ((panel.xaxis, across, xs), (panel.yaxis, rows, ys)):
        axis.set_ticks(range(len(values)), [shown(name, value) for value in values])
        axis.set_label_text(_axis_label(name))
    figure.colorbar(picture, ax=panel, label=_measure_label(measure))


def _is_at(spec: Spec, cell: Cell, wanted: dict[str, Any]) -> bool:
    return all(_value(spec, cell, name) == _number(value) for name, value in wanted.items())


def _value(spec: Spec, cell: Cell, name: str) -> float:
    return cell.values[list(spec.grid).index(name)]


def _number(value: Any) -> float:
    return float(value)


def _axis_label(name: str) -> str:
    unit = BY_NAME[name].unit
    return name if unit == "1" else f"{name} [{unit}]"


def _measure_label(name: str) -> str:
    unit = _MEASURES[name].unit
    return f"share {name}" if name in SHARES else name if unit == "1" else f"{name} [{unit}]"
