"""Plots of a campaign over its grid.

A line for one axis, lines or a heat map for two, panels for more.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from housefly.errors import RecordingError
from housefly.lab.campaigns.spec import COLUMN_WORDS, CampaignSpec
from housefly.lab.campaigns.summary import SHARES, GridPoint, value_text
from housefly.lab.experiments.cases import BY_NAME
from housefly.lab.experiments.outcomes import SUMMARY_MEASURES
from housefly.record.plot_style import PLOT_STYLE, save_figure
from housefly.theme import AMBER, GREEN, LIGHT, ORANGE, PINK, SKY

_COLOURS = (LIGHT.accent, ORANGE, GREEN, PINK, AMBER, SKY)
_MARKERS = "osD^vP"
_MAX_LINES = len(_COLOURS)
"""An axis with more values than this becomes a heat map."""
_MAX_PANELS = 12
_LOG_SCALE_RATIO = 10.0
"""An axis whose ends differ by more than this factor is logarithmic."""
_MARKER_SHIFT = 0.1
"""Horizontal shift between markers that share a word on the x axis."""
_EMPTY_SHADE = "0.85"
"""Shade of a grid point without data."""
_MEASURES = {measure.name: measure for measure in SUMMARY_MEASURES}


@dataclass(frozen=True, slots=True)
class _Plot:
    """Which column is drawn along which direction.

    Attributes:
        measure: what is drawn.
        across: column of the grid along x.
        lines: column distinguished by colour, or None.
        rows: column along y of a heat map, or None.
        split: columns distinguished by panels.
        field: value, low and high of the measure; one axis a column: ``split``, then ``lines`` or
            ``rows``, then ``across``.
        values: of each column.
    """

    measure: str
    across: str
    lines: str | None
    rows: str | None
    split: tuple[str, ...]
    field: Any
    values: dict[str, tuple[float, ...]]


def draw_campaign(
    spec: CampaignSpec, cells: tuple[GridPoint, ...], measure: str, stem: Path
) -> tuple[Path, ...]:
    """Draw one measure over the grid as ``stem.png`` and ``stem.svg`` and return the files.

    A grid of one point has no plot: the result is empty.

    Raises:
        RecordingError: the disk does not take them.
    """
    picture = _arranged(spec, cells, measure)
    if picture is None:
        return ()
    with matplotlib.rc_context(PLOT_STYLE):
        figure = _drawn(picture, spec.name)
        try:
            return save_figure(figure, stem, dpi=150)
        except OSError as error:
            raise RecordingError(f"{stem} cannot be written: {error.strerror}") from error


def _arranged(spec: CampaignSpec, cells: tuple[GridPoint, ...], measure: str) -> _Plot | None:
    """Assign the columns to directions.

    The longest numeric column goes along x. A second long one becomes the y axis of a heat map;
    short ones and words become lines.
    """
    values = {
        name: tuple(sorted(float(value) for value in given)) for name, given in spec.grid.items()
    }
    axes = sorted(
        (name for name in values if len(values[name]) > 1),
        key=lambda name: (name in COLUMN_WORDS, -len(values[name])),
    )
    if not axes:
        return None
    across, *others = axes
    few = all(len(values[name]) <= _MAX_LINES for name in others)
    others.sort(key=lambda name: (few and name not in COLUMN_WORDS, -len(values[name])))
    order = [*others[1:], *others[:1], across]
    field = np.full((*(len(values[name]) for name in order), 3), np.nan)
    names = list(spec.grid)
    for cell in cells:
        field[tuple(values[name].index(cell.values[names.index(name)]) for name in order)] = (
            cell.estimates[measure]
        )
    second = others[0] if others else None
    return _Plot(
        measure,
        across,
        second if few else None,
        None if few else second,
        tuple(others[1:]),
        field,
        values,
    )


def _drawn(picture: _Plot, title: str) -> Figure:
    places = list(product(*(range(len(picture.values[name])) for name in picture.split)))
    drawn = places[:_MAX_PANELS]
    columns = 2 if len(drawn) == 4 else min(3, len(drawn))
    height = -(-len(drawn) // columns)
    figure = Figure(
        figsize=(max(6.4, 3.2 * columns + 1.0), 3.8 if height == 1 else 2.6 * height + 0.6),
        layout="constrained",
    )
    panels = figure.subplots(height, columns, squeeze=False, sharex=True, sharey=True)
    for panel, place in zip(panels.ravel(), drawn, strict=False):
        draw = _lines if picture.rows is None else _heat_map
        draw(panel, picture, picture.field[place])
        panel.set_title(
            ", ".join(
                _setting(name, picture.values[name][index])
                for name, index in zip(picture.split, place, strict=True)
            )
        )
    for panel in panels.ravel()[len(drawn) :]:
        panel.set_visible(False)
    for number, panel in enumerate(panels.ravel()[: len(drawn)]):
        lowest = number + columns >= len(drawn)
        panel.set_xlabel(_axis_label(picture.across) if lowest else "")
        panel.tick_params(labelbottom=lowest)
        panel.set_ylabel(panel.get_ylabel() if number % columns == 0 else "")
    _key(figure, panels, picture)
    left_out = (
        "" if len(drawn) == len(places) else f" (the first {len(drawn)} of {len(places)} panels)"
    )
    figure.suptitle(f"{title}: {_measure_label(picture.measure)}{left_out}", fontsize=10)
    return figure


def _lines(panel: Any, picture: _Plot, field: Any) -> None:
    x = np.asarray(picture.values[picture.across])
    curves = field[np.newaxis] if picture.lines is None else field
    for index, (middle, low, high) in enumerate(np.moveaxis(curves, -1, 1)):
        colour = _COLOURS[index]
        label = (
            None
            if picture.lines is None
            else value_text(picture.lines, picture.values[picture.lines][index])
        )
        size = 1.0 + 0.25 * (
            len(curves) - 1 - index
        )  # so that curves that coincide are seen one on the other
        style: Any = {
            "color": colour,
            "marker": _MARKERS[index],
            "markersize": 4 * size,
            "linewidth": 1.4 * size,
            "label": label,
        }
        if picture.across in COLUMN_WORDS:
            shift = _MARKER_SHIFT * (index - 0.5 * (len(curves) - 1))
            panel.errorbar(
                x + shift,
                middle,
                (middle - low, high - middle),
                **style | {"linestyle": "none"},
                elinewidth=1.4,
            )
        else:
            panel.plot(x, middle, **style)
            panel.fill_between(x, low, high, color=colour, alpha=0.2, linewidth=0)
    _scale(panel, picture.across, x)
    for first, last in _gaps(x, np.isnan(curves[..., 0]).all(axis=0), panel.get_xlim()):
        panel.axvspan(first, last, color=_EMPTY_SHADE, linewidth=0)
    panel.set_ylabel(_measure_label(picture.measure))
    if picture.measure in SHARES:
        panel.set_ylim(-0.03, 1.03)
    panel.grid(alpha=0.25)


def _scale(panel: Any, name: str, x: Any) -> None:
    if x[0] > 0.0 and x[-1] > _LOG_SCALE_RATIO * x[0]:
        panel.set_xscale("log")
        reach = (x[-1] / x[0]) ** 0.04
        panel.set_xlim(x[0] / reach, x[-1] * reach)
        panel.minorticks_off()
    else:
        reach = 0.5 if name in COLUMN_WORDS else 0.04 * (x[-1] - x[0])
        panel.set_xlim(x[0] - reach, x[-1] + reach)
    if name in COLUMN_WORDS or panel.get_xscale() == "log":
        panel.set_xticks(x, [value_text(name, value) for value in x])


def _gaps(x: Any, empty: Any, ends: tuple[float, float]) -> list[tuple[float, float]]:
    """Return the ranges of x where no curve has data."""
    middles = np.concatenate(([ends[0]], 0.5 * (x[1:] + x[:-1]), [ends[1]]))
    return [(float(middles[index]), float(middles[index + 1])) for index in np.flatnonzero(empty)]


def _heat_map(panel: Any, picture: _Plot, field: Any) -> None:
    assert picture.rows is not None
    panel.set_facecolor(_EMPTY_SHADE)
    panel.imshow(field[..., 0], origin="lower", aspect="auto", cmap="viridis", **_limits(picture))
    for axis, name in ((panel.xaxis, picture.across), (panel.yaxis, picture.rows)):
        values = picture.values[name]
        step = -(-len(values) // 10)
        axis.set_ticks(
            range(0, len(values), step), [value_text(name, value) for value in values[::step]]
        )
    panel.set_ylabel(_axis_label(picture.rows))


def _limits(picture: _Plot) -> dict[str, float]:
    """Return one colour scale for all panels."""
    if picture.measure in SHARES:
        return {"vmin": 0.0, "vmax": 1.0}
    values = picture.field[..., 0]
    return {"vmin": 0.0, "vmax": float(np.nanmax(values))} if np.isfinite(values).any() else {}


def _key(figure: Figure, panels: Any, picture: _Plot) -> None:
    """Add the legend or colour bar beside the panels."""
    empty = np.isnan(picture.field[..., 0])
    nothing = [Patch(facecolor=_EMPTY_SHADE, label="no stable flight")]
    if picture.rows is not None:
        figure.colorbar(
            panels[0, 0].images[0],
            ax=panels,
            aspect=20 * len(panels),
            label=_measure_label(picture.measure),
        )
        if empty.any():
            figure.legend(handles=nothing, loc="outside lower right", fontsize=8, frameon=False)
        return
    handles = panels[0, 0].get_legend_handles_labels()[0]
    handles += (
        nothing
        if any(patch.get_visible() for panel in panels.ravel() for patch in panel.patches)
        else []
    )
    if handles:
        title = None if picture.lines is None else _axis_label(picture.lines)
        figure.legend(
            handles=handles,
            title=title,
            loc="outside right upper",
            fontsize=8,
            title_fontsize=8,
            frameon=False,
        )


def _setting(name: str, value: float) -> str:
    unit = BY_NAME[name].unit
    return f"{name} {value_text(name, value)}" + ("" if unit == "1" else f" {unit}")


def _axis_label(name: str) -> str:
    unit = BY_NAME[name].unit
    return name if unit == "1" else f"{name} [{unit}]"


def _measure_label(name: str) -> str:
    unit = _MEASURES[name].unit
    return f"share {name}" if name in SHARES else name if unit == "1" else f"{name} [{unit}]"
