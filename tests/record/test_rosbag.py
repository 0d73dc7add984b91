"""A recording as a rosbag2 folder, read back by two readers that are not ours."""

from __future__ import annotations

from pathlib import Path

import pytest
from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory
from rosbags.highlevel import AnyReader

from housefly.errors import RecordingError
from housefly.messages import PilotStep
from housefly.record import ros_messages
from housefly.record.mcap_log import McapLog
from housefly.record.replay import STEP_CHANNEL
from housefly.record.ros_topics import StepTopics
from housefly.record.rosbag import write_rosbag
from housefly.room.grid import OccupancyGrid


@pytest.fixture
def recording(tmp_path: Path, flight: tuple[PilotStep, ...], grid: OccupancyGrid) -> Path:
    file, topics = tmp_path / "flight.mcap", StepTopics(1.1)
    log = McapLog(file, {})
    log.add("/map", flight[0].now, ros_messages.occupancy(flight[0].now, grid))
    for step in flight[:200]:
        log.add_own(STEP_CHANNEL, step.now, step)
        for sample in topics.of(step):
            log.add(*sample)
    log.close()
    return file


def test_the_standard_topics_come_through_byte_for_byte_and_date_for_date(
    recording: Path, tmp_path: Path
) -> None:
    bag = tmp_path / "bag"
    counts = write_rosbag(recording, bag)
    assert (bag / "metadata.yaml").is_file()
    assert counts.left_out == {STEP_CHANNEL}
    with recording.open("rb") as file:
        source = [
            (channel.topic, message.log_time, message.data)
            for _, channel, message in make_reader(file).iter_messages()
            if channel.topic != STEP_CHANNEL
        ]
    with AnyReader([bag]) as reader:
        told = [(one.topic, at, bytes(data)) for one, at, data in reader.messages()]
        odom = [one for one in reader.connections if one.topic == "/odom"]
        first = next(reader.messages(odom))[2]
        assert reader.deserialize(first, odom[0].msgtype).header.frame_id == "world"
    assert sorted(told) == sorted(source)
    assert sum(counts.messages.values()) == len(source)
    (mcap,) = bag.glob("*.mcap")
    with mcap.open("rb") as file:
        decoded = make_reader(file, decoder_factories=[DecoderFactory()])
        assert sum(1 for _ in decoded.iter_decoded_messages()) == len(source)


def test_who_comes_late_to_a_played_bag_still_gets_the_map(recording: Path, tmp_path: Path) -> None:
    write_rosbag(recording, tmp_path / "bag")
    with AnyReader([tmp_path / "bag"]) as reader:
        (latched,) = (one for one in reader.connections if one.topic == "/map")
        assert [qos.durability.name for qos in latched.ext.offered_qos_profiles] == [
            "TRANSIENT_LOCAL"
        ]


def test_what_is_of_our_own_types_goes_in_only_where_it_is_asked_for(
    recording: Path, tmp_path: Path
) -> None:
    write_rosbag(recording, tmp_path / "bag", with_own=True)
    with AnyReader([tmp_path / "bag"]) as reader:
        assert STEP_CHANNEL in {one.topic for one in reader.connections}


def test_a_folder_that_is_there_is_not_written_over(recording: Path, tmp_path: Path) -> None:
    (tmp_path / "bag").mkdir()
    with pytest.raises(RecordingError, match="cannot be written"):
        write_rosbag(recording, tmp_path / "bag")


def test_a_file_that_is_no_recording_leaves_no_folder_behind(tmp_path: Path) -> None:
    (tmp_path / "flight.mcap").write_bytes(b"no recording")
    with pytest.raises(RecordingError, match="not a recording"):
        write_rosbag(tmp_path, tmp_path / "bag")
    assert not (tmp_path / "bag").exists()
