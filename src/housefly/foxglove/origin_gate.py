"""Lets in programs of this machine and the pages that the site names, and no other page.

A browser opens a WebSocket to this machine for any page in the world, and says in ``Origin`` which
one asks. The SDK's server does not look; so it listens where no page finds it, and this gate stands
at the known port and hands on the bytes of those that may look.
"""

from __future__ import annotations

import asyncio
import logging
import re
import secrets
import socket
import threading
from collections.abc import Collection
from contextlib import suppress

from housefly.config.text import shortened
from housefly.errors import ConfigError

_LOG = logging.getLogger(__name__)

_HEAD_LIMIT = 8192
"""Longest head of a request [bytes]."""
_HEAD_PATIENCE = 5.0
"""How long its end is waited for [s]."""
_PIECE = 64 * 1024
_BUFFER = 128 * 1024
"""Of the kernel's for one way [bytes]: what waits there is old, and cannot be dropped any more."""
_CONNECTIONS = 16
"""So many viewers at most; the next one is refused."""
_ORIGIN = re.compile(rb"^origin:[ \t]*(.*?)[ \t]*\r?$", re.IGNORECASE | re.MULTILINE)
_WORDS = b"this page may not look; foxglove.origins in the site file names who may\n"
_REFUSAL = (
    b"HTTP/1.1 403 Forbidden\r\nContent-Type: text/plain; charset=utf-8\r\nConnection: close\r\n"
    b"Content-Length: %d\r\n\r\n%b" % (len(_WORDS), _WORDS)
)
_ORIGINS_TOLD = 20
"""Pages that were refused, of which the log tells."""


def hidden_address() -> str:
    """Return a loopback address that nobody guesses: 24 bits by chance, beside the port's."""
    return f"127.{secrets.randbelow(254) + 1}.{secrets.randbelow(256)}.{secrets.randbelow(254) + 1}"


def origin_of(head: bytes) -> str | None:
    """Return the page that a request's head names; None for a program that is no browser."""
    found = _ORIGIN.findall(head.split(b"\r\n\r\n")[0])
    if not found:
        return None
    return found[0].decode("latin-1") if len(found) == 1 else "several"


class OriginGate:
    """The known port; runs on a thread of its own.

    Args:
        host: address to listen on.
        port: 0 takes a free one.
        inner: address and port of the server behind it.
        origins: pages that may look.

    Attributes:
        port: where it listens.

    Raises:
        ConfigError: the address cannot be had.
    """

    def __init__(
        self, host: str, port: int, inner: tuple[str, int], origins: Collection[str]
    ) -> None:
        self._inner, self._origins = inner, frozenset(origins)
        self._open, self._told = 0, set[str]()
        try:
            self._socket = socket.create_server(
                (host, port), family=socket.AF_INET6 if ":" in host else socket.AF_INET
            )
        except OSError as error:
            raise ConfigError(
                "foxglove.port",
                f"cannot listen on {host} port {port} ({error.strerror}); choose another port",
            ) from error
        self.port = int(self._socket.getsockname()[1])
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._run, name="origin gate", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Let nobody in any longer, and everybody go."""
        with suppress(RuntimeError):
            self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join(timeout=2.0)
        self._socket.close()

    def _run(self) -> None:
        asyncio.set_event_loop(self._loop)
        self._loop.run_until_complete(asyncio.start_server(self._met, sock=self._socket))
        self._loop.run_forever()
        for task in asyncio.all_tasks(self._loop):
            task.cancel()
        self._loop.run_until_complete(asyncio.sleep(0))
        self._loop.close()

    async def _met(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        self._open += 1
        try:
            if self._open <= _CONNECTIONS:
                async with asyncio.timeout(_HEAD_PATIENCE):
                    head = await _head(reader)
                await self._decide(head, reader, writer)
        except (OSError, TimeoutError, asyncio.IncompleteReadError, asyncio.LimitOverrunError):
            pass
        except asyncio.CancelledError:
            pass  # the gate closes; asyncio would log a connection that ends so as an error
        finally:
            self._open -= 1
            writer.close()

    async def _decide(
        self, head: bytes, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        origin = origin_of(head)
        if origin is not None and origin not in self._origins:
            if origin not in self._told and len(self._told) < _ORIGINS_TOLD:
                self._told.add(origin)
                _LOG.warning("refused the page %r: foxglove.origins", shortened(origin, 100))
            writer.write(_REFUSAL)
            await writer.drain()
            return
        inner_reader, inner_writer = await asyncio.open_connection(*self._inner)
        writer.get_extra_info("socket").setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, _BUFFER)
        within = inner_writer.get_extra_info("socket")
        within.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, _BUFFER)
        try:
            inner_writer.write(head)
            ways = [
                asyncio.create_task(_hand_on(reader, inner_writer)),
                asyncio.create_task(_hand_on(inner_reader, writer)),
            ]
            _, left = await asyncio.wait(ways, return_when=asyncio.FIRST_COMPLETED)
            for way in left:
                way.cancel()
        finally:
            inner_writer.close()


async def _head(reader: asyncio.StreamReader) -> bytes:
    """Return a request's head; raises asyncio.LimitOverrunError where it is too long."""
    head = await reader.readuntil(b"\r\n\r\n")
    if len(head) > _HEAD_LIMIT:
        raise asyncio.LimitOverrunError("too long", len(head))
    return head


async def _hand_on(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
    """Hand bytes on; one that does not read stops the other, which drops its oldest messages."""
    with suppress(OSError):
        while piece := await reader.read(_PIECE):
            writer.write(piece)
            await writer.drain()
