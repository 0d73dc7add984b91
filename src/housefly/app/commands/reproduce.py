"""``housefly reproduce``: the paper's figures and claims, with the numbers that it lacks."""

from __future__ import annotations

import os
import platform
import time
from argparse import ArgumentParser, Namespace
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from housefly.app.commands.subcommand import Subcommand
from housefly.app.terminal import console, new_progress
from housefly.errors import ConfigError

if TYPE_CHECKING:
    from rich.progress import Progress

    from housefly.app.reproduction_flights import RecordedService, StepFlight, WireService
    from housefly.config.site import Site
    from housefly.lab.reproduction.evidence import Evidence

_DESCRIPTION = """\
Make every figure of the paper again (7, 10-13, 15-17), the tables that it lacks, and a verdict \
on each of its
claims with the number behind it. One service is flown over real wires, some on a stepped clock, \
and thousands by the batch
engine. The result is one page, reproduction.html, with the figures as PNG and SVG beside it. \
Takes a few minutes; Ctrl-C
lands the drone."""
_SEEDS, _QUICK_SEEDS = 100, 6
_REPEATS, _QUICK_REPEATS = 6, 4


def _add_arguments(parser: ArgumentParser) -> None:
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
        help=f"{_QUICK_SEEDS} drones in place of {_SEEDS} for each cell of a table",
    )
    parser.add_argument(
        "--no-wires", action="store_true", help="fly nothing over real wires; Fig. 17 is then drawn"
    )


def _run(options: Namespace) -> int:
    """Reproduce; 0 when every figure was made."""
    from rich.progress import BarColumn, TextColumn, TimeElapsedColumn

    from housefly.app.compiling import CompiledPart, compile_once
    from housefly.app.loaded_site import read_site
    from housefly.app.ports import refuse_taken_ports
    from housefly.app.reproduction_exhibits import draw_exhibits
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
    for part in CompiledPart:
        compile_once(part, console.print)
    columns = (TextColumn("{task.description:<42}"), BarColumn(24), TimeElapsedColumn())
    with new_progress(*columns) as progress, ThreadPoolExecutor(1) as pool:
        wires = (
            None
            if options.no_wires
            else pool.submit(_wires, site, out / "flights" / "wires", progress)
        )
        evidence, paper, default, steps = _measure(site, options.quick, out, progress)
        wired = wires.result() if wires else None
        drawing = progress.add_task("figures and page", total=1)
        exhibits = draw_exhibits(out, evidence, paper, default, steps, wired)
        found = findings(evidence)
        made = _run_notes(options, time.monotonic() - began, evidence)
        page = write_page(out, exhibits, tables(evidence), found, made)
        progress.update(drawing, completed=1)
    _print_verdicts(found, page, time.monotonic() - began)
    return 0


def _measure(
    site: Site, quick: bool, out: Path, progress: Progress
) -> tuple[Evidence, RecordedService, RecordedService, StepFlight]:
    from housefly.app.reproduction_flights import fly_recorded_service, fly_steps
    from housefly.lab.reproduction.evidence import gather

    flying = progress.add_task("services and steps on a stepped clock", total=3)
    paper = fly_recorded_service(site, "paper", out / "flights" / "paper")
    progress.advance(flying)
    default = fly_recorded_service(site, "default", out / "flights" / "default")
    progress.advance(flying)
    steps = fly_steps(site, _QUICK_REPEATS if quick else _REPEATS)
    progress.advance(flying)
    batch = progress.add_task("thousands of simulated drones", total=1.0)
    seeds = _QUICK_SEEDS if quick else _SEEDS
    evidence = gather(site, seeds, lambda share: progress.update(batch, completed=share))
    return (
        replace(evidence, services=(paper.summary, default.summary), pitch=steps.fit),
        paper,
        default,
        steps,
    )


def _wires(site: Site, folder: Path, progress: Progress) -> WireService:
    from housefly.app.reproduction_flights import fly_recorded_over_wires

    task = progress.add_task("one service over real wires (about 70 s)", total=None)
    found = fly_recorded_over_wires(
        site, folder, lambda words: progress.update(task, description=f"over real wires: {words}")
    )
    progress.update(task, description="one service over real wires", total=1, completed=1)
    return found


def _run_notes(options: Namespace, seconds: float, evidence: Evidence) -> Any:
    from importlib import metadata

    from housefly.lab.reproduction.page import RunNotes

    flown = (
        evidence.streams.outcomes.size
        + evidence.edges.values.size
        + sum(t.size for t in evidence.trials.values())
    )
    quick = " --quick" if options.quick else ""
    wires = " --no-wires" if options.no_wires else ""
    return RunNotes(
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


def _print_verdicts(found: tuple[Any, ...], page: Path, seconds: float) -> None:
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


REPRODUCE_COMMAND = Subcommand(
    name="reproduce",
    help="make the paper's figures and claims again, with the numbers that it lacks",
    description=_DESCRIPTION,
    add_arguments=_add_arguments,
    run=_run,
)
