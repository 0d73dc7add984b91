"""Logs of others are read as the flight that they are of: same axes, same signs, same times."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import pi
from pathlib import Path

import numpy as np
import pytest
from foreign_logs import (
    EPOCH,
    Row,
    crazyflie_csv,
    dataflash_bytes,
    flight,
    ulog_bytes,
    write_bag,
)
from hypothesis import given, settings
from hypothesis import strategies as st
from pymavlink.DFReader import DFReader_binary

from housefly.app.flight_logs.dataflash_messages import dataflash_messages
from housefly.app.flight_logs.read_log import is_own_recording, read_flight_log
from housefly.errors import RecordingError
from housefly.messages import Severity
from housefly.numeric import FloatArray
from housefly.record.flight_log import FlightLog

ROWS = flight()
Writer = Callable[[Path, Sequence[Row]], Path]


def written(content: Callable[[Sequence[Row]], bytes]) -> Writer:
    def write(path: Path, rows: Sequence[Row]) -> Path:
        path.write_bytes(content(rows))
        return path

    return write


WRITERS: dict[str, Writer] = {
    "flight.bag": write_bag,
    "bag_db3": write_bag,
    "bag_mcap": write_bag,
    "flight.ulg": written(ulog_bytes),
    "flight.bin": written(dataflash_bytes),
    "flight.csv": written(lambda rows: crazyflie_csv(rows).encode()),
}
LACKS = {
    "flight.ulg": {"velocity setpoints"},
    "flight.bin": {"position setpoints", "velocity setpoints"},
}
CUT = ["flight.ulg", "flight.bin", "flight.csv"]


@pytest.fixture(autouse=True)
def _parts(request: pytest.FixtureRequest) -> None:
    if "ulg" in request.node.name:
        pytest.importorskip("pyulog")


def turned(one: FloatArray, other: FloatArray) -> FloatArray:
    """Return the differences of angles [rad]."""
    return np.abs(np.remainder(one - other + pi, 2.0 * pi) - pi)


def columns(name: str) -> FloatArray:
    return np.array([getattr(row, name) for row in ROWS])


def log_of(name: str, folder: Path) -> FlightLog:
    return read_flight_log(WRITERS[name](folder / name, ROWS))


@pytest.mark.parametrize("name", WRITERS)
def test_position_velocity_attitude_and_battery_are_those_of_the_flight(
    name: str, tmp_path: Path
) -> None:
    log = log_of(name, tmp_path)
    assert np.allclose(log.time, columns("at"), atol=1e-3)
    assert np.allclose(log.position, columns("position"), atol=1e-5)
    assert np.allclose(log.velocity, columns("velocity"), atol=1e-5)
    assert turned(log.attitude, columns("attitude")).max() < 1e-5
    assert np.allclose(log.battery, columns("battery"), atol=0.0051)
    assert log.problems == ()


@pytest.mark.parametrize("name", WRITERS)
def test_what_a_file_lacks_is_said_and_what_it_has_says_from_where(
    name: str, tmp_path: Path
) -> None:
    log = log_of(name, tmp_path)
    assert set(log.lacks) == LACKS.get(name, {"velocity setpoints"})
    assert "position" in log.sources
    if "position setpoints" not in log.lacks:
        assert np.allclose(log.wanted[:, :3], columns("wanted")[:, :3], atol=1e-5)
        assert turned(log.wanted[:, 3], columns("wanted")[:, 3]).max() < 1e-5


@pytest.mark.parametrize("name", ["flight.bag", "bag_db3", "bag_mcap"])
def test_a_bag_says_when_it_was_and_what_was_reported(name: str, tmp_path: Path) -> None:
    log = log_of(name, tmp_path)
    assert log.started_at == pytest.approx(EPOCH, abs=1e-3)
    assert [(one.severity, one.text) for one in log.events] == [
        (Severity.WARNING, "the battery is weak")
    ]
    assert (
        "battery"
        in read_flight_log(write_bag(tmp_path / f"without_{name}", ROWS, with_battery=False)).lacks
    )


@pytest.mark.parametrize("name", ["flight.ulg", "flight.bin"])
def test_the_autopilots_own_words_are_events(name: str, tmp_path: Path) -> None:
    (event,) = log_of(name, tmp_path).events
    assert event.text in ("Armed by external command", "Arming motors")
    assert event.at == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize("name", ["flight.ulg", "flight.bin"])
def test_a_cut_log_gives_what_is_there_and_says_where_it_is_cut(name: str, tmp_path: Path) -> None:
    file = WRITERS[name](tmp_path / name, ROWS)
    whole = file.read_bytes()
    file.write_bytes(whole[: 2 * len(whole) // 3 + 1])
    log = read_flight_log(file)
    assert 0 < log.time.size < len(ROWS)
    assert np.allclose(log.position, columns("position")[: log.time.size], atol=1e-5)
    assert "cut off or damaged after" in log.problems[0]
    assert "bytes" in log.problems[0]


def test_a_cut_mcap_gives_what_is_there(tmp_path: Path) -> None:
    (file,) = write_bag(tmp_path / "bag_mcap", flight(3000)).glob("*.mcap")
    single = tmp_path / "single.mcap"
    whole = file.read_bytes()
    single.write_bytes(whole)
    assert read_flight_log(single).time.size == 3000
    single.write_bytes(whole[: len(whole) // 2])
    assert 0 < read_flight_log(single).time.size < 3000


def test_a_cut_rosbag_1_is_refused_in_words(tmp_path: Path) -> None:
    file = write_bag(tmp_path / "flight.bag", ROWS)
    file.write_bytes(file.read_bytes()[:-2000])
    with pytest.raises(RecordingError, match="cannot be read as a bag"):
        read_flight_log(file)


def test_rows_of_a_table_that_are_no_numbers_are_left_out_and_counted(tmp_path: Path) -> None:
    file = tmp_path / "flight.csv"
    file.write_text(crazyflie_csv(ROWS) + "what,is,this\n1990,1.0")
    log = read_flight_log(file)
    assert log.time.size == len(ROWS)
    assert log.problems == ("1 of 102 rows hold no time and are left out",)


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("a.txt", b"hello", "of no known kind; allowed"),
        ("a.csv", b"a,b\n1,2\n", "of no known kind"),
        ("a.db3", b"SQLite format 3\0", "name its folder"),
        ("a.rosbag", b"#ROSBAG V2.0\n", "must end in .bag"),
        ("empty", b"", "of no known kind"),
        ("a.csv", b"timestamp,stateEstimate.x\n", "neither positions nor attitudes"),
        ("a.bag", b"#ROSBAG V2.0\n", "cannot be read as a bag"),
    ],
)
def test_what_cannot_be_read_is_refused_in_words(
    name: str, content: bytes, words: str, tmp_path: Path
) -> None:
    (tmp_path / name).write_bytes(content)
    with pytest.raises(RecordingError, match=words):
        read_flight_log(tmp_path / name)


def test_a_folder_that_is_no_bag_and_a_file_that_is_not_there_are_refused(tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match=r"no metadata\.yaml"):
        read_flight_log(tmp_path)
    with pytest.raises(RecordingError, match="cannot be read"):
        read_flight_log(tmp_path / "nowhere.bag")


@pytest.mark.parametrize("name", CUT)
@settings(deadline=None, max_examples=25)
@given(data=st.data())
def test_a_damaged_file_is_read_in_part_or_refused_and_nothing_else(
    name: str, tmp_path_factory: pytest.TempPathFactory, data: st.DataObject
) -> None:
    file = WRITERS[name](tmp_path_factory.mktemp("log") / name, ROWS[:10])
    whole = bytearray(file.read_bytes())
    for _ in range(data.draw(st.integers(1, 4))):
        whole[data.draw(st.integers(0, len(whole) - 1))] = data.draw(st.integers(0, 255))
    file.write_bytes(whole[: data.draw(st.integers(0, len(whole)))])
    try:
        log = read_flight_log(file)
    except RecordingError:
        return
    assert log.time.size == len(log.position) == len(log.attitude) == len(log.battery)
    assert np.all(np.diff(log.time) > 0.0)


def test_ours_are_told_from_those_of_others(tmp_path: Path) -> None:
    recorded = Path(__file__).parents[2] / "record" / "data" / "default"
    assert is_own_recording(recorded) and is_own_recording(recorded / "flight.mcap")
    bag = write_bag(tmp_path / "bag_mcap", ROWS)
    assert not is_own_recording(bag)
    assert not any(is_own_recording(one) for one in bag.glob("*.mcap"))
    assert not is_own_recording(tmp_path / "nowhere")


def test_our_reader_of_dataflash_logs_reads_what_that_of_pymavlink_reads(tmp_path: Path) -> None:
    file = WRITERS["flight.bin"](tmp_path / "flight.bin", ROWS[:20])
    theirs, log = [], DFReader_binary(str(file))
    while (message := log.recv_msg()) is not None:
        if message.get_type() != "FMT":
            told = {key: one for key, one in message.to_dict().items() if key != "mavpackettype"}
            theirs.append((message.get_type(), told))
    ours = [(one.name, dict(one.fields)) for one in dataflash_messages(file.read_bytes())]
    assert ours == theirs


def test_a_dataflash_log_that_is_damaged_in_the_middle_gives_what_is_before_and_behind(
    tmp_path: Path,
) -> None:
    file = WRITERS["flight.bin"](tmp_path / "flight.bin", ROWS)
    whole = bytearray(file.read_bytes())
    middle = len(whole) // 2
    whole[middle : middle + 100] = bytes(100)
    file.write_bytes(whole)
    log = read_flight_log(file)
    assert log.time.size > len(ROWS) - 5
    assert "damaged" in log.problems[0]
