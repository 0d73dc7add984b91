"""The messages before frames flow, and the protocol that every message follows."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import ClassVar, Protocol, Self

from housefly.errors import WireError
from housefly.wires.natnet.buffer import (
    I32,
    NAME_FIELD_SIZE,
    NatNetReader,
    NatNetVersion,
    NatNetWriter,
)

_SENDER = struct.Struct(f"<{NAME_FIELD_SIZE}s4B4B")
_STREAM = struct.Struct("<QH?4B")
_STREAM_SINCE = 3
"""Servers of older major versions tell neither clock nor ports."""
_OPTIONS = struct.Struct("<?4B")
_TICKS = struct.Struct("<Q")

_FourNumbers = tuple[int, int, int, int]


class NatNetMessage(Protocol):
    """One message."""

    KIND: ClassVar[int]

    def write(self, out: NatNetWriter) -> None:
        """Append the body, without its header."""
        ...

    @classmethod
    def read(cls, source: NatNetReader) -> Self:
        """Read the body; raises WireError. What follows the known fields is ignored."""
        ...


@dataclass(frozen=True, slots=True)
class Connect:
    """A client asks who serves; unicast clients of 4.0 servers and later may wish for a version."""

    KIND: ClassVar[int] = 0
    wish: NatNetVersion | None = None

    def write(self, out: NatNetWriter) -> None:
        """Append the greeting that Motive's own clients send, then the wish."""
        out.put(_SENDER, b"Ping", *[0] * 8)
        out.put(_OPTIONS, False, *(self.wish or (0, 0)), 0, 0)

    @classmethod
    def read(cls, source: NatNetReader) -> Self:
        """Read the body; short greetings of older clients wish for nothing."""
        if source.left < _SENDER.size + _OPTIONS.size:
            return cls()
        source.unpack(_SENDER, "client")
        _, major, minor, _, _ = source.unpack(_OPTIONS, "options")
        return cls((major, minor) if major else None)


@dataclass(frozen=True, slots=True)
class ServerInfo:
    """Who serves, how its clock ticks and where the frames go.

    Attributes:
        application: name of the program that serves.
        application_version: its version.
        version: of the protocol, major.minor.build.revision.
        clock_hz: ticks per second of all time stamps [Hz]; 0 before NatNet 3, which does not say.
        data_port: port that multicast frames are sent to.
        multicast: whether frames go to a group; else each client gets its own.
        group: address of the group.
    """

    KIND: ClassVar[int] = 1
    application: str
    application_version: _FourNumbers
    version: _FourNumbers
    clock_hz: int
    data_port: int
    multicast: bool
    group: str

    def write(self, out: NatNetWriter) -> None:
        """Append the body."""
        name = self.application.encode("utf-8", errors="replace")[: NAME_FIELD_SIZE - 1]
        out.put(_SENDER, name, *self.application_version, *self.version)
        out.put(_STREAM, self.clock_hz, self.data_port, self.multicast, *_quad(self.group))

    @classmethod
    def read(cls, source: NatNetReader) -> Self:
        """Read the body; servers before NatNet 3 do not say how their clock ticks."""
        name, *versions = source.unpack(_SENDER, "server")
        a, b, c, d, e, f, g, h = versions
        application = name.split(b"\0", 1)[0].decode("utf-8", errors="replace")
        if 0 < e < _STREAM_SINCE:
            return cls(application, (a, b, c, d), (e, f, g, h), 0, 0, False, "")
        clock_hz, data_port, multicast, *quad = source.unpack(_STREAM, "clock and data port")
        if clock_hz == 0:
            raise WireError("NatNet clock frequency: is 0")
        return cls(
            application,
            (a, b, c, d),
            (e, f, g, h),
            clock_hz,
            data_port,
            multicast,
            ".".join(map(str, quad)),
        )


@dataclass(frozen=True, slots=True)
class CommandRequest:
    """A command in words, for example ``Bitstream,4.1``."""

    KIND: ClassVar[int] = 2
    command: str

    def write(self, out: NatNetWriter) -> None:
        """Append the body."""
        out.text(self.command)

    @classmethod
    def read(cls, source: NatNetReader) -> Self:
        """Read the body."""
        return cls(source.text("command"))


@dataclass(frozen=True, slots=True)
class CommandResponse:
    """The answer to a command: 0 is success."""

    KIND: ClassVar[int] = 3
    code: int

    def write(self, out: NatNetWriter) -> None:
        """Append the body."""
        out.put(I32, self.code)

    @classmethod
    def read(cls, source: NatNetReader) -> Self:
        """Read the body."""
        return cls(source.number(I32, "response"))


@dataclass(frozen=True, slots=True)
class _Bare:
    """A message that is its kind alone."""

    def write(self, out: NatNetWriter) -> None:
        """Append nothing."""

    @classmethod
    def read(cls, source: NatNetReader) -> Self:
        """Read nothing."""
        return cls()


class RequestModelDef(_Bare):
    """The client asks for names of the bodies."""

    __slots__ = ()
    KIND: ClassVar[int] = 4


class Disconnect(_Bare):
    """The client leaves."""

    __slots__ = ()
    KIND: ClassVar[int] = 9


class KeepAlive(_Bare):
    """A unicast client is still there."""

    __slots__ = ()
    KIND: ClassVar[int] = 10


@dataclass(frozen=True, slots=True)
class EchoRequest:
    """A client compares clocks; ``client_time`` is by its own, in its own unit."""

    KIND: ClassVar[int] = 12
    client_time: int

    def write(self, out: NatNetWriter) -> None:
        """Append the body."""
        out.put(_TICKS, self.client_time)

    @classmethod
    def read(cls, source: NatNetReader) -> Self:
        """Read the body."""
        return cls(source.number(_TICKS, "client time"))


@dataclass(frozen=True, slots=True)
class EchoResponse:
    """The answer: the client's time as it came, and the server's [ticks]."""

    KIND: ClassVar[int] = 13
    client_time: int
    server_time: int

    def write(self, out: NatNetWriter) -> None:
        """Append the body."""
        out.put(_TICKS, self.client_time)
        out.put(_TICKS, self.server_time)

    @classmethod
    def read(cls, source: NatNetReader) -> Self:
        """Read the body."""
        return cls(source.number(_TICKS, "client time"), source.number(_TICKS, "server time"))


class Discovery(_Bare):
    """A client looks for servers; each answers with its ``ServerInfo``."""

    __slots__ = ()
    KIND: ClassVar[int] = 14


class Unrecognized(_Bare):
    """The server does not know a request."""

    __slots__ = ()
    KIND: ClassVar[int] = 100


def _quad(address: str) -> list[int]:
    parts = address.split(".")
    if len(parts) != 4 or not all(part.isdecimal() and int(part) < 256 for part in parts):
        raise WireError(f"NatNet multicast group: {address!r} is no IPv4 address")
    return [int(part) for part in parts]
