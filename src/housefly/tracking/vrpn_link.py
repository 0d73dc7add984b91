"""Two ways to a VRPN server: we connect to it, or we ask it by datagram to connect to us."""

from __future__ import annotations

import asyncio

from housefly.errors import LinkError
from housefly.tracking.datagrams import Ear
from housefly.wires.vrpn import encode_lob

Stream = tuple[asyncio.StreamReader, asyncio.StreamWriter]
CONNECT_TIMEOUT = 3.0
"""How long a server may take to be there [s]."""
_LOB_PERIOD = 0.5


async def connect(address: str, port: int) -> Stream:
    """Connect to a server; raises LinkError."""
    try:
        async with asyncio.timeout(CONNECT_TIMEOUT):
            return await asyncio.open_connection(address, port)
    except (OSError, UnicodeError) as error:
        raise LinkError(
            f"nobody answers at {address}:{port} (TCP); is the VRPN server running?"
        ) from error


async def be_connected(address: str, port: int) -> Stream:
    """Ask a server to connect to us, and wait for it; raises LinkError."""
    loop = asyncio.get_running_loop()
    called: asyncio.Future[Stream] = loop.create_future()
    try:
        transport, _ = await loop.create_datagram_endpoint(
            lambda: Ear(lambda data, sender: None), remote_addr=(address, port)
        )
    except (OSError, UnicodeError) as error:
        raise LinkError(f"{address}:{port} cannot be reached ({error})") from error
    host = transport.get_extra_info("sockname")[0]
    server_host = transport.get_extra_info("peername")[0]

    def answered(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        if called.done() or writer.get_extra_info("peername")[0] not in (server_host, host):
            writer.transport.abort()
        else:
            called.set_result((reader, writer))

    listener = await asyncio.start_server(answered, host, 0)
    try:
        own_port = listener.sockets[0].getsockname()[1]
        for _ in range(round(CONNECT_TIMEOUT / _LOB_PERIOD)):
            transport.sendto(encode_lob(host, own_port))
            done, _ = await asyncio.wait([called], timeout=_LOB_PERIOD)
            if done:
                return called.result()
        raise LinkError(
            f"the VRPN server at {address}:{port} (UDP) does not connect back to {host}:{own_port};"
            ' is it running, does the firewall let it in? Or set tracking.vrpn_transport = "tcp"'
        )
    finally:
        listener.close()
        transport.abort()
