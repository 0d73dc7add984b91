"""VRPN messages, big-endian: a header of 24 bytes, a body padded to a multiple of eight."""

from __future__ import annotations

import struct
from dataclasses import dataclass

from housefly.errors import WireError

_HEADER = struct.Struct(">IiiiiI")
VRPN_HEADER_SIZE = _HEADER.size
MAX_MESSAGE = 64 * 1024
"""Longest message accepted [bytes]; VRPN's own buffers are as long."""
_ALIGN = 8
_MILLION = 1_000_000

SENDER_DESCRIPTION = -1
TYPE_DESCRIPTION = -2
UDP_DESCRIPTION = -3
LOG_DESCRIPTION = -4
DISCONNECT = -5


@dataclass(frozen=True, slots=True)
class VrpnMessage:
    """One message.

    Attributes:
        kind: number of its type; negative ones are VRPN's own.
        sender: number of its sender.
        stamp: time that it tells of [microseconds of the sender's clock].
        body: what follows the header, without the filling.
    """

    kind: int
    sender: int
    stamp: int
    body: bytes


def encode_message(message: VrpnMessage, sequence: int = 0) -> bytes:
    """Return the bytes of a message; raises WireError when a value does not fit its field."""
    seconds, microseconds = divmod(message.stamp, _MILLION)
    length = VRPN_HEADER_SIZE + len(message.body)
    if length > MAX_MESSAGE:
        raise WireError(f"VRPN length: {length} bytes; at most {MAX_MESSAGE}")
    try:
        header = _HEADER.pack(
            length, seconds, microseconds, message.sender, message.kind, sequence & 0xFFFFFFFF
        )
    except struct.error as error:
        raise WireError(f"{message} does not fit the VRPN header: {error}") from error
    return header + message.body + bytes(-len(message.body) % _ALIGN)


class VrpnStream:
    """Puts messages together from whatever pieces a connection delivers."""

    def __init__(self) -> None:
        self._data = bytearray()

    def feed(self, piece: bytes) -> tuple[VrpnMessage, ...]:
        """Return the messages complete now; after a WireError the stream is unusable."""
        self._data += piece
        messages = []
        start = 0
        while len(self._data) - start >= VRPN_HEADER_SIZE:
            length, seconds, microseconds, sender, kind, _ = _HEADER.unpack_from(self._data, start)
            if not VRPN_HEADER_SIZE <= length <= MAX_MESSAGE:
                raise WireError(
                    f"VRPN length: {length} bytes; allowed: {VRPN_HEADER_SIZE} to {MAX_MESSAGE}"
                )
            if not (seconds >= 0 and 0 <= microseconds < _MILLION):
                raise WireError(f"VRPN time: {seconds} s and {microseconds} us is none")
            end = start + length + -length % _ALIGN
            if end > len(self._data):
                break
            body = bytes(self._data[start + VRPN_HEADER_SIZE : start + length])
            messages.append(VrpnMessage(kind, sender, seconds * _MILLION + microseconds, body))
            start = end
        del self._data[:start]
        return tuple(messages)
