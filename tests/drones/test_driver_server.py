"""A pilot and its driver on a real socket, and a simulated drone on its real ports."""

from __future__ import annotations

import asyncio
import contextlib
import os
import socket
from collections.abc import AsyncIterator, Callable
from dataclasses import dataclass
from pathlib import Path

import pytest
from full_disk import full_output
from kinematic_world import KinematicWorld
from virtual_time import loop_time

from housefly.bus.private_socket import is_own_user
from housefly.clock import RealClock
from housefly.config.airframe import airframe_named
from housefly.config.drone import DroneConfig
from housefly.config.limits import LimitsConfig
from housefly.drones import failsafe
from housefly.drones import remote_drone as remote_drone_module
from housefly.drones.ardrone.driver import ArDrone
from housefly.drones.driver_messages import TimedCommand, encode_driver_message
from housefly.drones.driver_server import DriverServer
from housefly.drones.remote_drone import RemoteDrone
from housefly.errors import LinkError
from housefly.messages import LEVEL, Action, Command, DroneStatus, Setpoint, VideoFrame
from housefly.messages.stick import Stick
from housefly.twin.ardrone.server import ArDroneServer

pytestmark = [pytest.mark.wire, pytest.mark.virtual_time]

FORWARD = Setpoint(theta=0.1)


@dataclass
class Bench:
    """A drone, its driver behind a socket, and a pilot."""

    world: KinematicWorld
    address: str
    driver: ArDrone
    server: DriverServer
    serving: asyncio.Task[None]
    pilot: RemoteDrone
    path: Path

    @property
    def status(self) -> DroneStatus | None:
        report = self.pilot.telemetry
        return None if report is None else report.status

    async def until(
        self,
        holds: Callable[[], bool],
        action: Action | None = None,
        setpoint: Setpoint = LEVEL,
        seconds: float = 10.0,
    ) -> None:
        """Send a command a hundred times a second until something holds."""
        end = loop_time() + seconds
        while not holds():
            assert loop_time() < end, f"{self.pilot.telemetry} {self.pilot.problem}"
            if action is not None:
                self.pilot.send(Command(action, setpoint))
            await asyncio.sleep(0.01)

    async def fly(self) -> None:
        """Take off and fly forward."""
        await self.pilot.connect()
        await self.until(lambda: self.status is DroneStatus.FLYING, Action.TAKE_OFF)
        await self.until(lambda: not self.world.asked.hover, Action.FLY, FORWARD)


@pytest.fixture
async def bench(loopback: str, tmp_path: Path) -> AsyncIterator[Bench]:
    world = KinematicWorld()

    async def move() -> None:
        last = loop_time()
        while True:
            await asyncio.sleep(0.005)
            now = loop_time()
            world.advance(now - last)
            last = now

    moving = asyncio.create_task(move())
    drone_server = ArDroneServer(world, loopback)
    await drone_server.start()
    folder = tmp_path / "run"
    folder.mkdir(mode=0o700)
    path = folder / "driver"
    driver = ArDrone(DroneConfig(address=loopback), LimitsConfig())
    server = DriverServer(driver, path, RealClock())
    serving = asyncio.create_task(server.run())
    pilot = RemoteDrone(path)
    yield Bench(world, loopback, driver, server, serving, pilot, path)
    await pilot.close()
    serving.cancel()
    moving.cancel()
    await asyncio.gather(serving, moving, return_exceptions=True)
    await drone_server.stop()


async def test_a_flight_through_the_socket(bench: Bench) -> None:
    await bench.fly()
    assert bench.world.asked.forward == pytest.approx(0.1 / 0.21, rel=1e-3)
    assert bench.pilot.connected and bench.pilot.problem == ""
    report = bench.pilot.telemetry
    assert report is not None and report.configured and report.notes == ()
    assert RealClock().now() - report.received_at < 0.3
    await bench.until(lambda: bench.world.asked.hover, Action.HOVER, seconds=2.0)
    await bench.until(lambda: bench.status is DroneStatus.LANDED, Action.LAND)
    await bench.until(lambda: bench.pilot.telemetry_rate_hz > 50)


async def test_a_drone_whose_greeting_failed_is_greeted_again_although_the_log_takes_no_more(
    bench: Bench, monkeypatch: pytest.MonkeyPatch
) -> None:
    connect, failures = bench.driver.connect, ["float division by zero"]

    async def fail_once() -> None:
        if failures:
            raise ZeroDivisionError(failures.pop())
        await connect()

    monkeypatch.setattr(bench.driver, "connect", fail_once)
    with full_output():
        await bench.pilot.connect()
        await bench.until(lambda: bench.pilot.telemetry is not None)
    assert not failures


