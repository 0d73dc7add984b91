"""The primitives of CGStream: little-endian numbers, strings and counted lists."""

from __future__ import annotations

import struct
from typing import Any

from housefly.errors import WireError

U8 = struct.Struct("<B")
U32 = struct.Struct("<I")
U64 = struct.Struct("<Q")
I64 = struct.Struct("<q")
F64 = struct.Struct("<d")

_MAX_NAME = 256
"""Longest name accepted [bytes]; Vicon Tracker itself stops far earlier."""


class ViconReader:
    """Reads one block and never past its end; every short read is a WireError."""

    def __init__(self, data: bytes, start: int = 0, end: int | None = None) -> None:
        self._data = data
        self._at = start
        self._end = len(data) if end is None else end

    @property
    def left(self) -> int:
        """Bytes not read yet."""
        return self._end - self._at

    def unpack(self, layout: struct.Struct) -> tuple[Any, ...]:
        """Read the fields of a fixed layout."""
        start = self._at
        if start + layout.size > self._end:
            raise WireError(f"Vicon block ends {layout.size - self.left} bytes too early")
        self._at = start + layout.size
        return layout.unpack_from(self._data, start)

    def u32(self) -> int:
        """Read an unsigned 32-bit number."""
        return int(self.unpack(U32)[0])

    def count(self, smallest: int) -> int:
        """Read the length of a list; refuses what cannot fit.

        Args:
            smallest: least size of an element [bytes].
        """
        number = self.u32()
        if number * smallest > self.left:
            raise WireError(
                f"Vicon list of {number} elements does not fit into the {self.left} bytes left"
            )
        return number

    def text(self) -> str:
        """Read a counted string; bytes that are not UTF-8 become replacement characters."""
        length = self.u32()
        if length > _MAX_NAME or length > self.left:
            raise WireError(
                f"Vicon name of {length} bytes; at most {min(_MAX_NAME, self.left)} are possible"
                " here"
            )
        start, self._at = self._at, self._at + length
        return self._data[start : self._at].decode("utf-8", errors="replace")

    def numbers(self) -> frozenset[int]:
        """Read a counted set of unsigned 32-bit numbers."""
        return frozenset(self.u32() for _ in range(self.count(U32.size)))

    def skip(self, length: int) -> ViconReader:
        """Return a reader of the next ``length`` bytes and step over them."""
        if length > self.left:
            raise WireError(
                f"Vicon block of {length} bytes in a packet with {self.left} bytes left"
            )
        start, self._at = self._at, self._at + length
        return ViconReader(self._data, start, self._at)


class ViconWriter:
    """Collects the bytes of one block."""

    def __init__(self) -> None:
        self.data = bytearray()

    def put(self, layout: struct.Struct, *values: float) -> None:
        """Append the fields of a fixed layout; raises WireError if a value does not fit."""
        try:
            self.data += layout.pack(*values)
        except struct.error as error:
            raise WireError(
                f"{values} do not fit the Vicon layout {layout.format}: {error}"
            ) from error

    def u32(self, number: int) -> None:
        """Append an unsigned 32-bit number."""
        self.put(U32, number)

    def text(self, text: str) -> None:
        """Append a counted UTF-8 string."""
        encoded = text.encode("utf-8", errors="replace")
        if len(encoded) > _MAX_NAME:
            raise WireError(f"a Vicon name has at most {_MAX_NAME} bytes, not {len(encoded)}")
        self.u32(len(encoded))
        self.data += encoded

    def numbers(self, numbers: frozenset[int]) -> None:
        """Append a counted set of unsigned 32-bit numbers, in ascending order as the SDK does."""
        self.u32(len(numbers))
        for number in sorted(numbers):
            self.u32(number)
