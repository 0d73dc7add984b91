"""Navdata: the drone's report over UDP port 5554.

A packet is a 16-byte header (magic, state bits, sequence, vision flag), options (u16 tag, u16 size
with these four bytes, payload) and last the checksum option, the sum of all bytes before it. Facts:
Parrot ARDroneLib SDK 2.0.1. Options are decoded when asked for: at 200 packets a second a client
pays only for what it reads.
"""

from __future__ import annotations

import struct
from collections.abc import Iterable
from dataclasses import dataclass, field
from enum import IntFlag
from functools import lru_cache
from typing import NamedTuple, TypeVar

import numpy as np

from housefly.errors import WireError
from housefly.wires.ardrone.layout import Structure
from housefly.wires.ardrone.navdata_options import OPTION_TYPES, TAGS

NAVDATA_PORT = 5554
_MAGIC = 0x55667788
_MAGICS = (_MAGIC, 0x55667789)
"""Accepted headers; other clients accept the second as well, without saying why."""
_CHECKSUM_TAG = 0xFFFF
_MAX_PACKET = 8192
"""Largest packet accepted [bytes]; the largest known one has 2120."""
REQUEST_UNICAST = b"\x01\x00\x00\x00"
"""What a client sends to port 5554 to ask for reports; one byte 0x01 is accepted as well."""
REQUEST_MULTICAST = b"\x02\x00\x00\x00"

_HEADER = struct.Struct("<4I")
_OPTION_HEADER = struct.Struct("<2H")
_CHECKSUM = struct.Struct("<2HI")

_Option = TypeVar("_Option", bound=Structure)


class StateBits(IntFlag):
    """The 32 state bits of the header."""

    FLYING = 1 << 0
    VIDEO = 1 << 1
    VISION = 1 << 2
    CONTROL_ALGORITHM = 1 << 3
    ALTITUDE_CONTROL = 1 << 4
    USER_START = 1 << 5
    COMMAND_ACK = 1 << 6
    CAMERA_READY = 1 << 7
    TRAVELLING = 1 << 8
    USB = 1 << 9
    NAVDATA_DEMO = 1 << 10
    NAVDATA_BOOTSTRAP = 1 << 11
    MOTORS_PROBLEM = 1 << 12
    COM_LOST = 1 << 13
    SOFTWARE_FAULT = 1 << 14
    BATTERY_LOW = 1 << 15
    USER_EMERGENCY = 1 << 16
    TIMER_ELAPSED = 1 << 17
    MAGNETO_NEEDS_CALIBRATION = 1 << 18
    ANGLES_OUT_OF_RANGE = 1 << 19
    WIND = 1 << 20
    ULTRASOUND_DEAF = 1 << 21
    CUTOUT = 1 << 22
    PIC_VERSION_OK = 1 << 23
    AT_THREAD = 1 << 24
    NAVDATA_THREAD = 1 << 25
    VIDEO_THREAD = 1 << 26
    ACQUISITION_THREAD = 1 << 27
    CONTROL_WATCHDOG = 1 << 28
    ADC_WATCHDOG = 1 << 29
    COM_WATCHDOG = 1 << 30
    EMERGENCY = 1 << 31


class RawOption(NamedTuple):
    """An option as it came: tag and payload without the four header bytes."""

    tag: int
    payload: bytes

    @property
    def size(self) -> int:
        """Size on the wire [bytes], header included."""
        return len(self.payload) + _OPTION_HEADER.size


@dataclass(frozen=True, slots=True)
class NavdataPacket:
    """One checked packet.

    Attributes:
        state: the 32 state bits; test with ``has``. A plain int, so that hostile values cannot
            fill the flag type's cache.
        sequence: packet number.
        vision: vision flag.
        options: all options but the checksum, undecoded, in order.
        magic: the header word.
    """

    state: int
    sequence: int
    vision: int = 1
    options: tuple[RawOption, ...] = field(default=())
    magic: int = _MAGIC

    def has(self, bits: StateBits) -> bool:
        """Return whether all these state bits are set."""
        wanted = int(bits)  # as flags, the answer would be made a flag first
        return self.state & wanted == wanted

    def option(self, kind: type[_Option]) -> _Option | None:
        """Return the first option of this kind and size, decoded, or None."""
        tag, size = TAGS[kind], kind.size()
        payload = next(
            (raw.payload for raw in self.options if raw.tag == tag and len(raw.payload) == size),
            None,
        )
        return None if payload is None else kind.decode(payload)

    def decoded(self) -> tuple[Structure, ...]:
        """Return all options that we know by tag and size, decoded, in order."""
        return tuple(
            OPTION_TYPES[raw.tag].decode(raw.payload) for raw in self.options if _is_known(raw)
        )

    @property
    def unknown(self) -> tuple[tuple[int, int], ...]:
        """Tag and size [bytes, header included] of the options that we do not know."""
        return tuple((raw.tag, raw.size) for raw in self.options if not _is_known(raw))


