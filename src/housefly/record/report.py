"""The flight report: one self-contained HTML file."""

from __future__ import annotations

import html
from datetime import UTC, datetime
from pathlib import Path

from housefly.config.site import Site
from housefly.record.map_plot import map_svg
from housefly.record.report_style import REPORT_CSS
from housefly.record.series import FlightSeries
from housefly.record.speed_plots import height_svg, stopping_svg
from housefly.record.summary import EventRecord, Summary
from housefly.record.time_plots import commands_svg, health_svg, position_svg, states_svg
from housefly.room.grid import OccupancyGrid
from housefly.room.model import Room

_MARKS = {"info": "", "warning": "\u25b2", "fault": "\u25a0"}
"""Shapes beside the words, for those who do not see colours."""


def write_report(
    path: Path, flight: FlightSeries, summary: Summary, site: Site, room: Room, grid: OccupancyGrid
) -> None:
    """Write ``report.html``; raises OSError when that fails."""
    sections = [
        (
            "The flight",
            _figure(
                map_svg(flight, room, grid),
                "From above. The line that was flown is where the tracking system saw the drone.",
            ),
        ),
        *_height_section(flight),
        (
            "Speed, way to a stop, uncertainty",
            _figure(
                stopping_svg(flight, site.drone.airframe.braking),
                "How far the drone flies on when it brakes as hard as it can be counted on, after"
                " the time to react; and how sure the filter is of the place.",
            ),
        ),
        (
            "Errand, behavior, safety",
            _figure(states_svg(flight), "Who was in charge, and of what, at every moment."),
        ),
        (
            "Position",
            _figure(
                position_svg(flight),
                "Estimate of the Kalman filter against the reference of the path.",
            ),
        ),
        (
            "Commands",
            _figure(
                commands_svg(flight, site),
                "What the drone was asked for. Dotted: the site's limits.",
            ),
        ),
        (
            "Battery and ages",
            _figure(
                health_svg(flight, site),
                "Dotted: what makes the last gate level or land the drone.",
            ),
        ),
        ("Events", _events(summary.events)),
    ]
    body = "\n".join(f"<section><h2>{title}</h2>{content}</section>" for title, content in sections)
    path.write_text(_page(_header(summary, site, room), body), encoding="utf-8")


def _height_section(flight: FlightSeries) -> list[tuple[str, str]]:
    """Return the heights of what was planned in space; nothing of a flight in the plane."""
    drawn = height_svg(flight)
    caption = "Each planned curve from its start; its colour is the planned speed."
    return [("Height along the way", _figure(drawn, caption))] if drawn else []


def _page(header: str, body: str) -> str:
    return f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>Housefly flight report</title>
<style>{REPORT_CSS}</style>
</head>
<body>
<main>
{header}
{body}
</main>
</body>
</html>
"""


def _header(summary: Summary, site: Site, room: Room) -> str:
    simulated = (
        f"simulated room, seed {summary.seed}" if summary.seed is not None else "real hardware"
    )
    written = datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC")
    where = (
        f"<p>{_text(site.name)} \u00b7 room {_text(room.name)} \u00b7 mode {summary.mode} \u00b7"
        f" {simulated} \u00b7 {written}</p>"
    )
    problems = "".join(
        f'<p class="problem">\u25b2 {_text(problem)}</p>' for problem in summary.problems
    )
    return (
        "<header><h1>Flight"
        f" report</h1>{_outcome(summary.outcome)}{where}{problems}{_numbers(summary)}</header>"
    )


def _outcome(outcome: str) -> str:
    kind, mark = ("good", "\u2713") if outcome == "completed" else ("bad", "\u2715")
    return f'<p class="outcome {kind}"><span>{mark}</span>{_text(outcome)}</p>'


def _numbers(summary: Summary) -> str:
    rows = (
        ("duration", summary.duration_s, 1, "s"),
        ("path to the goal", summary.path_length_m, 2, "m"),
        ("way flown", summary.flown_length_m, 2, "m"),
        ("true path error, rms", summary.rms_error_m, 3, "m"),
        ("tracked path error, rms", summary.tracked_rms_error_m, 3, "m"),
        ("true path error, largest", summary.max_error_m, 3, "m"),
        ("true goal error, mean", summary.arrival_error_m, 3, "m"),
        ("tracked goal error, mean", summary.tracked_arrival_error_m, 3, "m"),
        ("true landing error", summary.landed_error_m, 3, "m"),
        ("smallest true clearance", summary.min_clearance_m, 2, "m"),
        ("... from people", summary.min_clearance_people_m, 2, "m"),
        ("contacts", None if summary.contacts is None else len(summary.contacts), 0, ""),
        ("tracking rate", summary.mocap_rate_hz, 1, "Hz"),
        ("pictures", summary.video_frames, 0, ""),
        (
            "battery used",
            None if summary.battery_used is None else 100.0 * summary.battery_used,
            1,
            "%",
        ),
        (
            "steps recorded",
            summary.steps,
            0,
            "" if not summary.missing_steps else f"({summary.missing_steps} missing)",
        ),
    )
    return "<dl>" + "".join(_number(*row) for row in rows) + "</dl>"


def _number(name: str, value: float | None, digits: int, unit: str) -> str:
    shown = "\u2014" if value is None else f"{value:,.{digits}f}".replace(",", "\u202f")
    return (
        f"<div><dt>{name}</dt><dd>{shown} <small>{'' if value is None else unit}</small></dd></div>"
    )


def _figure(svg: str, caption: str) -> str:
    return f'<figure><div class="plot">{svg}</div><figcaption>{caption}</figcaption></figure>'


def _events(events: tuple[EventRecord, ...]) -> str:
    if not events:
        return "<p>Nothing was reported.</p>"
    rows = "".join(
        f'<tr class="{event.severity}"><td>{event.at_s:.2f}</td><td>{_MARKS[event.severity]}'
        f" {event.severity}</td>"
        f"<td>{_text(event.text)}</td><td><code>{_text(event.code)}</code></td></tr>"
        for event in events
    )
    head = "<tr><th>time [s]</th><th>severity</th><th>what</th><th>code</th></tr>"
    return f'<div class="plot"><table><thead>{head}</thead><tbody>{rows}</tbody></table></div>'


def _text(value: str) -> str:
    return html.escape(value)
