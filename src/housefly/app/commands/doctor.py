"""``housefly doctor``: what this machine lacks."""

from __future__ import annotations

from argparse import Namespace

from housefly.app.commands.shared import add_site_arguments
from housefly.app.commands.subcommand import Subcommand
from housefly.app.terminal import new_table, plain_console


def _run(options: Namespace) -> int:
    from housefly.app.doctor import check_machine
    from housefly.sites.loaded_site import read_site

    table = new_table(("", "check", "found", "what mends it"), overflow="fold")
    checks = check_machine(read_site(options.site))
    for check in checks:
        mark = "ok" if check.well else ("note" if check.optional else "LACKS")
        table.add_row(mark, check.name, check.found, "" if check.well else check.remedy)
    plain_console.print(table)
    return 0 if all(check.well or check.optional for check in checks) else 1


DOCTOR_COMMAND = Subcommand(
    name="doctor",
    help="say what this machine lacks and the line that mends it",
    add_arguments=add_site_arguments,
    run=_run,
)
