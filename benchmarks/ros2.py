"""What the ROS 2 node costs, whether the pilot feels it, and how soon a goal is in the air.

    python benchmarks/ros2.py

A listener in a process of its own subscribes to every topic; JPEG is what nobody else needs made.
``SECONDS`` over which each is looked at (20 by default).
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager

from _run import Running, bench_site, percentile, running, table
from demo import processes, seconds
from housefly.config.site import changed
from housefly.messages import Phase

SECONDS = float(os.environ.get("SECONDS", "20"))
GOAL_SHARE, GOAL_TIME = 0.15, 2.0
DOMAIN = 71
_SETTLE = 8.0
_LISTENER = """
import importlib, sys, time, rclpy
from rclpy.qos import *
rclpy.init(domain_id=int(sys.argv[1]))
node = rclpy.create_node("listener")
jpeg = sys.argv[2] == "jpeg"
known = set()
counts = {}
def look():
    for name, kinds in node.get_topic_names_and_types():
        infos = node.get_publishers_info_by_topic(name)
        if name in known or not infos or name.startswith("/rosout"):
            continue
        if name.endswith("compressed") and not jpeg:
            continue
        known.add(name)
        package, kind, interface = kinds[0].split("/")
        type_ = getattr(importlib.import_module(package + "." + kind), interface)
        qos = QoSProfile(depth=5, durability=infos[0].qos_profile.durability,
                         reliability=infos[0].qos_profile.reliability)
        counts[name] = 0
        def count(_, name=name):
            counts[name] += 1
        node.create_subscription(type_, name, count, qos, raw=True)
node.create_timer(0.5, look)
start = time.monotonic()
try:
    rclpy.spin(node)
except BaseException:
    pass
"""
_GOAL = """
import sys, time, rclpy
from geometry_msgs.msg import PoseStamped
rclpy.init(domain_id=int(sys.argv[1]))
node = rclpy.create_node("goal")
publisher = node.create_publisher(PoseStamped, "/b_sen/drone/goal_pose", 1)
while not publisher.get_subscription_count():
    time.sleep(0.02)
message = PoseStamped()
message.header.frame_id = "map"
message.pose.position.x, message.pose.position.y, message.pose.orientation.w = 3.9, 4.2, 1.0
time.sleep(0.5)
print(time.monotonic(), flush=True)
publisher.publish(message)
time.sleep(1.0)
"""


def main() -> None:
    """Print what was measured."""
    plain = bench_site("127.9.6.1", tasks__enabled=False)
    rows: list[list[object]] = []
    with running(plain) as state:
        rows.append(["without the node", *look(state)])
    site = changed(plain, ros2__enabled=True, ros2__domain=DOMAIN, ros2__requests="auto")
    with running(site) as state:
        rows.append(["the node, nobody listens", *look(state)])
        with listening("all"):
            rows.append(["all topics but JPEG", *look(state)])
        with listening("jpeg"):
            rows.append(["JPEG, too", *look(state)])
        airborne, ordered = flown(state)
    print("### The room as a ROS 2 node\n")
    print(table(["", "the node [cores]", "pilot late, p99 [ms]", "most [ms]"], rows))
    print(
        f"\nA goal on its topic to the order at the drone {ordered:.2f} s, to 10 cm up"
        f" {airborne:.2f} s. Goals: under {GOAL_SHARE} cores with all topics but JPEG; the order"
        f" under {GOAL_TIME:g} s."
    )


def look(state: Running) -> tuple[str, str, str]:
    """Return the node's share of a core and how late the pilot was, with the drone on its pad."""
    time.sleep(_SETTLE)
    node = processes(state).get("ros2")
    before, start = 0.0 if node is None else seconds(node), time.monotonic()
    state.links.clear()
    time.sleep(SECONDS)
    took = 0.0 if node is None else seconds(node) - before
    late = [1e3 * link.loop_p99_s for link in state.links]
    most = max(1e3 * link.loop_max_s for link in state.links)
    share = "-" if node is None else f"{took / (time.monotonic() - start):.3f}"
    return share, f"{percentile(late, 0.5):.2f}", f"{most:.1f}"


def flown(state: Running) -> tuple[float, float]:
    """Return the times from a goal to 10 cm up, and to the pilot's first phase of a flight [s]."""
    assert state.step is not None and state.step.outputs.estimate is not None
    floor = state.step.outputs.estimate.position[2]
    command = [sys.executable, "-c", _GOAL, str(DOMAIN)]
    goal = subprocess.Popen(command, env=environment(), stdout=subprocess.PIPE, text=True)
    assert goal.stdout is not None
    given = float(goal.stdout.readline())
    state.wait_for(Phase.TAKING_OFF, 30.0)
    ordered = time.monotonic() - given
    while state.step.outputs.estimate.position[2] < floor + 0.1:
        time.sleep(0.01)
    airborne = time.monotonic() - given
    goal.wait()
    return airborne, ordered


def environment() -> dict[str, str]:
    """Return the environment of a ROS program of this machine."""
    return os.environ | {"ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}


@contextmanager
def listening(what: str) -> Iterator[None]:
    """Let somebody subscribe to everything."""
    command = [sys.executable, "-c", _LISTENER, str(DOMAIN), what]
    with subprocess.Popen(command, env=environment()) as listener:
        try:
            yield
        finally:
            listener.kill()


if __name__ == "__main__":
    main()
