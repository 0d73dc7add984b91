"""``housefly ros2``: let a room that runs here join ROS 2."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from housefly.app.commands.subcommand import Subcommand
from housefly.errors import LinkError


def _add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("--site", default="bsen", help="site of the run (default: bsen)")
    parser.add_argument("--domain", type=int, metavar="N", help="ROS domain, 0 to 232")
    parser.add_argument(
        "--requests",
        choices=("off", "ask", "auto"),
        help="what a goal from ROS may do: nothing, ask a person, fly",
    )
    parser.add_argument(
        "--subnet", action="store_true", help="be found by the whole network, not this machine only"
    )


def _run(options: Namespace) -> int:
    """Serve until Ctrl-C."""
    from housefly.hub.client.discovery import find
    from housefly.ros2.process import run_ros2
    from housefly.sites.loaded_site import load_site

    changes = {"ros2__domain": options.domain, "ros2__requests": options.requests}
    changes["ros2__discovery"] = "subnet" if options.subnet else None
    given = {key: value for key, value in changes.items() if value is not None}
    loaded = load_site(options.site, **given)
    place = find(loaded.site.name)
    if not place.bus:
        raise LinkError(f"the run of {place.site} does not say where its bus is")
    run_ros2(loaded, place.bus)
    return 0


ROS2_COMMAND = Subcommand(
    name="ros2",
    help="let a room that runs here join ROS 2 as a node",
    description=(
        "Join ROS 2 beside a run, as an ordinary node: poses, paths, map, camera, people, things,"
        " tasks go out; goals, take-off, landing, STOP and sentences come in. It needs rclpy: of"
        " the sourced ROS, or pip install 'housefly[ros2]'. A site does the same by [ros2] enabled"
        " = true (docs/ros2.md)."
    ),
    add_arguments=_add_arguments,
    run=_run,
)
