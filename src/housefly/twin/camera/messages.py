"""Messages between the twin and the child process that renders: kind, length, body."""

from __future__ import annotations

import json
import socket
import struct
from dataclasses import asdict, dataclass
from enum import IntEnum

from housefly.messages import Pose
from housefly.twin.contracts import DroneCamera

MESSAGE_HEADER = struct.Struct("<BI")
_REQUEST = struct.Struct("<??d3d4d")
_PERSON = struct.Struct("<3d4d")
_PICTURE = struct.Struct("<?HHd")


class MessageKind(IntEnum):
    """What a message is: the first two go to the child, the others come from it."""

    SETTINGS = 1
    REQUEST = 2
    READY = 3
    FAILED = 4
    PICTURE = 5


class RenderBackend(IntEnum):
    """How the child makes pictures, best first."""

    EGL = 0
    OSMESA = 1
    CARD = 2


@dataclass(frozen=True, slots=True)
class RenderSettings:
    """What a child needs before its first picture.

    Attributes:
        scene: MuJoCo model text with the drone's cameras "front" and "bottom" on body "drone".
        backend: how to make pictures.
        rate_hz: pictures per second to expect.
        size: width and height of a picture [px].
        reasons: why no better backend is used, in words; shown on the card.
        yields: whether everything else on the machine goes first once it is ready.
    """

    scene: str
    backend: RenderBackend
    rate_hz: float
    size: tuple[int, int]
    reasons: tuple[str, ...] = ()
    yields: bool = False

    def pack(self) -> bytes:
        """Return the message body."""
        return json.dumps(asdict(self)).encode()

    @classmethod
    def unpack(cls, body: bytes) -> RenderSettings:
        """Read a message body."""
        fields = json.loads(body)
        return cls(
            fields["scene"],
            RenderBackend(fields["backend"]),
            float(fields["rate_hz"]),
            (int(fields["size"][0]), int(fields["size"][1])),
            tuple(fields["reasons"]),
            bool(fields["yields"]),
        )


@dataclass(frozen=True, slots=True)
class PictureRequest:
    """A request for one picture.

    Attributes:
        pose: the drone's true pose.
        visitor_present: whether the visitor is at the door.
        camera: which of the drone's cameras.
        at: world time [s].
        people: where the people are.
    """

    pose: Pose
    visitor_present: bool
    camera: DroneCamera
    at: float
    people: tuple[Pose, ...] = ()

    def pack(self) -> bytes:
        """Return the message body."""
        bottom = self.camera is DroneCamera.BOTTOM
        head = _REQUEST.pack(
            bottom, self.visitor_present, self.at, *self.pose.position, *self.pose.orientation
        )
        return head + b"".join(
            _PERSON.pack(*pose.position, *pose.orientation) for pose in self.people
        )

    @classmethod
    def unpack(cls, body: bytes) -> PictureRequest:
        """Read a message body."""
        bottom, visitor, at, x, y, z, qw, qx, qy, qz = _REQUEST.unpack_from(body)
        people = tuple(Pose(row[:3], row[3:]) for row in _PERSON.iter_unpack(body[_REQUEST.size :]))
        return cls(
            Pose((x, y, z), (qw, qx, qy, qz)),
            visitor,
            DroneCamera.BOTTOM if bottom else DroneCamera.FRONT,
            at,
            people,
        )


@dataclass(frozen=True, slots=True)
class Encoded:
    """One picture on its way back: H.264 access unit, size [px], world time [s]."""

    data: bytes
    keyframe: bool
    width: int
    height: int
    at: float

    def pack(self) -> bytes:
        """Return the message body."""
        return _PICTURE.pack(self.keyframe, self.width, self.height, self.at) + self.data

    @classmethod
    def unpack(cls, body: bytes) -> Encoded:
        """Read a message body."""
        keyframe, width, height, at = _PICTURE.unpack_from(body)
        return cls(body[_PICTURE.size :], keyframe, width, height, at)


def pack_message(kind: MessageKind, body: bytes) -> bytes:
    """Return a whole message."""
    return MESSAGE_HEADER.pack(kind, len(body)) + body


class Inbox:
    """The child's end; reads all that waits, so that only the newest request need be served."""

    def __init__(self, link: socket.socket) -> None:
        self._link = link
        self._bytes = bytearray()

    def receive(self) -> list[tuple[MessageKind, bytes]]:
        """Wait for a message and return all that have come; empty when the other side is gone."""
        messages: list[tuple[MessageKind, bytes]] = []
        while not messages:
            received = self._link.recv(1 << 16)
            if not received:
                return []
            self._bytes += received
            while (whole := self._first()) is not None:
                messages.append(whole)
        return messages

    def _first(self) -> tuple[MessageKind, bytes] | None:
        if len(self._bytes) < MESSAGE_HEADER.size:
            return None
        kind, length = MESSAGE_HEADER.unpack_from(self._bytes)
        end = MESSAGE_HEADER.size + length
        if len(self._bytes) < end:
            return None
        body = bytes(self._bytes[MESSAGE_HEADER.size : end])
        del self._bytes[:end]
        return MessageKind(kind), body
