"""The flight recorder writes what standard readers read, and never disturbs the flight."""

from __future__ import annotations

import json
import os
import pickle
import resource
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import av
import pytest
from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory

from housefly.config.site import Site, site_from_file
from housefly.config.tasks import PrivacyZone
from housefly.errors import RecordingError
from housefly.messages import LinkStatus, PilotStep, VideoFrame
from housefly.record.recorder import FlightRecorder
from housefly.record.replay import read_steps
from housefly.record.summary import Summary
from housefly.room.grid import Cell, OccupancyGrid
from housefly.room.model import Room


@pytest.fixture(scope="module")
def recording(
    tmp_path_factory: pytest.TempPathFactory,
    site: Site,
    room: Room,
    grid: OccupancyGrid,
    flight: tuple[PilotStep, ...],
    pictures: tuple[VideoFrame, ...],
) -> tuple[Path, Summary]:
    out = tmp_path_factory.mktemp("flight") / "made" / "by the recorder"
    recorder = FlightRecorder(out, site, room, grid)
    for step in flight:
        recorder.add_step(step)
    for picture in pictures:
        recorder.add_video(picture)
    recorder.add_link(LinkStatus(101.0, tracking_connected=True, tracking_rate_hz=50.0))
    return out, recorder.finish("completed")


def messages(out: Path) -> dict[str, list[Any]]:
    """Return the decoded messages of each topic, read by Foxglove's own decoder."""
    found: dict[str, list[Any]] = {}
    with (out / "flight.mcap").open("rb") as file:
        reader = make_reader(file, decoder_factories=[DecoderFactory()])
        assert reader.get_header().profile == "ros2"
        for _, channel, _, message in reader.iter_decoded_messages():
            found.setdefault(channel.topic, []).append(message)
    return found


def test_every_file_of_a_flight_is_there(recording: tuple[Path, Summary]) -> None:
    out, summary = recording
    assert sorted(path.name for path in out.iterdir()) == [
        "flight.mcap",
        "report.html",
        "site.json",
        "summary.json",
        "video.mp4",
    ]
    assert summary.problems == ()
    assert json.loads((out / "summary.json").read_text())["outcome"] == "completed"


def test_an_independent_reader_finds_standard_topics(
    recording: tuple[Path, Summary], flight: tuple[PilotStep, ...], pictures: tuple[VideoFrame, ...]
) -> None:
    found = messages(recording[0])
    counts = {topic: len(values) for topic, values in found.items()}
    steps = len(flight)
    assert (
        counts["/housefly/step"]
        == counts["/sighting/ardrone"]
        == counts["/sighting/visitor"]
        == steps
    )
    assert counts["/odom"] == counts["/cmd_vel"] == counts["/battery"] == steps
    assert (counts["/map"], counts["/housefly/link"], counts["/events"], counts["/video"]) == (
        1,
        1,
        1,
        len(pictures),
    )
    assert counts["/path"] == 3, "out, back, and none at the end"


def test_the_standard_messages_say_what_the_steps_said(
    recording: tuple[Path, Summary], flight: tuple[PilotStep, ...], grid: OccupancyGrid
) -> None:
    found = messages(recording[0])
    step = flight[400]
    pose, odometry, command = (
        found["/sighting/ardrone"][400],
        found["/odom"][400],
        found["/cmd_vel"][400],
    )
    seen, estimate = step.inputs.sightings[0], step.outputs.estimate
    assert estimate is not None
    assert (pose.pose.position.x, pose.pose.position.z) == (
        seen.pose.position[0],
        seen.pose.position[2],
    )
    assert pose.pose.orientation.w == seen.pose.orientation[0]
    assert pose.header.stamp.sec + 1e-9 * pose.header.stamp.nanosec == pytest.approx(
        seen.captured_at, abs=1e-8
    )
    assert odometry.header.frame_id == "world"
    assert odometry.pose.pose.position.y == estimate.position[1]
    assert odometry.twist.twist.linear.y < 0, (
        "flying along x while looking a little to the left is flying to the right"
    )
    assert command.twist.linear.y == -step.outputs.command.setpoint.phi
    occupancy = found["/map"][0]
    assert (occupancy.info.width, occupancy.info.height) == grid.cells.shape
    column, row = 30, 26
    assert (occupancy.data[row * occupancy.info.width + column] == 100) == (
        grid.cells[column, row] == Cell.OCCUPIED
    )
    assert found["/events"][0].level == 20
    assert found["/video"][0].format == "h264"


