"""How a VRPN connection begins: an optional call-back datagram, then a cookie from each side."""

from __future__ import annotations

from housefly.errors import WireError

MAJOR_VERSION = "07"
"""Major version; servers and clients of the same one understand each other."""
COOKIE_SIZE = 24
_MAGIC = "vrpn: ver. "
_COOKIE = f"{_MAGIC}{MAJOR_VERSION}.35  0"
_LONGEST_LOB = 256


def encode_cookie() -> bytes:
    """Return our cookie: version 07.35, nothing is to be logged for us."""
    return _COOKIE.encode("ascii").ljust(COOKIE_SIZE, b"\0")


def decode_cookie(cookie: bytes) -> str:
    """Return the version of the other side, as ``07.35``; raises WireError for no cookie."""
    text = cookie.split(b"\0", 1)[0].decode("ascii", errors="replace")
    version = text.removeprefix(_MAGIC)[:5]
    if len(cookie) != COOKIE_SIZE or not text.startswith(_MAGIC) or not _is_version(version):
        raise WireError(f"VRPN cookie: {text[:24]!r} does not start with {_MAGIC!r} and a version")
    return version


def encode_lob(host: str, port: int) -> bytes:
    """Return the datagram that asks a server to connect to us."""
    return f"{host} {port}".encode("ascii") + b"\0"


def decode_lob(datagram: bytes) -> tuple[str, int]:
    """Return the host and TCP port that a client wants to be called at; raises WireError."""
    text = datagram[:_LONGEST_LOB].split(b"\0", 1)[0].decode("ascii", errors="replace")
    host, _, port = text.partition(" ")
    if not (
        host and port.isascii() and port.isdecimal() and len(port) <= 5 and 0 < int(port) < 65536
    ):
        raise WireError(f"VRPN callback: {text[:40]!r} is not a host and a port")
    return host, int(port)


def _is_version(text: str) -> bool:
    return (
        len(text) == 5 and text[2] == "." and text.isascii() and (text[:2] + text[3:]).isdecimal()
    )
