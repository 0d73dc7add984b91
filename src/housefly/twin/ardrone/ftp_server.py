"""TCP 21 and 5551 of the simulated drone: FTP with one file, ``version.txt``.

Clients look there for the firmware's version, or whether a drone is there at all, and wait for
ever where nobody answers. Commands: RFC 959, as much as is needed to read one file passively.
"""

from __future__ import annotations

import asyncio
import contextlib

from housefly.wires.ardrone.config import default_values

_PORTS = (21, 5551)
_FILE = "version.txt"
_CLIENTS_MAX = 8
_LINE_MAX = 256
_PATIENCE = 30.0
"""A client that says nothing for so long is sent away [s]."""
_ANSWERS = {
    "USER": "331 any password",
    "PASS": "230 logged in",
    "SYST": "215 UNIX Type: L8",
    "TYPE": "200 binary",
    "MODE": "200 stream",
    "STRU": "200 file",
    "NOOP": "200 nothing",
    "PWD": '257 "/"',
    "CWD": "250 here",
}


class FtpServer:
    """Serves the firmware's version to a few clients.

    Port 21 is left out where this user may not open it.
    """

    def __init__(self) -> None:
        self._content = f"{default_values()['general:num_version_soft']}\n".encode()
        self._servers: list[asyncio.Server] = []
        self._sessions: set[asyncio.Task[None]] = set()

    async def start(self, address: str) -> None:
        """Listen; raises OSError when port 5551 is taken."""
        for port in _PORTS:
            try:
                server = await asyncio.start_server(self._accept, address, port, limit=_LINE_MAX)
            except OSError:
                if port == _PORTS[-1]:
                    raise
            else:
                self._servers.append(server)

    async def stop(self) -> None:
        """Close the ports and every session."""
        for server in self._servers:
            server.close()
        for session in tuple(self._sessions):
            session.cancel()
        await asyncio.gather(*self._sessions, return_exceptions=True)

    async def _accept(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        session = asyncio.current_task()
        if session is None or len(self._sessions) >= _CLIENTS_MAX:
            writer.close()
            return
        self._sessions.add(session)
        try:
            with contextlib.suppress(OSError, TimeoutError, ValueError):
                await _Session(self._content, reader, writer).run()
        finally:
            self._sessions.discard(session)
            writer.close()


class _Session:
    def __init__(
        self, content: bytes, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        self._content, self._reader, self._writer = content, reader, writer
        self._data: asyncio.Server | None = None
        self._peer: asyncio.Future[asyncio.StreamWriter] | None = None

    async def run(self) -> None:
        """Answer commands until QUIT; raises ValueError for a line without end."""
        try:
            await self._say("220 AR.Drone")
            while True:
                async with asyncio.timeout(_PATIENCE):
                    line = await self._reader.readline()
                verb, _, rest = line.decode("ascii", "replace").strip().partition(" ")
                if not line or verb.upper() == "QUIT":
                    await self._say("221 bye")
                    return
                await self._say(await self._answer(verb.upper(), rest))
        finally:
            self._close_data()

    async def _answer(self, verb: str, rest: str) -> str:
        match verb:
            case "PASV" | "EPSV":
                return await self._listen(verb)
            case "SIZE" if rest.lstrip("/") == _FILE:
                return f"213 {len(self._content)}"
            case "RETR" if rest.lstrip("/") == _FILE:
                return await self._send(self._content)
            case "LIST" | "NLST":
                return await self._send(f"{_FILE}\r\n".encode())
            case "SIZE" | "RETR":
                return f"550 there is only {_FILE}"
        return _ANSWERS.get(verb, "502 not here")

    async def _listen(self, verb: str) -> str:
        self._close_data()
        peer: asyncio.Future[asyncio.StreamWriter] = asyncio.get_running_loop().create_future()

        def connected(_: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
            if peer.done():
                writer.close()
            else:
                peer.set_result(writer)

        host = self._writer.get_extra_info("sockname")[0]
        self._data, self._peer = await asyncio.start_server(connected, host, 0), peer
        port = self._data.sockets[0].getsockname()[1]
        if verb == "EPSV":
            return f"229 passive (|||{port}|)"
        return f"227 passive ({host.replace('.', ',')},{port >> 8},{port & 255})"

    async def _send(self, content: bytes) -> str:
        if self._peer is None:
            return "425 PASV first"
        await self._say("150 it comes")
        async with asyncio.timeout(_PATIENCE):
            writer = await self._peer
        writer.write(content)
        await writer.drain()
        self._close_data()
        return "226 that was all"

    def _close_data(self) -> None:
        if self._data is not None and self._peer is not None:
            self._data.close()
            if self._peer.done() and not self._peer.cancelled():
                self._peer.result().close()
            self._peer.cancel()
        self._data = self._peer = None

    async def _say(self, words: str) -> None:
        self._writer.write(f"{words}\r\n".encode("ascii"))
        await self._writer.drain()
