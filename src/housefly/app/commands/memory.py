"""``housefly memory``: forget somebody; bring ROS-TMS's database in, and out again."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from housefly.app.commands.asked_room import DEFAULT_SITE, add_asked_site, asked_site
from housefly.app.commands.subcommand import CommandGroup, Subcommand
from housefly.app.terminal import console
from housefly.errors import ConfigError

if TYPE_CHECKING:
    from housefly.config.site import Site
    from housefly.hub.store.sql_store import SqlStore
    from housefly.hub.things.thing import Thing

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


def _add_forget_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("person", help="id, name or alias; a thing may be forgotten, too")
    add_asked_site(parser)
    parser.add_argument("--yes", action="store_true", help="do not ask again")


def _forget(options: Namespace) -> int:
    """Delete everything that is kept of somebody; the room must not run."""
    from housefly.hub.store.lock import reserved_store
    from housefly.hub.store.open import open_site_store

    site = asked_site(options)
    thing = _meant(options, site)
    if not options.yes and not _agrees(f"Delete everything about {thing.name} for good?"):
        console.print("nothing was deleted")
        return 1
    names = (thing.name, thing.name.removeprefix("the "), *thing.aliases)
    with reserved_store(site):
        store = open_site_store(site)
        try:
            found = store.forget(thing.id, names)
        finally:
            store.close()
        tasks, clips = _forget_tasks(site, (thing.id, *names))
    console.print(
        f"{thing.name}: {found.samples} sightings, {found.events} events, {tasks} tasks and {clips}"
        f" clips deleted; the name struck out of {found.struck} other events",
        markup=False,
        soft_wrap=True,
    )
    return 0


def _meant(options: Namespace, site: Site) -> Thing:
    """Return the thing of the catalogue that is meant; raises ThingError."""
    from housefly.hub.things.world_model import WorldModel
    from housefly.hub.things_of_room import catalogue_of
    from housefly.room.edits import room_of
    from housefly.sites.loaded_site import site_file

    folder = site_file(options.site or DEFAULT_SITE).parent
    return WorldModel(catalogue_of(site, room_of(site, folder), folder)).thing(options.person)


def _agrees(question: str) -> bool:
    return sys.stdin.isatty() and input(f"{question} [yes/no] ").strip().lower() in ("y", "yes")


def _forget_tasks(site: Site, names: tuple[str, ...]) -> tuple[int, int]:
    """Delete tasks and clips that mention somebody; return how many of each."""
    from housefly.config.state import clips_folder, tasks_folder
    from housefly.evidence.clip_index import ClipIndex
    from housefly.evidence.clip_values import ClipsQuestion
    from housefly.hub.store.forget import mention_of
    from housefly.tasks.scheduler.task_store import TASK_FILE, TaskStore

    tasks, clips = 0, set[str]()
    file = tasks_folder(site) / TASK_FILE
    if file.exists():
        store = TaskStore(file)
        tasks = store.forget(mention_of(names))
        store.close()
    if clips_folder(site).exists():
        index = ClipIndex(clips_folder(site), site.tasks)
        for name in names:
            for asked in (ClipsQuestion(person=name), ClipsQuestion(thing=name)):
                clips |= {clip.id for clip in index.find(asked).clips}
        for clip in clips:
            index.delete(clip, "forgotten")
        index.close()
    return tasks, len(clips)


def _store(name: str) -> SqlStore:
    from housefly.hub.store.open import open_site_store
    from housefly.sites.loaded_site import read_site

    return open_site_store(read_site(name))


MEMORY_COMMANDS = CommandGroup(
    name="memory",
    help="forget somebody; bring a ROS-TMS database in, or out",
    metavar="WHAT",
    commands=(
        Subcommand(
            name="forget",
            help="delete everything that is kept of a person",
            description=(
                "Delete where somebody was, what happened to them and by them, tasks and clips that"
                " show them, and strike their name out of other events. The room must not run. A"
                " sensor that still sees them will remember them again."
            ),
            add_arguments=_add_forget_arguments,
            run=_forget,
        ),
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
