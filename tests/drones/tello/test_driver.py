"""The driver against the simulated Tello in real time, on the same ports."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from math import hypot

import pytest
import pytest_asyncio

pytest.importorskip("mujoco")

from tello_ports import tello_ports
from virtual_time import loop_time

from housefly.clock import RealClock
from housefly.config.limits import LimitsConfig
from housefly.config.site import Site, changed
from housefly.drones.tello import driver, sockets
from housefly.drones.tello.driver import Tello
from housefly.drones.tello.sockets import local_address, open_socket
from housefly.errors import LinkError
from housefly.messages import Action, Command, DroneStatus, VelocitySetpoint, VideoFrame
from housefly.messages.steering import flying
from housefly.room.model import Place, Room
from housefly.twin.contracts import EncodedPicture, FlightState
from housefly.twin.real_time import RealTimeRunner
from housefly.twin.tello.server import TelloServer
from housefly.twin.world import SimulatedWorld
from housefly.wires.tello.lines import STATE_PORT
from housefly.wires.tello.state import TelloState, encode_state

pytestmark = [pytest.mark.wire, pytest.mark.virtual_time, pytest.mark.slow]

HALL = Room(
    "hall",
    (0.0, 0.0, 12.0, 5.0),
    2.6,
    (),
    (Place("home", (2.0, 2.5), (3.0, 2.5, 1.0)),),
    (),
    (2.0, 2.5),
    0.0,
    None,
)
KEY = b"\0\0\0\1\x67sps\0\0\0\1\x68pps\0\0\0\1\x65" + b"\x99" * 3000
SLICE = b"\0\0\0\1\x41" + b"\x99" * 800


class Flight:
    """A driver, and the drone at the other end of its wire."""

    def __init__(self, world: SimulatedWorld, server: TelloServer, drone: Tello) -> None:
        self.world, self.server, self.drone = world, server, drone

    async def until(
        self, holds: Callable[[], bool], command: Command | None = None, patience: float = 15.0
    ) -> None:
        """Say a command a hundred times a second until something holds."""
        end = loop_time() + patience
        while not holds():
            assert loop_time() < end, f"{command}: {self.drone.telemetry}"
            if command is not None:
                self.drone.send(command)
            await asyncio.sleep(0.01)

    def says(self, status: DroneStatus) -> Callable[[], bool]:
        return lambda: self.drone.telemetry is not None and self.drone.telemetry.status is status

    def is_(self, *flights: FlightState) -> Callable[[], bool]:
        return lambda: self.world.onboard().flight in flights

    @property
    def speed(self) -> float:
        return hypot(*self.world.truth().velocity[:2])

    async def in_the_air(self) -> None:
        await self.drone.connect()
        await self.until(self.says(DroneStatus.FLYING), Command(Action.TAKE_OFF))


def made(loopback: str) -> Tello:
    site = changed(Site(), drone__kind="tello", drone__address=loopback)
    return Tello(site.drone, LimitsConfig())


@pytest_asyncio.fixture
async def flight(loopback: str) -> AsyncIterator[Flight]:
    """An empty hall that moves in real time."""
    world = SimulatedWorld(changed(Site(), drone__kind="tello"), HALL)

    async def move() -> None:
        last = loop_time()
        while True:
            await asyncio.sleep(0.005)
            now = loop_time()
            world.advance(min(0.1, now - last))
            last = now

    with tello_ports():
        server, drone = TelloServer(world, loopback), made(loopback)
        await server.start()
        task = asyncio.create_task(move())
        yield Flight(world, server, drone)
        await drone.close()
        task.cancel()
        await server.stop()


async def test_take_off_fly_hover_film_land_cut_and_reset(flight: Flight) -> None:
    seen: list[VideoFrame] = []
    drone, world = flight.drone, flight.world
    drone.on_video(seen.append)
    await flight.in_the_air()
    assert drone.telemetry is not None and drone.telemetry.configured
    assert drone.telemetry.height == pytest.approx(world.truth().pose.position[2], abs=0.15)
    assert 7 <= drone.telemetry_rate_hz <= 12 and drone.firmware == "SDK 20"

    start = world.truth().pose.position[0]
    ahead = flying(VelocitySetpoint(forward=0.5))
    await flight.until(lambda: world.truth().pose.position[0] > start + 1.0, ahead)
    assert flight.speed == pytest.approx(0.5, abs=0.12)
    await flight.until(lambda: flight.speed < 0.08, Command(Action.HOVER))

    for number, data in enumerate((SLICE, KEY, SLICE, SLICE)):
        flight.server.publish(EncodedPicture(number, data, data is KEY, 960, 720, world.now))
        await asyncio.sleep(0.02)
    assert [frame.data for frame in seen] == [KEY, SLICE, SLICE], "from the key frame on"
    assert (seen[0].keyframe, seen[0].width, seen[0].height) == (True, 960, 720)
    assert drone.video_connected and drone.notes == ()

    await flight.until(flight.says(DroneStatus.LANDED), Command(Action.LAND))
    assert world.onboard().flight is FlightState.LANDED
    await flight.until(flight.says(DroneStatus.EMERGENCY), Command(Action.CUT))
    await flight.until(flight.says(DroneStatus.LANDED), Command(Action.RESET))
    assert flight.server.counters.malformed == 0


async def test_an_order_to_land_in_the_take_off_is_obeyed_once_it_can_be(flight: Flight) -> None:
    await flight.drone.connect()
    taking_off = flight.says(DroneStatus.TAKING_OFF)
    await flight.until(taking_off, Command(Action.TAKE_OFF))
    await flight.until(flight.is_(FlightState.LANDED), Command(Action.LAND), 25.0)
    await flight.until(flight.says(DroneStatus.LANDED), Command(Action.LAND))


async def test_a_new_driver_stops_a_drone_that_an_old_one_left_flying(flight: Flight) -> None:
    await flight.in_the_air()
    ahead = flying(VelocitySetpoint(forward=0.5))
    await flight.until(lambda: flight.speed > 0.4, ahead)
    # what a driver leaves that is killed: no order to land, and the last sticks
    flight.drone._tasks["repeat commands"].cancel()
    await flight.drone.close()
    await asyncio.sleep(0.5)
    assert flight.speed > 0.4, "the last sticks hold"
    second = made(flight.server._address)
    flight.drone = second
    await second.connect()
    await flight.until(lambda: flight.speed < 0.1)
    await flight.until(lambda: bool(second.notes), ahead)
    assert "it only hovers and lands" in second.problem
    await flight.until(flight.is_(FlightState.LANDED), ahead, 20.0)


async def test_a_drone_that_was_switched_off_and_on_is_greeted_again(flight: Flight) -> None:
    await flight.drone.connect()
    await flight.server.stop()
    await flight.until(lambda: not flight.drone.connected)
    flight.server = TelloServer(flight.world, flight.server._address)
    await flight.server.start()
    await flight.until(lambda: flight.drone.connected)


async def test_a_new_address_of_ours_in_the_drones_wifi_is_followed(
    flight: Flight, loopback: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    other = f"{loopback.rpartition('.')[0]}.253"
    monkeypatch.setattr(sockets, "local_address", lambda drone: other)
    monkeypatch.setattr(driver, "local_address", lambda drone: other)
    await flight.drone.connect()
    assert flight.drone._ours == other
    await flight.server.stop()
    monkeypatch.undo()
    await flight.until(lambda: flight.drone._ours == loopback)
    flight.server = TelloServer(flight.world, loopback)
    await flight.server.start()
    await flight.until(lambda: flight.drone.connected)


async def test_two_on_one_machine_are_told_apart_and_nobody_else_is_heard(
    flight: Flight, loopback: str
) -> None:
    other = f"{loopback.rpartition('.')[0]}.254"
    world = SimulatedWorld(changed(Site(), drone__kind="tello", twin__battery=0.6), HALL)
    server, drone = TelloServer(world, other), made(other)
    await server.start()
    moving = asyncio.create_task(RealTimeRunner(world, RealClock()).run())
    try:
        await flight.drone.connect()
        await drone.connect()
        assert flight.drone.telemetry is not None and drone.telemetry is not None
        assert (flight.drone.telemetry.battery, drone.telemetry.battery) == (1.0, 0.6)
        loop = asyncio.get_running_loop()
        stranger, _ = await loop.create_datagram_endpoint(
            asyncio.DatagramProtocol, local_addr=(other, 0), remote_addr=(loopback, STATE_PORT)
        )
        for _ in range(30):
            stranger.sendto(encode_state(TelloState(0, 0, 0, 90, 90, 3, 7)))
            await asyncio.sleep(0.01)
            assert flight.drone.telemetry.battery == 1.0
    finally:
        await drone.close()
        moving.cancel()
        await server.stop()


async def test_nobody_there_and_somebody_else_are_said_in_words(loopback: str) -> None:
    with tello_ports():
        drone = made(loopback)
        with pytest.raises(LinkError, match=r"no drone answers at 127.+:8890 within 3 s"):
            await drone.connect()
        assert "no drone answers" in drone.problem
        loop = asyncio.get_running_loop()
        talk, _ = await loop.create_datagram_endpoint(
            asyncio.DatagramProtocol, local_addr=(loopback, 0), remote_addr=(loopback, STATE_PORT)
        )
        talk.sendto(b"state:unknown")
        with pytest.raises(LinkError, match="is no state of a Tello"):
            await drone.connect()
        await drone.close()


async def test_a_taken_port_and_a_missing_interface_are_said_in_words(loopback: str) -> None:
    with tello_ports():
        first = await open_socket(asyncio.DatagramProtocol(), loopback, "", STATE_PORT)
        with pytest.raises(LinkError, match="cannot open UDP 8890 on this machine"):
            await open_socket(asyncio.DatagramProtocol(), loopback, "", STATE_PORT)
        first.abort()
    with pytest.raises(LinkError, match="cannot open nosuchwlan9"):
        await open_socket(asyncio.DatagramProtocol(), "192.168.10.1", "nosuchwlan9")
    assert local_address(loopback) == loopback
