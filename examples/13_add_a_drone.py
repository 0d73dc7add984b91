"""Add a drone of your own: one that takes a line of text over UDP, and has no hover of its own.

Needs: nothing beside Housefly itself.
Learns: what a driver owes the room (``drones/contract.py``): it carries what the failsafe decides,
    and what the drone reports; how its model is described (``13_kite.toml``).
Prints: what the drone is told and does while a pilot flies it through the very server that runs
    every driver, and then is gone: it sinks level, where another drone would hover, and stands.
"""

import asyncio
import socket
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import cast

from housefly import (
    Action,
    Airframe,
    Capabilities,
    Command,
    DriverServer,
    DroneDriver,
    DroneStatus,
    Failsafe,
    KnownMotion,
    LinkError,
    RealClock,
    RemoteDrone,
    Setpoint,
    Sighting,
    Telemetry,
    VideoFrame,
    airframe_in,
)

PERIOD = 0.02
TILT_MAX = 0.2


class KiteDriver(asyncio.DatagramProtocol):
    """Tells a Kite ``action theta phi vz``, and hears ``status height forward theta``."""

    video_connected, problem, firmware, notes = False, "", "1.0", ()

    def __init__(self, port: int, airframe: Airframe) -> None:
        self._port, self._airframe, self._clock = port, airframe, RealClock()
        self._failsafe = Failsafe(self._clock.now(), TILT_MAX, airframe)
        self._handler: Callable[[], None] = lambda: None
        self._heard = asyncio.Event()
        self._sending: asyncio.Task[None] | None = None
        self.telemetry: Telemetry | None = None

    @property
    def capabilities(self) -> Capabilities:
        """What a Kite can do."""
        return self._airframe.capabilities

    @property
    def connected(self) -> bool:
        """Whether reports arrive."""
        report = self.telemetry
        return report is not None and self._clock.now() - report.received_at < 0.5

    @property
    def telemetry_rate_hz(self) -> float:
        """Reports per second."""
        return 1.0 / PERIOD if self.connected else 0.0

    async def connect(self) -> None:
        """Open the wire; it is told something from then on, at its own rate."""
        if self._sending is None:
            where, loop = ("127.0.0.1", self._port), asyncio.get_running_loop()
            self._link, _ = await loop.create_datagram_endpoint(lambda: self, remote_addr=where)
            self._sending = asyncio.create_task(self._send_for_ever())
        try:
            await asyncio.wait_for(self._heard.wait(), 2.0)
        except TimeoutError as error:
            raise LinkError(f"no Kite answers at port {self._port}: is it on?") from error

    def send(
        self,
        command: Command,
        motion: KnownMotion | None = None,
        issued_at: float | None = None,
    ) -> None:
        """Put a command in force; one of another kind leaves at once."""
        if self._failsafe.update(command, self._clock.now(), issued_at, motion):
            self._transmit()

    def send_pose(self, seen: Sighting) -> None:
        """It wants none."""

    def abandon(self) -> None:
        """Note that the pilot is gone."""
        self._failsafe.abandon()

    def land_for_good(self) -> None:
        """Land, and take no order any more."""
        self._failsafe.land_for_good()

    def show_recording(self, records: bool) -> None:
        """It has no light."""

    def on_report(self, handler: Callable[[], None]) -> None:
        """Call the handler after each report."""
        self._handler = handler

    def on_video(self, handler: Callable[[VideoFrame], None]) -> None:
        """It has no camera."""

    async def close(self) -> None:
        """Release the wire."""
        if self._sending is not None:
            self._sending.cancel()
            self._link.close()

    async def _send_for_ever(self) -> None:
        while True:
            self._transmit()
            await asyncio.sleep(PERIOD)

    def _transmit(self) -> None:
        told = self._failsafe.decide(self._clock.now(), self.telemetry).command
        asked = told.setpoint
        line = f"{told.action.name} {asked.theta:.4f} {asked.phi:.4f} {asked.vz:.4f}"
        self._link.sendto(line.encode())

    def datagram_received(self, data: bytes, addr: tuple[str, int]) -> None:
        """Take in a report."""
        status, height, forward, theta = data.decode().split()
        self.telemetry = Telemetry(
            received_at=self._clock.now(),
            status=DroneStatus[status],
            battery=1.0,
            theta=float(theta),
            height=float(height),
            velocity=(float(forward), 0.0, 0.0),
        )
        self._heard.set()
        self._handler()


