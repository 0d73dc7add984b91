"""Two tables as plots: what limits stability, and how tracking affects the path error."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, NullLocator, ScalarFormatter

from housefly.lab.experiments.intervals import IntervalEstimate, mean
from housefly.lab.reproduction.edges import ESTIMATORS
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.exhibit import Exhibit
from housefly.lab.reproduction.streams import LATENCIES, LOSSES, OWN_FREQUENCY, RATES
from housefly.lab.reproduction.tables import MODE_ORDER
from housefly.record.plot_style import AMBER, BLUE, GREEN, ORANGE, PLOT_STYLE, save_figure

_COLOURS = (ORANGE, AMBER, BLUE, GREEN)
_MARKERS = ("s", "D", "o", "^")
_STYLE = PLOT_STYLE | {
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.titlesize": 9,
    "grid.color": "#dddddd",
    "legend.frameon": False,
}


def draw_table_plots(evidence: Evidence, folder: Path) -> tuple[Exhibit, Exhibit]:
    """Save both plots as PNG and SVG in an existing folder and return what they show."""
    return (
        _drawn(
            evidence,
            folder,
            _stability,
            Exhibit(
                "A",
                "What limits stability: by tracking rate, latency and way of estimating",
                "stability_by_rate",
                "The paper has no such figure; it says that 10 to 100 frames per second cause"
                " unstable behaviors in some cases.",
                "Largest natural frequency at which a step of one cell does not ring, mean over"
                " drones with its 95 % interval. Orange and red fall with the rate: there frames"
                " are held. Blue, the paper's filter, falls with the latency.",
            ),
        ),
        _drawn(
            evidence,
            folder,
            _distance,
            Exhibit(
                "B",
                "Distance from the path: by tracking rate, latency and loss",
                "distance_by_rate",
                "The paper has no such figure and gives no error.",
                "Root mean square distance from the planned way of the service, mean over the"
                " stable flights with its 95 % interval. Dashed: a fifth of the frames lost.",
            ),
        ),
    )


def _drawn(
    evidence: Evidence, folder: Path, draw_on: Callable[[Figure, Evidence], None], exhibit: Exhibit
) -> Exhibit:
    with rc_context(_STYLE):
        figure = Figure(figsize=(9.0, 4.0), layout="constrained")
        draw_on(figure, evidence)
        save_figure(figure, folder / exhibit.stem, dpi=150)
    return exhibit


def _stability(figure: Figure, evidence: Evidence) -> None:
    panels = figure.subplots(1, len(LATENCIES), sharey=True)
    for axes, latency in zip(panels, LATENCIES, strict=True):
        for (estimator, name), colour, marker in zip(
            ESTIMATORS.items(), _COLOURS, _MARKERS, strict=True
        ):
            numbers = [mean(evidence.edges.of(estimator, rate, latency)) for rate in RATES]
            _line(axes, numbers, colour, marker, name)
        axes.axhline(OWN_FREQUENCY, color="#555555", linestyle=":", linewidth=1.2)
        axes.set_title(f"{1000 * latency:.0f} ms latency")
        _rate_axis(axes)
    panels[0].set_ylim(bottom=0.0)
    panels[0].set_ylabel("largest stable frequency [rad/s]")
    panels[0].annotate(
        "our gains",
        (RATES[-1], OWN_FREQUENCY),
        (0, 3),
        textcoords="offset points",
        ha="right",
        color="#555555",
    )
    handles, names = panels[0].get_legend_handles_labels()
    figure.legend(handles, names, loc="outside upper center", ncols=2)


def _distance(figure: Figure, evidence: Evidence) -> None:
    panels = figure.subplots(1, len(MODE_ORDER), sharey=True)
    for axes, mode in zip(panels, MODE_ORDER, strict=True):
        for latency, colour, marker in zip(LATENCIES, _COLOURS[1:], _MARKERS[1:], strict=True):
            for loss, dashes in zip(LOSSES, ("-", "--"), strict=True):
                numbers = []
                for rate in RATES:
                    flown = evidence.streams.where(
                        mode=mode, mocap_rate_hz=rate, mocap_latency=latency, mocap_dropout=loss
                    )
                    numbers.append(mean(100.0 * flown["rms_error"][flown["stable"] == 1.0]))
                name = f"{1000 * latency:.0f} ms latency" if not loss else "_"
                _line(axes, numbers, colour, marker, name, dashes)
        axes.set_title(f"mode {mode}")
        _rate_axis(axes)
    panels[0].set_ylim(bottom=0.0)
    panels[0].set_ylabel("distance from the path, RMS [cm]")
    handles, names = panels[0].get_legend_handles_labels()
    figure.legend(handles, names, loc="outside upper center", ncols=len(LATENCIES))


def _line(
    axes: Axes,
    numbers: Sequence[IntervalEstimate],
    colour: str,
    marker: str,
    name: str,
    dashes: str = "-",
) -> None:
    middle = np.array([number.value for number in numbers])
    reach = np.nan_to_num([number.half for number in numbers])
    axes.errorbar(
        RATES,
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


def _rate_axis(axes: Axes) -> None:
    axes.set_xscale("log")
    axes.xaxis.set_major_locator(FixedLocator(list(RATES)))
    axes.xaxis.set_major_formatter(ScalarFormatter())
    axes.xaxis.set_minor_locator(NullLocator())
    axes.set_xlabel("tracking rate [frames/s]")
