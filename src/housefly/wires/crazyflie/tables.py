"""The tables of contents of log variables (port 5) and parameters (port 2), version 2.

A drone tells how many entries there are and a checksum of all, then each by its number: a type, a
group and a name. Both sides of the wire; the type bytes of the two tables differ.
"""

from __future__ import annotations

import struct
from collections.abc import Iterable
from dataclasses import dataclass
from enum import Enum
from zlib import crc32

from housefly.errors import WireError
from housefly.wires.crazyflie.crtp import Packet, Port

TOC_CHANNEL = 0
ENTRIES_MAX = 16_384
_ITEM, _INFO = 2, 3
_ID = struct.Struct("<H")
_INFO_ANSWER = struct.Struct("<BHI")
_LOG_EXTRA = struct.Struct("<BB")
_READ_ONLY = 0x40
_EXTENDED = 0x10


class ValueType(Enum):
    """A number as the drone keeps it: its type byte among log variables and parameters, its form.

    A table that has no such type has None.
    """

    UINT8 = (1, 0x08, "<B")
    UINT16 = (2, 0x09, "<H")
    UINT32 = (3, 0x0A, "<I")
    INT8 = (4, 0x00, "<b")
    INT16 = (5, 0x01, "<h")
    INT32 = (6, 0x02, "<i")
    FLOAT = (7, 0x06, "<f")
    HALF = (8, 0x05, "<e")
    UINT64 = (None, 0x0B, "<Q")
    INT64 = (None, 0x03, "<q")
    DOUBLE = (None, 0x07, "<d")

    @property
    def log_code(self) -> int:
        """Type byte of a log variable."""
        code: int | None = self.value[0]
        assert code is not None
        return code

    @property
    def form(self) -> struct.Struct:
        """How a value lies on the wire."""
        return struct.Struct(self.value[2])

    @property
    def is_real(self) -> bool:
        """Whether it has a fraction."""
        return self in (ValueType.FLOAT, ValueType.HALF, ValueType.DOUBLE)

    def pack(self, value: float) -> bytes:
        """Return a value's bytes; raises WireError where it does not fit."""
        try:
            return self.form.pack(value if self.is_real else int(value))
        except (struct.error, OverflowError, ValueError) as error:
            raise WireError(f"{value} does not fit {self.name}") from error

    def unpack(self, data: bytes) -> float:
        """Return the value of bytes; raises WireError for too few or too many."""
        if len(data) != self.form.size:
            raise WireError(f"{len(data)} bytes for {self.name}; allowed: {self.form.size}")
        value: float = self.form.unpack(data)[0]
        return value


_LOG_TYPES = {kind.value[0]: kind for kind in ValueType if kind.value[0] is not None}
_PARAMETER_TYPES = {kind.value[1]: kind for kind in ValueType}


@dataclass(frozen=True, slots=True)
class TableEntry:
    """One variable or parameter.

    Attributes:
        name: ``group.name``.
        kind: of its value.
        read_only: whether it can be written; of a parameter.
    """

    name: str
    kind: ValueType
    read_only: bool = False


def info_question(port: Port) -> Packet:
    """Return the question how long a table is."""
    return Packet(port, TOC_CHANNEL, bytes((_INFO,)))


def item_question(port: Port, number: int) -> Packet:
    """Return the question for an entry."""
    return Packet(port, TOC_CHANNEL, bytes((_ITEM,)) + _ID.pack(number))


def info_answer(port: Port, entries: tuple[TableEntry, ...], extra: tuple[int, int]) -> Packet:
    """Return how long a table is; extra is how many blocks and variables can be logged."""
    told = _INFO_ANSWER.pack(_INFO, len(entries), table_checksum(port, entries))
    return Packet(port, TOC_CHANNEL, told + (_LOG_EXTRA.pack(*extra) if port == Port.LOG else b""))


def item_answer(port: Port, number: int, entries: tuple[TableEntry, ...]) -> Packet:
    """Return an entry; one that is not there is an answer without one."""
    if number >= len(entries):
        return Packet(port, TOC_CHANNEL, bytes((_ITEM,)))
    told = _entry_bytes(port, entries[number])
    return Packet(port, TOC_CHANNEL, bytes((_ITEM,)) + _ID.pack(number) + told)


def read_question(packet: Packet) -> int | None:
    """Return the number of the entry that is asked for, None for the length of the table.

    Raises:
        WireError: neither.
    """
    data = packet.data
    if data[:1] == bytes((_INFO,)):
        return None
    if data[:1] == bytes((_ITEM,)) and len(data) == 3:
        number: int = _ID.unpack(data[1:])[0]
        return number
    raise WireError(f"no question about a table: {data.hex()}")


def read_info(packet: Packet) -> tuple[int, int]:
    """Return how long a table is, and its checksum; raises WireError for no such answer."""
    data = packet.data
    if packet.channel != TOC_CHANNEL or len(data) < _INFO_ANSWER.size or data[0] != _INFO:
        raise WireError(f"not the length of a table: {data.hex()}")
    _, count, check = _INFO_ANSWER.unpack_from(data)
    if count > ENTRIES_MAX:
        raise WireError(f"a table of {count} entries; allowed: {ENTRIES_MAX} or less")
    return count, check


def read_item(packet: Packet) -> tuple[int, TableEntry]:
    """Return the number of an entry, and the entry; raises WireError for no such answer."""
    data = packet.data
    if packet.channel != TOC_CHANNEL or len(data) < 6 or data[0] != _ITEM:
        raise WireError(f"no entry of a table: {data.hex()}")
    kind, texts = data[3], data[4:].split(b"\x00")
    if len(texts) != 3 or texts[2] or not (texts[0] and texts[1]):
        raise WireError(f"no name of an entry: {data.hex()}")
    is_log = packet.port == Port.LOG
    known = _LOG_TYPES.get(kind & 0x0F) if is_log else _PARAMETER_TYPES.get(kind & 0x0F)
    if known is None:
        raise WireError(f"a value of type {kind:#04x}, which nobody knows")
    name = b".".join(texts[:2]).decode("latin-1")
    number: int = _ID.unpack_from(data, 1)[0]
    return number, TableEntry(name, known, not is_log and bool(kind & _READ_ONLY))


def table_checksum(port: Port, entries: Iterable[TableEntry]) -> int:
    """Return what tells one table from another."""
    return crc32(b"".join(_entry_bytes(port, entry) for entry in entries))


def _entry_bytes(port: Port, entry: TableEntry) -> bytes:
    is_log = port == Port.LOG
    kind = entry.kind.value[0] if is_log else entry.kind.value[1]
    if kind is None:
        raise WireError(f"{entry.name} is {entry.kind.name}: that cannot be logged")
    flags = _READ_ONLY if entry.read_only and not is_log else 0
    group, _, name = entry.name.partition(".")
    return bytes((kind | flags,)) + f"{group}\0{name}\0".encode("latin-1")
