"""MSP frames in a stream of bytes, version 1 and 2, and back.

A frame is ``$``, ``M`` or ``X``, a direction, a header, the payload and a checksum; numbers are
little-endian. Version 1 (``M``): length, command, and the XOR of all that as a checksum; a length
of 255 says that the real one follows in two bytes. Version 2 (``X``): flags, command and length of
two bytes each, and CRC-8/DVB-S2. Source: betaflight/betaflight, src/main/msp/msp_serial.c.
"""

from __future__ import annotations

import struct
from dataclasses import dataclass
from enum import IntEnum
from functools import reduce
from operator import xor

from housefly.errors import WireError

PAYLOAD_MAX = 1024
"""No payload that is spoken here is longer [bytes]; a longer length is noise."""
_JUMBO = 255
_CRC_POLYNOMIAL = 0xD5
_V2_HEADER = struct.Struct("<BHH")


class MspDirection(IntEnum):
    """What a frame is."""

    REQUEST = ord("<")
    ANSWER = ord(">")
    REFUSAL = ord("!")


class MspVersion(IntEnum):
    """The two forms of a frame."""

    V1 = ord("M")
    V2 = ord("X")


@dataclass(frozen=True, slots=True)
class MspFrame:
    """One frame.

    Attributes:
        command: what it is about; 0 to 255 in version 1, to 65535 in version 2.
        payload: its bytes.
        direction: asked, answered or refused.
        version: the form it has on the wire.
    """

    command: int
    payload: bytes = b""
    direction: MspDirection = MspDirection.REQUEST
    version: MspVersion = MspVersion.V1


def crc8(data: bytes | bytearray, crc: int = 0) -> int:
    """Return CRC-8/DVB-S2 of bytes, on top of a former value."""
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = (crc << 1 ^ _CRC_POLYNOMIAL if crc & 0x80 else crc << 1) & 0xFF
    return crc


def encode_msp(frame: MspFrame) -> bytes:
    """Return the bytes of a frame.

    Raises:
        WireError: a command or a length that its version cannot say.
    """
    command_max = 255 if frame.version is MspVersion.V1 else 65535
    if not (0 <= frame.command <= command_max and len(frame.payload) <= PAYLOAD_MAX):
        raise WireError(
            f"no MSP frame: command {frame.command}, {len(frame.payload)} bytes; allowed: 0 to"
            f" {command_max}, {PAYLOAD_MAX} or less"
        )
    begin = bytes((ord("$"), frame.version, frame.direction))
    if frame.version is MspVersion.V2:
        body = _V2_HEADER.pack(0, frame.command, len(frame.payload)) + frame.payload
        return begin + body + bytes((crc8(body),))
    size = len(frame.payload)
    jumbo = size.to_bytes(2, "little") if size >= _JUMBO else b""
    body = bytes((min(size, _JUMBO), frame.command)) + jumbo + frame.payload
    return begin + body + bytes((reduce(xor, body, 0),))


class MspReader:
    """Cuts a stream into frames; what is none is dropped and counted, frames behind it are not.

    Attributes:
        noise: bytes that belonged to no frame.
        broken: frames whose checksum was wrong, or whose length was too large.
    """

    def __init__(self) -> None:
        self.noise = self.broken = 0
        self._waiting = bytearray()

    def feed(self, data: bytes) -> list[MspFrame]:
        """Append the next bytes and return the frames now complete, oldest first."""
        self._waiting += data
        frames: list[MspFrame] = []
        while True:
            found = self._cut()
            if found is None:
                return frames
            if isinstance(found, MspFrame):
                frames.append(found)

    def _cut(self) -> MspFrame | bool | None:
        """Return the next frame, True where something was dropped, None where bytes are missing."""
        waiting = self._waiting
        begin = waiting.find(b"$")
        dropped = len(waiting) if begin < 0 else begin
        self.noise += dropped
        del waiting[:dropped]
        if len(waiting) < 3:
            return None
        if waiting[1] not in _VERSIONS or waiting[2] not in _DIRECTIONS:
            return self._drop_mark()
        read = self._read_v1 if waiting[1] == MspVersion.V1 else self._read_v2
        return read(MspDirection(waiting[2]))

    def _drop_mark(self, *, is_frame: bool = False) -> bool:
        self.broken += is_frame
        self.noise += not is_frame
        del self._waiting[:1]
        return True

    def _read_v1(self, direction: MspDirection) -> MspFrame | bool | None:
        waiting = self._waiting
        if len(waiting) < 5:
            return None
        begin, size = 5, waiting[3]
        if size == _JUMBO:
            if len(waiting) < 7:
                return None
            begin, size = 7, int.from_bytes(waiting[5:7], "little")
        if size > PAYLOAD_MAX:
            return self._drop_mark(is_frame=True)
        end = begin + size
        if len(waiting) <= end:
            return None
        if reduce(xor, waiting[3:end], 0) != waiting[end]:
            return self._drop_mark(is_frame=True)
        frame = MspFrame(waiting[4], bytes(waiting[begin:end]), direction)
        del waiting[: end + 1]
        return frame

    def _read_v2(self, direction: MspDirection) -> MspFrame | bool | None:
        waiting = self._waiting
        if len(waiting) < 8:
            return None
        _, command, size = _V2_HEADER.unpack_from(waiting, 3)
        if size > PAYLOAD_MAX:
            return self._drop_mark(is_frame=True)
        end = 8 + size
        if len(waiting) <= end:
            return None
        if crc8(waiting[3:end]) != waiting[end]:
            return self._drop_mark(is_frame=True)
        frame = MspFrame(command, bytes(waiting[8:end]), direction, MspVersion.V2)
        del waiting[: end + 1]
        return frame


_VERSIONS, _DIRECTIONS = frozenset(MspVersion), frozenset(MspDirection)
