"""The command line: what to type, and what each thing does."""

from __future__ import annotations

import argparse
import signal
import sys

from housefly.app import (
    campaign_command,
    commands,
    gains_command,
    identify_command,
    memory_command,
    reproduce_command,
    room_commands,
)
from housefly.errors import HouseflyError

EPILOG = """examples:
  housefly demo                            fly the simulated room, with a console in the browser
  housefly fly entrance --headless         fly the whole service over real wires, record it, write a report
  housefly fly sofa --headless --lockstep  the same on a stepped clock, as fast as the machine can
  housefly plan --from 11.5,1.2 --to entrance --png path.png
  housefly room show --png room.png
  housefly run --site mylab.toml           real hardware: the site file names the addresses
"""


def build_parser() -> argparse.ArgumentParser:
    """Return the parser of all commands."""
    parser = argparse.ArgumentParser(
        prog="housefly",
        description="A room that knows where everything is flies a small drone on errands.",
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    actions = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    _add_demo(actions)
    _add_run(actions)
    _add_fly(actions)
    _add_plan(actions)
    _add_room(actions)
    _add_replay(actions)
    identify_command.add(actions)
    gains_command.add(actions)
    room_commands.add(actions)
    memory_command.add(actions)
    campaign_command.add(actions)
    reproduce_command.add(actions)
    _add_doctor(actions)
    return parser


Actions = argparse._SubParsersAction  # the type that add_subparsers returns has no public name


def _add_site(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--site",
        default="bsen",
        metavar="SITE",
        help="site file, folder, or shipped site (default: bsen)",
    )
    parser.add_argument(
        "--mode", choices=("default", "paper"), help="fly the paper's own chain, or the mended one"
    )


def _add_console(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--port", type=int, help="port of the console (default: the site's, 8080)")
    parser.add_argument(
        "--record", metavar="DIR", help="record everything that is flown into this folder"
    )


def _add_simulation(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--seed", type=int, help="seed of all simulated noise")
    parser.add_argument(
        "--mocap-rate",
        type=float,
        metavar="HZ",
        help="frames per second of the simulated tracking (default: 100)",
    )


def _add_demo(actions: Actions[argparse.ArgumentParser]) -> None:
    parser = actions.add_parser(
        "demo",
        help="everything: simulated room, pilot, console",
        description=(
            "Start the simulated room, the pilot and the console; print the console's address; say"
            " when it is ready. Ctrl-C lands the drone first."
        ),
    )
    _add_site(parser)
    _add_console(parser)
    _add_simulation(parser)
    parser.add_argument(
        "--lively",
        action="store_true",
        help="somebody lives there: people and things move, devices speak over MQTT (mosquitto)",
    )
    parser.set_defaults(run=commands.demo)


def _add_run(actions: Actions[argparse.ArgumentParser]) -> None:
    parser = actions.add_parser(
        "run",
        help="fly what a site file describes, real hardware included",
        description=(
            "Start what a site needs: pilot and console always, the simulated room only where the"
            " site enables it."
        ),
    )
    _add_site(parser)
    _add_console(parser)
    parser.set_defaults(run=commands.run, seed=None, mocap_rate=None)


def _add_fly(actions: Actions[argparse.ArgumentParser]) -> None:
    parser = actions.add_parser(
        "fly",
        help="fly one whole service: take off, go, look, come home, land",
        description=(
            "Fly to a named place, look, come home and land. Exit code 0 only if all of it"
            " happened. The folder given by --out holds summary.json, flight.mcap, video.mp4 and"
            " report.html."
        ),
    )
    parser.add_argument("place", help="a named place (housefly room show lists them)")
    _add_site(parser)
    parser.add_argument("--headless", action="store_true", help="without the console")
    parser.add_argument(
        "--lockstep",
        action="store_true",
        help="stepped clock, no wires: as fast as the machine can",
    )
    _add_simulation(parser)
    parser.add_argument(
        "--look", type=float, default=5.0, metavar="S", help="how long to look (default: 5 s)"
    )
    parser.add_argument(
        "--out", metavar="DIR", help="where to write the record (default: flights/<time>)"
    )
    parser.set_defaults(run=commands.fly)


def _add_plan(actions: Actions[argparse.ArgumentParser]) -> None:
    parser = actions.add_parser(
        "plan",
        help="plan a path without flying it",
        description="Plan a path between two points (x,y in metres) or named places, and draw it.",
    )
    parser.add_argument(
        "--from", dest="start", default="home", metavar="X,Y|PLACE", help="start (default: home)"
    )
    parser.add_argument("--to", dest="goal", required=True, metavar="X,Y|PLACE", help="goal")
    _add_site(parser)
    parser.add_argument("--png", metavar="FILE", help="draw the room with the path")
    parser.set_defaults(run=commands.plan)


def _add_room(actions: Actions[argparse.ArgumentParser]) -> None:
    parser = actions.add_parser("room", help="show a room, or make one of a ROS map")
    inner = parser.add_subparsers(dest="room_command", metavar="ACTION", required=True)
    show = inner.add_parser("show", help="draw the room: text in the terminal, PNG in a file")
    _add_site(show)
    show.add_argument("--png", metavar="FILE", help="write a picture")
    show.set_defaults(run=commands.room_show)
    load = inner.add_parser(
        "import",
        help="make a room of a ROS map (pgm or png, and yaml)",
        description=(
            "Extrude the walls of a ROS map and write room.toml and site.toml, ready for housefly"
            " run --site DIR."
        ),
    )
    load.add_argument("map", metavar="MAP.yaml", help="the map's YAML file")
    load.add_argument("--out", required=True, metavar="DIR", help="folder to write")
    load.set_defaults(run=commands.room_import)


def _add_replay(actions: Actions[argparse.ArgumentParser]) -> None:
    parser = actions.add_parser(
        "replay",
        help="give a recording to a fresh pilot and compare every command",
        description=(
            "Feed the inputs of a recorded flight to a fresh pilot. Exit code 0 when every command"
            " is the same, bit for bit."
        ),
    )
    parser.add_argument("recording", metavar="DIR|flight.mcap", help="a recorded flight")
    parser.add_argument(
        "--site", metavar="SITE", help="site to fly it with (default: the one recorded beside it)"
    )
    parser.set_defaults(run=commands.replay)


def _add_doctor(actions: Actions[argparse.ArgumentParser]) -> None:
    parser = actions.add_parser(
        "doctor", help="say what this machine lacks and the line that mends it"
    )
    _add_site(parser)
    parser.set_defaults(run=commands.doctor)


def main(arguments: list[str] | None = None) -> int:
    """Run the command line and return the exit code."""
    options = build_parser().parse_args(arguments)
    for number in (signal.SIGINT, signal.SIGTERM):
        # Said outright: a shell that starts us in the background lets SIGINT be ignored.
        signal.signal(number, signal.default_int_handler)
    try:
        return int(options.run(options))
    except HouseflyError as error:
        print(f"housefly: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main())
