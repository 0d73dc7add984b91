"""Lines over the tracking rate, with intervals: what the plots of the tables have in common."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import FixedLocator, NullLocator, ScalarFormatter

from housefly.lab.experiments.intervals import IntervalEstimate
from housefly.lab.reproduction.streams import RATES
from housefly.record.plot_style import AMBER, BLUE, GREEN, ORANGE

COLOURS = (ORANGE, AMBER, BLUE, GREEN)
MARKERS = ("s", "D", "o", "^")


def rate_line(
    axes: Axes,
    numbers: Sequence[IntervalEstimate],
    colour: str,
    marker: str,
    name: str,
    dashes: str = "-",
    aside: float = 1.0,
) -> None:
    """Draw one line with its intervals.

    Args:
        axes: to draw on.
        numbers: one for each of ``RATES``.
        colour: of the line.
        marker: at each point.
        name: in the legend; "_" shows none.
        dashes: line style.
        aside: factor by which the line stands aside of the rates.
    """
    middle = np.array([number.value for number in numbers])
    reach = np.nan_to_num(
        [(number.value - number.low, number.high - number.value) for number in numbers]
    ).T
    axes.errorbar(
        [aside * rate for rate in RATES],
        middle,
        reach,
        color=colour,
        marker=marker,
        markersize=4,
        linestyle=dashes,
        linewidth=1.4,
        capsize=2,
        label=name,
    )


def rate_axis(axes: Axes) -> None:
    """Make x the tracking rate, logarithmic."""
    axes.set_xscale("log")
    axes.xaxis.set_major_locator(FixedLocator(list(RATES)))
    axes.xaxis.set_major_formatter(ScalarFormatter())
    axes.xaxis.set_minor_locator(NullLocator())
    axes.set_xlabel("tracking rate [frames/s]")
