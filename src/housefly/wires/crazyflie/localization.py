"""Where the drone is, told from outside, port 6: to bytes and back.

Position in metres or, packed, in thousandths of 16 bits; orientation as w, x, y, z here and as x,
y, z, w on the wire. A packed packet holds two drones; each knows itself by the last byte of its
radio address. It has no time on it: the drone takes it as of now.
"""

from __future__ import annotations

import struct
from collections.abc import Sequence
from dataclasses import dataclass
from math import isfinite, sqrt

from housefly.errors import WireError
from housefly.geometry import Quaternion, Vec3
from housefly.wires.crazyflie.crtp import Packet, Port

OWN_ID = 0xE7
"""Last byte of the address that every Crazyflie leaves the factory with."""
PACKED_MAX = 2
_POSITION, _GENERIC = 0, 1
_EMERGENCY_STOP, _EMERGENCY_WATCHDOG, _POSE, _PACKED = 3, 4, 8, 9
_XYZ = struct.Struct("<3f")
_POSE_FORM = struct.Struct("<B7f")
_ITEM = struct.Struct("<B3hI")
_RANGE = 32.767
_LEVELS = (1 << 9) - 1
_HALF = sqrt(0.5)
_UNIT_MIN = 0.5
"""A quaternion shorter than this is none."""


@dataclass(frozen=True, slots=True)
class ToldPose:
    """Where a drone is.

    Attributes:
        position: world [m].
        orientation: (w, x, y, z); None where only the place is told.
        drone: last byte of its address; None where only this drone can be meant.
    """

    position: Vec3
    orientation: Quaternion | None = None
    drone: int | None = None


def encode_told_pose(position: Vec3, orientation: Quaternion) -> Packet:
    """Return the packet of one pose; raises WireError for numbers that are none."""
    w, x, y, z = orientation
    numbers = (*position, x, y, z, w)
    if not all(map(isfinite, numbers)):
        raise WireError(f"a pose with numbers that are none: {numbers}")
    try:
        return Packet(Port.LOCALIZATION, _GENERIC, _POSE_FORM.pack(_POSE, *numbers))
    except OverflowError as error:
        raise WireError(f"a pose with numbers too large: {numbers}") from error


def encode_packed_poses(poses: Sequence[tuple[int, Vec3, Quaternion]]) -> Packet:
    """Return the packet of up to two poses, by the last byte of each drone's address.

    Raises:
        WireError: more than two, or a place beyond 32.767 m.
    """
    if len(poses) > PACKED_MAX:
        raise WireError(f"{len(poses)} packed poses; allowed: {PACKED_MAX} or less")
    items = b"".join(_item(drone, position, turned) for drone, position, turned in poses)
    return Packet(Port.LOCALIZATION, _GENERIC, bytes((_PACKED,)) + items)


def decode_poses(packet: Packet) -> tuple[ToldPose, ...]:
    """Return the poses in a packet of port 6; none for one about something else.

    Raises:
        WireError: one that cannot be read.
    """
    data = packet.data
    if packet.channel == _POSITION:
        if len(data) != _XYZ.size:
            raise WireError(f"a place of {len(data)} bytes; allowed: {_XYZ.size}")
        return (ToldPose(_finite(_XYZ.unpack(data))),)
    if packet.channel != _GENERIC or not data:
        raise WireError(f"nothing about a place: channel {packet.channel}, {len(data)} bytes")
    if data[0] == _POSE:
        return (_whole(data),)
    if data[0] == _PACKED:
        return _packed(data[1:])
    return ()


def emergency_of(packet: Packet) -> bool | None:
    """Return what old clients say here: True stops, False feeds the watchdog, None is neither."""
    if packet.channel != _GENERIC or not packet.data:
        return None
    return {_EMERGENCY_STOP: True, _EMERGENCY_WATCHDOG: False}.get(packet.data[0])


def encode_emergency_stop() -> Packet:
    """Return the stop for firmware without the supervisor's port; it lasts until a restart."""
    return Packet(Port.LOCALIZATION, _GENERIC, bytes((_EMERGENCY_STOP,)))


def compressed(orientation: Quaternion) -> int:
    """Return a quaternion in 32 bits: which of x, y, z, w is largest, and the three others."""
    w, x, y, z = orientation
    parts = (x, y, z, w)
    largest = max(range(4), key=lambda index: abs(parts[index]))
    sign = -1.0 if parts[largest] < 0.0 else 1.0
    packed = largest
    for index, part in enumerate(parts):
        if index != largest:
            level = min(int(_LEVELS * abs(part) / _HALF + 0.5), _LEVELS)
            packed = packed << 10 | (sign * part < 0.0) << 9 | level
    return packed


def decompressed(packed: int) -> Quaternion:
    """Return the quaternion (w, x, y, z) of 32 bits; raises WireError for what is none."""
    largest = packed >> 30
    parts = [0.0, 0.0, 0.0, 0.0]
    for index in (3, 2, 1, 0):
        if index != largest:
            size = _HALF * (packed & _LEVELS) / _LEVELS
            parts[index] = -size if packed >> 9 & 1 else size
            packed >>= 10
    rest = 1.0 - sum(part * part for part in parts)
    if rest < 0.0:
        raise WireError("a packed orientation that is longer than one")
    parts[largest] = sqrt(rest)
    x, y, z, w = parts
    return w, x, y, z


def _item(drone: int, position: Vec3, orientation: Quaternion) -> bytes:
    if not all(isfinite(part) and abs(part) <= _RANGE for part in position):
        raise WireError(f"a packed place beyond {_RANGE} m: {position}")
    x, y, z = (round(1000.0 * part) for part in position)
    return _ITEM.pack(drone & 0xFF, x, y, z, compressed(orientation))


def _whole(data: bytes) -> ToldPose:
    if len(data) != _POSE_FORM.size:
        raise WireError(f"a pose of {len(data)} bytes; allowed: {_POSE_FORM.size}")
    _, px, py, pz, x, y, z, w = _POSE_FORM.unpack(data)
    if not all(map(isfinite, (x, y, z, w))):
        raise WireError("an orientation with numbers that are none")
    length = sqrt(x * x + y * y + z * z + w * w)
    if not (isfinite(length) and length >= _UNIT_MIN):
        raise WireError(f"an orientation of length {length:g}; allowed: 1")
    turned = w / length, x / length, y / length, z / length
    return ToldPose(_finite((px, py, pz)), turned)


def _packed(items: bytes) -> tuple[ToldPose, ...]:
    if not items or len(items) % _ITEM.size or len(items) > PACKED_MAX * _ITEM.size:
        raise WireError(f"packed poses of {len(items)} bytes; allowed: 11 or 22")
    return tuple(
        ToldPose((x / 1000.0, y / 1000.0, z / 1000.0), decompressed(turned), drone)
        for drone, x, y, z, turned in _ITEM.iter_unpack(items)
    )


def _finite(numbers: tuple[float, ...]) -> Vec3:
    if not all(map(isfinite, numbers)):
        raise WireError(f"a place with numbers that are none: {numbers}")
    x, y, z = numbers
    return x, y, z
