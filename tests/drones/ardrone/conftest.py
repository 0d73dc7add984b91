"""A simulated AR.Drone on its real ports, and a bad radio link in front of it."""

from __future__ import annotations

import asyncio
import contextlib
import random
from collections.abc import AsyncIterator, Awaitable, Callable
from dataclasses import dataclass

import pytest
from kinematic_world import KinematicWorld
from virtual_time import loop_time

from housefly.config.drone import DroneConfig
from housefly.config.limits import LimitsConfig
from housefly.drones.ardrone.driver import ArDrone
from housefly.messages import LEVEL, Action, Command, Setpoint
from housefly.twin.ardrone.server import ArDroneServer

UDP_PORTS = (5554, 5556)
TCP_PORTS = (5555, 5559)
Address = tuple[str, int]
SEND_PERIOD = 0.01


class RadioLink:
    """Stands at one address and passes everything on to the drone at another; loses, repeats and
    delays as told.

    Attributes:
        loss: share of UDP datagrams lost, both ways.
        duplicates: share of UDP datagrams that arrive twice.
        delay: largest extra delay of a UDP datagram [s]; drawn anew for each, so that they overtake
            each other.
        up, down: whether anything passes towards the drone, and from it.
        swallows: commands that hold these bytes are lost.
        commands: the datagrams that came for the drone's port 5556.
        drone: address of the drone behind.
        clients: who spoke last to each UDP port.
    """

    def __init__(self, here: str, drone: str) -> None:
        self.loss = 0.0
        self.duplicates = 0.0
        self.delay = 0.0
        self.up = self.down = True
        self.swallows: bytes | None = None
        self.commands: list[bytes] = []
        self.drone = drone
        self.clients: dict[int, Address] = {}
        self._here = here
        self._sockets: dict[int, asyncio.DatagramTransport] = {}
        self._chance = random.Random(1)
        self._open: list[asyncio.BaseTransport | asyncio.Server] = []
        self._pipes: set[asyncio.Task[None]] = set()

    async def start(self) -> None:
        for port in UDP_PORTS:
            await self._relay_udp(port)
        for port in TCP_PORTS:
            serve: Callable[[asyncio.StreamReader, asyncio.StreamWriter], Awaitable[None]] = (
                self._tcp_relay(port)
            )
            self._open.append(await asyncio.start_server(serve, self._here, port))

    async def stop(self) -> None:
        for thing in self._open:
            thing.close()
        for pipe in tuple(self._pipes):
            pipe.cancel()
        await asyncio.gather(*self._pipes, return_exceptions=True)

    async def _relay_udp(self, port: int) -> None:
        loop = asyncio.get_running_loop()

        def from_client(data: bytes, address: Address) -> None:
            self.clients[port] = address
            if port == 5556 and self.up:
                self.commands.append(data)
            is_lost = self.swallows is not None and self.swallows in data
            self._pass(self.up and not is_lost, lambda: outside.sendto(data))

        def from_drone(data: bytes, address: Address) -> None:
            if port in self.clients:
                self._pass(self.down, lambda: inside.sendto(data, self.clients[port]))

        outside, _ = await loop.create_datagram_endpoint(
            lambda: _Ear(from_drone), remote_addr=(self.drone, port)
        )
        inside, _ = await loop.create_datagram_endpoint(
            lambda: _Ear(from_client), local_addr=(self._here, port)
        )
        self._open += (outside, inside)
        self._sockets[port] = inside

    def say(self, port: int, data: bytes) -> None:
        """Send something to the client of a port as if the drone had."""
        self._sockets[port].sendto(data, self.clients[port])

    def cut_connections(self) -> None:
        """Break every TCP connection."""
        for pipe in tuple(self._pipes):
            pipe.cancel()

    def _pass(self, is_on: bool, send: Callable[[], None]) -> None:
        if not is_on or self._chance.random() < self.loss:
            return
        for _ in range(2 if self._chance.random() < self.duplicates else 1):
            asyncio.get_running_loop().call_later(self._chance.random() * self.delay, send)

    def _tcp_relay(
        self, port: int
    ) -> Callable[[asyncio.StreamReader, asyncio.StreamWriter], Awaitable[None]]:
        async def relay(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
            task = asyncio.current_task()
            assert task is not None
            self._pipes.add(task)
            drone_reader, drone_writer = await asyncio.open_connection(self.drone, port)
            try:
                while data := await drone_reader.read(65536):
                    if self.down:
                        writer.write(data)
                        await writer.drain()
            except (ConnectionError, asyncio.CancelledError):
                pass  # cut, or somebody went away
            finally:
                drone_writer.transport.abort()
                writer.transport.abort()
                self._pipes.discard(task)

        return relay


class _Ear(asyncio.DatagramProtocol):
    def __init__(self, hear: Callable[[bytes, Address], None]) -> None:
        self._hear = hear

    def datagram_received(self, data: bytes, addr: Address) -> None:
        self._hear(data, addr)


@dataclass
class Flight:
    """A drone with somebody at the sticks who sends the same command 100 times a second."""

    drone: ArDrone
    world: KinematicWorld
    server: ArDroneServer
    radio: RadioLink

    async def hold(self, action: Action, setpoint: Setpoint = LEVEL, *, seconds: float) -> None:
        """Send a command for at least this time, and as often as that time has hundredths.

        A machine that stands still for a while takes nothing from what was sent.
        """
        end = loop_time() + seconds
        sent = 0
        while sent < seconds / SEND_PERIOD or loop_time() < end:
            self.drone.send(Command(action, setpoint))
            sent += 1
            await asyncio.sleep(SEND_PERIOD)

    async def until(
        self,
        holds: Callable[[], bool],
        action: Action,
        setpoint: Setpoint = LEVEL,
        *,
        seconds: float = 20.0,
    ) -> None:
        """Send a command until something holds; fail after this time."""
        end = loop_time() + seconds
        while not holds():
            assert loop_time() < end, f"not reached within {seconds} s: {self.drone.telemetry}"
            self.drone.send(Command(action, setpoint))
            await asyncio.sleep(SEND_PERIOD)

    async def silence(self, seconds: float) -> None:
        """Say nothing to the driver for some time, as a pilot that has died."""
        await asyncio.sleep(seconds)


@pytest.fixture
async def world() -> AsyncIterator[KinematicWorld]:
    """A world without physics that moves in real time."""
    moving = KinematicWorld()

    async def move() -> None:
        last = loop_time()
        while True:
            await asyncio.sleep(0.005)
            now = loop_time()
            moving.advance(now - last)
            last = now

    task = asyncio.create_task(move())
    yield moving
    task.cancel()
    with contextlib.suppress(asyncio.CancelledError):
        await task


@pytest.fixture
async def flight(world: KinematicWorld, loopback: str) -> AsyncIterator[Flight]:
    """A drone in that world behind a radio link, and our driver, not yet connected."""
    a, b, c, d = loopback.split(".")
    behind = f"{a}.{b}.{(int(c) + 128) % 256}.{d}"
    server, radio = ArDroneServer(world, behind), RadioLink(loopback, behind)
    drone = ArDrone(DroneConfig(address=loopback), LimitsConfig())
    await server.start()
    await radio.start()
    yield Flight(drone, world, server, radio)
    await drone.close()
    await radio.stop()
    await server.stop()
