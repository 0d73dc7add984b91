"""Bytes to MAVLink messages and back, by pymavlink's parser; transports are others' business."""

from __future__ import annotations

from typing import Any

from housefly.errors import WireError
from housefly.wires.mavlink.dialect import dialect

_BACKLOG_MAX = 1024
"""An unfinished message is never longer: a good one is 280 bytes at most."""


class FrameReader:
    """Cuts a stream, or datagrams, into messages; one for each peer.

    Attributes:
        broken: pieces that were no message, and messages that were refused.
        complaint: what was wrong with the newest of them.
    """

    def __init__(self) -> None:
        self.broken, self.complaint = 0, ""
        self._parser = _parser()

    def feed(self, data: bytes) -> list[Any]:
        """Append the next bytes; return pymavlink's messages that are now complete, in order."""
        messages = self._parser.parse_buffer(data) or []
        if self._parser.buf_len() > _BACKLOG_MAX:
            self._parser = _parser()
        return [message for message in messages if self._is_known(message)]

    def refuse(self, error: WireError) -> None:
        """Count a message whose content is refused."""
        self.broken, self.complaint = self.broken + 1, str(error)

    def _is_known(self, message: Any) -> bool:
        kind = message.get_type()
        if kind == "BAD_DATA":
            self.refuse(WireError(f"no MAVLink message: {message.reason}"))
        return kind != "BAD_DATA" and not kind.startswith("UNKNOWN")


def messages_in(datagram: bytes) -> list[Any]:
    """Return the messages of a datagram that holds nothing else.

    Raises:
        WireError: something in it is no whole message, or its checksum is wrong.
    """
    reader = FrameReader()
    messages = reader.feed(datagram)
    if reader.broken:
        raise WireError(reader.complaint)
    if reader._parser.buf_len():
        raise WireError(f"a message ends early: {datagram[-20:].hex(' ')}")
    return messages


class FrameWriter:
    """Numbers messages of one sender.

    Args:
        system, component: whose they are.
    """

    def __init__(self, system: int, component: int) -> None:
        self._packer = dialect().MAVLink(None, system, component)

    def packed(self, message: Any) -> bytes:
        """Return the bytes of a message."""
        data: bytes = message.pack(self._packer)
        self._packer.seq = (self._packer.seq + 1) % 256
        return bytes(data)


def _parser() -> Any:
    parser = dialect().MAVLink(None)
    parser.robust_parsing = True
    return parser


def finite(message: Any, *fields: str) -> tuple[float, ...]:
    """Return number fields of a message; raises WireError for one that is not finite."""
    numbers = tuple(float(getattr(message, field)) for field in fields)
    for field, number in zip(fields, numbers, strict=True):
        if not -1e9 < number < 1e9:
            raise WireError(f"{message.get_type()}.{field} is {number}; allowed: a finite number")
    return numbers
