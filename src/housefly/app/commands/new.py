"""``housefly new``: a site of one's own, asked for in words or drawn in the browser."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from dataclasses import replace
from pathlib import Path
from shlex import quote
from typing import TYPE_CHECKING

from housefly.app.commands.subcommand import Subcommand
from housefly.app.terminal import console
from housefly.config.text import expanded

if TYPE_CHECKING:
    from housefly.room.draft.missing import DraftStep
    from housefly.room.draft.model import SiteDraft

_EPILOG = """\
Asked are the room, what stands in it, the pad, places, zones, tracking, the tracking frame, and \
the drone.
Each question has a default in brackets, which Enter takes; "help" says what can be typed, "back"
goes to the question before. Every answer is kept in NAME/draft.json: Ctrl-C loses nothing, the
same line goes on. Answers may come from a script (housefly new mylab < answers.txt) or from the
options below, whose texts are what one would type; --yes takes every default that is left.

examples:
  housefly new mylab                                     # asks
  housefly new mylab --page                              # draws it in the browser
  housefly new mylab --room 6x4 --yes                    # an empty rectangle, all simulated
  housefly new mylab --room 6x4 --drone crazyflie --yes  # another model of drone
  housefly new house --room map.yaml --yes               # a ROS map
  housefly new house --room ros2:/map --yes              # the map that a ROS 2 node publishes now
  housefly new flat --room 'scan.ply up=z' --yes         # a 3-D scan
  housefly new flat --room 'plan.dxf layers=WALL' --yes  # a floor plan
"""
_OPTIONS = (
    ("room", "ROOM", "size LxWxH in metres, a file of the room, or ros2:/map"),
    ("object", "LINE", "furniture: 'table 3,1 1.2x0.8x0.75'; repeatable"),
    ("pad", "X,Y", "where the drone starts and lands"),
    ("place", "LINE", "'kitchen 5,1'; repeatable"),
    ("zone", "LINE", "'0,0,1,1 the door swings'; repeatable"),
    ("tracking", "LINE", "'simulated' or 'vicon 10.0.0.5'"),
    ("point", "LINE", "'1.5,2 = 0.03,-0.12,0.06': a point on the map, and as tracking sees it"),
    ("drone", "LINE", "'crazyflie', or 'tello 192.168.10.1' where a real one answers"),
)


def _add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("name", metavar="NAME", help="folder to write, and name of the site")
    parser.add_argument("--page", action="store_true", help="draw it in the browser")
    parser.add_argument("--port", type=int, help="port of that page (default: a free one)")
    for name, metavar, help_ in _OPTIONS:
        parser.add_argument(f"--{name}", action="append", default=[], metavar=metavar, help=help_)
    parser.add_argument("--yes", action="store_true", help="take every default that is left")
    parser.add_argument(
        "--no-test", action="store_true", help="do not listen to tracking, nor ask the drone"
    )


def _run(options: Namespace) -> int:
    from housefly.app.new_site.asker import DefaultsAsker, OutOfAnswers, TerminalAsker
    from housefly.app.new_site.dialog import LeftDialog, NewSiteDialog, Wires
    from housefly.app.new_site.live import check_drone, hear_tracking
    from housefly.room.draft.files import load_draft, write_site
    from housefly.room.draft.model import SiteDraft

    folder = expanded(options.name, "NAME")
    kept = load_draft(folder)
    draft = kept or SiteDraft(name=folder.resolve().name[:60])
    if options.page:
        from housefly.app.new_site.page import serve_new_page

        NewSiteDialog(draft, folder, DefaultsAsker(), given=_given(options)).take_given()
        return serve_new_page(folder, options.port)
    _greet(folder, kept)
    if options.yes:
        draft = replace(draft, answered="")
    wires = Wires() if options.no_test else Wires(hear_tracking, check_drone)
    asker = DefaultsAsker() if options.yes else TerminalAsker()
    dialog = NewSiteDialog(draft, folder, asker, wires, _given(options))
    go_on = f"go on with: housefly new {quote(options.name)}"
    try:
        draft = dialog.run()
    except KeyboardInterrupt:
        console.print(f"\nkept in {folder}; {go_on}", markup=False, soft_wrap=True)
        return 130
    except LeftDialog:
        console.print(f"kept in {folder}; {go_on}", markup=False, soft_wrap=True)
        return 0
    except OutOfAnswers:
        console.print(f"the answers ended; kept in {folder}; {go_on}", markup=False)
        return 1
    _tell_result(draft, folder, write_site(draft, folder))
    return 0


def _given(options: Namespace) -> dict[DraftStep, tuple[str, ...]]:
    from housefly.room.draft.missing import DraftStep

    steps = {
        DraftStep.ROOM: options.room,
        DraftStep.OBJECTS: options.object,
        DraftStep.PAD: options.pad,
        DraftStep.PLACES: options.place,
        DraftStep.ZONES: options.zone,
        DraftStep.TRACKING: options.tracking,
        DraftStep.FRAME: options.point,
        DraftStep.DRONE: options.drone,
    }
    return {step: tuple(texts) for step, texts in steps.items() if texts}


def _greet(folder: Path, kept: SiteDraft | None) -> None:
    if kept is None:
        console.print(
            f"A new site in {folder}. Enter takes what stands in brackets; help, back, map,"
            " missing, quit are understood; Ctrl-C loses nothing.",
            markup=False,
            soft_wrap=True,
        )
    else:
        known = "no room yet" if kept.bounds is None else f"{len(kept.places)} places"
        console.print(f"Going on with {folder}: {known}.", markup=False, soft_wrap=True)


def _tell_result(draft: SiteDraft, folder: Path, paths: tuple[Path, ...]) -> None:
    from housefly.app.new_site.dialog import map_words
    from housefly.room.draft.files import SIMULATED_FILE
    from housefly.room.draft.missing import missing

    console.print(map_words(draft), markup=False, soft_wrap=True)
    console.print(f"written: {', '.join(map(str, paths))}", markup=False, soft_wrap=True)
    for item in missing(draft):
        console.print(f"note: {item.words}\n   -> {item.mend}", markup=False, soft_wrap=True)
    real = quote(str(folder))
    site = quote(str(folder / SIMULATED_FILE)) if draft.hardware else real
    place = draft.places[0].name
    lines = [
        ("is this machine fit for it", f"housefly doctor --site {real}"),
        ("the whole thing, simulated", f"housefly demo --site {site}"),
        (
            "one simulated service",
            f"housefly fly {quote(place)} --headless --lockstep --site {site}",
        ),
    ]
    if draft.hardware:
        lines += [
            ("before the first flight: compare tracking, drone and map, the drone in your hands",
             f"housefly preflight --frames --site {real}"),
            ("the real room", f"housefly run --site {real}"),
        ]  # fmt: skip
    for words, line in lines:
        console.print(f"{words}:\n  {line}", markup=False, soft_wrap=True)


NEW_COMMAND = Subcommand(
    name="new",
    help="describe a room of your own; writes its site file",
    description="Ask what a room of your own is; write a site that flies into the folder NAME.",
    add_arguments=_add_arguments,
    run=_run,
    epilog=_EPILOG,
)
"""The command of the parser."""