async def test_the_light_is_lit_through_the_socket_and_goes_out_when_nobody_says_so(
    bench: Bench,
) -> None:
    await bench.pilot.connect()
    await bench.until(
        lambda: bench.pilot.capabilities == airframe_named("ardrone").capabilities, Action.IDLE
    )
    for _ in range(4):
        bench.pilot.show_recording(True)
        await bench.until(lambda: bench.world.truth().leds == 2, Action.IDLE)
    await bench.until(lambda: bench.world.truth().leds == 6, Action.IDLE)


async def test_pictures_come_through_and_a_pilot_that_does_not_read_delays_no_command(
    bench: Bench,
) -> None:
    pictures: list[VideoFrame] = []
    bench.pilot.on_video(pictures.append)
    await bench.fly()
    frame = VideoFrame(b"x" * 60_000, True, 640, 360, 7, 1.0, 2.0)
    bench.server._on_video(frame)
    await bench.until(lambda: len(pictures) > 0, Action.FLY, FORWARD)
    assert pictures == [frame]
    link = bench.pilot._transport
    assert link is not None
    link.pause_reading()
    for _ in range(300):
        bench.server._on_video(frame)
    before = loop_time()
    await bench.until(lambda: bench.world.asked.hover, Action.HOVER, seconds=3.0)
    assert loop_time() - before < 1.0
    resumed_at = loop_time()
    link.resume_reading()
    await bench.until(
        lambda: (
            bench.pilot.telemetry is not None and bench.pilot.telemetry.received_at > resumed_at
        ),
        Action.HOVER,
    )
    assert len(pictures) < 100, "what nobody reads is thrown away"


async def test_a_pilot_whose_connection_ends_leaves_a_drone_that_hovers_at_once_and_lands(
    bench: Bench, monkeypatch: pytest.MonkeyPatch
) -> None:
    await bench.fly()
    monkeypatch.setattr(failsafe, "HOVER_AFTER", 60.0)  # nobody waits for silence
    await bench.pilot.close()
    end = loop_time() + 1.5
    while not bench.world.asked.hover:
        assert loop_time() < end
        await asyncio.sleep(0.01)
    report = bench.driver.telemetry
    assert report is not None and report.status is DroneStatus.FLYING
    end = loop_time() + 8.0
    while (report := bench.driver.telemetry) and report.status is not DroneStatus.LANDED:
        assert loop_time() < end
        await asyncio.sleep(0.02)


async def test_a_second_pilot_is_turned_away_while_the_first_one_lives(bench: Bench) -> None:
    await bench.fly()
    second = RemoteDrone(bench.path)
    connecting = asyncio.create_task(second.connect())
    flying = asyncio.create_task(bench.until(lambda: connecting.done(), Action.FLY, FORWARD))
    for _ in range(50):
        second.send(Command(Action.CUT))
        await asyncio.sleep(0.01)
    assert bench.status is DroneStatus.FLYING and not second.connected
    connecting.cancel()
    await second.close()
    await asyncio.gather(connecting, flying, return_exceptions=True)


async def test_a_command_that_is_late_or_older_than_a_hover_is_not_flown(bench: Bench) -> None:
    await bench.fly()
    link = bench.pilot._transport
    assert link is not None
    now = RealClock().now()
    for issued_at, action in (
        (now - 0.3, Action.FLY),
        (now, Action.HOVER),
        (now - 0.1, Action.FLY),
        (now - 0.01, Action.FLY),
    ):
        link.write(encode_driver_message(TimedCommand(Command(action, FORWARD), issued_at)))
        await asyncio.sleep(0.01)
    async with asyncio.timeout(10.0):
        while not bench.world.asked.hover:  # as soon as a busy machine comes to it
            await asyncio.sleep(0.01)
    for _ in range(20):
        await asyncio.sleep(0.01)
        assert bench.world.asked.hover


async def test_a_hover_is_obeyed_also_when_a_setpoint_follows_in_the_same_read(
    bench: Bench,
) -> None:
    await bench.fly()
    seen: list[Stick] = []
    set_stick = bench.world.set_stick
    bench.world.set_stick = lambda stick: (seen.append(stick), set_stick(stick))  # type: ignore
    link, now = bench.pilot._transport, RealClock().now()
    assert link is not None
    stop = (Command(Action.HOVER), Command(Action.FLY, Setpoint(theta=-0.1)))
    link.write(b"".join(encode_driver_message(TimedCommand(one, now)) for one in stop))
    await bench.until(lambda: bench.world.asked.forward < 0.0)
    hover = next(number for number, stick in enumerate(seen) if stick.hover)
    assert seen[hover + 1].forward < 0.0


