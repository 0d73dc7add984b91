"""The messages of a tracker: names of senders and types, and poses."""

from __future__ import annotations

import struct
from dataclasses import dataclass

from housefly.errors import WireError
from housefly.geometry import Quaternion, Vec3
from housefly.wires.vrpn.message import SENDER_DESCRIPTION, TYPE_DESCRIPTION, VrpnMessage

POSE_TYPE = "vrpn_Tracker Pos_Quat"
PING_TYPE = "vrpn_Base ping_message"
PONG_TYPE = "vrpn_Base pong_message"
MAX_NAME = 100
"""Longest name, with its closing zero [bytes], as in VRPN."""
MAX_NUMBERS = 2000
"""Most senders, and most types, of one connection, as in VRPN."""

_LENGTH = struct.Struct(">I")
_POSE = struct.Struct(">i4x3d4d")


@dataclass(frozen=True, slots=True)
class TrackerPose:
    """A pose report: position [m] and orientation (w, x, y, z) of one sensor of a tracker."""

    sensor: int
    position: Vec3
    orientation: Quaternion


def encode_pose(pose: TrackerPose) -> bytes:
    """Return the body of a pose message; raises WireError if the sensor does not fit."""
    w, x, y, z = pose.orientation
    try:
        return _POSE.pack(pose.sensor, *pose.position, x, y, z, w)
    except struct.error as error:
        raise WireError(f"VRPN sensor: {pose.sensor} does not fit") from error


def decode_pose(body: bytes) -> TrackerPose:
    """Return the pose of a message's body; raises WireError."""
    if len(body) != _POSE.size:
        raise WireError(f"VRPN pose: {_POSE.size} bytes wanted, {len(body)} came")
    sensor, px, py, pz, x, y, z, w = _POSE.unpack(body)
    return TrackerPose(sensor, (px, py, pz), (w, x, y, z))


def description_message(kind: int, number: int, name: str) -> VrpnMessage:
    """Return the message that gives a sender or a type its number.

    Args:
        kind: SENDER_DESCRIPTION or TYPE_DESCRIPTION.
        number: from here on it stands for the name.
        name: of the sender or type.

    Raises:
        WireError: the name is too long.
    """
    encoded = name.encode("utf-8", errors="replace")
    if len(encoded) >= MAX_NAME or b"\0" in encoded:
        raise WireError(f"a VRPN name has at most {MAX_NAME - 1} bytes and no zero, not {name!r}")
    return VrpnMessage(kind, number, 0, _LENGTH.pack(len(encoded) + 1) + encoded + b"\0")


class VrpnNames:
    """The names behind the other side's numbers."""

    def __init__(self) -> None:
        self._names: dict[tuple[int, int], str] = {}

    def learn(self, message: VrpnMessage) -> bool:
        """Store a description; returns whether the message was one. Raises WireError."""
        if message.kind not in (SENDER_DESCRIPTION, TYPE_DESCRIPTION):
            return False
        if not 0 <= message.sender < MAX_NUMBERS:
            raise WireError(
                f"VRPN description: number {message.sender} is not within 0 to {MAX_NUMBERS - 1}"
            )
        self._names[message.kind, message.sender] = _name(message.body)
        return True

    def sender(self, message: VrpnMessage) -> str:
        """Return the name of a message's sender, or ""."""
        return self._names.get((SENDER_DESCRIPTION, message.sender), "")

    def kind(self, message: VrpnMessage) -> str:
        """Return the name of a message's type, or ""."""
        return self._names.get((TYPE_DESCRIPTION, message.kind), "")


def _name(body: bytes) -> str:
    if len(body) < _LENGTH.size:
        raise WireError(f"VRPN description: {_LENGTH.size} bytes wanted, {len(body)} came")
    (length,) = _LENGTH.unpack_from(body)
    if not 0 < length <= min(MAX_NAME, len(body) - _LENGTH.size):
        raise WireError(f"VRPN description: a name of {length} bytes in {len(body)} bytes")
    return (
        body[_LENGTH.size : _LENGTH.size + length]
        .split(b"\0", 1)[0]
        .decode("utf-8", errors="replace")
    )
