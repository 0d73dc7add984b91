"""The report of a flight that others recorded: one self-contained HTML file."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from housefly.numeric import FloatArray
from housefly.record import svg
from housefly.record.flight_log import FlightLog
from housefly.record.report_parts import (
    report_events,
    report_figure,
    report_number,
    report_page,
    report_text,
)
from housefly.record.summary import EventRecord

_WIDTH, _ROW = 10.4, 1.35
"""Width of a figure and height of one strip [inch]."""
_SPAN_MIN = 0.02
"""An axis spans at least this: what is constant is drawn as a line, not as its rounding."""
_Line = tuple[str, FloatArray]


def write_log_report(path: Path, log: FlightLog, source: str) -> None:
    """Write the report of a log; raises OSError when that fails.

    Args:
        path: of the HTML file.
        log: what is drawn; a quantity that it lacks is said, and has no drawing.
        source: name of the log, as people know it.
    """
    known = [(title, report_figure(drawn, words)) for title, drawn, words in _figures(log)]
    events = [
        EventRecord(round(one.at, 3), one.severity.value, "log", one.text) for one in log.events
    ]
    sections = [*known, ("Events", report_events(events))]
    page = report_page(f"Flight report: {source}", _header(log, source), sections)
    path.write_text(page, encoding="utf-8")


def _figures(log: FlightLog) -> list[tuple[str, str, str]]:
    """Return title, drawing and caption of all that the log holds."""
    figures = []
    if _holds(log.position):
        figures.append(("The flight", _from_above(log), "From above, in the log's own world."))
        strips = [
            _strip(f"{name} [m]", ("logged", log.position[:, n]), ("wanted", log.wanted[:, n]))
            for n, name in enumerate("xyz")
        ]
        figures.append(("Position", _strips("position", log, strips), "What was, and was wanted."))
    if _holds(log.velocity):
        strips = [
            _strip(
                f"v{name} [m/s]",
                ("logged", log.velocity[:, n]),
                ("wanted", log.wanted_velocity[:, n]),
            )
            for n, name in enumerate("xyz")
        ]
        speed = np.linalg.norm(log.velocity, axis=1)
        strips.append(_strip("speed [m/s]", ("logged", speed)))
        caption = "In the world; what was wanted is drawn as its sender wrote it."
        figures.append(("Velocity", _strips("velocity", log, strips), caption))
    if _holds(log.attitude):
        names = ("roll [rad], right is positive", "pitch [rad], forward is positive", "yaw [rad]")
        strips = [
            _strip(name, ("logged", _unwound(log.attitude[:, n]))) for n, name in enumerate(names)
        ]
        figures.append(("Attitude", _strips("attitude", log, strips), "REP-103 signs."))
    if _holds(log.battery):
        strips = [_strip("battery [%]", ("logged", 100.0 * log.battery))]
        figures.append(("Battery", _strips("battery", log, strips), "As the drone told it."))
    return figures


def _header(log: FlightLog, source: str) -> str:
    began = ""
    if log.started_at is not None:
        at = datetime.fromtimestamp(log.started_at, UTC)
        began = f" · began {at.strftime('%Y-%m-%d %H:%M:%S UTC')}"
    where = f"<p>{report_text(source)} · {report_text(log.kind)}{began}</p>"
    problems = "".join(
        f'<p class="problem">▲ {report_text(problem)}</p>' for problem in log.problems
    )
    lacks = (
        f"<p>This file holds no {report_text(', no '.join(log.lacks))}.</p>" if log.lacks else ""
    )
    named = "; ".join(f"{words}: {topic}" for words, topic in log.sources.items())
    sources = f"<p>Read from: {report_text(named)}.</p>" if named else ""
    numbers = "<dl>" + "".join(report_number(*row) for row in log_numbers(log)) + "</dl>"
    return f"<header><h1>Flight report</h1>{where}{problems}{lacks}{sources}{numbers}</header>"


def log_numbers(log: FlightLog) -> tuple[tuple[str, float | None, int, str], ...]:
    """Return name, value, digits and unit of what a log says in numbers; None where it does not."""
    way = None
    if _holds(log.position):
        places = log.position[np.isfinite(log.position).all(axis=1)]
        way = float(np.linalg.norm(np.diff(places, axis=0), axis=1).sum())
    speed = np.linalg.norm(log.velocity, axis=1)
    battery = log.battery[np.isfinite(log.battery)]
    return (
        ("duration", float(log.time[-1]), 1, "s"),
        ("rows", log.time.size, 0, ""),
        ("sum of all steps", way, 2, "m"),
        ("highest speed", float(np.nanmax(speed)) if _holds(log.velocity) else None, 2, "m/s"),
        (
            "highest place",
            float(np.nanmax(log.position[:, 2])) if _holds(log.position) else None,
            2,
            "m",
        ),
        ("battery used", 100.0 * float(battery[0] - battery[-1]) if battery.size else None, 1, "%"),
    )


def _holds(values: FloatArray) -> bool:
    return bool(np.isfinite(values).any())


def _unwound(angles: FloatArray) -> FloatArray:
    """Return angles that do not jump where they wrap."""
    told = angles.copy()
    known = np.isfinite(told)
    told[known] = np.unwrap(told[known])
    return told


def _strip(name: str, *lines: _Line) -> tuple[str, tuple[_Line, ...]]:
    return name, tuple(line for line in lines if _holds(line[1]))


def _strips(name: str, log: FlightLog, rows: Sequence[tuple[str, tuple[_Line, ...]]]) -> str:
    with svg.drawing(name):
        height = _ROW * len(rows) + 0.6
        figure = Figure(figsize=(_WIDTH, height))
        figure.subplots_adjust(
            left=0.06, right=0.985, bottom=0.42 / height, top=1.0 - 0.3 / height, hspace=0.45
        )
        strips = list(np.atleast_1d(figure.subplots(len(rows), 1, sharex=True)))
        for axes, (title, lines) in zip(strips, rows, strict=True):
            axes.set_title(title)
            for number, (label, values) in enumerate(lines):
                style = "-" if number == 0 else (0, (4, 3))
                colour = svg.ACCENT if number == 0 else svg.SECONDARY
                axes.plot(log.time, values, color=colour, linestyle=style, label=label)
            low, high = axes.get_ylim()
            if high - low < _SPAN_MIN:
                middle = (low + high) / 2.0
                axes.set_ylim(middle - _SPAN_MIN / 2.0, middle + _SPAN_MIN / 2.0)
        if any(len(lines) > 1 for _, lines in rows):
            strips[0].legend(loc="upper right", ncols=2, bbox_to_anchor=(1.0, 1.4))
        strips[-1].set_xlabel("time [s]")
        strips[0].set_xlim(0.0, max(float(log.time[-1]), 1e-3))
        return svg.to_svg(figure, f"{name.capitalize()} over time")


def _from_above(log: FlightLog) -> str:
    with svg.drawing("above"):
        figure = Figure(figsize=(_WIDTH, 6.0), layout="constrained")
        axes = figure.add_subplot()
        if _holds(log.wanted):
            axes.plot(
                *log.wanted[:, :2].T, color=svg.SECONDARY, linestyle=(0, (4, 3)), label="wanted"
            )
        axes.plot(*log.position[:, :2].T, color=svg.ACCENT, label="logged")
        first = log.position[np.isfinite(log.position).all(axis=1)][0]
        axes.plot(*first[:2], "o", color=svg.TEXT, label="start")
        axes.set(aspect="equal", xlabel="x [m]", ylabel="y [m]")
        axes.margins(0.1)
        axes.legend(loc="upper right")
        return svg.to_svg(figure, "The way that was flown, from above")
