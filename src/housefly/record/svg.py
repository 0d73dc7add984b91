"""Plots as SVG that takes its colours from the page, so that one picture serves light and dark.

Figures are drawn with stand-in colours; on the way out each becomes a variable of the page's style
sheet.
"""

from __future__ import annotations

import html
import io
import re
from contextlib import AbstractContextManager
from typing import Any

import matplotlib
from matplotlib.figure import Figure

TEXT, MUTED, LINE, ACCENT, SECONDARY, WARN, FAULT = (f"#{n:02x}{n:02x}{n:02x}" for n in range(1, 8))
"""Text, small text, grid lines, accent, what it is compared with, limits, danger."""
OCCUPIED_FILL, INFLATED_FILL, VIRTUAL_FILL, OUTSIDE_FILL, FURNITURE_LINE = (
    f"#{n:02x}{n:02x}{n:02x}" for n in range(8, 13)
)
"""Fills of the map."""
STATE_FILLS = tuple(f"#{n:02x}{n:02x}{n:02x}" for n in range(13, 20))
"""Fills of the bands of states."""
SPEED_FILLS = tuple(f"#{n:02x}{n:02x}{n:02x}" for n in range(20, 25))
"""Lines of planned speeds, slow to fast."""

_NAMES = (
    "ink",
    "muted",
    "line",
    "accent",
    "second",
    "warn",
    "fault",
    "occupied",
    "inflated",
    "virtual",
    "outside",
    "furniture",
)
_VARIABLES = {
    f"#{n:02x}{n:02x}{n:02x}": f"var(--{name})"
    for n, name in enumerate(
        (*_NAMES, *(f"s{i}" for i in range(7)), *(f"v{i}" for i in range(5))), 1
    )
}

_STYLE: Any = {
    "svg.fonttype": "none",
    "font.size": 9,
    "axes.titlesize": 9,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.edgecolor": LINE,
    "axes.labelcolor": MUTED,
    "axes.titlecolor": TEXT,
    "axes.facecolor": "none",
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.linewidth": 0.8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "figure.facecolor": "none",
    "grid.color": LINE,
    "grid.linewidth": 0.6,
    "hatch.color": MUTED,
    "hatch.linewidth": 0.6,
    "legend.frameon": False,
    "legend.labelcolor": TEXT,
    "legend.fontsize": 8,
    "lines.linewidth": 1.4,
    "path.simplify_threshold": 0.5,
    "text.color": TEXT,
    "xtick.color": MUTED,
    "ytick.color": MUTED,
    "xtick.major.size": 0,
    "ytick.major.size": 0,
}


def drawing(name: str) -> AbstractContextManager[None]:
    """Return the context for drawing the figure of this name.

    The name keeps the ids of several figures on one page apart.
    """
    return matplotlib.rc_context({**_STYLE, "svg.hashsalt": name})


def to_svg(figure: Figure, title: str) -> str:
    """Return the figure as an ``<svg>`` element with an accessible title."""
    buffer = io.StringIO()
    figure.savefig(
        buffer, format="svg", metadata={"Date": None, "Creator": None, "Format": None, "Type": None}
    )
    text = buffer.getvalue()
    text = text[text.index("<svg") :]
    text = re.sub(r"<metadata>.*?</metadata>", "", text, flags=re.DOTALL)
    text = re.sub(r'width="[\d.]+pt" height="[\d.]+pt"', 'role="img"', text, count=1)
    text = re.sub(r">", f"><title>{html.escape(title)}</title>", text, count=1)
    text = re.sub(r"('DejaVu Sans'[^;\"]*)", "var(--font)", text)
    return re.sub(r"#[0-9a-f]{6}\b", lambda found: _VARIABLES.get(found[0], found[0]), text)
