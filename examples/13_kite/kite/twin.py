"""The other side of the wire: a simulated Kite obeys each line and answers with a report."""

import asyncio
from contextlib import suppress
from typing import cast

from housefly import LinkError, PlainDrone, Pose, TwinDrone, WireError
from kite import wire


class Server(asyncio.DatagramProtocol):
    """Serves a simulated drone at an address."""

    def __init__(self, drone: TwinDrone, address: str) -> None:
        self._drone, self._address = PlainDrone(drone, "kite"), address

    async def start(self) -> None:
        """Open the port."""
        there, loop = (self._address, wire.PORT), asyncio.get_running_loop()
        try:
            await loop.create_datagram_endpoint(lambda: self, there)
        except OSError as error:
            raise LinkError(f"cannot serve a Kite at {there}: {error.strerror}") from error

    async def stop(self) -> None:
        """Close it."""
        self._link.close()

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Answer over this socket."""
        self._link = cast(asyncio.DatagramTransport, transport)

    def datagram_received(self, data: bytes, addr: tuple[str, int]) -> None:
        """Obey, or take in a pose; what is neither is dropped."""
        with suppress(WireError):
            if data.startswith(b"POSE"):
                x, y, z, *turned, age = wire.pose_of(data)
                qw, qx, qy, qz = turned
                self._drone.tell_pose(Pose((x, y, z), (qw, qx, qy, qz)), age)
                return
            self._drone.obey(wire.command_of(data))
            self._link.sendto(wire.report_line(self._drone.report()), addr)
