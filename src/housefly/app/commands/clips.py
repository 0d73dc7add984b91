"""``housefly clips``: which clips there are, take some away, delete what is too old."""

from __future__ import annotations

import getpass
import time
from argparse import ArgumentParser, Namespace
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from housefly.app.commands.subcommand import CommandGroup, Subcommand
from housefly.app.parse_time import TIME_FORMS, parse_time
from housefly.app.room_words import clock_time
from housefly.app.terminal import plain_console

if TYPE_CHECKING:
    from housefly.config.site import Site
    from housefly.evidence.clip_index import ClipIndex
    from housefly.evidence.clip_values import ClipInfo


def _add_site(parser: ArgumentParser) -> None:
    parser.add_argument("--site", default="bsen", metavar="SITE", help="whose (default: bsen)")


def _add_list_arguments(parser: ArgumentParser) -> None:
    _add_site(parser)
    for name in ("person", "place", "thing"):
        parser.add_argument(f"--{name}", default="", help="only those that show it")
    parser.add_argument("--task", type=int, default=0, help="only those of this task")
    parser.add_argument(
        "--since", default="30d", metavar="TIME", help=f"from then on: {TIME_FORMS} (default: 30d)"
    )
    parser.add_argument("--until", metavar="TIME", help="up to then (default: now)")
    parser.add_argument(
        "--limit", type=int, default=50, metavar="N", help="the newest N (default: 50)"
    )


def _list(options: Namespace) -> int:
    """Print the clips and snapshots, the newest first."""
    from housefly.evidence.clip_values import ClipsQuestion
    from housefly.tasks.api.json import task_question_from_json, task_question_to_json

    now = time.time()
    asked = ClipsQuestion(
        parse_time(options.since, now, "--since"),
        parse_time(options.until, now, "--until") if options.until else None,
        *(options.person, options.place, options.thing, options.task, options.limit),
    )
    question = task_question_from_json(task_question_to_json(asked))  # refuses what cannot be
    assert isinstance(question, ClipsQuestion)
    with _index(_site(options)) as index:
        found = index.find(question).clips
    for clip in found:
        plain_console.print(clip_line(clip, now), soft_wrap=True)
    if not found:
        plain_console.print("no such clip: the camera records only while a task asks for it")
    return 0


def clip_line(clip: ClipInfo, now: float) -> str:
    """Return one clip: id, when, how long, what it shows, for what, how long it is kept.

    The drone that filmed it is named where a site names its drones.
    """
    from housefly.config.drone import DRONE_NAME

    length = f", {clip.duration:.0f} s" if clip.kind == "clip" else ""
    shown = ", ".join(name for name in (*clip.people, clip.thing, clip.place) if name)
    until = "kept" if clip.keep_until is None else f"until {clock_time(clip.keep_until, now)}"
    asked = f"{clip.service}, task {clip.task}" if clip.task else "nobody knows for what"
    asked += f", {clip.drone}" if clip.drone not in ("", DRONE_NAME) else ""
    marks = "; cut off" * clip.cut_off + "; partly blank" * clip.blanked
    when = clock_time(clip.began_at, now)
    return f"{clip.id}  {when}  {clip.kind}{length}: {shown or '?'}  ({asked}; {until}{marks})"


def _add_export_arguments(parser: ArgumentParser) -> None:
    _add_site(parser)
    parser.add_argument("clips", nargs="+", metavar="ID", help="as `housefly clips list` says")
    parser.add_argument(
        "--out", type=Path, required=True, metavar="DIR", help="folder to copy them into"
    )


def _export(options: Namespace) -> int:
    """Copy clips out of the house, each with a picture and all that is known of it."""
    from housefly.config.state import edits_folder
    from housefly.errors import RecordingError
    from housefly.evidence.clip_export import write_folder
    from housefly.evidence.clip_picture import clip_picture
    from housefly.web.access.audit_log import AuditLog

    site, who = _site(options), f"{getpass.getuser()} at the terminal"
    with _index(site) as index:
        export = index.export(options.clips, who)
        pictures = {}
        for path in (file for file in export.files if file.suffix == ".mp4"):
            try:
                pictures[f"{path.stem}.jpg"] = clip_picture(path.read_bytes(), "clip")
            except RecordingError as error:
                plain_console.print(f"{path.stem}: {error}", soft_wrap=True)
        files = write_folder(export, options.out, pictures)
    with closing(AuditLog(edits_folder(site).with_name("commands.jsonl"))) as audit:
        audit.record(who, "", f"exported the clips {', '.join(options.clips)} to {options.out}")
    for path in files:
        plain_console.print(str(path), soft_wrap=True)
    return 0


def _add_tidy_arguments(parser: ArgumentParser) -> None:
    _add_site(parser)
    parser.add_argument(
        "--clock-is-right",
        action="store_true",
        help="believe the clock of this machine, although it leapt",
    )


def _tidy(options: Namespace) -> int:
    """Delete what is too old, as the run does by itself."""
    with _index(_site(options)) as index:
        gone = index.tidy(is_right=options.clock_is_right)
        notices = index.notices
    for name in gone:
        plain_console.print(f"deleted: {name}")
    for words in notices:
        plain_console.print(words, soft_wrap=True)
    if not gone:
        plain_console.print("nothing was deleted")
    return 0


def _site(options: Namespace) -> Site:
    from housefly.sites.loaded_site import read_site

    return read_site(options.site)


@contextmanager
def _index(site: Site) -> Iterator[ClipIndex]:
    """Yield the index of a site's clips, also while the site runs."""
    from housefly.config.state import clips_folder
    from housefly.evidence.clip_index import ClipIndex

    with closing(ClipIndex(clips_folder(site), site.tasks)) as index:
        yield index


CLIPS_COMMANDS = CommandGroup(
    name="clips",
    help="what the camera has kept: list it, take some away, delete what is too old",
    metavar="WHAT",
    default="list",
    commands=(
        Subcommand(
            name="list",
            help="which clips and snapshots there are",
            description="Print the clips and snapshots of a site, running or not.",
            add_arguments=_add_list_arguments,
            run=_list,
        ),
        Subcommand(
            name="export",
            help="copy clips out of the house",
            description=(
                "Copy clips and snapshots into a folder, with a picture of each clip, clips.json"
                " (what, when, why, who watched) and SHA256SUMS. Who exported what is written into"
                " the clips' own book and the audit log."
            ),
            add_arguments=_add_export_arguments,
            run=_export,
        ),
        Subcommand(
            name="tidy",
            help="delete what is too old or too much",
            description=(
                "Do now what a run does at its start and every ten minutes. After a leap of the"
                " clock nothing is deleted for its age; --clock-is-right says that it is right."
            ),
            add_arguments=_add_tidy_arguments,
            run=_tidy,
        ),
    ),
)
