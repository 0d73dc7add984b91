"""Record a flight and read it with nothing of ours.

Learns: a flight is one MCAP file with standard ROS 2 types, so Foxglove, PlotJuggler and the mcap
    library read it (package mcap-ros2-support; `make setup-dev` installs it).
Prints: topics with their types and counts, then the highest point and the end of the flight from
    /odom, read by strangers' code.
"""

from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory

import housefly

flight = housefly.fly("sofa", housefly.load_site("bsen"), look_s=1.0)
files = ", ".join(sorted(file.name for file in flight.folder.iterdir()))
print(f"{flight.outcome}; files: {files}")

with (flight.folder / "flight.mcap").open("rb") as stream:
    reader = make_reader(stream, decoder_factories=[DecoderFactory()])
    summary = reader.get_summary()
    assert summary is not None and summary.statistics is not None
    for channel in summary.channels.values():
        count = summary.statistics.channel_message_counts[channel.id]
        print(f"  {channel.topic:<22} {summary.schemas[channel.schema_id].name:<30} {count:6d}")
    odometry = reader.iter_decoded_messages(topics=["/odom"])
    places = [message.pose.pose.position for *_, message in odometry]

x, y, highest = places[-1].x, places[-1].y, max(place.z for place in places)
print(f"highest point {highest:.2f} m, landed at ({x:.2f}, {y:.2f}) m")
