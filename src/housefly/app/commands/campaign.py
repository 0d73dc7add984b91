"""``housefly campaign``: many flights from one file."""

from __future__ import annotations

import re
import time
from argparse import ArgumentParser, Namespace
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from housefly.app.commands.subcommand import Subcommand
from housefly.app.terminal import console
from housefly.errors import ConfigError

if TYPE_CHECKING:
    from housefly.config.site import Site
    from housefly.lab.campaigns.folder import CampaignFolder
    from housefly.lab.campaigns.plan import Plan
    from housefly.lab.campaigns.runner import Fleet
    from housefly.lab.campaigns.spec import CampaignSpec

_EPILOG = """the file (docs/campaigns.md lists every key):
  name = "tracking rate"
  seeds = 100
  [mission]
  goal = "entrance"                      # planned by the site's room; \
or waypoints = [[0, 0], [3, 0]]
  [grid]                                 # every combination is flown
  mode = ["default", "paper"]
  mocap_rate_hz = [10, 20, 30, 50, 100]
  [draw]                                 # drawn anew for each seed
  lag = {normal = [7.0, 1.0]}

A campaign that was stopped goes on where it stopped: run the same again.
"""
_PROBE_DRONES = 200
"""Drones flown to estimate the time of all."""


def _add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("spec", metavar="SPEC.toml", help="the campaign file")
    parser.add_argument("--out", metavar="DIR", help="where to write (default: campaigns/<name>)")
    parser.add_argument("--threads", type=int, metavar="N", help="threads (default: one a core)")
    parser.add_argument(
        "--cluster",
        metavar="ADDRESS",
        help="spread it over a Dask cluster, for example tcp://127.0.0.1:8786",
    )
    parser.add_argument(
        "--fresh", action="store_true", help="forget what the folder holds of an earlier run"
    )
    parser.add_argument(
        "--dry-run",
        action="store_true",
        help="say how many drones would fly and for how long, then stop",
    )


def _run(options: Namespace) -> int:
    """Fly a campaign, or what is missing of it."""
    from housefly.app.compiling import CompiledPart, compile_once
    from housefly.lab.campaigns.notes import notes
    from housefly.lab.campaigns.plan import plan_campaign
    from housefly.lab.campaigns.spec import load_spec

    if options.threads is not None and not 1 <= options.threads <= 1024:
        raise ConfigError("--threads", f"is {options.threads}; allowed: a number from 1 to 1024")
    path = Path(options.spec)
    spec = load_spec(path)
    plan = plan_campaign(spec, _site(spec, path.parent))
    seconds = plan.drones * spec.mission.duration_s
    console.print(
        f"{spec.name}: {spec.points} points x {spec.seeds} seeds = {plan.drones:,} drones,"
        f" {seconds:,.0f} drone-seconds"
    )
    compile_once(CompiledPart.ENGINE, console.print)
    for note in notes(plan):
        console.print(f"note: {note}", markup=False, soft_wrap=True)
    return _estimate(plan, options.threads) if options.dry_run else _fly(plan, options)


def _fly(plan: Plan, options: Namespace) -> int:
    from housefly.lab.campaigns.folder import CampaignFolder

    out = Path(
        options.out or Path("campaigns") / re.sub(r"[^\w-]+", "_", plan.spec.name).strip("_")
    )
    with CampaignFolder(out, plan, fresh=options.fresh) as folder:
        try:
            with _fleet(options) as fleet:
                _fly_missing(plan, folder, fleet)
        except KeyboardInterrupt:
            kept = f"{folder.landed:,} of {plan.drones:,} drones are kept in {out}"
            words = f"stopped; {kept}: run the same again to go on"
            console.print(words, markup=False, soft_wrap=True)
            return 130
        _conclude(plan.spec, folder)
    return 0


@contextmanager
def _fleet(options: Namespace) -> Iterator[Fleet]:
    from housefly.lab.campaigns.runner import LocalFleet

    if not options.cluster:
        yield LocalFleet(options.threads)
        return
    from housefly.lab.campaigns.cluster import ClusterFleet

    with ClusterFleet(options.cluster) as fleet:
        others = ", ".join(sorted(fleet.foreign_processors()))
        if others:
            console.print(
                f"note: workers with other processors ({others}): the last bits of their numbers"
                " may differ"
            )
        yield fleet


def _fly_missing(plan: Plan, folder: CampaignFolder, fleet: Fleet) -> None:
    from housefly.app.campaign_progress import CampaignProgress
    from housefly.lab.campaigns.runner import fly_chunks

    missing = folder.missing()
    if folder.landed:
        console.print(f"{folder.landed:,} drones are there from an earlier run")
    with CampaignProgress(plan.drones, folder.landed, plan.spec.mission.duration_s) as progress:
        fly_chunks(plan, missing, folder, fleet, progress.advance)


def _conclude(spec: CampaignSpec, folder: CampaignFolder) -> None:
    from housefly.app.campaign_table import print_summary
    from housefly.lab.campaigns.plots import draw_campaign
    from housefly.lab.campaigns.summary import summarize_campaign, write_summary

    cells = summarize_campaign(spec, folder.finish())
    write_summary(folder.path / "summary.csv", spec, cells)
    files = [
        file
        for measure in spec.plot
        for file in draw_campaign(spec, cells, measure, folder.path / measure)
    ]
    print_summary(spec, cells)
    names = ", ".join(
        ["results.parquet", "summary.csv", *(file.name for file in files if file.suffix == ".png")]
    )
    console.print(f"written: {folder.path} ({names})", markup=False, soft_wrap=True)


def _estimate(plan: Plan, threads: int | None) -> int:
    from housefly.lab.experiments.engine import fly_many

    chunk = plan.chunks[0]
    cases = plan.cases_of(chunk)[0][:_PROBE_DRONES]
    mission = plan.groups[chunk.group].mission
    fly_many(cases[:1], mission, threads=threads)
    began = time.monotonic()
    fly_many(cases, mission, threads=threads)
    spent = (time.monotonic() - began) / len(cases)
    console.print(f"about {plan.drones * spent:,.1f} s here, in {len(plan.chunks)} chunks")
    return 0


def _site(spec: CampaignSpec, base: Path) -> Site:
    from housefly.sites.loaded_site import read_site

    beside = base / spec.site
    return read_site(str(beside) if beside.exists() else spec.site)


CAMPAIGN_COMMAND = Subcommand(
    name="campaign",
    help="fly thousands of simulated drones from one file: grids, distributions, seeds",
    description=(
        "Fly the closed loop (reduced-order drone, stamped noisy tracking, filter, acceptor,"
        " control, safety) for every drone of a campaign file; write results.parquet,"
        " summary.csv and plots."
    ),
    epilog=_EPILOG,
    add_arguments=_add_arguments,
    run=_run,
)
