"""Logs as others write them, of one made-up flight: a circle that climbs, one sample in 20 ms.

Bags are written by ``rosbags``; ulog and dataflash byte by byte, by their public formats.
"""

from __future__ import annotations

import struct
from collections.abc import Sequence
from dataclasses import dataclass
from math import cos, degrees, pi, sin
from pathlib import Path
from typing import Any

import numpy as np
from rosbags.rosbag1 import Writer as Writer1
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_typestore

from housefly.geometry import quaternion_from_euler

PERIOD = 0.02
EPOCH = 1_700_000_000.0
"""Unix time of the first row of a bag [s]."""


@dataclass(frozen=True)
class Row:
    """What is true at one time, in our axes: [s, m, m/s, rad], charge 0 to 1."""

    at: float
    position: tuple[float, float, float]
    velocity: tuple[float, float, float]
    attitude: tuple[float, float, float]
    wanted: tuple[float, float, float, float]
    battery: float


def flight(count: int = 100) -> list[Row]:
    """Return a flight of so many rows."""
    rows = []
    for n in range(count):
        at = n * PERIOD
        yaw = 0.5 * at
        rows.append(
            Row(
                at,
                (cos(at), sin(at), 0.5 + 0.1 * at),
                (-sin(at), cos(at), 0.1),
                (0.05 * sin(3.0 * at), 0.04 * cos(2.0 * at), yaw),
                (1.0, 0.5, 1.0, 0.25),
                1.0 - 0.001 * n,
            )
        )
    return rows


def write_bag(path: Path, rows: Sequence[Row], *, with_battery: bool = True) -> Path:
    """Write a rosbag 1 for a .bag, else a rosbag2 folder in SQLite (``db3``) or MCAP."""
    is_first = path.suffix == ".bag"
    store = get_typestore(Stores.ROS1_NOETIC if is_first else Stores.ROS2_JAZZY)
    new = store.types
    if is_first:
        bag: Any = Writer1(path)
    else:
        plugin = StoragePlugin.SQLITE3 if "db3" in path.name else StoragePlugin.MCAP
        bag = Writer(path, version=9, storage_plugin=plugin)
    with bag:
        topics = {
            "/odom": "nav_msgs/msg/Odometry",
            "/setpoint/pose": "geometry_msgs/msg/PoseStamped",
            "/rosout": "rosgraph_msgs/msg/Log" if is_first else "rcl_interfaces/msg/Log",
        }
        if with_battery:
            topics["/battery"] = "sensor_msgs/msg/BatteryState"
        links = {
            topic: bag.add_connection(topic, kind, typestore=store)
            for topic, kind in topics.items()
        }
        for number, row in enumerate(rows):
            told = {
                "/odom": _odometry(new, row, number, is_first),
                "/setpoint/pose": _pose_stamped(new, row, number, is_first),
            }
            if with_battery:
                told["/battery"] = _battery(new, row, number, is_first)
            if number == 0:
                told["/rosout"] = _log(new, is_first)
            for topic, message in told.items():
                write = store.serialize_ros1 if is_first else store.serialize_cdr
                stamp = round((EPOCH + row.at) * 1e9)
                bag.write(links[topic], stamp, write(message, topics[topic]))
    return path


def _header(new: Any, number: int, is_first: bool, frame: str = "map") -> Any:
    stamp = new["builtin_interfaces/msg/Time"](0, 0)
    kind = new["std_msgs/msg/Header"]
    return kind(number, stamp, frame) if is_first else kind(stamp, frame)


def _pose(new: Any, place: Sequence[float], turn: Sequence[float]) -> Any:
    w, x, y, z = turn
    return new["geometry_msgs/msg/Pose"](
        new["geometry_msgs/msg/Point"](*place), new["geometry_msgs/msg/Quaternion"](x, y, z, w)
    )


def _odometry(new: Any, row: Row, number: int, is_first: bool) -> Any:
    turn = quaternion_from_euler(*row.attitude)
    matrix = _matrix(turn)
    body = matrix.T @ np.array(row.velocity)
    vector = new["geometry_msgs/msg/Vector3"]
    twist = new["geometry_msgs/msg/Twist"](vector(*body), vector(0.0, 0.0, 0.0))
    return new["nav_msgs/msg/Odometry"](
        _header(new, number, is_first),
        "body",
        new["geometry_msgs/msg/PoseWithCovariance"](_pose(new, row.position, turn), np.zeros(36)),
        new["geometry_msgs/msg/TwistWithCovariance"](twist, np.zeros(36)),
    )


def _pose_stamped(new: Any, row: Row, number: int, is_first: bool) -> Any:
    turn = quaternion_from_euler(0.0, 0.0, row.wanted[3])
    return new["geometry_msgs/msg/PoseStamped"](
        _header(new, number, is_first), _pose(new, row.wanted[:3], turn)
    )


def _battery(new: Any, row: Row, number: int, is_first: bool) -> Any:
    nothing = np.zeros(0, dtype=np.float32)
    electrical, cells = [0.0] * 6, [nothing] * 2
    return new["sensor_msgs/msg/BatteryState"](
        _header(new, number, is_first), *electrical, row.battery, 0, 0, 0, True, *cells, "", ""
    )


