"""``housefly memory``: what a site remembers, brought in from ROS-TMS's database, and out to it."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from housefly.app.commands.subcommand import CommandGroup, Subcommand
from housefly.app.terminal import console
from housefly.errors import ConfigError

if TYPE_CHECKING:
    from housefly.hub.store.sql_store import SqlStore

_MAX_REMARKS = 12
"""Remarks that are printed; the rest is counted."""


def _add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("file", metavar="FILE.json")
    parser.add_argument(
        "--site", default="bsen", metavar="SITE", help="whose memory (default: bsen)"
    )


def _import_tms(options: Namespace) -> int:
    """Read a dump into the memory; 0 when at least one thing was read."""
    from housefly.hub.store.import_tms import read_tms

    dump = read_tms(Path(options.file))
    store = _store(options.site)
    try:
        store.put_things(dump.things)
        store.write(dump.samples)
    finally:
        store.close()
    for remark in dump.remarks[:_MAX_REMARKS]:
        console.print(f"  {remark}", markup=False, soft_wrap=True)
    more = (
        f" ({len(dump.remarks) - _MAX_REMARKS} more remarks)"
        if len(dump.remarks) > _MAX_REMARKS
        else ""
    )
    console.print(
        f"{len(dump.things)} things and {len(dump.samples)} sightings read, {dump.skipped} rows"
        f" left out{more}"
    )
    return 0 if dump.things else 1


def _export_tms(options: Namespace) -> int:
    """Write the memory as rows."""
    from housefly.hub.store.export_tms import tms_lines

    file = Path(options.file)
    store = _store(options.site)
    try:
        rows = list(tms_lines(store.things(), store.latest()))
    finally:
        store.close()
    try:
        file.write_text("\n".join(rows) + "\n", encoding="utf-8")
    except OSError as error:
        raise ConfigError(
            "FILE.json", f"cannot be written ({error.strerror})", str(file)
        ) from error
    console.print(f"{len(rows)} rows written: {file}", markup=False)
    return 0


def _store(name: str) -> SqlStore:
    from housefly.app.loaded_site import read_site
    from housefly.hub.store.open import open_site_store

    return open_site_store(read_site(name))


MEMORY_COMMANDS = CommandGroup(
    name="memory",
    help="bring a ROS-TMS database into a site's memory, or out of it",
    metavar="WHAT",
    commands=(
        Subcommand(
            name="import-tms",
            help="read a dump of ROS-TMS's database",
            description=(
                "Read a dump of ROS-TMS's database (mongoexport, one JSON object a line) into the"
                " memory of a site: things with their places, approach poses and containers, and"
                " what each sensor last said. A bad row is named and left out."
            ),
            add_arguments=_add_arguments,
            run=_import_tms,
        ),
        Subcommand(
            name="export-tms",
            help="write the memory as rows of ROS-TMS",
            description=(
                "Write things and what each source last said of them as rows for mongoimport, one"
                " JSON object a line."
            ),
            add_arguments=_add_arguments,
            run=_export_tms,
        ),
    ),
)
