"""``housefly room``: show a room, or make one of a ROS map."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path

from housefly.app.commands.shared import add_site_arguments, load
from housefly.app.commands.subcommand import CommandGroup, Subcommand
from housefly.app.terminal import console


def _add_show_arguments(parser: ArgumentParser) -> None:
    add_site_arguments(parser)
    parser.add_argument("--png", metavar="FILE", help="write a picture")


def _show(options: Namespace) -> int:
    from housefly.room.draw import draw_room, text_map

    loaded = load(options)
    console.print(text_map(loaded.room, loaded.grid), markup=False, soft_wrap=True)
    for place in loaded.room.places:
        x, y = place.viewpoint
        words = f"  {place.name:<12} hover at {x:.2f},{y:.2f}  {place.title}"
        console.print(words, markup=False)
    if options.png:
        draw_room(loaded.room, loaded.grid, Path(options.png))
        console.print(f"drawn: {options.png}", markup=False)
    return 0


def _add_import_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("map", metavar="MAP.yaml", help="the map's YAML file")
    parser.add_argument("--out", required=True, metavar="DIR", help="folder to write")
    parser.add_argument(
        "--unexplored",
        choices=("wall", "free"),
        default="wall",
        help="what floor counts as that was never seen (default: wall)",
    )


def _import(options: Namespace) -> int:
    from housefly.room.ros_map import import_ros_map

    out = Path(options.out)

    def tell(words: str) -> None:
        console.print(words, markup=False)

    room = import_ros_map(
        Path(options.map), out, unexplored_is_free=options.unexplored == "free", tell=tell
    )
    places = ", ".join(place.name for place in room.places)
    for words in (
        f"{room.name}: {len(room.solids)} solids, places: {places}",
        f"look at it:  housefly room show --site {out}",
        f"fly it:      housefly demo --site {out}",
    ):
        console.print(words, markup=False)
    return 0


ROOM_COMMANDS = CommandGroup(
    name="room",
    help="show a room, or make one of a ROS map",
    metavar="ACTION",
    default="show",
    commands=(
        Subcommand(
            name="show",
            help="draw the room: text in the terminal, PNG in a file",
            add_arguments=_add_show_arguments,
            run=_show,
        ),
        Subcommand(
            name="import",
            help="make a room of a ROS map (pgm or png, and yaml)",
            description=(
                "Extrude the walls of a ROS map and write room.toml and site.toml, ready for"
                " housefly run --site DIR."
            ),
            add_arguments=_add_import_arguments,
            run=_import,
        ),
    ),
)
