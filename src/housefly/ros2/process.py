"""The room as a ROS 2 node: ``python -m housefly.ros2.process --site FILE --bus ENDPOINT``.

Started by the launcher where ``[ros2] enabled``, or by ``housefly ros2`` beside a run. It listens
on the bus and asks as other programs do; when it dies, nobody in the room misses it.
"""

from __future__ import annotations

import argparse
import signal
import sys
import threading
from collections.abc import Callable, Iterable, Sequence
from contextlib import ExitStack
from functools import partial
from pathlib import Path
from typing import Any

from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.process_log import log_line
from housefly.config.site import site_from_file
from housefly.errors import HouseflyError
from housefly.ros2.navigate_server import NavigateServer
from housefly.ros2.node import RosNode
from housefly.ros2.order_line import RosReply
from housefly.ros2.ros_caller import node_caller
from housefly.ros2.ros_room import RosRoom
from housefly.ros2.wishes import TRIGGER, RosInput, RosService, triggered
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
        desk = room.desk(node_caller(loaded.site.ros2.requests))
        _offer(node, room.offered(desk, node.publish))
        room.on_errands = lambda: _offer(node, room.offered_errands(desk))
        for drone in room.drones:
            NavigateServer(drone, loaded.site.ros2.frame, node, desk).begin(bus, stack)
        looking = threading.Thread(target=room.look, args=(ended.wait,), name="look", daemon=True)
        looking.start()
        log_line("ros2 ready")
        node.spin()
        ended.set()
        looking.join(timeout=2.0)


def _offer(node: RosNode, offered: Iterable[RosService | RosInput]) -> None:
    for one in offered:
        if isinstance(one, RosService):
            node.serve(TRIGGER, one.name, triggered(one.wish))
        else:
            node.subscribe(one.topic, one.name, partial(_taken, node, one.wish))


def _taken(node: RosNode, wish: Callable[[Any], RosReply], message: Any) -> None:
    reply = wish(message)
    if reply.message:
        (node.inform if reply.success else node.warn)(reply.message)


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
