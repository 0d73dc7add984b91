"""Reading and writing parameters, port 2, version 2: a parameter by its number in the table."""

from __future__ import annotations

import struct

from housefly.errors import WireError
from housefly.wires.crazyflie.crtp import Packet, Port
from housefly.wires.crazyflie.tables import ValueType

READ, WRITE, MISC = 1, 2, 3
_ID = struct.Struct("<H")


def encode_read(number: int) -> Packet:
    """Return the question for a value."""
    return Packet(Port.PARAMETERS, READ, _ID.pack(number))


def encode_write(number: int, kind: ValueType, value: float) -> Packet:
    """Return the order to keep a value; raises WireError where it does not fit."""
    return Packet(Port.PARAMETERS, WRITE, _ID.pack(number) + kind.pack(value))


def number_of(packet: Packet) -> int:
    """Return which parameter a packet is about; raises WireError for none."""
    if packet.channel not in (READ, WRITE) or len(packet.data) < _ID.size:
        raise WireError(f"nothing about a parameter: {packet.data.hex()}")
    number: int = _ID.unpack_from(packet.data)[0]
    return number


def written_value(packet: Packet, kind: ValueType) -> float:
    """Return the value in an order to keep it, or in the answer; raises WireError for none."""
    return kind.unpack(packet.data[_ID.size :])


def parameter_answer(number: int, kind: ValueType, value: float) -> Packet:
    """Return the answer to a question: a zero stands before the value."""
    return Packet(Port.PARAMETERS, READ, _ID.pack(number) + b"\x00" + kind.pack(value))


def read_value(packet: Packet, kind: ValueType) -> float:
    """Return the value in an answer to a question; raises WireError where it says why not."""
    data = packet.data
    if len(data) < 3 or data[2]:
        raise WireError(f"the drone does not tell parameter {number_of(packet)}: {data.hex()}")
    return kind.unpack(data[3:])
