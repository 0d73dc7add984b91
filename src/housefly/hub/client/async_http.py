"""One HTTP request at a time for asyncio; a cancelled one closes its connection."""

from __future__ import annotations

import asyncio
import ssl

import h11

from housefly.errors import LinkError
from housefly.hub.client.console_address import ConsoleAddress

ANSWER_MAX = 32 * 2**20
"""Longest answer [bytes]."""
_PIECE = 64 * 1024


class AsyncHttp:
    """Opens a connection for each request, so that none is made twice; any number at once.

    Args:
        address: of the console.
        key: bearer token of the run.
        timeout: of one request [s].
        tls: whom to trust; None for the usual authorities.
    """

    def __init__(
        self, address: ConsoleAddress, key: str, timeout: float, tls: ssl.SSLContext | None = None
    ) -> None:
        self._address, self._timeout = address, timeout
        self._headers = [
            ("Host", address.netloc),
            ("Authorization", f"Bearer {key}"),
            ("Content-Type", "application/json"),
            ("Connection", "close"),
        ]
        self._tls = (tls or ssl.create_default_context()) if address.is_secure else None

    async def request(self, method: str, path: str, body: str | None = None) -> tuple[int, str]:
        """Return status and text of an answer; raises LinkError if there is none."""
        try:
            async with asyncio.timeout(self._timeout):
                return await self._requested(method, path, (body or "").encode())
        except (OSError, TimeoutError, h11.RemoteProtocolError, UnicodeDecodeError) as error:
            raise LinkError(f"the room does not answer: {error or 'in time'}") from error

    async def _requested(self, method: str, path: str, body: bytes) -> tuple[int, str]:
        port = self._address.port or (443 if self._address.is_secure else 80)
        reader, writer = await asyncio.open_connection(self._address.host, port, ssl=self._tls)
        try:
            protocol = h11.Connection(h11.CLIENT)
            headers = [*self._headers, ("Content-Length", str(len(body)))]
            writer.write(protocol.send(h11.Request(method=method, target=path, headers=headers)))
            writer.write(protocol.send(h11.Data(data=body)) or b"")
            writer.write(protocol.send(h11.EndOfMessage()) or b"")
            await writer.drain()
            return await _answer(protocol, reader)
        finally:
            writer.close()


async def _answer(protocol: h11.Connection, reader: asyncio.StreamReader) -> tuple[int, str]:
    status, text = 0, bytearray()
    while True:
        event = protocol.next_event()
        if event is h11.NEED_DATA:
            protocol.receive_data(await reader.read(_PIECE))
        elif isinstance(event, h11.Response):
            status = event.status_code
        elif isinstance(event, h11.Data):
            text += event.data
            if len(text) > ANSWER_MAX:
                raise LinkError(f"the answer is longer than {ANSWER_MAX} bytes")
        elif isinstance(event, h11.EndOfMessage):
            return status, text.decode()
