"""NatNet primitives: little-endian numbers, zero-terminated strings, sized sections."""

from __future__ import annotations

import struct
from typing import Any

from housefly.errors import WireError

I32 = struct.Struct("<i")

NAME_FIELD_SIZE = 256
"""Longest name accepted, with its closing zero [bytes]; the field of the protocol's own headers."""

NatNetVersion = tuple[int, int]
"""Major and minor number of the protocol."""
SIZED_SECTIONS_SINCE: NatNetVersion = (4, 1)
"""From this version on every section begins with its size."""


class NatNetReader:
    """Reads one message and never past its end; every WireError names the field.

    Args:
        data: bytes that hold the message.
        version: protocol version that they are written in.
    """

    def __init__(
        self, data: bytes, version: NatNetVersion, start: int = 0, end: int | None = None
    ) -> None:
        self.version = version
        self._data = data
        self._at = start
        self._end = len(data) if end is None else end

    @property
    def left(self) -> int:
        """Bytes not read yet."""
        return self._end - self._at

    def unpack(self, layout: struct.Struct, field: str) -> tuple[Any, ...]:
        """Read the fields of a fixed layout."""
        start = self._at
        self.skip(layout.size, field)
        return layout.unpack_from(self._data, start)

    def number(self, layout: struct.Struct, field: str) -> int:
        """Read one whole number."""
        return int(self.unpack(layout, field)[0])

    def count(self, smallest: int, field: str) -> int:
        """Read the length of a list; refuses what cannot fit.

        Args:
            smallest: least size of an element [bytes].
            field: for the error.
        """
        number = self.number(I32, field)
        if not 0 <= number * smallest <= self.left:
            raise WireError(f"NatNet {field}: {number} do not fit into the {self.left} bytes left")
        return number

    def text(self, field: str) -> str:
        """Read a string up to its closing zero; invalid UTF-8 becomes replacement characters."""
        end = self._data.find(b"\0", self._at, min(self._end, self._at + NAME_FIELD_SIZE))
        if end < 0:
            raise WireError(
                f"NatNet {field}: no closing zero within {min(self.left, NAME_FIELD_SIZE)} bytes"
            )
        start, self._at = self._at, end + 1
        return self._data[start:end].decode("utf-8", errors="replace")

    def skip(self, length: int, field: str) -> NatNetReader:
        """Return a reader of the next ``length`` bytes and step over them."""
        if not 0 <= length <= self.left:
            raise WireError(f"NatNet {field}: {length} bytes wanted, {self.left} are left")
        start, self._at = self._at, self._at + length
        return NatNetReader(self._data, self.version, start, self._at)

    def section(self, field: str) -> NatNetReader:
        """Return a reader of a section; before 4.1 sections have no length, and it is this one."""
        return (
            self.skip(self.number(I32, f"size of {field}"), field)
            if self.version >= SIZED_SECTIONS_SINCE
            else self
        )


class NatNetWriter:
    """Collects the bytes of one message body.

    Args:
        version: protocol version to write.
    """

    def __init__(self, version: NatNetVersion) -> None:
        self.version = version
        self.data = bytearray()

    def put(self, layout: struct.Struct, *values: float | bytes) -> None:
        """Append the fields of a fixed layout; raises WireError if a value does not fit."""
        try:
            self.data += layout.pack(*values)
        except (struct.error, OverflowError) as error:
            raise WireError(
                f"{values} do not fit the NatNet layout {layout.format}: {error}"
            ) from error

    def text(self, text: str) -> None:
        """Append a zero-terminated UTF-8 string."""
        encoded = text.encode("utf-8", errors="replace")
        if len(encoded) >= NAME_FIELD_SIZE or b"\0" in encoded:
            raise WireError(
                f"a NatNet name has at most {NAME_FIELD_SIZE - 1} bytes and no zero, not {text!r}"
            )
        self.data += encoded + b"\0"

    def section(self, body: bytes | bytearray) -> None:
        """Append a section, after its length where the version wants it."""
        if self.version >= SIZED_SECTIONS_SINCE:
            self.put(I32, len(body))
        self.data += body
