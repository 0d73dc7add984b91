"""``housefly demo`` and ``housefly run``: everything that a site needs, until Ctrl-C."""

from __future__ import annotations

from argparse import SUPPRESS, ArgumentParser, Namespace
from pathlib import Path

from housefly.app.commands.shared import (
    add_console_arguments,
    add_fault_argument,
    add_instance_argument,
    add_simulation_arguments,
    add_site_arguments,
    given,
    load,
)
from housefly.app.commands.subcommand import Subcommand
from housefly.app.terminal import console


def _add_run_arguments(parser: ArgumentParser) -> None:
    add_site_arguments(parser)
    add_instance_argument(parser)
    add_console_arguments(parser)


def _add_demo_arguments(parser: ArgumentParser) -> None:
    add_site_arguments(parser)
    add_instance_argument(parser, "which room (default: the first that is free): ")
    add_console_arguments(parser)
    add_simulation_arguments(parser)
    add_fault_argument(parser)
    parser.add_argument(
        "--drone",
        dest="model",
        metavar="MODEL",
        help="which model flies (default: the site's); a wrong name lists them",
    )
    parser.add_argument(
        "--empty",
        dest="lively",
        action="store_false",
        help=(
            "the site as it is: without this, somebody lives there, seen by scanners, and devices"
            " speak over MQTT (mosquitto)"
        ),
    )
    parser.add_argument("--lively", action="store_true", default=True, help=SUPPRESS)
    parser.add_argument(
        "--memory",
        action="store_true",
        help="without a drone: the room sees, remembers and answers, and nothing flies",
    )


def _demo(options: Namespace) -> int:
    """Start the site with what makes it lively; the page begins with what one can ask.

    Where the first room's ports are taken it is the next instance.
    """
    if options.instance is None:
        options.instance = _free_instance(options)
    return _run(options)


def _free_instance(options: Namespace) -> int:
    from housefly.app.instance import free_instance
    from housefly.sites.loaded_site import read_site
    from housefly.twin.demo_site import demo_site

    site = read_site(options.site, **given({"drone__kind": options.model}))
    if options.lively:
        site, _ = demo_site(site, has_broker=False)
    instance = free_instance(site, web=options.port is None)
    if instance > 1:
        console.print(
            f"instance: {instance}, with addresses and a memory of its own, because another"
            f" program has the first one's ports; ask it with --instance {instance}",
            soft_wrap=True,
        )
    return instance


def _run(options: Namespace) -> int:
    """Start what the site needs and stay until Ctrl-C; the drone lands first."""
    from housefly.app.compiling import CompiledPart, compile_once
    from housefly.app.interactive import run_interactively
    from housefly.app.run_folder import temporary_run_folder
    from housefly.twin.installed import require_simulator
    from housefly.web.access.exposure import checked_exposure

    loaded = load(options, with_edits=True)
    checked_exposure(loaded.site)
    if loaded.site.twin.enabled:
        require_simulator()
    if loaded.site.drone_names:
        compile_once(CompiledPart.CHAIN, console.print)
    record = Path(options.record) if options.record else None
    with temporary_run_folder("logs") as folder:
        return run_interactively(loaded, folder, record)


DEMO_COMMAND = Subcommand(
    name="demo",
    help="everything: a simulated room in which somebody lives, pilot, services, console",
    description=(
        "Start the simulated room, in which somebody lives, the pilot, the services and the"
        " console; print the console's address, where one asks and rings; say when it is ready."
        " Ctrl-C lands the drone first."
    ),
    add_arguments=_add_demo_arguments,
    run=_demo,
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
