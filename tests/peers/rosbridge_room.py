"""Uses the room by PyPI roslibpy as its documentation shows; prints what it saw as JSON.

    python rosbridge_room.py HOST PORT KEY

Nothing of Housefly is imported here.
"""

from __future__ import annotations

import json
import sys
import time
from typing import Any

import roslibpy

PATIENCE = 20.0
ROOM, DRONE = "/b_sen", "/b_sen/drone"


def heard(ros: Any, name: str, kind: str, count: int = 1, **options: Any) -> list[Any]:
    """Return so many messages of a topic."""
    found: list[Any] = []
    topic = roslibpy.Topic(ros, name, kind, **options)
    topic.subscribe(found.append)
    deadline = time.monotonic() + PATIENCE
    while len(found) < count and time.monotonic() < deadline:
        time.sleep(0.02)
    topic.unsubscribe()
    return found[:count]


def called(ros: Any, name: str) -> Any:
    """Return the response of a Trigger service."""
    service = roslibpy.Service(ros, name, "std_srvs/Trigger")
    return dict(service.call(roslibpy.ServiceRequest(), timeout=PATIENCE))


def main(host: str, port: int, key: str) -> None:
    """Look, ask, order."""
    ros = roslibpy.Ros(host, port, headers={"Authorization": f"Bearer {key}"})
    ros.run(timeout=PATIENCE)
    told: dict[str, Any] = {"connected": ros.is_connected}
    told["topics"] = ros.get_topics()
    told["type"] = ros.get_topic_type(f"{DRONE}/odom")
    told["services"] = ros.get_services()
    # Its own get_time reads what ROS 1 says.
    clock = roslibpy.Service(ros, "/rosapi/get_time", "rosapi/GetTime")
    told["second"] = clock.call(roslibpy.ServiceRequest(), timeout=PATIENCE)["time"]["sec"]
    told["poses"] = heard(ros, f"{DRONE}/pose", "geometry_msgs/PoseStamped", 5)
    told["throttled"] = heard(
        ros, f"{DRONE}/odom", "nav_msgs/Odometry", 2, throttle_rate=500, queue_length=1
    )
    told["map"] = heard(ros, f"{ROOM}/map", "nav_msgs/OccupancyGrid")[0]["info"]
    told["takeoff"] = called(ros, f"{DRONE}/takeoff")
    goal = roslibpy.Topic(ros, f"{DRONE}/goal_pose", "geometry_msgs/PoseStamped")
    goal.advertise()
    position, upright = {"x": 6.0, "y": 4.0, "z": 1.0}, {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}
    pose = {"position": position, "orientation": upright}
    time.sleep(0.5)  # one wish in 0.2 s is taken
    goal.publish(roslibpy.Message({"header": {"frame_id": "map"}, "pose": pose}))
    time.sleep(1.0)
    told["stop"] = called(ros, f"{ROOM}/stop")
    goal.unadvertise()
    print(json.dumps(told))
    ros.terminate()


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]), sys.argv[3])
