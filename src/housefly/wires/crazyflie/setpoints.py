"""The generic setpoints, port 7: to bytes and back, in our units and signs.

The wire has degrees, and a pitch that is positive with the nose up; here all is radian, and theta
is positive with the nose down, as everywhere. Types 1, 2 and 5 are those of old firmware, with the
yaw rate turned round: nothing here sends them, and they are refused.
"""

from __future__ import annotations

import struct
from collections.abc import Callable
from dataclasses import dataclass
from math import degrees, isfinite, radians

from housefly.errors import WireError
from housefly.geometry import Vec3, euler_from_quaternion, quaternion_from_euler
from housefly.wires.crazyflie.crtp import Packet, Port
from housefly.wires.crazyflie.localization import compressed, decompressed

_SETPOINT, _META = 0, 1
_STOP, _ALT_HOLD, _FULL_STATE, _PLACE, _VELOCITY, _Z_DISTANCE, _HOVER = 0, 4, 6, 7, 8, 9, 10
_NOTIFY_STOP = struct.Struct("<BI")
_FOUR = struct.Struct("<B4f")
_STATE = struct.Struct("<B9hI3h")
_MILLI = 1000.0
_RANGE = 32.767
"""Largest number that fits into thousandths of 16 bits."""


@dataclass(frozen=True, slots=True)
class Stop:
    """Motors off now."""


@dataclass(frozen=True, slots=True)
class AltHold:
    """Lean and climb.

    Attributes:
        phi, theta: [rad], positive to the right and forward.
        yaw_rate: [rad/s], positive counter-clockwise.
        vz: [m/s].
    """

    phi: float
    theta: float
    yaw_rate: float
    vz: float


@dataclass(frozen=True, slots=True)
class ZDistance:
    """Lean at a height; as ``AltHold`` but for z: height in the world [m]."""

    phi: float
    theta: float
    yaw_rate: float
    z: float


@dataclass(frozen=True, slots=True)
class Hover:
    """Fly along the body's axes at a height: forward, left [m/s], yaw_rate [rad/s], z [m]."""

    forward: float
    left: float
    yaw_rate: float
    z: float


@dataclass(frozen=True, slots=True)
class WorldVelocity:
    """Fly along the world's axes: vx, vy, vz [m/s], yaw_rate [rad/s]."""

    vx: float
    vy: float
    vz: float
    yaw_rate: float


@dataclass(frozen=True, slots=True)
class Place:
    """Fly to a place in the world: x, y, z [m], facing yaw [rad]."""

    x: float
    y: float
    z: float
    yaw: float


@dataclass(frozen=True, slots=True)
class FullState:
    """Where it should be now, and how it should move; of its attitude, the heading.

    Its PID controller takes the place and the heading alone (controller_pid.c: a quaternion goes
    before a yaw rate); the others of the firmware take all of it.

    Attributes:
        position, velocity, acceleration: in the world [m], [m/s], [m/s^2]; each below 32.767.
        yaw: heading [rad], to a thousandth or two.
        yaw_rate: [rad/s].
    """

    position: Vec3
    velocity: Vec3 = (0.0, 0.0, 0.0)
    acceleration: Vec3 = (0.0, 0.0, 0.0)
    yaw: float = 0.0
    yaw_rate: float = 0.0


GenericSetpoint = Stop | AltHold | ZDistance | Hover | WorldVelocity | Place | FullState


def encode_setpoint(setpoint: GenericSetpoint) -> Packet:
    """Return a setpoint's packet; raises WireError for numbers that do not fit."""
    match setpoint:
        case Stop():
            data = bytes((_STOP,))
        case AltHold(phi, theta, yaw_rate, vz):
            data = _four(_ALT_HOLD, degrees(phi), -degrees(theta), degrees(yaw_rate), vz)
        case ZDistance(phi, theta, yaw_rate, z):
            data = _four(_Z_DISTANCE, degrees(phi), -degrees(theta), degrees(yaw_rate), z)
        case Hover(forward, left, yaw_rate, z):
            data = _four(_HOVER, forward, left, degrees(yaw_rate), z)
        case WorldVelocity(vx, vy, vz, yaw_rate):
            data = _four(_VELOCITY, vx, vy, vz, degrees(yaw_rate))
        case Place(x, y, z, yaw):
            data = _four(_PLACE, x, y, z, degrees(yaw))
        case FullState():
            data = _full_state(setpoint)
    return Packet(Port.GENERIC_SETPOINT, _SETPOINT, data)


