"""The drone's real ports with faults on them."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager

import pytest

from housefly.clock import RealClock
from housefly.config.site import Site, changed
from housefly.errors import WireError
from housefly.geometry import quaternion_from_euler, wrap_angle
from housefly.messages import Pose
from housefly.room.model import Room
from housefly.twin.ardrone.server import ArDroneServer
from housefly.twin.camera.process import CameraProcess
from housefly.twin.contracts import EncodedPicture
from housefly.twin.faults.injector import FaultInjector
from housefly.twin.faults.vocabulary import Injection
from housefly.twin.faults.wire_link import faulty_links, faulty_pictures
from housefly.twin.process import Twin
from housefly.twin.real_time import RealTimeRunner
from housefly.twin.world import SimulatedWorld
from housefly.wires.ardrone import at
from housefly.wires.ardrone.navdata import NAVDATA_PORT, REQUEST_UNICAST, decode_navdata

pytestmark = pytest.mark.wire


@asynccontextmanager
async def serving(
    room: Room, address: str, *faults: str
) -> AsyncIterator[tuple[SimulatedWorld, ArDroneServer]]:
    site = changed(Site(), faults=[{"fault": fault} for fault in faults])
    world, injector = SimulatedWorld(site, room), FaultInjector(site, Injection.WIRES)
    server = ArDroneServer(world, address, filters=faulty_links(injector, lambda: world.now))
    running = asyncio.create_task(RealTimeRunner(world, RealClock()).run())
    await server.start()
    try:
        yield world, server
    finally:
        await server.stop()
        running.cancel()
        await asyncio.gather(running, return_exceptions=True)


async def navdata(address: str, count: int, patience: float) -> list[bytes]:
    """Return what the drone sends to one who asks for it, at most so many within so long [s]."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as own:
        own.setblocking(False)
        own.sendto(REQUEST_UNICAST, (address, NAVDATA_PORT))
        packets: list[bytes] = []
        loop = asyncio.get_running_loop()
        end = loop.time() + patience
        while len(packets) < count and (left := end - loop.time()) > 0.0:
            try:
                packets.append(await asyncio.wait_for(loop.sock_recv(own, 4096), left))
            except TimeoutError:
                break
        return packets


def readable(packets: list[bytes]) -> int:
    good = 0
    for packet in packets:
        try:
            decode_navdata(packet)
            good += 1
        except WireError:
            pass
    return good


async def test_reports_stop_come_late_or_are_noise(
    make_room: Callable[..., Room], loopback: str
) -> None:
    async with serving(make_room(), loopback):
        assert readable(await navdata(loopback, 5, 20.0)) == 5
    async with serving(make_room(), loopback, "telemetry:garbage"):
        noise = await navdata(loopback, 5, 20.0)
        assert (len(noise), readable(noise)) == (5, 0)
    async with serving(make_room(), loopback, "telemetry:off"):
        assert await navdata(loopback, 1, 0.5) == []
    async with serving(make_room(), loopback, "telemetry:delayed=1") as (world, _):
        assert readable(await navdata(loopback, 1, 20.0)) == 1
        assert world.now > 1.0


async def test_commands_are_lost_late_or_repeated_under_new_numbers(
    make_room: Callable[..., Room], loopback: str
) -> None:
    async def heard(count: Callable[[], int], wanted: int) -> None:
        while count() < wanted:
            await asyncio.sleep(0.02)

    async def send(*commands: at.AtCommand) -> None:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as own:
            for number, command in enumerate(commands):
                datagram = at.encode_datagram(1 + 10 * number, (command,))
                own.sendto(datagram, (loopback, at.COMMAND_PORT))
                await asyncio.sleep(0.05)

    rise, rest = at.Ref(at.RefBits.TAKE_OFF), at.ComWatchdog()
    async with serving(make_room(), loopback, "commands:off") as (_, server):
        await send(rise, rise)
        assert server.counters.datagrams == 0
    async with serving(make_room(), loopback, "commands:garbage") as (_, server):
        await send(rise, rise)
        await heard(lambda: server.counters.datagrams, 2)
        assert server.counters.commands == 0
    async with serving(make_room(), loopback, "commands:delayed=0.4") as (world, server):
        began = world.now
        await send(rise)
        await heard(lambda: server.counters.commands, 1)
        assert world.now > began + 0.3
    async with serving(make_room(), loopback, "commands:stuck") as (world, server):
        await send(rest, rise, rise)
        await heard(lambda: server.counters.commands, 3)
        assert server.counters.stale_commands == 0
        assert not world.onboard().flight.airborne


