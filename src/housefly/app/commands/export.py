"""``housefly export``: what happened, and where things were, as a table for other programs."""

from __future__ import annotations

import time
from argparse import ArgumentParser, Namespace
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from housefly.app.commands.asked_room import DEFAULT_SITE, add_asked_site, asked_site
from housefly.app.commands.subcommand import Subcommand
from housefly.app.parse_time import TIME_FORMS, parse_time
from housefly.app.terminal import console
from housefly.errors import ConfigError

if TYPE_CHECKING:
    from housefly.app.event_table import Row
    from housefly.app.pseudonyms import Pseudonyms
    from housefly.hub.store.sql_store import SqlStore
    from housefly.hub.things.thing import Thing

_EVERY = (0.0, 86_400.0)
"""Allowed values of ``--every`` [s]."""
_TABLES = ("steps", "sightings", "events")
_OF_MEMORY = ("ways", "thing", "kind", "pseudonyms")


def _add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument(
        "file",
        metavar="FILE",
        help="events.csv or events.parquet; with --flight also the new folder of a rosbag2",
    )
    add_asked_site(parser)
    parser.add_argument(
        "--since", default="30d", metavar="TIME", help=f"from then on: {TIME_FORMS} (default: 30d)"
    )
    parser.add_argument("--until", metavar="TIME", help="up to then (default: now)")
    parser.add_argument("--thing", default="", help="only of this thing or person")
    parser.add_argument("--kind", default="", help='only this, for example "door opened"')
    parser.add_argument(
        "--ways", action="store_true", help="where things were, instead of what happened"
    )
    parser.add_argument(
        "--every",
        type=float,
        default=1.0,
        metavar="S",
        help="of --ways: one row in so many seconds (default: 1; 0 for all that is kept)",
    )
    parser.add_argument(
        "--flight",
        metavar="LOG",
        help="a recorded flight, or a log as `housefly report` reads it, instead of the memory",
    )
    parser.add_argument(
        "--table",
        choices=_TABLES,
        default=_TABLES[0],
        help="of --flight: one row for each step, sighting or event (default: steps)",
    )
    parser.add_argument(
        "--own",
        action="store_true",
        help="of --flight: into the rosbag2 also what is of Housefly's own types",
    )
    parser.add_argument(
        "--pseudonyms",
        metavar="KEY.json",
        help="people as P01, P02 ...; who is who stands in this file alone, which you keep apart",
    )


def _run(options: Namespace) -> int:
    """Write the table; 0 when it has a row."""
    if options.flight:
        return _export_flight(options)
    from housefly.app.event_table import EVENT_HEADINGS, WAY_HEADINGS, write_table
    from housefly.hub.store.open import open_site_store
    from housefly.hub.things_of_room import catalogue_of
    from housefly.room.edits import room_of
    from housefly.sites.loaded_site import site_file

    now = time.time()
    since = parse_time(options.since, now, "--since")
    until = parse_time(options.until, now, "--until") if options.until else now
    if not _EVERY[0] <= options.every <= _EVERY[1]:
        raise ConfigError("--every", f"is {options.every}; allowed: 0 to 86400 s")
    site, folder = asked_site(options), site_file(options.site or DEFAULT_SITE).parent
    things = catalogue_of(site, room_of(site, folder), folder)
    store = open_site_store(site)
    try:
        hidden = _pseudonyms(options, things)
        headings = WAY_HEADINGS if options.ways else EVENT_HEADINGS
        rows = (_ways if options.ways else _events)(options, store, things, hidden, (since, until))
        count = write_table(Path(options.file), headings, rows)
    finally:
        store.close()
    console.print(f"{count} rows written: {options.file}", markup=False)
    return 0 if count else 1


def _export_flight(options: Namespace) -> int:
    """Write a recorded flight; 0 when it has a row or a message."""
    for name in _OF_MEMORY:
        if getattr(options, name):
            raise ConfigError(f"--{name}", "is of what the room remembers, not of --flight")
    from housefly.app.event_table import write_table
    from housefly.app.flight_logs.read_log import is_own_recording

    recording, file = Path(options.flight), Path(options.file)
    if not is_own_recording(recording):
        count = _export_log(recording, file)
    elif not file.suffix:
        return _write_bag(recording, file, with_own=options.own)
    else:
        from housefly.app.flight_tables import TABLE_FORMS, FlightTable, flight_rows

        table = FlightTable(options.table)
        count = write_table(file, TABLE_FORMS[table].headings, flight_rows(recording, table))
    console.print(f"{count} rows written: {options.file}", markup=False)
    return 0 if count else 1


