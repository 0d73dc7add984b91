"""``housefly doctor``: what this machine, or a drone, lacks."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from housefly.app.commands.shared import add_site_arguments
from housefly.app.commands.subcommand import Subcommand
from housefly.app.terminal import new_table, plain_console

if TYPE_CHECKING:
    from housefly.app.doctor import MachineCheck


def _add_arguments(parser: ArgumentParser) -> None:
    add_site_arguments(parser)
    parser.add_argument(
        "--drone",
        metavar="URI",
        help="look at a drone in place of this machine: MODEL://ADDRESS; orders nothing",
    )


def _checks(options: Namespace) -> tuple[MachineCheck, ...]:
    if options.drone:
        from housefly.app.drone_doctor import drone_at, look_at_drone

        return look_at_drone(drone_at(options.drone))
    from housefly.app.doctor import check_machine
    from housefly.sites.loaded_site import read_site

    return check_machine(read_site(options.site))


def _run(options: Namespace) -> int:
    table = new_table(("", "check", "found", "what mends it"), overflow="fold")
    checks = _checks(options)
    for check in checks:
        mark = "ok" if check.well else ("note" if check.optional else "LACKS")
        table.add_row(mark, check.name, check.found, "" if check.well else check.remedy)
    plain_console.print(table)
    return 0 if all(check.well or check.optional for check in checks) else 1


DOCTOR_COMMAND = Subcommand(
    name="doctor",
    help="say what this machine, or a drone, lacks and the line that mends it",
    add_arguments=_add_arguments,
    run=_run,
)