def _is_known(raw: RawOption) -> bool:
    return raw.tag < len(OPTION_TYPES) and len(raw.payload) == OPTION_TYPES[raw.tag].size()


def _checksum(data: bytes | memoryview) -> int:
    """Return the navdata checksum: the sum of the bytes, modulo 2**32."""
    return int(np.frombuffer(data, np.uint8).sum(dtype=np.uint32))


def decode_navdata(data: bytes) -> NavdataPacket:
    """Check a datagram and cut it into options.

    Raises:
        WireError: bad length or magic, an option that runs over the end, bytes after the checksum,
            no or a wrong checksum.
    """
    if not _HEADER.size + _CHECKSUM.size <= len(data) <= _MAX_PACKET:
        raise WireError(
            f"navdata of {len(data)} bytes; {_HEADER.size + _CHECKSUM.size} to {_MAX_PACKET} are"
            " possible"
        )
    magic, state, sequence, vision = _HEADER.unpack_from(data)
    if magic not in _MAGICS:
        raise WireError(f"navdata starts with {magic:#010x}, expected {_MAGIC:#010x}")
    _verify_checksum(data)
    return NavdataPacket(
        state, sequence, vision, _cut_options(data, len(data) - _CHECKSUM.size), magic
    )


def _verify_checksum(data: bytes) -> None:
    end = len(data) - _CHECKSUM.size
    tag, size, told = _CHECKSUM.unpack_from(data, end)
    if tag != _CHECKSUM_TAG or size != _CHECKSUM.size:
        raise WireError("navdata does not end with a checksum")
    found = _checksum(memoryview(data)[:end])
    if told != found:
        raise WireError(f"navdata checksum is {told:#x}, the bytes give {found:#x}")


def _cut_options(data: bytes, end: int) -> tuple[RawOption, ...]:
    options: list[RawOption] = []
    at = _HEADER.size
    while at < end:
        if at + _OPTION_HEADER.size > end:
            raise WireError("navdata ends inside an option header")
        tag, size = _OPTION_HEADER.unpack_from(data, at)
        if size < _OPTION_HEADER.size or at + size > end:
            raise WireError(f"navdata option {tag} at byte {at} has the impossible size {size}")
        if tag == _CHECKSUM_TAG:
            raise WireError(f"navdata has a checksum at byte {at}, before its end")
        options.append(RawOption(tag, data[at + _OPTION_HEADER.size : at + size]))
        at += size
    return tuple(options)


def encode_navdata(
    state: int,
    sequence: int,
    options: Iterable[Structure | RawOption] = (),
    *,
    vision: int = 1,
    magic: int = _MAGIC,
) -> bytes:
    """Return a packet with its checksum; without options it is the bootstrap packet.

    Args:
        state: StateBits.
        sequence: packet number.
        options: in the order wanted; tags follow from their types.
        vision: vision flag.
        magic: header word.

    Raises:
        WireError: when a value does not fit its field.
    """
    try:
        parts = [_HEADER.pack(magic, state, sequence, vision)]
    except struct.error as error:
        raise WireError(f"navdata header value does not fit: {error}") from error
    for option in options:
        if isinstance(option, RawOption):
            tag, payload = option
        else:
            tag, payload = TAGS[type(option)], option.encode()
        parts += (_option_header(tag, len(payload)), payload)
    body = b"".join(parts)
    return body + _CHECKSUM.pack(_CHECKSUM_TAG, _CHECKSUM.size, _checksum(body))


@lru_cache(maxsize=256)
def _option_header(tag: int, length: int) -> bytes:
    """Return what stands before a payload of this length [bytes]."""
    return _OPTION_HEADER.pack(tag, length + _OPTION_HEADER.size)
