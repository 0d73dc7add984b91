"""``housefly reproduce``: the paper's figures and claims, with the numbers that it lacks."""

from __future__ import annotations

import os
import platform
import time
from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from housefly.app.commands.subcommand import Subcommand
from housefly.app.terminal import console, new_progress
from housefly.errors import ConfigError, LinkError

if TYPE_CHECKING:
    from rich.progress import TaskID

    from housefly.app.reproduction_run import Measured
    from housefly.app.reproduction_store import ReproductionStore
    from housefly.config.site import Site
    from housefly.lab.reproduction.exhibit import ClaimFinding
    from housefly.lab.reproduction.page import RunNotes

_DESCRIPTION = """\
Make every figure of the paper again (7, 10-13, 15-17), the tables that it lacks, and a verdict \
on each of its
claims with the number behind it. One service is flown over real wires, some on a stepped clock, \
and thousands by the batch
engine. The result is one page, reproduction.html, with the figures as PNG and SVG beside it. \
Takes a few minutes. What was
flown is kept as it comes: after Ctrl-C, which lands the drone, or a crash, the same command goes \
on."""
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
    parser.add_argument(
        "--fresh", action="store_true", help="throw away what an earlier run has flown in DIR"
    )


def _run(options: Namespace) -> int:
    """Reproduce; 0 when every figure was made."""
    if not 0 <= options.seed < 2**31:
        raise ConfigError("--seed", f"is {options.seed}; allowed: a number from 0 to {2**31 - 1}")
    out = Path(options.out)
    console.print(f"reproducing the paper into {out} ...", markup=False, soft_wrap=True)
    began = time.monotonic()
    from housefly.app.ports import refuse_taken_ports
    from housefly.app.reproduction_store import ReproductionStore
    from housefly.sites.loaded_site import open_site, read_site

    # The paper flies in a plane: both modes fly the same corners, so that only control differs.
    site = read_site(options.site, twin__seed=options.seed, map__planner="grid")
    if not options.no_wires:
        refuse_taken_ports(site, web=False)
    inputs = f"{site.model_dump_json()} {open_site(site).room}"
    store = ReproductionStore(out, inputs, fresh=options.fresh)
    try:
        measured = _measured(options, site, store)
    except KeyboardInterrupt:
        words = f"stopped; what was flown is kept in {out}: run the same again to go on"
        console.print(words, markup=False, soft_wrap=True)
        return 130
    except LinkError as error:
        kept = f"what was flown is kept in {out}: run the same again to go on"
        raise LinkError(f"{error}; {kept}") from error
    found, page = _written(options, out, measured, began)
    _print_verdicts(found, page, time.monotonic() - began)
    return 0


def _measured(options: Namespace, site: Site, store: ReproductionStore) -> Measured:
    from rich.progress import BarColumn, TextColumn, TimeElapsedColumn

    from housefly.app.compiling import CompiledPart, compile_once
    from housefly.app.reproduction_run import Effort, Show, measure

    for part in CompiledPart:
        compile_once(part, console.print)
    effort = Effort(
        seeds=_QUICK_SEEDS if options.quick else _SEEDS,
        repeats=_QUICK_REPEATS if options.quick else _REPEATS,
        wires=not options.no_wires,
    )
    columns = (TextColumn("{task.description:<42}"), BarColumn(24), TimeElapsedColumn())
    with new_progress(*columns) as progress:
        tasks: dict[str, TaskID] = {}

        def share(part: str, done: float | None) -> None:
            if part not in tasks:
                tasks[part] = progress.add_task(part, total=None if done is None else 1.0)
            if done is not None:
                progress.update(tasks[part], total=1.0, completed=done)

        def say(words: str) -> None:
            told = f"{time.strftime('%H:%M:%S')} {words}"
            progress.console.print(told, markup=False, soft_wrap=True)

        return measure(site, store, effort, Show(say, share))


def _written(
    options: Namespace, out: Path, measured: Measured, began: float
) -> tuple[tuple[ClaimFinding, ...], Path]:
    from housefly.app.reproduction_exhibits import draw_exhibits
    from housefly.lab.reproduction.claims import findings
    from housefly.lab.reproduction.counterexamples import judged_elsewhere
    from housefly.lab.reproduction.page import write_page
    from housefly.lab.reproduction.tables import tables

    console.print("flying a world against each verdict ...")
    found = judged_elsewhere(findings(measured.evidence), measured.evidence)
    console.print("drawing figures and page ...")
    exhibits = draw_exhibits(out, measured)
    made = _run_notes(options, time.monotonic() - began, measured)
    return found, write_page(out, exhibits, tables(measured.evidence), found, made)


def _run_notes(options: Namespace, seconds: float, measured: Measured) -> RunNotes:
    from importlib import metadata

    from housefly.lab.reproduction.page import RunNotes

    seeds = _QUICK_SEEDS if options.quick else _SEEDS
    flown = f"{measured.evidence.flights:,}".replace(",", " ")
    quick = " --quick" if options.quick else ""
    wires = " --no-wires" if options.no_wires else ""
    return RunNotes(
        notices=_notices(measured),
        lines=(
            ("made by", f"housefly reproduce --seed {options.seed}{quick}{wires}"),
            ("on", time.strftime("%Y-%m-%d %H:%M")),
            (
                "simulated flights",
                f"{flown} in this world; {seeds} drones in each cell of Tables 1 to 9",
            ),
            ("time of this run", f"{seconds / 60:.1f} min, {len(os.sched_getaffinity(0))} cores"),
            (
                "versions",
                f"Housefly {metadata.version('housefly')}, Python {platform.python_version()}",
            ),
        ),
    )


def _notices(measured: Measured) -> tuple[str, ...]:
    """Return what a reader must know before the figures: flights that were not completed."""
    if not measured.wire_troubles:
        return ()
    reasons = "; ".join(measured.wire_troubles)
    if measured.wired is not None:
        return (
            "The flight of Fig. 17 over real wires was flown again, alone. The first was not"
            f" completed on this machine: {reasons}.",
        )
    return (
        f"No flight over real wires was completed on this machine, in"
        f" {len(measured.wire_troubles)} attempts: {reasons}. Fig. 17 shows the flight on the"
        " stepped clock in its place. On a machine with less to do, run the same command again:"
        " it flies only what is missing.",
    )


def _print_verdicts(found: tuple[ClaimFinding, ...], page: Path, seconds: float) -> None:
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
    console.print(f"written in {seconds / 60:.1f} min: {page}", markup=False, soft_wrap=True)


REPRODUCE_COMMAND = Subcommand(
    name="reproduce",
    help="make the paper's figures and claims again, with the numbers that it lacks",
    description=_DESCRIPTION,
    add_arguments=_add_arguments,
    run=_run,
)
