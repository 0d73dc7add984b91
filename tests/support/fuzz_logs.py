"""Fuzz targets: logs of flights that others recorded, and who asks for the live view."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

from foreign_logs import crazyflie_csv, dataflash_bytes, flight, ulog_bytes, write_bag
from fuzz_target import FuzzTarget, as_file

from housefly.app.flight_logs.read_log import read_flight_log
from housefly.errors import MissingPartError, RecordingError
from housefly.foxglove.origin_gate import origin_of

_ROWS = flight(3)


def _log(name: str, data: bytes) -> None:
    with as_file(data, name) as path:
        read_flight_log(path)


def _bag() -> Iterable[bytes]:
    with TemporaryDirectory() as folder:
        yield write_bag(Path(folder) / "a.bag", _ROWS, with_battery=False).read_bytes()


def _mcap() -> Iterable[bytes]:
    with TemporaryDirectory() as folder:
        (file,) = write_bag(Path(folder) / "mcap", _ROWS, with_battery=False).glob("*.mcap")
        yield file.read_bytes()


def _target(name: str, seeds: Callable[[], Iterable[bytes]], length_max: int) -> FuzzTarget:
    return FuzzTarget(partial(_log, name), seeds, (RecordingError, MissingPartError), length_max)


LOGS: dict[str, FuzzTarget] = {
    "log_rosbag": _target("a.bag", _bag, 2**16),
    "log_mcap": _target("a.mcap", _mcap, 2**16),
    "log_ulog": _target("a.ulg", lambda: [ulog_bytes(_ROWS)], 4096),
    "log_dataflash": _target("a.bin", lambda: [dataflash_bytes(_ROWS)], 4096),
    "log_crazyflie": _target("a.csv", lambda: [crazyflie_csv(_ROWS).encode()], 4096),
    "foxglove_head": FuzzTarget(
        origin_of, lambda: [b"GET / HTTP/1.1\r\nOrigin: https://app.foxglove.dev\r\n\r\n"]
    ),
}
