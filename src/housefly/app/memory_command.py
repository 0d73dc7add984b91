"""``housefly memory``: what a site remembers, brought in from ROS-TMS's database, and out to it."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.console import Console

from housefly.errors import ConfigError

if TYPE_CHECKING:
    from housefly.hub.store.sql_store import SqlStore

console = Console(highlight=False)
REMARKS = 12
"""Remarks that are printed; the rest is counted."""


def add(actions: Any) -> None:
    """Add the commands to the parser."""
    parser = actions.add_parser(
        "memory", help="bring a ROS-TMS database into a site's memory, or out of it"
    )
    parser.set_defaults(site="bsen")
    kinds = parser.add_subparsers(dest="what", metavar="WHAT", required=True)
    bring = kinds.add_parser(
        "import-tms",
        help="read a dump of ROS-TMS's database",
        description=(
            "Read a dump of ROS-TMS's database (mongoexport, one JSON object a line) into the"
            " memory of a site: things with their places, approach poses and containers, and what"
            " each sensor last said. A bad row is named and left out."
        ),
    )
    take = kinds.add_parser(
        "export-tms",
        help="write the memory as rows of ROS-TMS",
        description=(
            "Write things and what each source last said of them as rows for mongoimport, one JSON"
            " object a line."
        ),
    )
    for command, run in ((bring, import_tms), (take, export_tms)):
        command.add_argument("file", metavar="FILE.json")
        command.add_argument(
            "--site", default="bsen", metavar="SITE", help="whose memory (default: bsen)"
        )
        command.set_defaults(run=run)


def import_tms(options: argparse.Namespace) -> int:
    """Read a dump into the memory; 0 when at least one thing was read."""
    from housefly.hub.store.import_tms import read_tms

    dump = read_tms(Path(options.file))
    store = _store(options.site)
    try:
        store.know(dump.things)
        store.write(dump.samples)
    finally:
        store.close()
    for remark in dump.remarks[:REMARKS]:
        console.print(f"  {remark}", soft_wrap=True)
    more = f" ({len(dump.remarks) - REMARKS} more remarks)" if len(dump.remarks) > REMARKS else ""
    console.print(
        f"{len(dump.things)} things and {len(dump.samples)} sightings read, {dump.skipped} rows"
        f" left out{more}"
    )
    return 0 if dump.things else 1


def export_tms(options: argparse.Namespace) -> int:
    """Write the memory as rows."""
    from housefly.hub.store.export_tms import export_tms as rows_of

    file = Path(options.file)
    store = _store(options.site)
    try:
        rows = list(rows_of(store.things(), store.latest()))
    finally:
        store.close()
    try:
        file.write_text("\n".join(rows) + "\n", encoding="utf-8")
    except OSError as error:
        raise ConfigError(
            "FILE.json", f"cannot be written ({error.strerror})", str(file)
        ) from error
    console.print(f"{len(rows)} rows written: {file}")
    return 0


def _store(name: str) -> SqlStore:
    from housefly.app.premises import read_site
    from housefly.hub.process import store_address
    from housefly.hub.store.opening import open_store

    site = read_site(name)
    return open_store(store_address(site), keep_days=site.hub.keep_days)
