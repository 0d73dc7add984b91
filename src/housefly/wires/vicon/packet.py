"""Packets: a header of kind and length, then blocks with the same header each."""

from __future__ import annotations

import struct
from collections.abc import Iterable

from housefly.errors import WireError
from housefly.wires.vicon.buffer import ViconReader, ViconWriter
from housefly.wires.vicon.frame import (
    ApplicationInfo,
    FrameContents,
    FrameInfo,
    GlobalSegments,
    LatencyInfo,
    StreamInfo,
    SubjectInfo,
)
from housefly.wires.vicon.handshake import (
    ObjectEnums,
    RequestFrame,
    RequestNextFrame,
    ViconObject,
    ViconPing,
)

_HEADER = struct.Struct("<II")
_OBJECTS = 0x1A2B0001

VICON_HEADER_SIZE = _HEADER.size
MAX_PACKET = 4 * 1024 * 1024
"""Largest packet body accepted [bytes]; a frame of a hundred subjects has about 60 kB."""
_MAX_BLOCKS = 4096

_OBJECT_TYPES: dict[int, type[ViconObject]] = {
    item.KIND: item
    for item in (
        ObjectEnums,
        RequestFrame,
        RequestNextFrame,
        ViconPing,
        FrameContents,
        StreamInfo,
        ApplicationInfo,
        SubjectInfo,
        FrameInfo,
        LatencyInfo,
        GlobalSegments,
    )
}
"""Every kind that the codec reads."""


def packet_length(header: bytes, largest: int = MAX_PACKET) -> int:
    """Return how many bytes follow this packet header.

    Raises:
        WireError: not a CGStream packet, or larger than ``largest``.
    """
    if len(header) != VICON_HEADER_SIZE:
        raise WireError(f"a Vicon packet header has {VICON_HEADER_SIZE} bytes, not {len(header)}")
    kind, length = _HEADER.unpack(header)
    if kind != _OBJECTS:
        raise WireError(
            f"not a Vicon DataStream packet: it starts with 0x{kind:08x}, not 0x{_OBJECTS:08x}"
        )
    if length > largest:
        raise WireError(f"Vicon packet of {length} bytes; the limit is {largest}")
    return int(length)


def decode_packet(body: bytes) -> tuple[ViconObject, ...]:
    """Return the known objects of a packet body, in order; raises WireError."""
    source = ViconReader(body)
    items: list[ViconObject] = []
    blocks = 0
    while source.left:
        blocks += 1
        if blocks > _MAX_BLOCKS:
            raise WireError(f"Vicon packet with more than {_MAX_BLOCKS} blocks")
        kind, length = source.unpack(_HEADER)
        block = source.skip(length)
        item = _OBJECT_TYPES.get(kind)
        if item is not None:
            items.append(item.read(block))
    return tuple(items)


def encode_packet(items: Iterable[ViconObject]) -> bytes:
    """Return a packet, header included; raises WireError if a value does not fit its field."""
    packet = ViconWriter()
    for item in items:
        block = ViconWriter()
        item.write(block)
        packet.put(_HEADER, item.KIND, len(block.data))
        packet.data += block.data
    return _HEADER.pack(_OBJECTS, len(packet.data)) + packet.data
