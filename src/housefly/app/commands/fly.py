"""``housefly fly``: one recorded service."""

from __future__ import annotations

import time
from argparse import ArgumentParser, Namespace
from pathlib import Path

from housefly.app.commands.shared import (
    add_drone_argument,
    add_fault_argument,
    add_instance_argument,
    add_simulation_arguments,
    add_site_arguments,
    load_drone,
)
from housefly.app.commands.subcommand import Subcommand
from housefly.app.terminal import console
from housefly.errors import ConfigError


def _add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("place", help="a named place (housefly room show lists them)")
    add_site_arguments(parser)
    add_drone_argument(parser)
    parser.add_argument("--headless", action="store_true", help="without the console")
    parser.add_argument(
        "--lockstep",
        action="store_true",
        help="stepped clock, no wires: as fast as the machine can",
    )
    add_simulation_arguments(parser)
    add_instance_argument(parser)
    add_fault_argument(parser)
    parser.add_argument(
        "--look", type=float, default=5.0, metavar="S", help="how long to look (default: 5 s)"
    )
    parser.add_argument(
        "--out", metavar="DIR", help="where to write the record (default: flights/<time>)"
    )


def _run(options: Namespace) -> int:
    from housefly.app.compiling import CompiledPart, compile_once
    from housefly.app.flight import fly_service
    from housefly.twin.installed import require_simulator
    from housefly.web.access.exposure import checked_exposure

    loaded = load_drone(options, with_edits=not options.lockstep)
    out = Path(options.out or time.strftime("flights/%Y-%m-%d_%H-%M-%S"))
    try:
        loaded.room.place(options.place)
    except KeyError as error:
        raise ConfigError("place", str(error.args[0])) from error
    if not 0.0 <= options.look <= 120.0:
        raise ConfigError("--look", f"is {options.look}; allowed: a number from 0 to 120 s")
    if not (options.lockstep or options.headless):
        checked_exposure(loaded.site)
    if options.lockstep or loaded.site.twin.enabled:
        require_simulator()
    compile_once(CompiledPart.CHAIN, console.print)
    outcome = fly_service(
        loaded,
        options.place,
        options.look,
        out,
        lockstep=options.lockstep,
        web=not options.headless,
    )
    return 0 if outcome == "completed" else 1


FLY_COMMAND = Subcommand(
    name="fly",
    help="fly one whole service: take off, go, look, come home, land",
    description=(
        "Fly to a named place, look, come home and land. Exit code 0 only if all of it"
        " happened and nothing was touched. The folder given by --out holds summary.json,"
        " flight.mcap, video.mp4, truth.jsonl and report.html."
    ),
    add_arguments=_add_arguments,
    run=_run,
)
