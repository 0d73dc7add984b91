"""Record a flight and read it with nothing of ours.

Learns: a flight is one MCAP file with standard ROS 2 types, so Foxglove, PlotJuggler and the mcap
    library read it
(package mcap-ros2-support; `make setup-dev` installs it).
Prints: topics with their types and counts, then the highest point and the end of the flight from
    /odom, read by strangers' code.
"""

import tempfile
from pathlib import Path

from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory

from housefly.app.loaded_site import open_site, read_site
from housefly.app.lockstep import fly_lockstep
from housefly.messages import Order, OrderKind
from housefly.record.recorder import FlightRecorder

with tempfile.TemporaryDirectory() as folder:
    loaded = open_site(read_site("bsen"))
    recorder = FlightRecorder(Path(folder), loaded.site, loaded.room, loaded.grid)
    outcome = fly_lockstep(
        loaded, Order(OrderKind.SERVICE, place="sofa", look_s=1.0), recorder.add_step
    )
    flight = recorder.finish(outcome)
    print(
        f"{flight.outcome}; files:"
        f" {', '.join(sorted(path.name for path in Path(folder).iterdir()))}"
    )

    with (Path(folder) / "flight.mcap").open("rb") as stream:
        reader = make_reader(stream, decoder_factories=[DecoderFactory()])
        summary = reader.get_summary()
        assert summary is not None and summary.statistics is not None
        for channel in summary.channels.values():
            count = summary.statistics.channel_message_counts[channel.id]
            print(f"  {channel.topic:<22} {summary.schemas[channel.schema_id].name:<30} {count:6d}")
        places = [
            message.pose.pose.position
            for *_, message in reader.iter_decoded_messages(topics=["/odom"])
        ]
    print(
        f"highest point {max(place.z for place in places):.2f} m, landed at ({places[-1].x:.2f},"
        f" {places[-1].y:.2f}) m"
    )
