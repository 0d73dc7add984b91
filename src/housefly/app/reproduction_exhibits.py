"""The figures of a reproduction, drawn from its flights and tables."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from housefly.app.reproduction_flights import RecordedService, StepFlight, WireService
from housefly.app.reproduction_moments import MOMENTS, video_pictures
from housefly.lab.identification.plots import step_response
from housefly.lab.reproduction import (
    fig07_grid,
    fig10_acceptor,
    fig11_angles,
    fig12_loops,
    fig15_paths,
    fig17_service,
    table_plots,
)
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.exhibit import Exhibit
from housefly.lab.reproduction.fig11_angles import ALPHA, THETA_MAX
from housefly.lab.reproduction.fig17_service import Moment, drawn_console
from housefly.messages import Phase


def draw_exhibits(
    out: Path,
    evidence: Evidence,
    paper: RecordedService,
    default: RecordedService,
    steps: StepFlight,
    wired: WireService | None,
) -> tuple[Exhibit, ...]:
    """Draw all figures into a folder; a service over real wires is shown where there is one."""
    room = paper.loaded.room
    outbound = default.flight.during(Phase.OUTBOUND)
    start = float(default.flight.at[outbound][0])
    moments, photographed = _wire_moments(wired) if wired else (_lockstep_moments(default), False)
    service = wired.service if wired else default
    return (
        fig07_grid.draw_fig07(out, paper.loaded.grid, room.home),
        fig10_acceptor.draw_fig10(out),
        fig11_angles.draw_fig11(
            out, steps.onboard, _tracked(steps), steps.fit, steps.identified.constants
        ),
        *fig12_loops.draw_fig12_and_13(out, default.flight, start),
        *fig15_paths.draw_fig15_and_16(
            out,
            (paper.loaded.grid, paper.flight),
            (default.loaded.grid, default.flight),
            room.place("entrance").viewpoint,
        ),
        fig17_service.draw_fig17(
            out, moments, service.summary.outcome, photographed, over_wires=wired is not None
        ),
        *table_plots.draw_table_plots(evidence, out),
    )


def _tracked(steps: StepFlight) -> tuple[Any, Any]:
    """Return times and angles of all steps by tracking, each turned to the same sign."""
    found = step_response(steps.identified)
    return found.at, found.share * ALPHA * THETA_MAX


def _wire_moments(flown: WireService) -> tuple[tuple[Moment, ...], bool]:
    """Return the pairs of pictures, and whether the consoles are photographs."""
    flight, grid = flown.service.flight, flown.service.loaded.grid
    start, end = flight.steps[0].now, flight.steps[-1].now
    cameras = video_pictures(flown.folder, tuple(end - shot.step.now for shot in flown.shots))
    photographed = all(shot.console is not None for shot in flown.shots)
    moments = []
    for shot, camera in zip(flown.shots, cameras, strict=True):
        at = shot.step.now - start
        console = shot.console if photographed else None
        if console is None:
            console = drawn_console(grid, flight, at)
        moments.append(Moment(shot.title, at, console, camera))
    return tuple(moments), photographed


def _lockstep_moments(flown: RecordedService) -> tuple[Moment, ...]:
    """Return drawn consoles: a service on a stepped clock has no cameras."""
    flight, moments = flown.flight, []
    for title, phase, after in MOMENTS:
        at = flight.at[flight.during(phase)]
        if at.size:
            when = min(float(at[0]) + after, float(at[-1]))
            console = drawn_console(flown.loaded.grid, flight, when)
            moments.append(Moment(title, when, console, None))
    return tuple(moments)
