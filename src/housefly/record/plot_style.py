"""How all plots look, and how they are saved."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from matplotlib.figure import Figure

from housefly.theme import LIGHT

PLOT_STYLE: Any = {
    "font.size": 9,
    "text.color": LIGHT.ink,
    "axes.axisbelow": True,
    "axes.edgecolor": LIGHT.thing_edge,
    "axes.labelcolor": LIGHT.quiet,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.titlecolor": LIGHT.ink,
    "axes.titlelocation": "left",
    "axes.titlesize": 9,
    "xtick.color": LIGHT.quiet,
    "ytick.color": LIGHT.quiet,
    "grid.color": LIGHT.line,
    "legend.frameon": False,
    "svg.fonttype": "none",
    "svg.hashsalt": "housefly",
}
"""Settings of matplotlib; the salt makes an SVG the same in every run."""


def save_figure(figure: Figure, stem: Path, dpi: int) -> tuple[Path, Path]:
    """Write ``stem.png`` and ``stem.svg`` and return both; raises OSError when that fails."""
    png, svg = stem.with_suffix(".png"), stem.with_suffix(".svg")
    figure.savefig(png, dpi=dpi)
    figure.savefig(svg, metadata={"Date": None})
    return png, svg