def test_commands_of_a_wire_without_such_numbers_are_repeated_as_they_were() -> None:
    site = changed(Site(), faults=[{"fault": "commands:stuck"}])
    heard: list[bytes] = []
    send = faulty_links(FaultInjector(site, Injection.WIRES), lambda: 1.0).uplink(heard.append)
    for datagram in (b"rc 0 0 0 0", b"rc 0 40 0 0", b"\xfd\x09\x00"):
        send(datagram)
    assert heard == [b"rc 0 0 0 0"] * 3


def test_pictures_are_passed_on_as_the_faults_have_it() -> None:
    site = changed(Site(), faults=[{"fault": "video:off@1s"}])
    injector, shown, now = FaultInjector(site, Injection.WIRES), [], [0.0]
    publish = faulty_pictures(injector, lambda: now[0], shown.append)
    picture = EncodedPicture(1, b"data", True, 8, 8, 0.0)
    publish(picture)
    now[0] = 1.0
    publish(picture)
    assert shown == [picture]


def test_late_pictures_come_late_in_order_and_with_true_stamps() -> None:
    site = changed(Site(), faults=[{"fault": "video:delayed@1s=0.5"}])
    injector, now = FaultInjector(site, Injection.WIRES), [0.0]
    shown: list[tuple[float, float]] = []
    publish = faulty_pictures(injector, lambda: now[0], lambda p: shown.append((now[0], p.at)))
    for number in range(30):
        now[0] = 0.1 * number
        publish(EncodedPicture(number, b"data", True, 8, 8, now[0]))
    assert [at for _, at in shown] == [0.1 * number for number in range(25)]
    assert all(now - at == pytest.approx(0.0 if at < 0.95 else 0.5) for now, at in shown)


def test_a_slow_camera_takes_fewer_pictures_and_what_it_took_all_arrives() -> None:
    injector = FaultInjector(changed(Site(), faults=[{"fault": "video:slow=2"}]), Injection.WIRES)
    pose = Pose((1.0, 2.0, 1.0))
    taken = [0.1 * n for n in range(20) if injector.view(pose, 0.1 * n) is not None]
    assert taken == [0.1 * n for n in (0, 5, 10, 15)]
    picture = EncodedPicture(1, b"data", True, 8, 8, 0.0)
    assert [injector.pictures(picture, at + 0.05) for at in taken] == [(picture,)] * 4


@pytest.mark.parametrize("heading", [0.0, 1.0, -3.0])
def test_a_wrong_camera_looks_aside_from_where_the_drone_is(heading: float) -> None:
    site = changed(Site(), faults=[{"fault": "video:wrong@1s=0.5"}])
    injector = FaultInjector(site, Injection.WIRES)
    pose = Pose((1.0, 2.0, 1.0), quaternion_from_euler(0.0, 0.0, heading))
    assert injector.view(pose, 0.9) is pose
    seen = injector.view(pose, 1.0)
    assert seen is not None and seen.position == pose.position
    assert wrap_angle(seen.yaw - heading) == pytest.approx(0.5)


async def test_the_twin_films_as_the_faults_have_it(
    make_room: Callable[..., Room], loopback: str
) -> None:
    class Film(CameraProcess):
        def __init__(self, *about: object) -> None:
            self.poses: list[Pose] = []
            self.restarts = 0

        problem = ""

        def request_picture(self, pose: Pose, *rest: object, **more: object) -> None:
            self.poses.append(pose)

    async def filmed(*faults: str) -> list[Pose]:
        site = changed(
            Site(), faults=[{"fault": fault} for fault in faults], drone__address=loopback
        )
        film, twin = Film(), Twin(site, make_room())
        with pytest.raises(TimeoutError):
            served = twin._drones[0]
            assert served._filmed is not None
            await asyncio.wait_for(served._film(film, served._filmed), 0.6)
        return film.poses

    true, (slow, *others), (aside, *_) = (
        await filmed(), await filmed("video:slow=0.2"), await filmed("video:wrong=0.5"),
    )  # fmt: skip
    assert len(true) > 3 and others == [] and slow == true[0]
    assert wrap_angle(aside.yaw - true[0].yaw) == pytest.approx(0.5)