def test_the_film_plays_with_every_picture_at_its_time(
    recording: tuple[Path, Summary], pictures: tuple[VideoFrame, ...]
) -> None:
    with av.open(str(recording[0] / "video.mp4")) as film:
        shown = [(frame.time, frame.width, frame.height) for frame in film.decode(video=0)]
    assert len(shown) == len(pictures)
    assert shown[0][1:] == (64, 48)
    for (at, _, _), picture in zip(shown, pictures, strict=True):
        assert at == pytest.approx(picture.received_at - pictures[0].received_at, abs=1e-4)


def test_the_site_is_kept_as_it_was_flown(recording: tuple[Path, Summary], site: Site) -> None:
    assert site_from_file(recording[0] / "site.json") == site


@pytest.mark.usefixtures("no_report")
def test_finishing_twice_gives_the_same_summary_and_later_messages_are_ignored(
    tmp_path: Path, site: Site, room: Room, grid: OccupancyGrid, flight: tuple[PilotStep, ...]
) -> None:
    recorder = FlightRecorder(tmp_path, site, room, grid)
    first = recorder.finish("nothing flown")
    recorder.add_step(flight[0])
    assert recorder.finish("something else") is first
    assert (first.outcome, first.duration_s, first.rms_error_m, first.steps) == (
        "nothing flown",
        None,
        None,
        0,
    )
    assert first.problems == ()


