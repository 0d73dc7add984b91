"""Two ways to reach a VRPN server: connect to it, or ask it by datagram to connect back."""

from __future__ import annotations

import asyncio

from housefly.bus.reconnect import TcpStream, open_tcp
from housefly.errors import LinkError
from housefly.tracking.datagrams import DatagramReceiver
from housefly.wires.vrpn import encode_lob

VRPN_TIMEOUT = 3.0
"""How long a server may take to connect, and to send its cookie [s]."""
_REQUEST_PERIOD = 0.5


async def open_directly(address: str, port: int) -> TcpStream:
    """Connect to a server; raises LinkError."""
    complaint = f"nobody answers at {address}:{port} (TCP); is the VRPN server running?"
    return await open_tcp(address, port, VRPN_TIMEOUT, complaint)


async def open_by_datagram(address: str, port: int) -> TcpStream:
    """Ask a server to connect back, and wait for it; raises LinkError."""
    loop = asyncio.get_running_loop()
    connection: asyncio.Future[TcpStream] = loop.create_future()
    try:
        transport, _ = await loop.create_datagram_endpoint(
            lambda: DatagramReceiver(lambda data, sender: None), remote_addr=(address, port)
        )
    except (OSError, UnicodeError) as error:
        raise LinkError(f"{address}:{port} cannot be reached ({error})") from error
    host = transport.get_extra_info("sockname")[0]
    server_host = transport.get_extra_info("peername")[0]

    def connected_back(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        if connection.done() or writer.get_extra_info("peername")[0] not in (server_host, host):
            writer.transport.abort()
        else:
            connection.set_result((reader, writer))

    listener = await asyncio.start_server(connected_back, host, 0)
    try:
        own_port = listener.sockets[0].getsockname()[1]
        for _ in range(round(VRPN_TIMEOUT / _REQUEST_PERIOD)):
            transport.sendto(encode_lob(host, own_port))
            done, _ = await asyncio.wait([connection], timeout=_REQUEST_PERIOD)
            if done:
                return connection.result()
        raise LinkError(
            f"the VRPN server at {address}:{port} (UDP) does not connect back to {host}:{own_port};"
            ' is it running, does the firewall let it in? Or set tracking.vrpn_transport = "tcp"'
        )
    finally:
        listener.close()
        transport.abort()
