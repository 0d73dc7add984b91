"""The simulated autopilot on its ports: UDP and TCP of one address, several clients at once."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Any, cast

from housefly.bus.rate import Rate
from housefly.config.process_log import log_traceback
from housefly.errors import LinkError, WireError
from housefly.twin.address import check_address
from housefly.twin.contracts import TwinDrone
from housefly.twin.link_filters import UNFILTERED, LinkFilters
from housefly.twin.mavlink.tellings import TELLINGS, USUAL_RATES
from housefly.twin.mavlink.vehicle import MavlinkVehicle
from housefly.wires.mavlink.dialect import dialect
from housefly.wires.mavlink.framing import FrameReader, FrameWriter
from housefly.wires.mavlink.reports import Result
from housefly.wires.mavlink.requests import CommandId

_SYSTEM, _COMPONENT = 1, 1
_STEP_HZ = 100.0
_CLIENTS_MAX = 8
_FORGOTTEN_AFTER = 60.0
_BACKLOG_MAX = 65_536
_RATE_MAX_HZ = 100.0


class MavlinkClient:
    """One ground station: what it sends, and what it wants to be told how often.

    Args:
        vehicle: whom it talks to.
        deliver: sends it bytes.
    """

    def __init__(self, vehicle: MavlinkVehicle, deliver: Callable[[bytes], None]) -> None:
        self.heard_at = vehicle.drone.now
        self._vehicle, self._deliver = vehicle, deliver
        self._reader = FrameReader()
        self._writer = FrameWriter(_SYSTEM, _COMPONENT)
        self._periods = {number: 1.0 / rate for number, rate in USUAL_RATES.items()}
        self._due_at: dict[int, float] = {}

    @property
    def broken(self) -> int:
        """How many pieces were no message, or were refused."""
        return self._reader.broken

    def hear(self, data: bytes) -> None:
        """Obey the next bytes, and answer."""
        self.heard_at = self._vehicle.drone.now
        for message in self._reader.feed(data):
            try:
                answers = self._own(message)
                self.tell(self._vehicle.hear(message) if answers is None else answers)
            except WireError as error:
                self._reader.refuse(error)

    def tell(self, messages: list[Any]) -> None:
        """Send messages."""
        if messages:
            self._deliver(b"".join(map(self._writer.packed, messages)))

    def stream(self) -> None:
        """Send what is due now."""
        now, due = self._vehicle.drone.now, []
        for number, period in self._periods.items():
            if now >= self._due_at.get(number, float("-inf")) - 1e-6:
                self._due_at[number] = max(now, self._due_at.get(number, now) + period)
                due.append(TELLINGS[number](self._vehicle))
        self.tell(due)

    def _own(self, message: Any) -> list[Any] | None:
        """Return the answer to what is about this client alone, None for anything else."""
        if message.get_type() != "COMMAND_LONG":
            return None
        number = int(message.param1) if 0.0 <= message.param1 < 1e6 else -1
        match message.command:
            case CommandId.REQUEST:
                return self._requested(message, number)
            case CommandId.SET_RATE:
                return [self._acknowledged(message, self._set_rate(number, message.param2))]
        return None

    def _requested(self, message: Any, number: int) -> list[Any]:
        if number == 49 and self._vehicle.has_origin:
            origin = dialect().MAVLink_gps_global_origin_message(450000000, 70000000, 0, 0)
            return [self._acknowledged(message, Result.ACCEPTED), origin]
        if number not in TELLINGS:
            return [self._acknowledged(message, Result.DENIED)]
        return [self._acknowledged(message, Result.ACCEPTED), TELLINGS[number](self._vehicle)]

    def _set_rate(self, number: int, period_us: float) -> Result:
        if number not in TELLINGS or not -1.0 <= period_us < 1e9:
            return Result.DENIED
        if period_us < 0.0:
            self._periods.pop(number, None)
        else:
            usual = 1.0 / USUAL_RATES.get(number, 1.0)
            self._periods[number] = max(period_us / 1e6, 1.0 / _RATE_MAX_HZ) if period_us else usual
            self._due_at.pop(number, None)
        return Result.ACCEPTED

    def _acknowledged(self, message: Any, result: Result) -> Any:
        sender = message.get_srcSystem(), message.get_srcComponent()
        return dialect().MAVLink_command_ack_message(message.command, int(result), 0, 0, *sender)


class MavlinkServer:
    """Serves one simulated drone as a MAVLink vehicle; all calls belong to one asyncio loop.

    Args:
        drone: what flies.
        address: IP address whose ports are taken.
        beyond_loopback: allow an address that other machines can reach.
        filters: what stands between a client and the drone.

    Attributes:
        model: a row of ``AUTOPILOTS``.
        vehicle: the autopilot.

    Raises:
        ConfigError: an address that is not loopback, without ``beyond_loopback``.
    """

    model = "arducopter"

    def __init__(
        self,
        drone: TwinDrone,
        address: str = "127.0.0.1",
        *,
        beyond_loopback: bool = False,
        filters: LinkFilters = UNFILTERED,
    ) -> None:
        check_address("drone.address", address, beyond_loopback)
        self._address, self._filters = address, filters
        self.vehicle = MavlinkVehicle(drone, self.model)
        self.vehicle.reported = filters.reported
        self._clients: dict[Any, MavlinkClient] = {}
        self._uplinks: dict[Any, Callable[[bytes], None]] = {}
        self._udp: asyncio.DatagramTransport | None = None
        self._tcp: asyncio.Server | None = None
        self._stepping: asyncio.Task[None] | None = None

    @property
    def clients(self) -> int:
        """How many ground stations talk to it."""
        return len(self._clients)

    @property
    def broken(self) -> int:
        """How many pieces of what came were no message, or were refused."""
        return sum(client.broken for client in self._clients.values())

    async def start(self) -> None:
        """Open the ports; raises LinkError when one cannot be had."""
        loop, autopilot = asyncio.get_running_loop(), self.vehicle.autopilot
        try:
            self._udp, _ = await loop.create_datagram_endpoint(
                lambda: _UdpPort(self), (self._address, autopilot.udp_port)
            )
            self._tcp = await loop.create_server(
                lambda: _TcpClient(self), self._address, autopilot.tcp_port
            )
        except OSError as error:
            await self.stop()
            raise LinkError(
                f"cannot serve a {autopilot.name} at {self._address}: {error.strerror or error}"
            ) from error
        if autopilot.own_port:
            self.client_at((self._address, autopilot.own_port)).heard_at = float("inf")
        self._stepping = asyncio.create_task(self._run(), name="simulated autopilot")

    async def stop(self) -> None:
        """Close the ports and every connection."""
        if self._stepping is not None:
            self._stepping.cancel()
            await asyncio.gather(self._stepping, return_exceptions=True)
        if self._udp is not None:
            self._udp.abort()
        if self._tcp is not None:
            self._tcp.close()
        for client in tuple(self._clients):
            if isinstance(client, _TcpClient):
                client.close()

    def client_at(self, place: Any) -> MavlinkClient:
        """Return the ground station at a UDP address, one that is new included."""
        client = self._clients.get(place)
        if client is None:

            def deliver(data: bytes) -> None:
                if self._udp is not None:
                    self._udp.sendto(data, place)

            client = self.admit(place, deliver)
        return client

    def admit(self, place: Any, deliver: Callable[[bytes], None]) -> MavlinkClient:
        """Take a new ground station; where there are too many, the longest silent one goes."""
        if len(self._clients) >= _CLIENTS_MAX:
            silent = min(self._clients, key=lambda one: self._clients[one].heard_at)
            self.dismiss(silent)
        client = MavlinkClient(self.vehicle, self._filters.downlink(deliver))
        self._clients[place] = client
        self._uplinks[place] = self._filters.uplink(client.hear)
        return client

    def dismiss(self, place: Any) -> None:
        """Forget a ground station."""
        self._clients.pop(place, None)
        self._uplinks.pop(place, None)

    def heard(self, place: Any, data: bytes) -> None:
        """Take in bytes of a ground station."""
        if place in self._uplinks:
            self._uplinks[place](data)

    async def _run(self) -> None:
        rate = Rate(_STEP_HZ)
        while True:
            await rate.sleep()
            try:
                self._step()
            except Exception:
                log_traceback()

    def _step(self) -> None:
        said, now = self.vehicle.step(), self.vehicle.drone.now
        for place, client in tuple(self._clients.items()):
            if now - client.heard_at > _FORGOTTEN_AFTER:
                self.dismiss(place)
                continue
            client.tell(said)
            client.stream()


class Px4Server(MavlinkServer):
    """The same with PX4 on board."""

    model = "px4"


class _UdpPort(asyncio.DatagramProtocol):
    """The UDP port: each address is a ground station."""

    def __init__(self, server: MavlinkServer) -> None:
        self._server = server

    def datagram_received(self, data: bytes, addr: Any) -> None:
        self._server.client_at(addr)
        self._server.heard(addr, data)

    def error_received(self, exc: Exception) -> None:
        """Ignore that a ground station is gone: it is forgotten later."""


class _TcpClient(asyncio.Protocol):
    """One connection."""

    def __init__(self, server: MavlinkServer) -> None:
        self._server = server
        self._transport: asyncio.Transport | None = None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        self._transport = cast(asyncio.Transport, transport)
        self._server.admit(self, self._send)

    def connection_lost(self, exc: Exception | None) -> None:
        self._transport = None
        self._server.dismiss(self)

    def data_received(self, data: bytes) -> None:
        self._server.heard(self, data)

    def close(self) -> None:
        if self._transport is not None:
            self._transport.abort()

    def _send(self, data: bytes) -> None:
        link = self._transport
        if link is not None and link.get_write_buffer_size() <= _BACKLOG_MAX:
            link.write(data)