def _log(new: Any, is_first: bool) -> Any:
    if is_first:
        kind = new["rosgraph_msgs/msg/Log"]
        return kind(_header(new, 0, True), 4, "node", "the battery is weak", "", "", 0, [])
    stamp = new["builtin_interfaces/msg/Time"](0, 0)
    return new["rcl_interfaces/msg/Log"](stamp, 30, "node", "the battery is weak", "", "", 0)


def _matrix(turn: Sequence[float]) -> Any:
    w, x, y, z = turn
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def ned(vector: Sequence[float]) -> tuple[float, float, float]:
    """Return a vector of our world as north, east, down: x is east, y north, z up."""
    x, y, z = vector
    return y, x, -z


def euler_ned(attitude: Sequence[float]) -> tuple[float, float, float]:
    """Return roll, pitch, heading as an autopilot tells them: nose up, clockwise from north."""
    roll, pitch, yaw = attitude
    return roll, -pitch, pi / 2 - yaw


def ulog_bytes(rows: Sequence[Row]) -> bytes:
    """Return a ulog (https://docs.px4.io/main/en/dev_log/ulog_file_format.html)."""

    def message(kind: str, body: bytes) -> bytes:
        return struct.pack("<HB", len(body), ord(kind)) + body

    formats = {
        "vehicle_local_position": "uint64_t timestamp;float x;float y;float z;float vx;float vy;"
        "float vz;",
        "vehicle_attitude": "uint64_t timestamp;float[4] q;",
        "trajectory_setpoint": "uint64_t timestamp;float[3] position;float yaw;",
        "battery_status": "uint64_t timestamp;float remaining;",
    }
    told = b"ULog\x01\x12\x35" + struct.pack("<BQ", 1, 0)
    told += message("B", bytes(40))
    for name, fields in formats.items():
        told += message("F", f"{name}:{fields}".encode())
    for number, name in enumerate(formats):
        told += message("A", struct.pack("<BH", 0, number) + name.encode())
    words = b"Armed by external command"
    told += message("L", struct.pack("<BQ", ord("4"), 1_000_000) + words)
    for row in rows:
        stamp = round((1.0 + row.at) * 1e6)
        w, x, y, z = quaternion_from_euler(*euler_ned(row.attitude))
        bodies: list[tuple[float, ...]] = [
            (*ned(row.position), *ned(row.velocity)),
            (w, x, y, z),
            (*ned(row.wanted[:3]), pi / 2 - row.wanted[3]),
            (row.battery,),
        ]
        for number, values in enumerate(bodies):
            body = struct.pack(f"<HQ{len(values)}f", number, stamp, *values)
            told += message("D", body)
    return told


def dataflash_bytes(rows: Sequence[Row]) -> bytes:
    """Return a dataflash log (ArduPilot's LogStructure.h: FMT describes itself and all others)."""
    kinds = {
        128: ("FMT", "BBnNZ", "Type,Length,Name,Format,Columns", "<BB4s16s64s"),
        10: ("XKF1", "QBffffff", "TimeUS,C,VN,VE,VD,PN,PE,PD", "<QB6f"),
        11: ("ATT", "Qfff", "TimeUS,Roll,Pitch,Yaw", "<Q3f"),
        12: ("BAT", "QBB", "TimeUS,Inst,RemPct", "<QBB"),
        13: ("MSG", "QZ", "TimeUS,Message", "<Q64s"),
    }

    def message(kind: int, *values: Any) -> bytes:
        return bytes((0xA3, 0x95, kind)) + struct.pack(kinds[kind][3], *values)

    told = b""
    for kind, (name, form, columns, layout) in kinds.items():
        length = 3 + struct.calcsize(layout)
        told += message(128, kind, length, name.encode(), form.encode(), columns.encode())
    told += message(13, 1_000_000, b"Arming motors")
    for row in rows:
        stamp = round((1.0 + row.at) * 1e6)
        told += message(10, stamp, 0, *ned(row.velocity), *ned(row.position))
        told += message(10, stamp, 1, *[9.0] * 6)  # the second core, which does not fly
        told += message(11, stamp, *map(degrees, euler_ned(row.attitude)))
        told += message(12, stamp, 0, round(100.0 * row.battery))
    return told


def crazyflie_csv(rows: Sequence[Row]) -> str:
    """Return a table of log variables with milliseconds, as the makers' client writes it."""
    variables = (
        *(f"stateEstimate.{name}" for name in ("x", "y", "z", "vx", "vy", "vz")),
        *(f"stateEstimate.{name}" for name in ("roll", "pitch", "yaw")),
        *(f"ctrltarget.{name}" for name in ("x", "y", "z", "yaw")),
        "pm.batteryLevel",
    )
    lines = [",".join(("Timestamp", *variables))]
    for row in rows:
        roll, pitch, yaw = map(degrees, row.attitude)
        values = (
            round(1e3 * row.at),
            *row.position,
            *row.velocity,
            *(roll, -pitch, yaw),
            *row.wanted[:3],
            degrees(row.wanted[3]),
            round(100.0 * row.battery),
        )
        lines.append(",".join(map(str, values)))
    return "\n".join(lines) + "\n"
