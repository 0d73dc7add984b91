"""The address of a console, taken apart."""

from __future__ import annotations

from dataclasses import dataclass
from urllib.parse import urlsplit

from housefly.errors import LinkError

_WORDS = "allowed: http://HOST:PORT or https://HOST:PORT"


@dataclass(frozen=True, slots=True)
class ConsoleAddress:
    """Where a console answers.

    Attributes:
        host: name or address.
        port: None for the usual one of the scheme.
        is_secure: whether TLS encrypts it.
    """

    host: str
    port: int | None
    is_secure: bool

    @property
    def netloc(self) -> str:
        """Host and port as they stand in an address."""
        host = f"[{self.host}]" if ":" in self.host else self.host
        return host if self.port is None else f"{host}:{self.port}"


def console_address_of(text: str) -> ConsoleAddress:
    """Return an address; raises LinkError that says what is allowed."""
    try:
        parts = urlsplit(text)
        host, port = parts.hostname or "", parts.port
    except ValueError as error:
        raise LinkError(f"{text!r} is no address ({error}); {_WORDS}") from error
    if parts.scheme not in ("http", "https") or not host:
        raise LinkError(f"{text!r} is no address; {_WORDS}")
    return ConsoleAddress(host, port, parts.scheme == "https")
