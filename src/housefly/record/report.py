"""The flight report: one self-contained HTML file."""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path

from housefly.config.site import Site
from housefly.record.map_plot import map_svg
from housefly.record.report_parts import (
    report_events,
    report_figure,
    report_number,
    report_page,
    report_text,
)
from housefly.record.series import FlightSeries
from housefly.record.speed_plots import height_svg, stopping_svg
from housefly.record.summary import Summary
from housefly.record.time_plots import commands_svg, health_svg, position_svg, states_svg
from housefly.room.grid import OccupancyGrid
from housefly.room.model import Room


def write_report(
    path: Path, flight: FlightSeries, summary: Summary, site: Site, room: Room, grid: OccupancyGrid
) -> None:
    """Write ``report.html``; raises OSError when that fails."""
    sections = [
        (
            "The flight",
            report_figure(
                map_svg(flight, room, grid),
                "From above. The line that was flown is where the tracking system saw the drone.",
            ),
        ),
        *_height_section(flight),
        (
            "Speed, way to a stop, uncertainty",
            report_figure(
                stopping_svg(flight, site.drone.airframe.braking),
                "How far the drone flies on when it brakes as hard as it can be counted on, after"
                " the time to react; and how sure the filter is of the place.",
            ),
        ),
        (
            "Errand, behavior, safety",
            report_figure(states_svg(flight), "Who was in charge, and of what, at every moment."),
        ),
        (
            "Position",
            report_figure(
                position_svg(flight),
                "Estimate of the Kalman filter against the reference of the path.",
            ),
        ),
        (
            "Commands",
            report_figure(
                commands_svg(flight, site),
                "What the drone was asked for. Dotted: the site's limits.",
            ),
        ),
        (
            "Battery and ages",
            report_figure(
                health_svg(flight, site),
                "Dotted: what makes the last gate level or land the drone.",
            ),
        ),
        ("Events", report_events(summary.events)),
    ]
    page = report_page("Housefly flight report", _header(summary, site, room), sections)
    path.write_text(page, encoding="utf-8")


def _height_section(flight: FlightSeries) -> list[tuple[str, str]]:
    """Return the heights of what was planned in space; nothing of a flight in the plane."""
    drawn = height_svg(flight)
    caption = "Each planned curve from its start; its colour is the planned speed."
    return [("Height along the way", report_figure(drawn, caption))] if drawn else []


def _header(summary: Summary, site: Site, room: Room) -> str:
    simulated = (
        f"simulated room, seed {summary.seed}" if summary.seed is not None else "real hardware"
    )
    written = datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC")
    where = (
        f"<p>{report_text(site.name)} \u00b7 room {report_text(room.name)} \u00b7 mode"
        f" {summary.mode} \u00b7 {simulated} \u00b7 {written}</p>"
    )
    problems = "".join(
        f'<p class="problem">\u25b2 {report_text(problem)}</p>' for problem in summary.problems
    )
    return (
        "<header><h1>Flight"
        f" report</h1>{_outcome(summary.outcome)}{where}{problems}{_numbers(summary)}</header>"
    )


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
    return "<dl>" + "".join(report_number(*row) for row in rows) + "</dl>"


def _outcome(outcome: str) -> str:
    kind, mark = ("good", "\u2713") if outcome == "completed" else ("bad", "\u2715")
    return f'<p class="outcome {kind}"><span>{mark}</span>{report_text(outcome)}</p>'
