"""Tells what a Vicon system sees on ROS 2 topics, as a driver of a lab does.

``python tests/support/ros_mocap.py ADDRESS PORT DOMAIN``; ends with its standard input.
"""

from __future__ import annotations

import asyncio
import os
import sys
import threading
import time
from contextlib import suppress
from typing import Any

from housefly.clock import RealClock
from housefly.config.tracking import TrackingConfig
from housefly.messages import Sighting
from housefly.tracking.vicon import ViconTracker


def main() -> None:
    """Publish each pose as ``/mocap/BODY/pose``."""
    os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "LOCALHOST"
    import rclpy
    from geometry_msgs.msg import PoseStamped

    with suppress(PermissionError):
        os.nice(-5)  # as the room that is simulated
    threading.Thread(target=lambda: (sys.stdin.read(), os._exit(0)), daemon=True).start()
    address, port, domain = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    rclpy.init(domain_id=domain)
    node = rclpy.create_node("mocap")
    publishers: dict[str, Any] = {}
    offset = time.time() - time.monotonic()

    def tell(sightings: tuple[Sighting, ...]) -> None:
        for one in sightings:
            if one.body not in publishers:
                topic = f"/mocap/{one.body}/pose"
                publishers[one.body] = node.create_publisher(PoseStamped, topic, 10)
            message, at = PoseStamped(), one.captured_at + offset
            message.header.stamp.sec = int(at)
            message.header.stamp.nanosec = int(at % 1.0 * 1e9)
            place, turn = message.pose.position, message.pose.orientation
            place.x, place.y, place.z = one.pose.position
            turn.w, turn.x, turn.y, turn.z = one.pose.orientation
            publishers[one.body].publish(message)

    config = TrackingConfig(kind="vicon", address=address, port=port)
    asyncio.run(ViconTracker(config, RealClock()).run(tell))


if __name__ == "__main__":
    main()
