"""Publishes a map on a ROS 2 topic, well or badly, as a map server or a SLAM node does.

``python tests/support/ros_map_server.py DOMAIN TOPIC MANNER`` prints ``up``, then serves; ends with
its standard input. ``MANNER`` is a key of ``MANNERS``.
"""

from __future__ import annotations

import os
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
from numpy.typing import NDArray

EDGE = 0.05
SIZE = 120, 80
"""Cells along x and y: a room of 6 m by 4 m with walls, a column and a corner nobody saw."""
ORIGIN = -1.0, -2.0


def room_values() -> NDArray[np.int8]:
    """Return the cells of the room, shape (rows, columns), the lowest row first."""
    values = np.zeros((SIZE[1], SIZE[0]), np.int8)
    values[:2], values[-2:], values[:, :2], values[:, -2:] = 100, 100, 100, 100
    values[30:40, 100:110] = 80
    values[60:78, 90:118] = -1
    return values


def room_map() -> Any:
    """Return the message."""
    from nav_msgs.msg import OccupancyGrid

    told = OccupancyGrid()
    told.info.resolution, (told.info.width, told.info.height) = EDGE, SIZE
    told.info.origin.position.x, told.info.origin.position.y = ORIGIN
    told.data = room_values().reshape(-1).tolist()
    return told


def _turned() -> Any:
    told = room_map()
    told.info.origin.orientation.w, told.info.origin.orientation.z = 0.924, 0.383
    return told


def _short() -> Any:
    told = room_map()
    told.data = told.data[:-1]
    return told


def _text() -> Any:
    from std_msgs.msg import String

    return String(data="a map")


MANNERS: dict[str, tuple[Callable[[], Any], bool]] = {
    "latched": (room_map, True),
    "repeated": (room_map, False),
    "turned": (_turned, True),
    "short": (_short, True),
    "text": (_text, True),
    "silent": (room_map, True),
}
"""What is published, and whether it is latched; what is not is told every 0.2 s."""


def main() -> None:
    """Publish until the parent is gone."""
    os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "LOCALHOST"
    import rclpy
    from rclpy.qos import DurabilityPolicy, QoSProfile

    threading.Thread(target=lambda: (sys.stdin.read(), os._exit(0)), daemon=True).start()
    domain, topic, manner = int(sys.argv[1]), sys.argv[2], sys.argv[3]
    rclpy.init(domain_id=domain)
    node = rclpy.create_node("map_server")
    make, is_latched = MANNERS[manner]
    profile = QoSProfile(depth=1)
    if is_latched:
        profile.durability = DurabilityPolicy.TRANSIENT_LOCAL
    publisher = node.create_publisher(type(make()), topic, profile)
    if manner != "silent":
        publisher.publish(make())
    print("up", flush=True)
    while True:
        time.sleep(0.2)
        if not is_latched:
            publisher.publish(make())


@contextmanager
def ros_map_server(domain: int, topic: str, manner: str = "latched") -> Iterator[None]:
    """Run a map server as a process of its own."""
    command = [sys.executable, __file__, str(domain), topic, manner]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        assert process.stdout is not None and process.stdout.readline() == b"up\n"
        yield
        process.kill()


if __name__ == "__main__":
    main()
