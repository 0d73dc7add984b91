"""Messages: a header of kind and length, then the body; one datagram holds one message."""

from __future__ import annotations

import struct

from housefly.errors import WireError
from housefly.wires.natnet.buffer import NatNetReader, NatNetVersion, NatNetWriter
from housefly.wires.natnet.frame import NatNetFrame
from housefly.wires.natnet.handshake import (
    CommandRequest,
    CommandResponse,
    Connect,
    Disconnect,
    Discovery,
    EchoRequest,
    EchoResponse,
    KeepAlive,
    NatNetMessage,
    RequestModelDef,
    ServerInfo,
    Unrecognized,
)
from housefly.wires.natnet.model import ModelDef

_HEADER = struct.Struct("<HH")
MAX_BODY = 65535 - 28 - _HEADER.size
"""Longest body that fits into a datagram [bytes]."""

_MESSAGES: dict[int, type[NatNetMessage]] = {
    item.KIND: item
    for item in (
        Connect,
        ServerInfo,
        CommandRequest,
        CommandResponse,
        RequestModelDef,
        ModelDef,
        NatNetFrame,
        Disconnect,
        KeepAlive,
        EchoRequest,
        EchoResponse,
        Discovery,
        Unrecognized,
    )
}
"""Every kind that the codec reads."""


def encode_natnet(item: NatNetMessage, version: NatNetVersion) -> bytes:
    """Return a datagram; raises WireError when a value does not fit its field."""
    body = NatNetWriter(version)
    item.write(body)
    if len(body.data) > MAX_BODY:
        raise WireError(f"NatNet message of {len(body.data)} bytes; a datagram holds {MAX_BODY}")
    return _HEADER.pack(item.KIND, len(body.data)) + body.data


def decode_natnet(datagram: bytes, version: NatNetVersion) -> NatNetMessage:
    """Return the message of a datagram.

    Bytes after the message are ignored: some clients send a zero that their header does not count.

    Raises:
        WireError: not a NatNet message; names the field.
    """
    if len(datagram) < _HEADER.size:
        raise WireError(f"NatNet header: {_HEADER.size} bytes wanted, {len(datagram)} came")
    kind, length = _HEADER.unpack_from(datagram)
    if length > len(datagram) - _HEADER.size:
        raise WireError(
            f"NatNet length: the header says {length} bytes, {len(datagram) - _HEADER.size} came"
        )
    item = _MESSAGES.get(kind)
    if item is None:
        raise WireError(f"NatNet kind: {kind} is unknown")
    return item.read(NatNetReader(datagram, version, _HEADER.size, _HEADER.size + length))
