"""Tells what a SCIP scanner sees on a ROS 2 topic, as a driver of a lab does.

``python tests/support/ros_urg.py ADDRESS DOMAIN TOPIC``; ends with its standard input.
"""

from __future__ import annotations

import asyncio
import os
import sys
import threading
import time
from typing import Any

from housefly.clock import RealClock
from housefly.config.laser import LaserConfig
from housefly.messages import Scan
from housefly.sensors.laser import LaserClient


def main() -> None:
    """Publish each scan."""
    os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "LOCALHOST"
    import rclpy
    from rclpy.qos import qos_profile_sensor_data
    from sensor_msgs.msg import LaserScan

    threading.Thread(target=lambda: (sys.stdin.read(), os._exit(0)), daemon=True).start()
    address, domain, topic = sys.argv[1], int(sys.argv[2]), sys.argv[3]
    rclpy.init(domain_id=domain)
    publisher: Any = rclpy.create_node("urg").create_publisher(
        LaserScan, topic, qos_profile_sensor_data
    )
    offset = time.time() - time.monotonic()

    def tell(scan: Scan) -> None:
        message, at = LaserScan(), scan.captured_at + offset
        message.header.stamp.sec, message.header.stamp.nanosec = int(at), int(at % 1.0 * 1e9)
        message.angle_min, message.angle_increment = scan.first_angle, scan.step
        message.angle_max = scan.first_angle + scan.step * (len(scan.ranges) - 1)
        message.range_min, message.range_max = 0.06, 30.0
        message.ranges = list(scan.ranges)
        publisher.publish(message)

    asyncio.run(LaserClient(LaserConfig(name="urg", address=address), RealClock()).run(tell))


if __name__ == "__main__":
    main()
