"""The high-level commander, port 8: the drone flies a trajectory of its own; both sides.

It takes as long as it is told, whatever is silent meanwhile. Setpoints of port 7 go before it,
until the drone is told that they stop (``setpoints.notify_setpoints_stop``).
"""

from __future__ import annotations

import struct
from dataclasses import dataclass
from math import isfinite

from housefly.errors import WireError
from housefly.geometry import Vec3
from housefly.wires.crazyflie.crtp import Packet, Port

_STOP, _GO_TO, _TAKE_OFF, _LAND, _GO_TO_2 = 3, 4, 7, 8, 12
_VERTICAL = struct.Struct("<BBff?f")
_GO = struct.Struct("<BB?fffff")
_GO_2 = struct.Struct("<BB??fffff")
_ALL = 0
ALREADY = 1
"""What the drone answers to a take-off or a landing while it flies a way, or lands."""
_DURATION_MAX = 600.0


@dataclass(frozen=True, slots=True)
class TakeOff:
    """Rise to a height in the world [m] within a duration [s]; yaw [rad], None keeps it."""

    height: float
    duration: float
    yaw: float | None = None


@dataclass(frozen=True, slots=True)
class Land:
    """Sink to a height in the world [m] within a duration [s], then stop; yaw as above."""

    height: float
    duration: float
    yaw: float | None = None


@dataclass(frozen=True, slots=True)
class GoTo:
    """Fly to a place [m] within a duration [s], facing yaw [rad]; or by so much."""

    place: Vec3
    yaw: float
    duration: float
    is_relative: bool = False


@dataclass(frozen=True, slots=True)
class StopTrajectory:
    """Motors off now, unless setpoints of port 7 go before."""


HighLevelOrder = TakeOff | Land | GoTo | StopTrajectory


def encode_high_level(order: HighLevelOrder) -> Packet:
    """Return an order's packet, for every group."""
    match order:
        case TakeOff(height, duration, yaw):
            data = _VERTICAL.pack(_TAKE_OFF, _ALL, height, yaw or 0.0, yaw is None, duration)
        case Land(height, duration, yaw):
            data = _VERTICAL.pack(_LAND, _ALL, height, yaw or 0.0, yaw is None, duration)
        case GoTo((x, y, z), yaw, duration, relative):
            data = _GO_2.pack(_GO_TO_2, _ALL, relative, False, x, y, z, yaw, duration)
        case StopTrajectory():
            data = bytes((_STOP, _ALL))
    return Packet(Port.HIGH_LEVEL, 0, data)


def decode_high_level(packet: Packet) -> HighLevelOrder:
    """Read an order; raises WireError for anything else, or numbers that are none."""
    data = packet.data
    try:
        return _read(data)
    except struct.error as error:
        raise WireError(f"no high-level order: {data.hex()}") from error


def high_level_answer(packet: Packet, error: int) -> Packet:
    """Return the drone's answer to an order: the first bytes of it, and 0 or why not."""
    return Packet(Port.HIGH_LEVEL, 0, packet.data[:3].ljust(3, b"\x00") + bytes((error,)))


def read_high_level_answer(packet: Packet) -> tuple[int, int]:
    """Return which order is answered, and 0 or why not; raises WireError for no answer."""
    if packet.channel != 0 or len(packet.data) != 4:
        raise WireError(f"no answer to a high-level order: {packet.data.hex()}")
    return packet.data[0], packet.data[3]


def is_land_answer(packet: Packet) -> bool:
    """Return whether the drone says that it lands, from now on or already; raises WireError."""
    order, error = read_high_level_answer(packet)
    return order == _LAND and error in (0, ALREADY)


def _read(data: bytes) -> HighLevelOrder:
    kind = data[0] if data else -1
    if kind == _STOP and len(data) == 2:
        return StopTrajectory()
    if kind in (_TAKE_OFF, _LAND):
        _, _, height, yaw, keeps_yaw, duration = _VERTICAL.unpack(data)
        _check(height, yaw, duration)
        return (TakeOff if kind == _TAKE_OFF else Land)(
            height, duration, None if keeps_yaw else yaw
        )
    if kind == _GO_TO_2:
        _, _, relative, _, x, y, z, yaw, duration = _GO_2.unpack(data)
    elif kind == _GO_TO:
        _, _, relative, x, y, z, yaw, duration = _GO.unpack(data)
    else:
        raise WireError(f"a high-level order of type {kind}, which nothing here flies")
    _check(x, y, z, yaw, duration)
    return GoTo((x, y, z), yaw, duration, relative)


def _check(*numbers: float) -> None:
    if not all(map(isfinite, numbers)) or not 0.0 <= numbers[-1] <= _DURATION_MAX:
        raise WireError(f"a high-level order with numbers that cannot be flown: {numbers}")
