"""The sockets towards one Tello: by network interface, or by the address that reaches it.

Every Tello answers at 192.168.10.1 and gives its client the same address, in a Wi-Fi of its own.
So several are told apart by the interface that their sockets are bound to (``drone.interface``);
simulated ones by their loopback addresses. Nothing else is listened to.
"""

from __future__ import annotations

import asyncio
import socket
from contextlib import suppress
from ipaddress import ip_address

from housefly.errors import LinkError

_RECEIVE_BUFFER = 1 << 20
"""Bytes that the kernel may hold: a key frame comes in one burst."""


async def open_socket(
    protocol: asyncio.DatagramProtocol, drone: str, interface: str, port: int = 0
) -> asyncio.DatagramTransport:
    """Bind a socket to what reaches a drone.

    Args:
        protocol: hears what comes.
        drone: its IP address.
        interface: name of a network interface; "" finds it by the address.
        port: of this machine; 0 for any.

    Raises:
        LinkError: no such interface, no way to the address, or the port is taken; says which.
    """
    made = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    try:
        made.setblocking(False)
        made.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, _RECEIVE_BUFFER)
        if interface:
            made.setsockopt(socket.SOL_SOCKET, socket.SO_BINDTODEVICE, interface.encode())
        made.bind(("" if interface else local_address(drone), port))
    except OSError as error:
        made.close()
        where = f"UDP {port} on {interface or 'this machine'}" if port else interface or drone
        raise LinkError(f"cannot open {where}: {error.strerror or error}") from error
    loop = asyncio.get_running_loop()
    transport, _ = await loop.create_datagram_endpoint(lambda: protocol, sock=made)
    return transport


def local_address(drone: str) -> str:
    """Return our address in the drone's network; of a simulated one its own loopback address.

    Raises OSError when nothing leads there.
    """
    with suppress(ValueError):
        if ip_address(drone).is_loopback:
            return drone
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.connect((drone, 9))
        address: str = probe.getsockname()[0]
        return address
