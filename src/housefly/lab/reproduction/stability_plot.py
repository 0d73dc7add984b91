"""The largest stable frequency over the tracking rate, with every drone counted."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, NullLocator, ScalarFormatter

from housefly.lab.reproduction.edges import ESTIMATORS, FREQUENCIES
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.rate_lines import COLOURS, MARKERS, rate_axis, rate_line
from housefly.lab.reproduction.stability_limit import StabilityLimit, stability_limit
from housefly.lab.reproduction.streams import LATENCIES, OWN_FREQUENCY, RATES


def draw_stability(figure: Figure, evidence: Evidence) -> None:
    """Draw a panel a latency, a line an estimator."""
    panels = figure.subplots(1, len(LATENCIES), sharey=True)
    shown: list[StabilityLimit] = []
    for axes, latency in zip(panels, LATENCIES, strict=True):
        for (estimator, name), colour, marker in zip(
            ESTIMATORS.items(), COLOURS, MARKERS, strict=True
        ):
            limits = [stability_limit(evidence.edges, estimator, rate, latency) for rate in RATES]
            rate_line(axes, [limit.frequency for limit in limits], colour, marker, name)
            _counted(axes, limits, colour)
            shown += limits
        axes.axhline(OWN_FREQUENCY, color="#555555", linestyle=":", linewidth=1.2)
        axes.set_title(f"{1000 * latency:.0f} ms latency")
        rate_axis(axes)
    _frequency_axis(panels[0])
    panels[0].annotate(
        "our gains",
        (RATES[-1], OWN_FREQUENCY),
        (0, -10),
        textcoords="offset points",
        ha="right",
        color="#555555",
    )
    handles, names = panels[0].get_legend_handles_labels()
    figure.legend(handles, names, loc="outside upper center", ncols=2)
    figure.supxlabel(drones_counted(shown), fontsize=8, color="#555555")


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
