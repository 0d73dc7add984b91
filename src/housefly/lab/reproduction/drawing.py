"""How the paper's figures are drawn and saved."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from matplotlib import rc_context
from matplotlib.figure import Figure

from housefly.record.plot_style import PLOT_STYLE, save_figure


def write_figure(
    folder: Path, stem: str, size: tuple[float, float], draw: Callable[[Figure], None]
) -> None:
    """Draw a figure of this size [inches] and save it as PNG and SVG in an existing folder."""
    with rc_context(PLOT_STYLE):
        figure = Figure(figsize=size, layout="constrained", facecolor="white")
        draw(figure)
        save_figure(figure, folder / stem, dpi=140)
