"""Fuzz targets: what a MAVLink vehicle sends, and what the simulated one reads."""

from __future__ import annotations

from typing import Any

from fuzz_target import FuzzTarget, pieces

from housefly.drones.mavlink.orders import Orders
from housefly.drones.mavlink.vehicle import Vehicle
from housefly.errors import WireError
from housefly.messages import Action, Command, Pose, VelocitySetpoint
from housefly.messages.steering import Instruction
from housefly.wires.mavlink import requests
from housefly.wires.mavlink.autopilots import AUTOPILOTS
from housefly.wires.mavlink.dialect import dialect
from housefly.wires.mavlink.framing import FrameReader, FrameWriter, messages_in
from housefly.wires.mavlink.poses import pose_in, pose_message, vision_in
from housefly.wires.mavlink.reports import report_in
from housefly.wires.mavlink.setpoints import setpoint_in, setpoint_message

_READ_BY_VEHICLE = {
    "SET_POSITION_TARGET_LOCAL_NED": setpoint_in,
    "ODOMETRY": pose_in,
    "VISION_POSITION_ESTIMATE": vision_in,
}


def _resealed(data: bytes) -> bytes:
    """Return bytes as messages with the right checksums: a mutator would never find them."""
    sealed = b""
    while len(data) > 5:
        number, length = int.from_bytes(data[:3], "little") % 400, data[3]
        payload, data = data[4 : 4 + length] or b"\0", data[4 + length :]
        kind = dialect().mavlink_map.get(number)
        body = bytes((len(payload), 0, 0, 1, 1, 1)) + number.to_bytes(3, "little") + payload
        extra = bytes((kind.crc_extra,)) if kind else b"\0"
        checksum = dialect().x25crc(body + extra).crc.to_bytes(2, "little")
        sealed += b"\xfd" + body + checksum
    return sealed


def _stream(data: bytes) -> None:
    vehicle = Vehicle(AUTOPILOTS["px4"])
    orders, reader = Orders(vehicle), FrameReader()
    told = Instruction(Command(Action.LAND), 1, 0.0, True)
    for number, piece in enumerate(pieces(_resealed(data), 1 + (data[0] if data else 0))):
        for message in reader.feed(piece):
            _hear(vehicle, message, 0.1 * number)
        orders.due(told, 0.1 * number)
        vehicle.report(0.1 * number, configured=False, notes=vehicle.refusals.told(1.0))


def _hear(vehicle: Vehicle, message: Any, now: float) -> None:
    try:
        report = report_in(message)
    except WireError:
        return
    if report is not None:
        vehicle.hear(report, now)


def _asked(data: bytes) -> None:
    for message in FrameReader().feed(_resealed(data)):
        read = _READ_BY_VEHICLE.get(message.get_type())
        if read is not None:
            read(message)


def _datagrams() -> tuple[bytes, ...]:
    writer = FrameWriter(1, 1)
    told = (
        dialect().MAVLink_heartbeat_message(2, 3, 129, 4, 4, 3),
        dialect().MAVLink_attitude_message(2500, 0.1, -0.2, 1.5, 0, 0, 0),
        dialect().MAVLink_statustext_message(2, b"PreArm: Compass not calibrated"),
        requests.arming((1, 1), True),
        setpoint_message(VelocitySetpoint(0.4), (1, 1), 3.0),
        pose_message(Pose((1.0, 2.0, 3.0)), (0.0, 0.1, 0.0), 3.0),
    )
    return tuple(map(writer.packed, told))


def _unsealed() -> tuple[bytes, ...]:
    """Return the same as ``_resealed`` takes them."""
    return tuple(one[7:10] + one[1:2] + one[10:-2] for one in _datagrams())


MAVLINK: dict[str, FuzzTarget] = {
    "mavlink_datagram": FuzzTarget(messages_in, _datagrams, (WireError,), 600, (b"\xfd", b"\xfe")),
    "mavlink_stream": FuzzTarget(_stream, lambda: (*_unsealed(), b"".join(_unsealed()))),
    "mavlink_asked": FuzzTarget(_asked, _unsealed, (WireError,), 600),
}
