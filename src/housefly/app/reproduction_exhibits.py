"""The figures of a reproduction, drawn from its flights and tables."""

from __future__ import annotations

from pathlib import Path

from housefly.app.reproduction_flights import GOAL, RecordedService, demanded_accelerations
from housefly.app.reproduction_moments import MOMENTS, video_pictures
from housefly.app.reproduction_run import Measured
from housefly.app.reproduction_wires import WireService
from housefly.lab.reproduction import (
    fig07_grid,
    fig10_acceptor,
    fig11_angles,
    fig12_loops,
    fig15_paths,
    fig17_service,
    table_plots,
)
from housefly.lab.reproduction.exhibit import Exhibit
from housefly.lab.reproduction.fig17_service import Moment, drawn_console
from housefly.messages import Phase

_STAND_IN = (
    "This is not the flight over real wires: on this machine none was completed. The flight on the"
    " stepped clock stands in for it."
)


def draw_exhibits(out: Path, measured: Measured) -> tuple[Exhibit, ...]:
    """Draw all figures into a folder; a service over real wires is shown where there is one."""
    paper, default, wired = measured.paper, measured.default, measured.wired
    room = paper.loaded.room
    outbound = default.flight.during(Phase.OUTBOUND)
    start = float(default.flight.at[outbound][0])
    demanded = demanded_accelerations(default.loaded, default.flight.steps)
    moments, photographed = _wire_moments(wired) if wired else (_lockstep_moments(default), False)
    service = wired.service if wired else default
    return (
        fig07_grid.draw_fig07(out, paper.loaded.grid, room.home),
        fig10_acceptor.draw_fig10(out),
        fig11_angles.draw_fig11(out, measured.steps),
        *fig12_loops.draw_fig12_and_13(out, default.flight, demanded, start),
        *fig15_paths.draw_fig15_and_16(
            out,
            (paper.loaded.grid, paper.flight),
            (default.loaded.grid, default.flight),
            room.place(GOAL).viewpoint,
        ),
        fig17_service.draw_fig17(
            out,
            moments,
            service.summary.outcome,
            photographed,
            over_wires=wired is not None,
            notice=_STAND_IN if measured.wire_troubles and wired is None else "",
        ),
        *table_plots.draw_table_plots(measured.evidence, out),
    )


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