def _export_log(recording: Path, file: Path) -> int:
    """Write a log of others as a table; return its number of rows."""
    from housefly.app.event_table import write_table
    from housefly.app.flight_logs.read_log import read_flight_log
    from housefly.app.flight_tables import LOG_HEADINGS, log_rows

    log = read_flight_log(recording)
    for problem in log.problems:
        console.print(problem, markup=False)
    return write_table(file, LOG_HEADINGS, log_rows(log))


def _write_bag(recording: Path, folder: Path, *, with_own: bool) -> int:
    from housefly.record.rosbag import write_rosbag

    counts = write_rosbag(recording, folder, with_own=with_own)
    total = sum(counts.messages.values())
    console.print(f"{total} messages of {len(counts.messages)} topics written: {folder}")
    if counts.left_out:
        named = ", ".join(sorted(counts.left_out))
        console.print(f"of Housefly's own types, left out without --own: {named}")
    return 0 if total else 1


def _pseudonyms(options: Namespace, things: Iterable[Thing]) -> Pseudonyms | None:
    from housefly.app.pseudonyms import Pseudonyms
    from housefly.hub.things.thing import ThingKind

    if not options.pseudonyms:
        return None
    people = (one for one in things if one.kind is ThingKind.PERSON)
    names = {one.id: (one.name, one.name.removeprefix("the "), *one.aliases) for one in people}
    return Pseudonyms(Path(options.pseudonyms), names)


def _events(
    options: Namespace,
    store: SqlStore,
    things: tuple[Thing, ...],
    hidden: Pseudonyms | None,
    span: tuple[float, float],
) -> Iterable[Row]:
    from housefly.app.event_table import event_rows

    thing = _id(options.thing, things) if options.thing else ""
    events = store.events(*span, thing=thing, kind=options.kind)
    if thing:  # what somebody did is about them, too
        done = store.events(*span, cause=thing, kind=options.kind)
        events = tuple(sorted({*events, *done}, key=lambda one: one.at))
    names = {one.id: one.name for one in things}
    if hidden is None:
        return event_rows(events, names)
    return event_rows(map(hidden.event, events), hidden.names(names))


def _ways(
    options: Namespace,
    store: SqlStore,
    things: tuple[Thing, ...],
    hidden: Pseudonyms | None,
    span: tuple[float, float],
) -> Iterable[Row]:
    from housefly.app.event_table import way_rows

    names = {one.id: one.name for one in things}
    wanted = {_id(options.thing, things)} if options.thing else _seen(store)
    for thing in sorted(wanted):
        rows = store.trajectory(thing, *span, every=options.every)
        told = thing if hidden is None else hidden.of(thing)
        name = names.get(thing, "") if hidden is None or told == thing else told
        yield from way_rows(told, name, map(tuple, rows.tolist()))


def _seen(store: SqlStore) -> set[str]:
    """Return the ids of everything that a sensor ever had at a place."""
    return {sample.thing for sample in store.latest() if sample.position is not None}


def _id(words: str, things: tuple[Thing, ...]) -> str:
    """Return the id of a thing by its name; raises ThingError."""
    from housefly.hub.things.world_model import WorldModel

    return WorldModel(things).thing(words).id


EXPORT_COMMAND = Subcommand(
    name="export",
    help="what happened, or a flight, as a table: CSV, Parquet; a flight as rosbag2",
    description=(
        "Write what a room remembers as a table: events, or with --ways where things were; or"
        " with --flight a recorded flight, as a table or as a rosbag2 folder. The room may run or"
        " not. CSV needs nothing more, Parquet the extra lab."
    ),
    add_arguments=_add_arguments,
    run=_run,
    epilog=(
        "examples:\n"
        "  housefly export events.csv --since 7d\n"
        "  housefly export ways.parquet --ways --thing resident --every 10\n"
        "  housefly export events.csv --pseudonyms ../apart/who-is-who.json\n"
        "  housefly export flight.parquet --flight mine\n"
        "  housefly export seen.csv --flight mine --table sightings\n"
        "  housefly export mine_bag --flight mine           a rosbag2 folder\n"
    ),
)
