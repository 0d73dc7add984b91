"""``housefly campaign``: many flights from one file."""

from __future__ import annotations

import argparse
import re
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.console import Console

from housefly.errors import ConfigError

if TYPE_CHECKING:
    from housefly.campaigns.folder import CampaignFolder
    from housefly.campaigns.plan import Plan
    from housefly.campaigns.runner import Fleet
    from housefly.campaigns.spec import Spec

console = Console(highlight=False)

EPILOG = """the file (docs/campaigns.md lists every key):
  name = "tracking rate"
  seeds = 100
  [mission]
  goal = "entrance"                      # planned by the site's room; or waypoints = [[0, 0], [3, 0]]
  [grid]                                 # every combination is flown
  mode = ["default", "paper"]
  mocap_rate_hz = [10, 20, 30, 50, 100]
  [draw]                                 # drawn anew for each seed
  lag = {normal = [7.0, 1.0]}

A campaign that was stopped goes on where it stopped: run the same again.
"""
PROBE = 200
"""Drones flown to estimate the time of all."""
ROWS = 40
"""Rows of the summary that are printed."""


def add(actions: Any) -> None:
    """Add the command to the parser."""
    parser = actions.add_parser(
        "campaign",
        help="fly thousands of simulated drones from one file: grids, distributions, seeds",
        description="Fly the closed loop (reduced-order drone, stamped noisy tracking, filter, acceptor, control, safety) "
        "for every drone of a campaign file; write results.parquet, summary.csv and plots.",
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("spec", metavar="SPEC.toml", help="the campaign file")
    parser.add_argument("--out", metavar="DIR", help="where to write (default: campaigns/<name>)")
    parser.add_argument("--threads", type=int, metavar="N", help="threads (default: one a core)")
    parser.add_argument("--cluster", metavar="ADDRESS", help="spread it over a Dask cluster, for example tcp://127.0.0.1:8786")
    parser.add_argument("--fresh", action="store_true", help="forget what the folder holds of an earlier run")
    parser.add_argument("--dry-run", action="store_true", help="say how many drones would fly and for how long, then stop")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Fly a campaign, or what is missing of it."""
    from housefly.campaigns.plan import plan_campaign
    from housefly.campaigns.spec import load_spec

    if options.threads is not None and not 1 <= options.threads <= 1024:
        raise ConfigError("--threads", f"is {options.threads}; allowed: a number from 1 to 1024")
    path = Path(options.spec)
    spec = load_spec(path)
    plan = plan_campaign(spec, _site(spec, path.parent))
    seconds = sum(len(leg.points) * spec.seeds * leg.mission.duration for leg in plan.legs)
    console.print(
        f"{spec.name}: {spec.points} points x {spec.seeds} seeds = {plan.drones:,} drones, {seconds:,.0f} drone-seconds"
    )
    if options.dry_run:
        return _estimate(plan, seconds, options.threads)
    return _fly(plan, options)


def _fly(plan: Plan, options: argparse.Namespace) -> int:
    from housefly.campaigns.folder import CampaignFolder
    from housefly.campaigns.runner import LocalFleet

    out = Path(options.out or Path("campaigns") / re.sub(r"[^\w-]+", "_", plan.spec.name).strip("_"))
    folder = CampaignFolder(out, plan, fresh=options.fresh)
    try:
        if options.cluster:
            from housefly.campaigns.cluster import ClusterFleet

            with ClusterFleet(options.cluster) as fleet:
                _run(plan, folder, fleet)
        else:
            _run(plan, folder, LocalFleet(options.threads))
    except KeyboardInterrupt:
        left = sum(chunk.stop - chunk.start for chunk in folder.missing())
        console.print(f"stopped; {plan.drones - left:,} of {plan.drones:,} drones are kept in {out}: run the same again to go on")
        return 130
    _conclude(plan.spec, folder)
    return 0


def _run(plan: Plan, folder: CampaignFolder, fleet: Fleet) -> None:
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    from housefly.campaigns.runner import run_campaign

    columns = (
        TextColumn("drones"),
        BarColumn(30),
        MofNCompleteColumn(),
        TextColumn("{task.fields[rate]}"),
        TimeRemainingColumn(),
    )
    duration = plan.legs[0].mission.duration
    with Progress(*columns, console=console, transient=not console.is_terminal) as progress:
        task = progress.add_task("", total=plan.drones, rate="")
        began, flown = time.monotonic(), -1

        def landed(drones: int) -> None:
            nonlocal flown
            progress.advance(task, drones)
            if flown < 0:
                flown = 0  # the first call tells what an earlier run left
                return
            flown += drones
            speed = flown * duration / max(time.monotonic() - began, 1e-3)
            progress.update(task, rate=f"{speed:,.0f} drone-s/s")

        run_campaign(plan, folder, fleet, landed)


def _conclude(spec: Spec, folder: CampaignFolder) -> None:
    from rich.table import Table

    from housefly.campaigns.plots import draw_campaign
    from housefly.campaigns.summary import SHARES, shown, summarize, write_summary

    cells = summarize(spec, folder.finish())
    write_summary(folder.path / "summary.csv", spec, cells)
    files = [file for measure in spec.plot for file in draw_campaign(spec, cells, measure, folder.path / measure)]
    table = Table(box=None, pad_edge=False)
    for heading in (*spec.grid, "drones", *spec.plot):
        table.add_column(heading, justify="right")
    for cell in cells[:ROWS]:
        values = (shown(name, value) for name, value in zip(spec.grid, cell.values, strict=True))
        numbers = []
        for measure in spec.plot:
            value, low, high = cell.estimates[measure]
            scale, unit = (100.0, " %") if measure in SHARES else (1.0, "")
            numbers.append(f"{scale * value:.3g}{unit} ({scale * low:.3g} .. {scale * high:.3g})")
        table.add_row(*values, str(cell.drones), *numbers)
    console.print(table)
    if len(cells) > ROWS:
        console.print(f"... {len(cells) - ROWS} more in summary.csv")
    names = ", ".join(["results.parquet", "summary.csv", *(file.name for file in files if file.suffix == ".png")])
    console.print(f"written: {folder.path} ({names})", soft_wrap=True)


def _estimate(plan: Plan, seconds: float, threads: int | None) -> int:
    from dataclasses import replace

    from housefly.experiments.engine import fly_many

    chunk = plan.chunks[0]
    cases, _ = plan.cases_of(replace(chunk, stop=min(chunk.stop, chunk.start + PROBE)))
    mission = plan.legs[chunk.leg].mission
    fly_many(cases[:1], mission, threads=threads)
    began = time.monotonic()
    fly_many(cases, mission, threads=threads)
    spent = (time.monotonic() - began) / (len(cases) * mission.duration)
    console.print(f"about {seconds * spent:,.1f} s here, in {len(plan.chunks)} chunks")
    return 0


def _site(spec: Spec, base: Path) -> Any:
    from housefly.app.premises import read_site

    beside = base / spec.site
    return read_site(str(beside) if beside.exists() else spec.site)
