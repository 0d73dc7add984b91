"""What client and server agree on: the Item protocol, and the objects that ask for frames."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Protocol, Self

from housefly.wires.vicon.buffer import U8, U64, ViconReader, ViconWriter


class ViconObject(Protocol):
    """One object of a packet."""

    KIND: ClassVar[int]

    def write(self, out: ViconWriter) -> None:
        """Append the body, without its header."""
        ...

    @classmethod
    def read(cls, source: ViconReader) -> Self:
        """Read the body; raises WireError. Unknown fields at the end are ignored."""
        ...


@dataclass(frozen=True, slots=True)
class ObjectEnums:
    """The kinds that a server offers (first packet) or that a client asks for."""

    KIND: ClassVar[int] = 100001
    kinds: frozenset[int]

    def write(self, out: ViconWriter) -> None:
        """Append the body."""
        out.numbers(self.kinds)

    @classmethod
    def read(cls, source: ViconReader) -> Self:
        """Read the body."""
        return cls(source.numbers())


@dataclass(frozen=True, slots=True)
class RequestFrame:
    """The client wants every frame (``streaming``), or just the present one."""

    KIND: ClassVar[int] = 100002
    streaming: bool

    def write(self, out: ViconWriter) -> None:
        """Append the body."""
        out.put(U8, self.streaming)

    @classmethod
    def read(cls, source: ViconReader) -> Self:
        """Read the body."""
        return cls(source.unpack(U8)[0] != 0)


@dataclass(frozen=True, slots=True)
class RequestNextFrame:
    """The client wants this many of the coming frames."""

    KIND: ClassVar[int] = 100008
    number: int = 1

    def write(self, out: ViconWriter) -> None:
        """Append the body."""
        out.u32(self.number)

    @classmethod
    def read(cls, source: ViconReader) -> Self:
        """Read the body."""
        return cls(source.u32())


@dataclass(frozen=True, slots=True)
class ViconPing:
    """Echoed by the server as it came."""

    KIND: ClassVar[int] = 42
    identity: int

    def write(self, out: ViconWriter) -> None:
        """Append the body."""
        out.put(U64, self.identity)

    @classmethod
    def read(cls, source: ViconReader) -> Self:
        """Read the body."""
        return cls(int(source.unpack(U64)[0]))