def decode_setpoint(packet: Packet) -> GenericSetpoint:
    """Read a setpoint; raises WireError for anything else."""
    data = packet.data
    kind = data[0] if data else -1
    if kind == _STOP:
        return Stop()
    if kind == _FULL_STATE:
        return _read_full_state(data)
    if kind not in _READERS or len(data) != _FOUR.size:
        raise WireError(f"no setpoint: type {kind} of {len(data)} bytes")
    _, first, second, third, fourth = _FOUR.unpack(data)
    if not all(map(isfinite, (first, second, third, fourth))):
        raise WireError(f"a setpoint of type {kind} with numbers that are none")
    return _READERS[kind](first, second, third, fourth)


def notify_setpoints_stop(valid_for_ms: int = 0) -> Packet:
    """Return the packet after which the high-level commander is heard again."""
    return Packet(Port.GENERIC_SETPOINT, _META, _NOTIFY_STOP.pack(0, valid_for_ms))


def is_notify_stop(packet: Packet) -> bool:
    """Return whether a packet is that; raises WireError for another of its channel."""
    if packet.channel != _META:
        return False
    if len(packet.data) != _NOTIFY_STOP.size or packet.data[0] != 0:
        raise WireError(f"no order about setpoints: {packet.data.hex()}")
    return True


def _four(kind: int, *numbers: float) -> bytes:
    if not all(map(isfinite, numbers)):
        raise WireError(f"a setpoint of type {kind} with numbers that are none: {numbers}")
    try:
        return _FOUR.pack(kind, *numbers)
    except OverflowError as error:
        raise WireError(f"a setpoint of type {kind} with numbers too large: {numbers}") from error


def _full_state(state: FullState) -> bytes:
    numbers = (*state.position, *state.velocity, *state.acceleration, state.yaw_rate)
    is_whole = all(isfinite(number) and abs(number) <= _RANGE for number in numbers)
    if not is_whole or not isfinite(state.yaw):
        raise WireError(f"a full state with numbers beyond {_RANGE}: {numbers}")
    *nine, yaw_rate = (round(_MILLI * number) for number in numbers)
    turned = quaternion_from_euler(0.0, 0.0, state.yaw)
    return _STATE.pack(_FULL_STATE, *nine, compressed(turned), 0, 0, yaw_rate)


def _read_full_state(data: bytes) -> FullState:
    if len(data) != _STATE.size:
        raise WireError(f"a full state of {len(data)} bytes; allowed: {_STATE.size}")
    _, *numbers = _STATE.unpack(data)
    x, y, z, vx, vy, vz, ax, ay, az = (number / _MILLI for number in numbers[:9])
    _, _, yaw = euler_from_quaternion(decompressed(numbers[9]))
    return FullState((x, y, z), (vx, vy, vz), (ax, ay, az), yaw, numbers[12] / _MILLI)


_READERS: dict[int, Callable[[float, float, float, float], GenericSetpoint]] = {
    _ALT_HOLD: lambda a, b, c, d: AltHold(radians(a), -radians(b), radians(c), d),
    _Z_DISTANCE: lambda a, b, c, d: ZDistance(radians(a), -radians(b), radians(c), d),
    _HOVER: lambda a, b, c, d: Hover(a, b, radians(c), d),
    _VELOCITY: lambda a, b, c, d: WorldVelocity(a, b, c, radians(d)),
    _PLACE: lambda a, b, c, d: Place(a, b, c, radians(d)),
}