class Kite(asyncio.DatagramProtocol):
    """The drone: climbs to 1 m, follows tilt and climb, lands when told or on the floor."""

    def __init__(self) -> None:
        self.height = self.forward = 0.0
        self.status, self.told = DroneStatus.LANDED, ""

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Answer over this socket."""
        self._link = cast(asyncio.DatagramTransport, transport)

    def datagram_received(self, data: bytes, addr: tuple[str, int]) -> None:
        """Obey for one period, and report."""
        action, theta, _phi, vz = data.decode().split()
        climb = {"TAKE_OFF": 1.0, "LAND": -0.8, "FLY": float(vz)}.get(action, 0.0)
        if action == "TAKE_OFF" and self.status is DroneStatus.LANDED:
            self.status = DroneStatus.TAKING_OFF
        elif action == "LAND" and self.status is not DroneStatus.LANDED:
            self.status = DroneStatus.LANDING
        if self.status is not DroneStatus.LANDED:
            self.height = max(0.0, self.height + PERIOD * climb)
            self.forward += PERIOD * (9.81 * float(theta) - 0.58 * self.forward)
        if self.status is DroneStatus.TAKING_OFF and self.height >= 1.0:
            self.status = DroneStatus.FLYING
        elif self.status is DroneStatus.LANDING and self.height == 0.0:
            self.status, self.forward = DroneStatus.LANDED, 0.0
        if (told := f"told {action}, is {self.status.value}") != self.told:
            self.told = told
            print(f"{told} at {self.height:.1f} m, {self.forward:+.1f} m/s")
        report = f"{self.status.name} {self.height:.3f} {self.forward:.3f} {theta}"
        self._link.sendto(report.encode(), addr)


async def fly(pilot: RemoteDrone, command: Command, until: Callable[[], bool]) -> None:
    """Say the same a hundred times a second, as a pilot does, and how the drone moves."""
    async with asyncio.timeout(20.0):
        while not until():
            report = pilot.telemetry
            pilot.send(command, KnownMotion(report.velocity[0], 0.0) if report else None)
            await asyncio.sleep(0.01)


async def main() -> None:
    """Fly it, vanish, and see it down."""
    airframe = airframe_in(Path(__file__).with_name("13_kite.toml"))
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    kite = Kite()
    loop = asyncio.get_running_loop()
    body, _ = await loop.create_datagram_endpoint(lambda: kite, ("127.0.0.1", port))
    driver: DroneDriver = KiteDriver(port, airframe)
    path = Path(tempfile.mkdtemp()) / "driver.sock"
    server = DriverServer(driver, path, RealClock())
    serving = asyncio.create_task(server.run())
    pilot = RemoteDrone(path)
    await pilot.connect()
    await fly(pilot, Command(Action.IDLE), lambda: pilot.telemetry is not None)
    known = pilot.capabilities
    print(f"{airframe.name} hovers by itself: {'yes' if known and known.hovers else 'no'}")
    await fly(pilot, Command(Action.TAKE_OFF), lambda: kite.status is DroneStatus.FLYING)
    await fly(pilot, Command(Action.FLY, Setpoint(theta=0.1)), lambda: kite.forward > 0.5)
    print("the pilot is gone")
    await pilot.close()
    async with asyncio.timeout(20.0):
        while kite.status is not DroneStatus.LANDED:
            await asyncio.sleep(0.05)
    server.leave()
    await serving
    body.close()
    print("it stands, and its driver has left")


if __name__ == "__main__":
    asyncio.run(main())
