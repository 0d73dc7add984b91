"""The room as a ROS 2 node: ``python -m housefly.ros2.process --site FILE --bus ENDPOINT``.

Started by the launcher where ``[ros2] enabled``, or by ``housefly ros2`` beside a run. It listens
on the bus and asks as other programs do; when it dies, nobody in the room misses it.
"""

from __future__ import annotations

import argparse
import signal
import sys
import threading
from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path

from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.process_log import log_line
from housefly.config.site import site_from_file
from housefly.errors import HouseflyError
from housefly.ros2.node import RosNode
from housefly.ros2.ros_room import RosRoom
from housefly.sites.loaded_site import LoadedSite, open_site


def run_ros2(loaded: LoadedSite, endpoint: str) -> None:
    """Serve a room as a ROS 2 node until told to end.

    Args:
        loaded: the site.
        endpoint: zenoh endpoint of its run.

    Raises:
        MissingPartError: there is no rclpy.
        LinkError: nobody listens at the endpoint.
    """
    node = RosNode("housefly", loaded.site.ros2)
    ended = threading.Event()

    def end(*_: object) -> None:
        ended.set()
        node.end()

    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, end)
    with ZenohBus(connect=endpoint) as bus, ExitStack() as stack:
        stack.callback(node.close)
        room = RosRoom(loaded, bus, node)
        room.begin(stack)
        looking = threading.Thread(target=room.look, args=(ended,), name="look", daemon=True)
        looking.start()
        log_line("ros2 ready")
        node.spin()
        ended.set()
        looking.join(timeout=2.0)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run until SIGINT or SIGTERM; returns the exit status."""
    parser = argparse.ArgumentParser(description="The room as a ROS 2 node.")
    parser.add_argument("--site", type=Path, required=True, help="the checked site, as JSON")
    parser.add_argument("--bus", required=True, help="zenoh endpoint of the run")
    options = parser.parse_args(arguments)
    try:
        run_ros2(open_site(site_from_file(options.site)), options.bus)
    except HouseflyError as error:
        log_line(str(error), sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
