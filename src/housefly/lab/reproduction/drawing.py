"""How all figures look, and how they are written."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from matplotlib import rc_context
from matplotlib.figure import Figure

BLUE, ORANGE, GREEN, PINK, GREY, INK = (
    "#0072B2",
    "#D55E00",
    "#009E73",
    "#CC79A7",
    "#777777",
    "#222222",
)
"""Told apart by the colour-blind (Okabe and Ito)."""
STYLE: Any = {
    "font.size": 9,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.axisbelow": True,
    "axes.titlesize": 9,
    "axes.titlelocation": "left",
    "grid.color": "#dddddd",
    "legend.frameon": False,
    "svg.fonttype": "none",
    "svg.hashsalt": "housefly",
}
DPI = 140


def write(
    folder: Path, stem: str, size: tuple[float, float], draw: Callable[[Figure], None]
) -> None:
    """Draw a figure of a size [inches] and write it into a folder that exists as PNG and SVG."""
    with rc_context(STYLE):
        figure = Figure(figsize=size, layout="constrained", facecolor="white")
        draw(figure)
        figure.savefig(folder / f"{stem}.png", dpi=DPI)
        figure.savefig(folder / f"{stem}.svg", metadata={"Date": None})
