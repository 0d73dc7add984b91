"""Reads a log of others, whatever it is: by its first bytes, not by its name."""

from __future__ import annotations

from pathlib import Path

from housefly.app.flight_logs.bag_log import read_bag
from housefly.app.flight_logs.crazyflie_csv import is_crazyflie_csv, read_crazyflie_csv
from housefly.app.flight_logs.dataflash import read_dataflash
from housefly.app.flight_logs.dataflash_messages import DATAFLASH_MAGIC
from housefly.app.flight_logs.ulog import ULOG_MAGIC, read_ulog
from housefly.errors import RecordingError
from housefly.record.flight_log import FlightLog
from housefly.record.mcap_reader import read_messages
from housefly.record.replay import STEP_CHANNEL

_MCAP_MAGIC, _SQLITE_MAGIC = b"\x89MCAP0\r\n", b"SQLite format 3\x00"
_ROSBAG_MAGIC = b"#ROSBAG V"
_HEAD = 4096
_ALLOWED = (
    "allowed: a recording of Housefly, a rosbag (.bag), a rosbag2 folder or .mcap, PX4 .ulg,"
    " ArduPilot dataflash .bin, CSV of a Crazyflie's log variables"
)
_LOOKED_AT = 2000
"""So many messages of an MCAP file are looked at for a step of ours."""


def is_own_recording(path: Path) -> bool:
    """Return whether a folder or file is a recording of Housefly."""
    if path.is_dir():
        return (path / "flight.mcap").is_file()
    if not path.is_file() or _head(path)[: len(_MCAP_MAGIC)] != _MCAP_MAGIC:
        return False
    for number, message in enumerate(read_messages(path)):
        if message.topic == STEP_CHANNEL or number >= _LOOKED_AT:
            return message.topic == STEP_CHANNEL
    return False


def read_flight_log(path: Path) -> FlightLog:
    """Return a log of others.

    Raises:
        RecordingError: it is of no known kind, cannot be read, or holds no pose.
        MissingPartError: a library for it is not installed.
    """
    if path.is_dir():
        if (path / "metadata.yaml").is_file():
            return read_bag(path)
        raise RecordingError(f"{path} has no metadata.yaml, so it is no rosbag2; {_ALLOWED}")
    head = _head(path)
    if head.startswith(_ROSBAG_MAGIC) and path.suffix != ".bag":
        raise RecordingError(f"{path} is a rosbag 1; its name must end in .bag")
    if head.startswith((_ROSBAG_MAGIC, _MCAP_MAGIC)):
        return read_bag(path)
    if head.startswith(ULOG_MAGIC):
        return read_ulog(path)
    if head.startswith(DATAFLASH_MAGIC):
        return read_dataflash(path)
    if head.startswith(_SQLITE_MAGIC):
        raise RecordingError(f"{path} is one file of a rosbag2; name its folder")
    if is_crazyflie_csv(head.decode("utf-8-sig", errors="replace").partition("\n")[0]):
        return read_crazyflie_csv(path)
    raise RecordingError(f"{path} is of no known kind; {_ALLOWED}")


def _head(path: Path) -> bytes:
    try:
        with path.open("rb") as file:
            return file.read(_HEAD)
    except OSError as error:
        raise RecordingError(f"{path} cannot be read: {error.strerror}") from error