@pytest.mark.usefixtures("no_report")
def test_many_threads_may_record_at_once(
    tmp_path: Path,
    site: Site,
    room: Room,
    grid: OccupancyGrid,
    flight: tuple[PilotStep, ...],
    pictures: tuple[VideoFrame, ...],
) -> None:
    recorder = FlightRecorder(tmp_path, site, room, grid)
    threads = [
        threading.Thread(target=lambda: [recorder.add_step(step) for step in flight]),
        threading.Thread(target=lambda: [recorder.add_video(picture) for picture in pictures]),
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert recorder.finish("completed").video_frames == len(pictures)
    assert list(read_steps(tmp_path)) == list(flight)


@pytest.fixture
def small_disk() -> Iterator[Callable[[int], None]]:
    """Return a function that limits the size of this process's files [bytes]."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    yield lambda size: resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    resource.setrlimit(resource.RLIMIT_FSIZE, before)


def test_a_disk_that_fills_up_in_flight_is_reported_and_not_raised(
    tmp_path: Path,
    site: Site,
    room: Room,
    grid: OccupancyGrid,
    flight: tuple[PilotStep, ...],
    pictures: tuple[VideoFrame, ...],
    small_disk: Callable[[int], None],
) -> None:
    recorder = FlightRecorder(tmp_path, site, room, grid)
    small_disk(60_000)
    for step in flight:
        recorder.add_step(step)
    for picture in pictures:
        recorder.add_video(picture)
    summary = recorder.finish("completed")
    assert (summary.outcome, summary.video_frames) == ("completed", len(pictures))
    assert any("flight.mcap is incomplete" in problem for problem in summary.problems)
    assert json.loads((tmp_path / "summary.json").read_text())["problems"] == list(summary.problems)
    readable = list(read_steps(tmp_path))
    assert readable == list(flight[: len(readable)])
    assert 0 < len(readable) == summary.steps < len(flight)


def test_a_disk_that_is_full_before_the_flight_is_refused(
    tmp_path: Path, site: Site, room: Room, grid: OccupancyGrid
) -> None:
    if not Path("/dev/full").exists():
        pytest.skip("this system has no /dev/full")
    (tmp_path / "flight.mcap").symlink_to("/dev/full")
    with pytest.raises(RecordingError, match="No space left"):
        FlightRecorder(tmp_path, site, room, grid)


def test_a_folder_that_cannot_be_written_is_refused_before_the_flight(
    tmp_path: Path, site: Site, room: Room, grid: OccupancyGrid
) -> None:
    (tmp_path / "file").write_text("in the way")
    with pytest.raises(RecordingError, match="cannot be written"):
        FlightRecorder(tmp_path / "file", site, room, grid)


@pytest.mark.usefixtures("no_report")
def test_a_step_that_cannot_be_encoded_is_left_out_and_told(
    tmp_path: Path, site: Site, room: Room, grid: OccupancyGrid, flight: tuple[PilotStep, ...]
) -> None:
    recorder = FlightRecorder(tmp_path, site, room, grid)
    recorder.add_step(flight[0])
    recorder.add_step(replace(flight[1], sequence=2**70))
    recorder.add_step(flight[2])
    summary = recorder.finish("completed")
    assert [step.sequence for step in read_steps(tmp_path)] == [0, 2]
    assert (summary.steps, summary.missing_steps) == (2, 1)
    assert any("lacks a message" in problem for problem in summary.problems)


@pytest.mark.usefixtures("no_report")
def test_pictures_before_the_first_key_frame_and_of_another_size_are_left_out_of_the_film(
    tmp_path: Path, site: Site, room: Room, grid: OccupancyGrid, pictures: tuple[VideoFrame, ...]
) -> None:
    recorder = FlightRecorder(tmp_path, site, room, grid)
    for picture in pictures[5:]:
        recorder.add_video(picture)
    recorder.add_video(replace(pictures[0], width=32, height=24, received_at=200.0))
    recorder.add_video(replace(pictures[0], data=b"garbage", received_at=201.0))
    assert recorder.finish("completed").video_frames == 57
    with av.open(str(tmp_path / "video.mp4")) as film:
        assert len(list(film.decode(video=0))) == 45


@pytest.mark.usefixtures("no_report")
def test_where_there_are_privacy_zones_no_picture_is_recorded(
    tmp_path: Path, site: Site, room: Room, grid: OccupancyGrid, pictures: tuple[VideoFrame, ...]
) -> None:
    zone = PrivacyZone(name="bed", polygon=((0, 0), (1, 0), (1, 1)))
    tasks = site.tasks.model_copy(update={"privacy_zones": (zone,)})
    private = site.model_copy(update={"tasks": tasks})
    recorder = FlightRecorder(tmp_path, private, room, grid)
    for picture in pictures:
        recorder.add_video(picture)
    recorder.finish("completed")
    assert not (tmp_path / "video.mp4").exists()
    assert "/video" not in messages(tmp_path)


@pytest.mark.usefixtures("no_report")
def test_garbage_instead_of_pictures_makes_no_film_and_no_noise(
    tmp_path: Path, site: Site, room: Room, grid: OccupancyGrid
) -> None:
    recorder = FlightRecorder(tmp_path, site, room, grid)
    for data in (b"", b"garbage", bytes(5000), b"\x00\x00\x00\x01\x67garbage"):
        recorder.add_video(VideoFrame(data, True, 64, 48, 1, 100.0))
    summary = recorder.finish("completed")
    assert (summary.video_frames, summary.problems) == (4, ())
    assert not (tmp_path / "video.mp4").exists()


@pytest.mark.usefixtures("no_report")
def test_a_recording_can_be_read_while_it_grows_also_when_little_happens(
    tmp_path: Path, site: Site, room: Room, grid: OccupancyGrid, flight: tuple[PilotStep, ...]
) -> None:
    recorder = FlightRecorder(tmp_path, site, room, grid)
    for step in flight[:60]:
        recorder.add_step(step)
    readable: list[PilotStep] = []
    deadline = time.monotonic() + 20.0
    while time.monotonic() < deadline and len(readable) < 15:
        time.sleep(0.05)
        readable = list(read_steps(tmp_path))
    assert readable == list(flight[: len(readable)])
    assert len(readable) >= 15
    recorder.finish("completed")


CRASH = """
import pickle, sys
from pathlib import Path
from housefly.record.recorder import FlightRecorder
site, room, grid, flight, pictures = pickle.loads(Path(sys.argv[1]).read_bytes())
recorder = FlightRecorder(Path(sys.argv[2]), site, room, grid)
import time
for number, step in enumerate(flight):
    recorder.add_step(step)
    if number < len(pictures):
        recorder.add_video(pictures[number])
    time.sleep(0.002)
print("recorded", flush=True)
time.sleep(60)
"""


@pytest.mark.wire
def test_after_a_crash_all_but_the_last_second_is_readable(
    tmp_path: Path,
    site: Site,
    room: Room,
    grid: OccupancyGrid,
    flight: tuple[PilotStep, ...],
    pictures: tuple[VideoFrame, ...],
) -> None:
    (tmp_path / "flight.pickle").write_bytes(pickle.dumps((site, room, grid, flight, pictures)))
    arguments = [
        sys.executable,
        "-c",
        CRASH,
        str(tmp_path / "flight.pickle"),
        str(tmp_path / "out"),
    ]
    with subprocess.Popen(arguments, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "recorded\n"
        time.sleep(0.2)
        os.kill(process.pid, signal.SIGKILL)
    readable = list(read_steps(tmp_path / "out"))
    assert readable == list(flight[: len(readable)])
    # At 50 steps a second: the chunk in the making and what the file's own buffer holds.
    assert len(readable) > len(flight) - 50
    with av.open(str(tmp_path / "out" / "video.mp4")) as film:
        assert len(list(film.decode(video=0))) >= 30
