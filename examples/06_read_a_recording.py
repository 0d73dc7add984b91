"""Record a flight and read it with nothing of ours.

Needs: MuJoCo: the extra `twin`, which `make setup` brings.
Learns: a flight is one MCAP file with standard ROS 2 types, which other people's tools read:
    Foxglove, PlotJuggler, the mcap library, and rosbags, as here.
Prints: topics with their types and counts, then the highest point and the end of the flight from
    /odom, read by strangers' code.
"""

from collections.abc import Callable
from typing import Any

from rosbags.highlevel import AnyReader

import housefly

flight = housefly.fly("sofa", housefly.load_site("bsen"), look_s=1.0)
files = ", ".join(sorted(file.name for file in flight.folder.iterdir()))
print(f"{flight.outcome}; files: {files}")

with AnyReader([flight.folder / "flight.mcap"]) as reader:
    for topic in reader.connections:
        print(f"  {topic.topic:<22} {topic.msgtype:<34} {topic.msgcount:6d}")
    odometry = [topic for topic in reader.connections if topic.topic == "/odom"]
    decode: Callable[[bytes, str], Any] = reader.deserialize
    places = [
        decode(data, topic.msgtype).pose.pose.position
        for topic, _, data in reader.messages(connections=odometry)
    ]

x, y, highest = places[-1].x, places[-1].y, max(place.z for place in places)
print(f"highest point {highest:.2f} m, landed at ({x:.2f}, {y:.2f}) m")
