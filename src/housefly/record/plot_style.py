"""How all plots look, and how they are saved."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from matplotlib.figure import Figure

BLUE, ORANGE, GREEN, PINK, GREY, INK = (
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#777777", "#222222",
)  # fmt: skip
"""The palette of Okabe and Ito, which colour-blind people can tell apart, and two greys."""
AMBER, SKY = "#e69f00", "#56b4e9"
"""Two more of the same palette."""
PLOT_STYLE: Any = {
    "font.size": 9,
    "axes.spines.top": False,
    "axes.spines.right": False,
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