async def test_a_driver_told_to_leave_lands_first_whatever_its_pilot_wants(bench: Bench) -> None:
    await bench.fly()
    for _ in range(3):
        bench.server.leave()
    await bench.until(lambda: bench.status is DroneStatus.LANDED, Action.FLY, FORWARD)
    await bench.pilot.close()
    await asyncio.wait_for(bench.serving, 5.0)
    assert bench.world.flight.name == "LANDED"


async def test_a_driver_that_is_gone_is_said_and_found_again(
    bench: Bench, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(remote_drone_module, "_CONNECT_TIMEOUT", 0.3)
    await bench.pilot.connect()
    bench.serving.cancel()
    await asyncio.gather(bench.serving, return_exceptions=True)
    await bench.until(lambda: "does not answer" in bench.pilot.problem)
    assert not bench.pilot.connected
    with pytest.raises(LinkError, match=r"driver\.log"):
        await bench.pilot.connect()
    again = DriverServer(
        ArDrone(DroneConfig(address=bench.address), LimitsConfig()),
        bench.path,
        RealClock(),
    )
    serving = asyncio.create_task(again.run())
    await bench.until(lambda: bench.pilot.connected)
    serving.cancel()
    await asyncio.gather(serving, return_exceptions=True)


async def test_a_new_driver_that_finds_the_drone_in_the_air_only_hovers_and_lands(
    bench: Bench,
) -> None:
    await bench.fly()
    bench.serving.cancel()
    await asyncio.gather(bench.serving, return_exceptions=True)
    again = ArDrone(DroneConfig(address=bench.address), LimitsConfig())
    serving = asyncio.create_task(DriverServer(again, bench.path, RealClock()).run())
    await bench.until(lambda: bench.world.asked.hover, Action.FLY, FORWARD)
    await bench.until(
        lambda: any("in the air" in note for note in bench.pilot.telemetry.notes), Action.HOVER
    )
    report = bench.pilot.telemetry
    assert report is not None and not report.configured
    await bench.until(lambda: bench.status is DroneStatus.LANDED, Action.FLY, FORWARD)
    await bench.until(lambda: bool(bench.pilot.telemetry.configured), Action.IDLE)
    await bench.until(lambda: bench.status is DroneStatus.FLYING, Action.TAKE_OFF)
    serving.cancel()
    await asyncio.gather(serving, return_exceptions=True)


async def test_garbage_on_the_socket_ends_that_connection_and_nothing_else(bench: Bench) -> None:
    _, writer = await asyncio.open_unix_connection(str(bench.path))
    writer.write(b"GET / HTTP/1.1\r\n\r\n")
    await writer.drain()
    await asyncio.sleep(0.05)
    writer.close()
    with contextlib.suppress(OSError):
        await writer.wait_closed()
    await bench.fly()


async def test_a_folder_that_others_can_enter_is_refused(tmp_path: Path) -> None:
    tmp_path.chmod(0o755)
    driver = ArDrone(DroneConfig(address="127.0.0.1"), LimitsConfig())
    with pytest.raises(LinkError, match="0700"):
        await DriverServer(driver, tmp_path / "driver", RealClock()).run()
    tmp_path.chmod(0o700)


def test_the_socket_lets_nobody_else_in(tmp_path: Path) -> None:
    if os.geteuid() != 0:
        pytest.skip("only root can be somebody else for a moment")
    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind(str(tmp_path / "s"))
        listener.listen()
        listener.settimeout(5.0)
        for folder_mode, user, comes_in in ((0o755, 65534, True), (0o700, 65534, False)):
            tmp_path.chmod(folder_mode)
            (tmp_path / "s").chmod(0o777)
            assert connect_as(user, tmp_path) is comes_in
            if comes_in:
                with listener.accept()[0] as call:
                    assert not is_own_user(call)
        assert connect_as(0, tmp_path)
        with listener.accept()[0] as call:
            assert is_own_user(call)


def connect_as(user: int, folder: Path) -> bool:
    """Return whether a child process of another user reaches the socket."""
    entered = os.open(folder, os.O_RDONLY)
    child = os.fork()
    if child == 0:
        code = 1
        try:
            os.fchdir(entered)
            os.setuid(user)
            with socket.socket(socket.AF_UNIX) as caller:
                code = caller.connect_ex("s") != 0
        finally:
            os._exit(int(code))
    os.close(entered)
    return os.waitpid(child, 0)[1] == 0
