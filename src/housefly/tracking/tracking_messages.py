"""What the room's process tells a pilot over their socket: frames, and the tracker's health.

Each message is magic, kind, size of its body [bytes], body.
"""

from __future__ import annotations

import struct
from dataclasses import dataclass

from housefly.bus.codec import from_cdr, to_cdr
from housefly.errors import WireError
from housefly.messages import TrackedFrame

_MAGIC = b"HFt1"
_HEADER = struct.Struct("<4sBI")
_FRAME, _STATUS = 0, 1
_BODY_MAX = 256 * 1024
"""Longest body accepted [bytes], as on the bus (``FRAME_TOPIC``)."""


@dataclass(frozen=True, slots=True)
class TrackerStatus:
    """Health of the room's tracking client.

    Attributes:
        connected: whether frames arrive.
        problem: why not, in words, or "".
    """

    connected: bool = False
    problem: str = ""


TrackingMessage = TrackedFrame | TrackerStatus


def encode_tracking_message(message: TrackingMessage) -> bytes:
    """Return a message with its header."""
    if isinstance(message, TrackedFrame):
        kind, body = _FRAME, to_cdr(message)
    else:
        kind, body = _STATUS, bytes([message.connected]) + message.problem.encode()
    return _HEADER.pack(_MAGIC, kind, len(body)) + body


class TrackingMessageReader:
    """Cuts a stream into messages."""

    def __init__(self) -> None:
        self._buffer = bytearray()

    def feed(self, data: bytes) -> list[TrackingMessage]:
        """Append the next bytes and return the messages now complete, oldest first.

        Raises:
            WireError: no message of ours; the connection is of no use any more.
        """
        self._buffer += data
        messages: list[TrackingMessage] = []
        while len(self._buffer) >= _HEADER.size:
            magic, kind, size = _HEADER.unpack_from(self._buffer)
            if magic != _MAGIC or kind not in (_FRAME, _STATUS) or size > _BODY_MAX:
                raise WireError("room and pilot do not speak the same language")
            end = _HEADER.size + size
            if len(self._buffer) < end:
                break
            body = bytes(memoryview(self._buffer)[_HEADER.size : end])
            del self._buffer[:end]
            messages.append(from_cdr(TrackedFrame, body) if kind == _FRAME else _status(body))
        return messages


def _status(body: bytes) -> TrackerStatus:
    try:
        return TrackerStatus(bool(body[0]), body[1:].decode())
    except (IndexError, UnicodeDecodeError) as error:
        raise WireError(f"a tracker's status that cannot be read: {error}") from error
