"""What each command does. Heavy parts are imported late, so that ``--help`` answers at once."""

from __future__ import annotations

import argparse
import tempfile
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.console import Console
from rich.table import Table

from housefly import sites
from housefly.errors import ConfigError
from housefly.geometry import Vec2

if TYPE_CHECKING:
    from housefly.app.premises import Premises

console = Console(highlight=False)


def demo(options: argparse.Namespace) -> int:
    """Start everything and stay until Ctrl-C."""
    return run(options)


def run(options: argparse.Namespace) -> int:
    """Start what the site needs and stay until Ctrl-C; the drone lands first."""
    from housefly.app.attended import stay
    from housefly.app.compiling import Part, compile_once

    compile_once(Part.CHAIN, console.print)
    premises = _premises(options, with_edits=True)
    record = Path(options.record) if options.record else None
    with tempfile.TemporaryDirectory(prefix="housefly-") as folder:
        return stay(premises, Path(folder), record, console)


def fly(options: argparse.Namespace) -> int:
    """Fly one service and write its record; 0 only when it completed."""
    from housefly.app.compiling import Part, compile_once
    from housefly.app.flight import fly_service

    premises = _premises(options, with_edits=not options.lockstep)
    out = Path(options.out or time.strftime("flights/%Y-%m-%d_%H-%M-%S"))
    try:
        premises.room.place(options.place)
    except KeyError as error:
        raise ConfigError("place", str(error.args[0])) from error
    if not 0.0 <= options.look <= 120.0:
        raise ConfigError("--look", f"is {options.look}; allowed: a number from 0 to 120 s")
    compile_once(Part.CHAIN, console.print)
    outcome = fly_service(
        premises,
        options.place,
        options.look,
        out,
        console,
        lockstep=options.lockstep,
        web=not options.headless,
    )
    return 0 if outcome == "completed" else 1


def plan(options: argparse.Namespace) -> int:
    """Plan a path, print it, draw it."""
    from housefly.app.compiling import Part, compile_once
    from housefly.pilot.pilot import Pilot
    from housefly.room.draw import draw_room, text_map

    premises = _premises(options)
    compile_once(Part.CHAIN, console.print)
    pilot = Pilot(premises.site, premises.room, premises.grid)
    answer = pilot.plan(
        _point(options.goal, premises, "--to"), _point(options.start, premises, "--from")
    )
    if answer.path is None:
        console.print(f"no path: {answer.reason}")
        if answer.suggestion:
            console.print("nearest free point: {:.2f},{:.2f}".format(*answer.suggestion))
    else:
        path = answer.path
        size = f"{len(path.waypoints)} waypoints, clearance {path.clearance:.2f} m"
        console.print(f"{path.length:.2f} m, about {answer.duration:.0f} s, {size}")
        console.print(" ".join(f"{x:.2f},{y:.2f}" for x, y in path.waypoints))
    if options.png:
        draw_room(
            premises.room,
            premises.grid,
            Path(options.png),
            route=answer.path.waypoints if answer.path else None,
        )
        console.print(f"drawn: {options.png}")
    else:
        console.print(text_map(premises.room, premises.grid), markup=False, soft_wrap=True)
    return 0 if answer.path else 1


def room_show(options: argparse.Namespace) -> int:
    """Draw the room."""
    from housefly.room.draw import draw_room, text_map

    premises = _premises(options)
    console.print(text_map(premises.room, premises.grid), markup=False, soft_wrap=True)
    for place in premises.room.places:
        x, y = place.viewpoint
        console.print(f"  {place.name:<12} hover at {x:.2f},{y:.2f}  {place.title}")
    if options.png:
        draw_room(premises.room, premises.grid, Path(options.png))
        console.print(f"drawn: {options.png}")
    return 0


def room_import(options: argparse.Namespace) -> int:
    """Make a room of a ROS map."""
    from housefly.room.ros_map import import_ros_map

    out = Path(options.out)
    room = import_ros_map(Path(options.map), out)
    console.print(
        f"{room.name}: {len(room.solids)} solids, places:"
        f" {', '.join(place.name for place in room.places)}"
    )
    console.print(f"look at it:  housefly room show --site {out}")
    console.print(f"fly it:      housefly demo --site {out}")
    return 0


def replay(options: argparse.Namespace) -> int:
    """Compare a recording's commands with those of a fresh pilot."""
    from housefly.app.compiling import Part, compile_once
    from housefly.app.premises import open_premises, read_site
    from housefly.app.replaying import recorded_site, verify_recording

    recording = Path(options.recording)
    recording = recording / "flight.mcap" if recording.is_dir() else recording
    site = read_site(options.site) if options.site else recorded_site(recording)
    compile_once(Part.CHAIN, console.print)
    verdict = verify_recording(recording, open_premises(site))
    if verdict.missing:
        console.print(
            f"{verdict.missing} steps are missing in the recording: it cannot replay bit for bit"
            " from there on"
        )
    if verdict.difference is not None:
        console.print(f"differs: {verdict.difference}")
        return 1
    console.print(f"{verdict.steps} steps replayed; every command is the same, bit for bit")
    return 0


def doctor(options: argparse.Namespace) -> int:
    """Examine this machine."""
    from housefly.app.doctor import examine
    from housefly.app.premises import read_site

    table = Table(box=None, pad_edge=False)
    for heading in ("", "check", "found", "what mends it"):
        table.add_column(heading, overflow="fold")
    findings = examine(read_site(options.site))
    for finding in findings:
        mark = "ok" if finding.well else ("note" if finding.optional else "LACKS")
        table.add_row(mark, finding.name, finding.found, "" if finding.well else finding.remedy)
    console.print(table)
    return 0 if all(finding.well or finding.optional for finding in findings) else 1


def _premises(options: argparse.Namespace, *, with_edits: bool = False) -> Premises:
    """Open what the options name, with the newest edits of the ROOM screen where real wires are
    flown.
    """
    from housefly.app.premises import open_premises, read_site, with_newest_edits

    changes: dict[str, Any] = {"mode": options.mode, "web__port": getattr(options, "port", None)}
    changes["twin__seed"] = getattr(options, "seed", None)
    if getattr(options, "lively", False):
        changes["hub__things"] = str(Path(sites.__file__).with_name("bsen_things.toml"))
        changes |= {
            "twin__scene": "bsen",
            "mqtt__broker": "127.0.0.1",
            "mqtt__start": True,
            "mqtt__port": 0,
        }
    changes["twin__mocap_rate_hz"] = getattr(options, "mocap_rate", None)
    site = read_site(
        options.site, **{key: value for key, value in changes.items() if value is not None}
    )
    if with_edits:
        site, words = with_newest_edits(site)
        if words:
            console.print(f"map:      {words}", markup=False)
    return open_premises(site)


def _point(text: str, premises: Premises, option: str) -> Vec2:
    try:
        return premises.room.place(text).viewpoint
    except KeyError as error:
        try:
            x, y = (float(part) for part in text.split(","))
        except ValueError:
            raise ConfigError(
                option, f"is {text!r}; allowed: x,y in metres or a place ({error.args[0]})"
            ) from error
        return x, y
