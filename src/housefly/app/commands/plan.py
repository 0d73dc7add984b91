"""``housefly plan``: a path, without flying it."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from housefly.app.commands.shared import add_drone_argument, add_site_arguments, chosen_drone, load
from housefly.app.commands.subcommand import Subcommand
from housefly.app.terminal import console
from housefly.errors import ConfigError
from housefly.geometry import Vec2

if TYPE_CHECKING:
    from housefly.sites.loaded_site import LoadedSite


def _add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument(
        "--from", dest="start", default="home", metavar="X,Y|PLACE", help="start (default: home)"
    )
    parser.add_argument("--to", dest="goal", required=True, metavar="X,Y|PLACE", help="goal")
    add_site_arguments(parser)
    add_drone_argument(parser)
    parser.add_argument("--png", metavar="FILE", help="draw the room with the path")


def _run(options: Namespace) -> int:
    from housefly.app.compiling import CompiledPart, compile_once
    from housefly.pilot.assembly import make_pilot
    from housefly.room.distance import half_diagonal
    from housefly.room.draw import draw_room, text_map

    loaded = load(options)
    if loaded.site.drone_names:
        loaded = loaded.for_drone(chosen_drone(loaded.site, options))
    goal, start = _point(options.goal, loaded, "--to"), _point(options.start, loaded, "--from")
    compile_once(CompiledPart.CHAIN, console.print)
    answer = make_pilot(loaded.site, loaded.room, loaded.grid).plan(goal, start)
    path = answer.path
    if path is None:
        console.print(f"no path: {answer.reason}", markup=False)
        if answer.suggestion:
            console.print("nearest free point: {:.2f},{:.2f}".format(*answer.suggestion))
    else:
        hull = half_diagonal(loaded.site.drone.hull_length, loaded.site.drone.hull_width)
        size = f"{len(path.waypoints)} waypoints"
        console.print(f"{path.length:.2f} m, about {answer.duration:.0f} s, {size}")
        console.print(
            f"clearance of the hull at least {max(0.0, path.clearance - hull):.2f} m: the path"
            f" keeps {path.clearance:.2f} m from the obstacles of the map",
            soft_wrap=True,
        )
        console.print(" ".join(f"{x:.2f},{y:.2f}" for x, y in path.waypoints))
    if options.png:
        route = path.waypoints if path else None
        draw_room(loaded.room, loaded.grid, Path(options.png), route=route)
        console.print(f"drawn: {options.png}", markup=False)
    else:
        drawn = text_map(loaded.room, loaded.grid, path.waypoints if path else ())
        console.print(drawn, markup=False, soft_wrap=True)
    return 0 if path else 1


def _point(text: str, loaded: LoadedSite, option: str) -> Vec2:
    """Return a point that is given as a place or as "x,y"."""
    try:
        return loaded.room.place(text).viewpoint
    except KeyError as error:
        try:
            x, y = (float(part) for part in text.split(","))
        except ValueError:
            raise ConfigError(
                option, f"is {text!r}; allowed: x,y in metres or a place ({error.args[0]})"
            ) from error
        return x, y


PLAN_COMMAND = Subcommand(
    name="plan",
    help="plan a path without flying it",
    description="Plan a path between two points (x,y in metres) or named places, and draw it.",
    add_arguments=_add_arguments,
    run=_run,
)
