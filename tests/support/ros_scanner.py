"""Tells scans on ROS 2 topics, well or badly, as the driver of a scanner does.

``python tests/support/ros_scanner.py DOMAIN TOPIC MANNER [RATE]`` prints ``up``, then publishes;
ends with its standard input. ``MANNER`` is a key of ``MANNERS``.
"""

from __future__ import annotations

import os
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from math import inf, nan, pi
from typing import Any

BEAMS = 1081
AGE = 0.03
"""How long before it is sent a scan was captured [s]."""


def main() -> None:
    """Publish until the parent is gone."""
    os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "LOCALHOST"
    import rclpy
    from rclpy.qos import QoSProfile, ReliabilityPolicy

    threading.Thread(target=lambda: (sys.stdin.read(), os._exit(0)), daemon=True).start()
    domain, topic, manner = int(sys.argv[1]), sys.argv[2], sys.argv[3]
    period = 1.0 / float(sys.argv[4] if len(sys.argv) > 4 else "20")
    rclpy.init(domain_id=domain)
    node = rclpy.create_node(f"scanner_{os.getpid()}")
    is_reliable = manner != "best_effort"
    policy = ReliabilityPolicy.RELIABLE if is_reliable else ReliabilityPolicy.BEST_EFFORT
    first = MANNERS[manner](0)
    publisher = node.create_publisher(type(first), topic, QoSProfile(depth=10, reliability=policy))
    print("up", flush=True)
    number = 0
    while True:
        publisher.publish(MANNERS[manner](number))
        number += 1
        time.sleep(period)


def good_scan(number: int) -> Any:
    """Return a scan of a room in which nothing stands 2 m away; no two are alike."""
    from sensor_msgs.msg import LaserScan

    scan, at = LaserScan(), time.time() - AGE
    scan.header.stamp.sec, scan.header.stamp.nanosec = int(at), int(at % 1.0 * 1e9)
    scan.header.frame_id = "laser"
    scan.angle_min, scan.angle_max = -0.75 * pi, 0.75 * pi
    scan.angle_increment = 1.5 * pi / (BEAMS - 1)
    scan.range_min, scan.range_max = 0.06, 30.0
    scan.ranges = [2.0 + 0.001 * (number % 7)] * (BEAMS - 1) + [inf]
    return scan


def _changed(**changes: Any) -> Callable[[int], Any]:
    def make(number: int) -> Any:
        scan = good_scan(number)
        for name, value in changes.items():
            setattr(scan, name, value)
        return scan

    return make


def _frozen(number: int) -> Any:
    scan = good_scan(number)
    scan.header.stamp.sec, scan.header.stamp.nanosec = 7, 0
    return scan


def _absurd(number: int) -> Any:
    scan = good_scan(number)
    scan.header.stamp.sec, scan.header.stamp.nanosec = -5, 4_000_000_000
    return scan


def _text(_: int) -> Any:
    from std_msgs.msg import String

    return String(data="a scan")


MANNERS: dict[str, Callable[[int], Any]] = {
    "good": good_scan,
    "best_effort": good_scan,
    "nan": _changed(ranges=[nan] * BEAMS),
    "count": _changed(ranges=[2.0] * 17),
    "giant": _changed(ranges=[2.0] * 2_000_000),
    "frozen": _frozen,
    "absurd": _absurd,
    "text": _text,
}
"""What is published."""


@contextmanager
def ros_scanner(
    domain: int, topic: str, manner: str = "good", rate_hz: float = 20.0
) -> Iterator[subprocess.Popen[bytes]]:
    """Run a scanner as a process of its own; it publishes by the time that it is given."""
    command = [sys.executable, __file__, str(domain), topic, manner, str(rate_hz)]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        assert process.stdout is not None and process.stdout.readline() == b"up\n"
        yield process
        process.kill()


if __name__ == "__main__":
    main()
