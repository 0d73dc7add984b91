"""Two tables as plots: what limits stability, and how tracking affects the path error."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, NullLocator, ScalarFormatter

from housefly.config.site import Mode
from housefly.lab.experiments.intervals import IntervalEstimate, mean
from housefly.lab.experiments.outcomes import Outcomes
from housefly.lab.reproduction.edges import ESTIMATORS, FREQUENCIES
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.exhibit import Exhibit
from housefly.lab.reproduction.stability_limit import StabilityLimit, stability_limit
from housefly.lab.reproduction.streams import LATENCIES, LOSSES, OWN_FREQUENCY, RATES
from housefly.lab.reproduction.tables import MODE_ORDER
from housefly.record.plot_style import PLOT_STYLE, save_figure
from housefly.theme import AMBER, GREEN, LIGHT, ORANGE

_SPREAD = 1.03
"""Lines of one panel stand aside by this factor, so that their bars do not cover each other."""
_STYLE = PLOT_STYLE | {"axes.grid": True}

_COLOURS = (ORANGE, AMBER, LIGHT.accent, GREEN)
_MARKERS = ("s", "D", "o", "^")


def draw_table_plots(evidence: Evidence, folder: Path) -> tuple[Exhibit, Exhibit]:
    """Save both plots as PNG and SVG in an existing folder and return what they show."""
    return (
        _drawn(
            evidence,
            folder,
            draw_stability,
            Exhibit(
                "A",
                "What limits stability: by tracking rate, latency and way of estimating",
                "stability_by_rate",
                "The paper has no such figure; it says that 10 to 100 frames per second cause"
                " unstable behaviors in some cases.",
                "Largest natural frequency at which a step of one cell does not ring in still air,"
                " mean over all drones with its 95 % bootstrap interval; a drone that rings at"
                f" every frequency tried ({FREQUENCIES[0]:.1f} to {FREQUENCIES[-1]:.0f} rad/s)"
                " counts as 0. Orange and yellow fall with the rate: there frames are held. Blue,"
                " the paper's filter, falls with the latency.",
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
        figure = Figure(figsize=(9.0, 4.2), layout="constrained")
        draw_on(figure, evidence)
        save_figure(figure, folder / exhibit.stem, dpi=150)
    return exhibit


def _distance(figure: Figure, evidence: Evidence) -> None:
    panels = figure.subplots(1, len(MODE_ORDER), sharey=True)
    for axes, mode in zip(panels, MODE_ORDER, strict=True):
        flights = unstable = 0
        for place, latency in enumerate(LATENCIES):
            colour, marker = _COLOURS[1 + place], _MARKERS[1 + place]
            for loss, dashes in zip(LOSSES, ("-", "--"), strict=True):
                cells = [_stream(evidence, mode, rate, latency, loss) for rate in RATES]
                flights += sum(flown.size for flown in cells)
                unstable += sum(int((flown["stable"] == 0.0).sum()) for flown in cells)
                numbers = [
                    mean(100.0 * flown["rms_error"][flown["stable"] == 1.0]) for flown in cells
                ]
                name = f"{1000 * latency:.0f} ms latency" if not loss else "_"
                _rate_line(axes, numbers, colour, marker, name, dashes, _SPREAD ** (place - 1))
        axes.set_title(f"mode {mode}: {unstable} of {flights} flights not stable, left out")
        _rate_axis(axes)
    panels[0].set_ylim(bottom=0.0)
    panels[0].set_ylabel("distance from the path, RMS [cm]")
    handles, names = panels[0].get_legend_handles_labels()
    figure.legend(handles, names, loc="outside upper center", ncols=len(LATENCIES))


def _stream(evidence: Evidence, mode: Mode, rate: float, latency: float, loss: float) -> Outcomes:
    return evidence.streams.where(
        mode=mode, mocap_rate_hz=rate, mocap_latency=latency, mocap_dropout=loss
    )


def draw_stability(figure: Figure, evidence: Evidence) -> None:
    """Draw a panel a latency, a line an estimator."""
    panels = figure.subplots(1, len(LATENCIES), sharey=True)
    shown: list[StabilityLimit] = []
    for axes, latency in zip(panels, LATENCIES, strict=True):
        for (estimator, name), colour, marker in zip(
            ESTIMATORS.items(), _COLOURS, _MARKERS, strict=True
        ):
            limits = [stability_limit(evidence.edges, estimator, rate, latency) for rate in RATES]
            _rate_line(axes, [limit.frequency for limit in limits], colour, marker, name)
            _counted(axes, limits, colour)
            shown += limits
        axes.axhline(OWN_FREQUENCY, color=LIGHT.quiet, linestyle=":", linewidth=1.2)
        axes.set_title(f"{1000 * latency:.0f} ms latency")
        _rate_axis(axes)
    _frequency_axis(panels[0])
    panels[0].annotate(
        "our gains",
        (RATES[-1], OWN_FREQUENCY),
        (0, -10),
        textcoords="offset points",
        ha="right",
        color=LIGHT.quiet,
    )
    handles, names = panels[0].get_legend_handles_labels()
    figure.legend(handles, names, loc="outside upper center", ncols=2)
    figure.supxlabel(drones_counted(shown), fontsize=8, color=LIGHT.quiet)


def drones_counted(limits: Sequence[StabilityLimit]) -> str:
    """Return what became of the drones whose edge lies outside the frequencies tried."""
    drones, ringing = limits[0].drones, sum(limit.ringing for limit in limits)
    beyond = sum(limit.beyond for limit in limits)
    lowest, highest = f"{FREQUENCIES[0]:.1f}", f"{FREQUENCIES[-1]:.0f}"
    return (
        f"Still air. A point is the mean of all {drones} drones, its bar the 95 % interval. Of"
        f" {drones * len(limits)} edges {ringing} lie below {lowest} rad/s and count as 0 (\u2193),"
        f"\n{beyond} lie above {highest} rad/s and count as {highest} (\u2191); their numbers stand"
        " at their points."
    )


def _counted(axes: Axes, limits: Sequence[StabilityLimit], colour: str) -> None:
    """Write at each point how many drones lie outside the frequencies tried."""
    for rate, limit in zip(RATES, limits, strict=True):
        for count, sign, below in (
            (limit.ringing, "\u2193", True),
            (limit.beyond, "\u2191", False),
        ):
            if count:
                axes.annotate(
                    f"{sign}{count}",
                    (rate, limit.frequency.low if below else limit.frequency.high),
                    (0, -3 if below else 3),
                    textcoords="offset points",
                    ha="center",
                    va="top" if below else "bottom",
                    fontsize=7,
                    color=colour,
                )


def _frequency_axis(axes: Axes) -> None:
    axes.set_yscale("log")
    axes.set_ylim(1.0, 1.35 * FREQUENCIES[-1])
    axes.yaxis.set_major_locator(FixedLocator([1.0, 2.0, 3.0, 5.0, 10.0, 20.0]))
    axes.yaxis.set_major_formatter(ScalarFormatter())
    axes.yaxis.set_minor_locator(NullLocator())
    axes.set_ylabel("largest stable frequency [rad/s]")


def _rate_line(
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


def _rate_axis(axes: Axes) -> None:
    """Make x the tracking rate, logarithmic."""
    axes.set_xscale("log")
    axes.xaxis.set_major_locator(FixedLocator(list(RATES)))
    axes.xaxis.set_major_formatter(ScalarFormatter())
    axes.xaxis.set_minor_locator(NullLocator())
    axes.set_xlabel("tracking rate [frames/s]")
