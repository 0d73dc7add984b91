"""``housefly demo`` and ``housefly run``: everything that a site needs, until Ctrl-C."""

from __future__ import annotations

import tempfile
from argparse import ArgumentParser, Namespace
from pathlib import Path

from housefly.app.commands.shared import (
    add_console_arguments,
    add_fault_argument,
    add_simulation_arguments,
    add_site_arguments,
    load,
)
from housefly.app.commands.subcommand import Subcommand
from housefly.app.terminal import console


def _add_run_arguments(parser: ArgumentParser) -> None:
    add_site_arguments(parser)
    add_console_arguments(parser)


def _add_demo_arguments(parser: ArgumentParser) -> None:
    add_site_arguments(parser)
    add_console_arguments(parser)
    add_simulation_arguments(parser)
    add_fault_argument(parser)
    parser.add_argument(
        "--lively",
        action="store_true",
        help=(
            "somebody lives there, beside what the site has of its own: people and things move,"
            " devices speak over MQTT (mosquitto)"
        ),
    )


def _run(options: Namespace) -> int:
    """Start what the site needs and stay until Ctrl-C; the drone lands first."""
    from housefly.app.compiling import CompiledPart, compile_once
    from housefly.app.interactive import run_interactively
    from housefly.web.exposure import checked_exposure

    loaded = load(options, with_edits=True)
    checked_exposure(loaded.site)
    compile_once(CompiledPart.CHAIN, console.print)
    record = Path(options.record) if options.record else None
    with tempfile.TemporaryDirectory(prefix="housefly-") as folder:
        return run_interactively(loaded, Path(folder), record)


DEMO_COMMAND = Subcommand(
    name="demo",
    help="everything: simulated room, pilot, console",
    description=(
        "Start the simulated room, the pilot and the console; print the console's address; say"
        " when it is ready. Ctrl-C lands the drone first."
    ),
    add_arguments=_add_demo_arguments,
    run=_run,
)

RUN_COMMAND = Subcommand(
    name="run",
    help="fly what a site file describes, real hardware included",
    description=(
        "Start what a site needs: pilot and console always, the simulated room only where the"
        " site enables it."
    ),
    add_arguments=_add_run_arguments,
    run=_run,
)
