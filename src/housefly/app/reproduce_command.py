"""``housefly reproduce``: the paper's figures and claims, made again, with the numbers that it
lacks.
"""

from __future__ import annotations

import argparse
import os
import platform
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.console import Console

from housefly.errors import ConfigError

if TYPE_CHECKING:
    from rich.progress import Progress

    from housefly.app.reproduce_flights import Service, Steps, WireService
    from housefly.config.site import Site
    from housefly.lab.reproduction.evidence import Evidence
    from housefly.lab.reproduction.exhibit import Exhibit

console = Console(highlight=False)

DESCRIPTION = """Make every figure of the paper again (7, 10-13, 15-17), the tables that it lacks, and a verdict on each of its
claims with the number behind it. One service is flown over real wires, some on a stepped clock, and thousands by the batch
engine. The result is one page, reproduction.html, with the figures as PNG and SVG beside it. Takes a few minutes; Ctrl-C
lands the drone."""
SEEDS, QUICK_SEEDS = 100, 6
REPEATS, QUICK_REPEATS = 6, 4


def add(actions: Any) -> None:
    """Add the command to the parser."""
    parser = actions.add_parser(
        "reproduce",
        help="make the paper's figures and claims again, with the numbers that it lacks",
        description=DESCRIPTION,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        "--out",
        default="reproduction",
        metavar="DIR",
        help="where to write (default: reproduction)",
    )
    parser.add_argument(
        "--site",
        default="bsen",
        metavar="SITE",
        help="site with room and drone (default: bsen, the paper's own)",
    )
    parser.add_argument(
        "--seed", type=int, default=1, help="seed of everything random (default: 1)"
    )
    parser.add_argument(
        "--quick",
        action="store_true",
        help=f"{QUICK_SEEDS} drones in place of {SEEDS} for each cell of a table",
    )
    parser.add_argument(
        "--no-wires", action="store_true", help="fly nothing over real wires; Fig. 17 is then drawn"
    )
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Reproduce; 0 when every figure was made."""
    from housefly.app.compiling import Part, compile_once
    from housefly.app.ports import refuse_taken_ports
    from housefly.app.premises import read_site
    from housefly.lab.reproduction.claims import findings
    from housefly.lab.reproduction.page import write_page
    from housefly.lab.reproduction.tables import tables

    if not 0 <= options.seed < 2**31:
        raise ConfigError("--seed", f"is {options.seed}; allowed: a number from 0 to {2**31 - 1}")
    site = read_site(options.site, twin__seed=options.seed)
    if not options.no_wires:
        refuse_taken_ports(site, web=False)
    out = Path(options.out)
    out.mkdir(parents=True, exist_ok=True)
    began = time.monotonic()
    for part in Part:
        compile_once(part, console.print)
    with _progress() as progress, ThreadPoolExecutor(1) as pool:
        wires = (
            None
            if options.no_wires
            else pool.submit(_wires, site, out / "flights" / "wires", progress)
        )
        evidence, paper, default, steps = _measure(site, options.quick, out, progress)
        wired = wires.result() if wires else None
        drawing = progress.add_task("figures and page", total=1)
        exhibits = _draw(out, site, evidence, paper, default, steps, wired)
        found = findings(evidence)
        made = _made(options, time.monotonic() - began, evidence)
        page = write_page(out, exhibits, tables(evidence), found, made)
        progress.update(drawing, completed=1)
    _tell(found, page, time.monotonic() - began)
    return 0


def _measure(
    site: Site, quick: bool, out: Path, progress: Progress
) -> tuple[Evidence, Service, Service, Steps]:
    from housefly.app.reproduce_flights import fly_service, fly_steps
    from housefly.lab.reproduction.evidence import gather

    flying = progress.add_task("services and steps on a stepped clock", total=3)
    paper = fly_service(site, "paper", out / "flights" / "paper")
    progress.advance(flying)
    default = fly_service(site, "default", out / "flights" / "default")
    progress.advance(flying)
    steps = fly_steps(site, QUICK_REPEATS if quick else REPEATS)
    progress.advance(flying)
    batch = progress.add_task("thousands of simulated drones", total=1.0)
    evidence = gather(
        site, QUICK_SEEDS if quick else SEEDS, lambda share: progress.update(batch, completed=share)
    )
    return (
        replace(evidence, services=(paper.summary, default.summary), pitch=steps.fit),
        paper,
        default,
        steps,
    )


def _wires(site: Site, folder: Path, progress: Progress) -> WireService:
    from housefly.app.reproduce_flights import fly_wires

    task = progress.add_task("one service over real wires (about 70 s)", total=None)
    found = fly_wires(
        site, folder, lambda words: progress.update(task, description=f"over real wires: {words}")
    )
    progress.update(task, description="one service over real wires", total=1, completed=1)
    return found


def _draw(
    out: Path,
    site: Site,
    evidence: Evidence,
    paper: Service,
    default: Service,
    steps: Steps,
    wired: WireService | None,
) -> tuple[Exhibit, ...]:
    from housefly.lab.reproduction import (
        fig07_grid,
        fig10_acceptor,
        fig11_angles,
        fig12_loops,
        fig15_paths,
        fig17_service,
        table_plots,
    )
    from housefly.messages import Phase

    room = paper.premises.room
    outbound = default.flight.during(Phase.OUTBOUND)
    start = float(default.flight.at[outbound][0])
    moments, photographed = _moments(wired or default)
    service = wired.service if wired else default
    return (
        fig07_grid.draw(out, paper.premises.grid, room.home),
        fig10_acceptor.draw(out),
        fig11_angles.draw(
            out, steps.onboard, _tracked(steps), steps.fit, steps.identified.constants
        ),
        *fig12_loops.draw(out, default.flight, start),
        *fig15_paths.draw(
            out,
            (paper.premises.grid, paper.flight),
            (default.premises.grid, default.flight),
            room.place("entrance").viewpoint,
        ),
        fig17_service.draw(
            out, moments, service.summary.outcome, photographed, over_wires=wired is not None
        ),
        *table_plots.draw(evidence, out),
    )


def _tracked(steps: Steps) -> tuple[Any, Any]:
    """Return times and angles of all steps by tracking, each turned to the same sign."""
    from housefly.lab.identification.picture import step_response
    from housefly.lab.reproduction.fig11_angles import ALPHA, THETA_MAX

    found = step_response(steps.identified)
    return found.at, found.share * ALPHA * THETA_MAX


def _moments(flown: WireService | Service) -> tuple[tuple[Any, ...], bool]:
    """Return the pairs of pictures, and whether the consoles are photographs."""
    from housefly.app.reproduce_flights import MOMENTS, WireService, camera_pictures
    from housefly.lab.reproduction.fig17_service import Moment, drawn_console

    if isinstance(flown, WireService):
        flight, grid = flown.service.flight, flown.service.premises.grid
        end = flown.service.flight.steps[-1].now
        cameras = camera_pictures(flown.folder, tuple(end - shot.step.now for shot in flown.shots))
        start = flight.steps[0].now
        photographed = all(shot.console is not None for shot in flown.shots)
        return (
            tuple(
                Moment(
                    shot.title,
                    shot.step.now - start,
                    (
                        shot.console
                        if photographed and shot.console is not None
                        else drawn_console(grid, flight, shot.step.now - start)
                    ),
                    camera,
                )
                for shot, camera in zip(flown.shots, cameras, strict=True)
            ),
            photographed,
        )
    flight = flown.flight
    found = []
    for title, phase, after in MOMENTS:
        at = flight.at[flight.during(phase)]
        if at.size:
            when = min(float(at[0]) + after, float(at[-1]))
            found.append(
                Moment(title, when, drawn_console(flown.premises.grid, flight, when), None)
            )
    return tuple(found), False


def _made(options: argparse.Namespace, seconds: float, evidence: Evidence) -> Any:
    from importlib import metadata

    from housefly.lab.reproduction.page import Made

    flown = (
        evidence.streams.outcomes.size
        + evidence.edges.values.size
        + sum(t.size for t in evidence.trials.values())
    )
    quick = " --quick" if options.quick else ""
    wires = " --no-wires" if options.no_wires else ""
    return Made(
        (
            ("made by", f"housefly reproduce --seed {options.seed}{quick}{wires}"),
            ("on", time.strftime("%Y-%m-%d %H:%M")),
            ("simulated flights", f"{flown:,}".replace(",", " ")),
            ("time", f"{seconds / 60:.1f} min, {len(os.sched_getaffinity(0))} cores"),
            (
                "versions",
                f"Housefly {metadata.version('housefly')}, Python {platform.python_version()}",
            ),
        )
    )


def _tell(found: tuple[Any, ...], page: Path, seconds: float) -> None:
    from housefly.lab.reproduction.exhibit import Verdict

    counts = ", ".join(
        f"{sum(f.verdict is verdict for f in found)} {verdict.value}" for verdict in Verdict
    )
    console.print(f"{len(found)} claims: {counts}")
    low = next(f for f in found if f.key == "low frame rate")
    console.print(
        f"low frame rate causes unstable behaviors: [bold]{low.verdict.value}[/bold]."
        f" {low.evidence}"
    )
    console.print(f"written in {seconds / 60:.1f} min: {page}", soft_wrap=True)


def _progress() -> Progress:
    from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

    columns = (TextColumn("{task.description:<42}"), BarColumn(24), TimeElapsedColumn())
    return Progress(*columns, console=console, transient=not console.is_terminal)
