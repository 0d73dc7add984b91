"""A map that a ROS 2 node publishes now: nav_msgs/OccupancyGrid, heard once by a child process."""

from __future__ import annotations

import base64
import json
import re
import subprocess
import threading
from dataclasses import dataclass
from typing import Any

import numpy as np

from housefly.bus.interfaces import type_store
from housefly.bus.ros2_child import ros2_command
from housefly.errors import ConfigError, LinkError, RoomError
from housefly.room.occupancy_map import OccupancyMessage, ros_map_of
from housefly.room.ros_image import MAP_SIDE_MAX, RosMap

ROS2_MAP = "ros2:"
"""How a map of ROS begins where a room is asked for."""
OCCUPANCY_GRID = "nav_msgs/msg/OccupancyGrid"
PATIENCE = 10.0
"""How long one is waited for [s]: a latched one comes at once, a slow SLAM tells every 5 s."""
_START = 60.0
"""A child that has said nothing for so long besides hangs [s]."""
_BYTES_MAX = MAP_SIDE_MAX**2 + 64 * 1024
_TOPIC = re.compile(r"(/[A-Za-z_][A-Za-z0-9_]*)+")
_DOMAIN_MAX = 232
_DISCOVERY = ("localhost", "subnet")


@dataclass(frozen=True, slots=True)
class MapTopic:
    """Where a map is published.

    Attributes:
        topic: its full name.
        domain: of ROS; None is ROS_DOMAIN_ID, or 0.
        discovery: whose nodes are heard: of this machine, or of the whole network.
    """

    topic: str
    domain: int | None = None
    discovery: str = "localhost"

    @property
    def source(self) -> str:
        """As it is typed."""
        return f"{ROS2_MAP}{self.topic}"


def map_topic(text: str, keys: dict[str, str]) -> MapTopic:
    """Return what ``ros2:/map domain=3 discovery=subnet`` names; raises ConfigError."""
    topic = text.removeprefix(ROS2_MAP)
    if not _TOPIC.fullmatch(topic):
        raise ConfigError("room", f"is {text!r}; allowed: ros2: and a full topic, ros2:/map")
    domain, discovery = keys.get("domain"), keys.get("discovery", "localhost")
    if domain is not None and not (domain.isdecimal() and int(domain) <= _DOMAIN_MAX):
        raise ConfigError("domain", f"is {domain!r}; allowed: 0 to {_DOMAIN_MAX}")
    if discovery not in _DISCOVERY:
        raise ConfigError("discovery", f"is {discovery!r}; allowed: {', '.join(_DISCOVERY)}")
    return MapTopic(topic, None if domain is None else int(domain), discovery)


def hear_map(where: MapTopic, patience: float = PATIENCE) -> RosMap:
    """Return the map that is published on a topic.

    Args:
        where: it is published.
        patience: how long one is waited for, once ROS was joined [s].

    Raises:
        LinkError: none came; says who publishes there.
        RoomError: it is no map.
        MissingPartError: there is no rclpy.
    """
    settings = {
        "topic": where.topic,
        "domain": where.domain,
        "discovery": where.discovery,
        "patience": patience,
        "bytes_max": _BYTES_MAX,
    }
    command = ros2_command("housefly.app.new_site.ros2_map_child", settings)
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as child:
        hangs = threading.Timer(patience + _START, child.kill)
        hangs.start()
        try:
            assert child.stdout is not None
            line = child.stdout.readline()
        finally:
            hangs.cancel()
            child.kill()
    tree = _tree(line)
    if "too_large" in tree:
        raise RoomError(f"{where.source}: {tree['too_large']} bytes; allowed: {_BYTES_MAX}")
    if "map" not in tree:
        raise LinkError(_silence(tree, where, patience))
    message = occupancy_message(base64.b64decode(tree["map"]), where.source)
    return ros_map_of(message, where.source)


def _tree(line: bytes) -> dict[str, Any]:
    try:
        tree = json.loads(line)
    except ValueError as error:
        raise LinkError("the child that hears ROS 2 ended without a word") from error
    if "problem" in tree:
        raise LinkError(f"ROS 2 says: {tree['problem']}")
    return dict(tree)


def occupancy_message(data: bytes, name: str) -> OccupancyMessage:
    """Return what the bytes of a message say, unchecked; ``name`` says where they are from.

    Raises:
        RoomError: they are no OccupancyGrid.
    """
    try:
        told: Any = type_store().deserialize_cdr(data, OCCUPANCY_GRID)
    except Exception as error:  # whatever the reader raises on foreign bytes
        why = type(error).__name__
        raise RoomError(f"{name}: no {OCCUPANCY_GRID} ({why})") from error
    info = told.info
    place, turn = info.origin.position, info.origin.orientation
    return OccupancyMessage(
        (int(info.width), int(info.height)),
        round(float(info.resolution), 6),  # of 32 bits
        (float(place.x), float(place.y)),
        (float(turn.w), float(turn.x), float(turn.y), float(turn.z)),
        np.asarray(told.data, np.int8),
    )


def _silence(tree: dict[str, Any], where: MapTopic, patience: float) -> str:
    """Return why no map came."""
    types = [str(kind) for kind in tree.get("types", ())]
    if OCCUPANCY_GRID in types:
        return (
            f"no map came on {where.source} in {patience:g} s, though somebody publishes there: let"
            " its node tell it latched (transient local), or again"
        )
    if types:
        return (
            f"what is published on {where.source} is {', '.join(types)}; allowed: {OCCUPANCY_GRID}"
        )
    return (
        f"nobody publishes on {where.source} in {patience:g} s: is the node up, in the same domain"
        " (domain=), and on this machine (else discovery=subnet)?"
    )
