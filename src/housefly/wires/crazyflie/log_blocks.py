"""Log blocks, port 5: some variables that the drone sends by itself, at a rate; both sides."""

from __future__ import annotations

import struct
from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum

from housefly.errors import WireError
from housefly.wires.crazyflie.crtp import Packet, Port
from housefly.wires.crazyflie.tables import ValueType

CONTROL, DATA = 1, 2
BLOCK_DATA_MAX = 26
"""Bytes of values in one packet."""
BLOCKS_MAX, VARIABLES_MAX = 16, 128
PERIOD_STEP = 0.01
"""The older order to start counts in these [s]."""
_VARIABLE = struct.Struct("<BH")
_ANSWER = struct.Struct("<BBB")
_PERIOD_MS = struct.Struct("<H")
_TYPES = {kind.value[0]: kind for kind in ValueType if kind.value[0] is not None}


class BlockOrder(IntEnum):
    """What can be done with a block."""

    DELETE = 2
    START = 3
    STOP = 4
    RESET = 5
    CREATE = 6
    APPEND = 7
    START_MS = 8


class BlockError(IntEnum):
    """Why an order was not obeyed; the numbers of errno."""

    NONE = 0
    NO_SUCH_BLOCK = 2
    TOO_LARGE = 7
    COMMAND_UNKNOWN = 8
    NO_MEMORY = 12
    EXISTS = 17


@dataclass(frozen=True, slots=True)
class BlockRequest:
    """One order.

    Attributes:
        order: what to do.
        block: 0 to 255.
        variables: type and number in the table of each, for ``CREATE`` and ``APPEND``.
        period: between two packets [s], for the two that start.
    """

    order: BlockOrder
    block: int = 0
    variables: tuple[tuple[ValueType, int], ...] = ()
    period: float = 0.0


def encode_block_request(request: BlockRequest) -> Packet:
    """Return the packet of an order."""
    data = bytes((request.order, request.block))
    if request.order in (BlockOrder.CREATE, BlockOrder.APPEND):
        data += b"".join(
            _VARIABLE.pack(kind.log_code, number) for kind, number in request.variables
        )
    elif request.order is BlockOrder.START:
        data += bytes((round(request.period / PERIOD_STEP),))
    elif request.order is BlockOrder.START_MS:
        data += _PERIOD_MS.pack(round(1000.0 * request.period))
    elif request.order is BlockOrder.RESET:
        data = data[:1]
    return Packet(Port.LOG, CONTROL, data)


def decode_block_request(packet: Packet) -> BlockRequest:
    """Read an order; raises WireError for anything else."""
    data = packet.data
    try:
        order = BlockOrder(data[0])
        if order is BlockOrder.RESET:
            return BlockRequest(order)
        block, rest = data[1], data[2:]
        if order in (BlockOrder.CREATE, BlockOrder.APPEND):
            return BlockRequest(order, block, _variables(rest))
        if order is BlockOrder.START:
            return BlockRequest(order, block, period=PERIOD_STEP * rest[0])
        if order is BlockOrder.START_MS:
            return BlockRequest(order, block, period=_PERIOD_MS.unpack(rest)[0] / 1000.0)
        return BlockRequest(order, block)
    except (IndexError, ValueError, struct.error) as error:
        raise WireError(f"no order about a log block: {data.hex()}") from error


def encode_answer(order: BlockOrder, block: int, error: BlockError) -> Packet:
    """Return what the drone says to an order."""
    return Packet(Port.LOG, CONTROL, _ANSWER.pack(order, block, error))


def read_block_answer(packet: Packet) -> tuple[BlockOrder, int, int]:
    """Return order, block, and 0 or why not; raises WireError for anything else."""
    if packet.channel != CONTROL or len(packet.data) < _ANSWER.size:
        raise WireError(f"no answer about a log block: {packet.data.hex()}")
    order, block, error = _ANSWER.unpack_from(packet.data)
    try:
        return BlockOrder(order), block, error
    except ValueError as unknown:
        raise WireError(f"an answer to order {order} about a log block") from unknown


def encode_values(
    block: int, milliseconds: int, values: Sequence[tuple[ValueType, float]]
) -> Packet:
    """Return a packet of a running block; milliseconds since the drone was switched on."""
    told = b"".join(kind.pack(value) for kind, value in values)
    if len(told) > BLOCK_DATA_MAX:
        raise WireError(f"{len(told)} bytes of values; allowed: {BLOCK_DATA_MAX}")
    clock = (milliseconds & 0xFFFFFF).to_bytes(3, "little")
    return Packet(Port.LOG, DATA, bytes((block,)) + clock + told)


def read_values(packet: Packet, kinds: Sequence[ValueType]) -> tuple[int, tuple[float, ...]]:
    """Return the drone's clock [ms, 24 bits], and the values of a block's packet.

    Raises:
        WireError: it is not as long as its variables are.
    """
    data = packet.data[4:]
    sizes = [kind.form.size for kind in kinds]
    if len(packet.data) < 4 or len(data) != sum(sizes):
        raise WireError(f"{len(data)} bytes of values; this block has {sum(sizes)}")
    values, at = [], 0
    for kind, size in zip(kinds, sizes, strict=True):
        values.append(kind.unpack(data[at : at + size]))
        at += size
    return int.from_bytes(packet.data[1:4], "little"), tuple(values)


def _variables(data: bytes) -> tuple[tuple[ValueType, int], ...]:
    if len(data) % _VARIABLE.size:
        raise ValueError("an unfinished variable")
    # the upper half of the type says how it is kept, which the drone knows
    found = [(_TYPES.get(kind & 0x0F), number) for kind, number in _VARIABLE.iter_unpack(data)]
    known = tuple((kind, number) for kind, number in found if kind is not None)
    if len(known) != len(found):
        raise ValueError("a type that nobody knows")
    return known
