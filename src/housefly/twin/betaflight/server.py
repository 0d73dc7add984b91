"""MSP over TCP, port 5761 of one address: a simulated drone with Betaflight.

As the firmware it takes one command each time it looks, a hundred times a second, and answers each.
Several may be connected; each is answered on its own stream. The server does not advance the world.
"""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Callable
from functools import partial

from housefly.errors import ConfigError, LinkError, WireError
from housefly.twin.address import check_address
from housefly.twin.betaflight.firmware import BetaflightFirmware
from housefly.twin.contracts import TwinDrone
from housefly.twin.link_filters import UNFILTERED, LinkFilters
from housefly.wires.betaflight import reports, settings
from housefly.wires.betaflight.commands import COMMANDS_PER_SECOND, VARIANT, Msp
from housefly.wires.betaflight.endpoint import TCP_PORT
from housefly.wires.betaflight.framing import MspDirection, MspFrame, MspReader, encode_msp
from housefly.wires.betaflight.payloads import packed

API = bytes((0, 1, 47))
FIRMWARE = bytes((25, 12, 0))
"""What it answers to API_VERSION and FC_VERSION."""
CELLS = 4
"""Of its battery."""
_LOW_CELL = 3.5
_QUEUE_MAX = 200
"""More commands than this that were not looked at yet are dropped."""


class BetaflightServer:
    """Serves one drone of the room; all calls belong to one asyncio loop.

    Args:
        drone: what flies.
        address: IP address whose port is taken.
        beyond_loopback: allow an address that other machines can reach.
        filters: what stands between the client and the drone.

    Attributes:
        malformed: commands that could not be read, or that it does not know.
        dropped: commands that came faster than it looks.
        heard: commands that were answered.

    Raises:
        ConfigError: an address that is not loopback, without ``beyond_loopback``; a drone that is
            no Betaflight.
    """

    def __init__(
        self,
        drone: TwinDrone,
        address: str = "127.0.0.1",
        *,
        beyond_loopback: bool = False,
        filters: LinkFilters = UNFILTERED,
    ) -> None:
        check_address("drone.address", address, beyond_loopback)
        if not isinstance(drone.firmware, BetaflightFirmware):
            raise ConfigError("drone.kind", "is no Betaflight; its wire has nothing to say to it")
        self._drone, self._address, self._firmware = drone, address, drone.firmware
        self._filters = filters
        self.malformed = self.dropped = self.heard = 0
        self._server: asyncio.Server | None = None
        self._clients: set[_Client] = set()
        self._looking: asyncio.Task[None] | None = None

    async def start(self) -> None:
        """Open the port; raises LinkError when it cannot be had."""
        there, loop = (self._address, TCP_PORT), asyncio.get_running_loop()
        try:
            self._server = await loop.create_server(lambda: _Client(self), *there)
        except OSError as error:
            raise LinkError(f"cannot serve a Betaflight at {there}: {error.strerror}") from error
        self._looking = asyncio.create_task(self._look_for_ever(), name="betaflight serial task")

    async def stop(self) -> None:
        """Close it."""
        if self._looking is not None:
            self._looking.cancel()
            await asyncio.gather(self._looking, return_exceptions=True)
        if self._server is not None:
            self._server.close()
            for client in tuple(self._clients):
                client.end()
            await self._server.wait_closed()

    async def _look_for_ever(self) -> None:
        loop = asyncio.get_running_loop()
        due = loop.time()
        while True:
            due = max(due + 1.0 / COMMANDS_PER_SECOND, loop.time() - 0.1)
            await asyncio.sleep(max(0.0, due - loop.time()))
            for client in tuple(self._clients):
                client.look()

    def answer(self, frame: MspFrame) -> MspFrame:
        """Obey a command, or answer a question; what cannot be is refused."""
        try:
            payload = self._payload(frame)
        except WireError:
            self.malformed += 1
            return MspFrame(frame.command, b"", MspDirection.REFUSAL, frame.version)
        self.heard += 1
        return MspFrame(frame.command, payload, MspDirection.ANSWER, frame.version)

    def _payload(self, frame: MspFrame) -> bytes:
        if frame.command == Msp.SET_RAW_RC:
            channels = reports.read_channels(Msp.SET_RAW_RC, frame.payload)
            self._drone.keep_alive()
            self._drone.later(partial(self._firmware.hear, channels))
            return b""
        question = _QUESTIONS.get(frame.command)
        if question is None:
            raise WireError(f"MSP command {frame.command} is not known here")
        return question(self)

    def _status(self) -> bytes:
        firmware = self._firmware
        return reports.encode_status(reports.FcStatus(firmware.box_bits, firmware.blocked, 20))

    def _attitude(self) -> bytes:
        onboard = self._filters.reported(self._drone.onboard())
        return reports.encode_attitude(reports.FcAttitude(onboard.phi, onboard.theta, onboard.psi))

    def _battery(self) -> bytes:
        charge = self._filters.reported(self._drone.onboard()).battery
        cell = reports.cell_voltage_of(charge)
        return reports.encode_battery(reports.FcBattery(CELLS, CELLS * cell, cell < _LOW_CELL))

    def _inertial(self) -> bytes:
        onboard = self._drone.onboard()
        specific = (round(2048 * one / 9.80665) for one in onboard.acceleration)
        turning = (round(57.29578 * one) for one in onboard.angular_rate)
        numbers = (*specific, *turning, 0, 0, 0)
        return packed(*((max(-32768, min(32767, one)), 2) for one in numbers))

    def _analog(self) -> bytes:
        charge = self._filters.reported(self._drone.onboard()).battery
        volts = CELLS * reports.cell_voltage_of(charge)
        return packed((round(volts * 10), 1), (0, 2), (0, 2), (0, 2), (round(volts * 100), 2))

    @property
    def _set(self) -> settings.FcSettings:
        return self._firmware.settings


_QUESTIONS: dict[int, Callable[[BetaflightServer], bytes]] = {
    Msp.API_VERSION: lambda server: API,
    Msp.FC_VARIANT: lambda server: VARIANT,
    Msp.FC_VERSION: lambda server: FIRMWARE,
    Msp.MODE_RANGES: lambda server: settings.encode_mode_ranges(server._set.ranges),
    Msp.FEATURE_CONFIG: lambda server: packed((server._set.features, 4)),
    Msp.RX_CONFIG: lambda server: settings.encode_receiver(
        server._set.middle, server._set.throttle_low
    ),
    Msp.RX_MAP: lambda server: bytes((*server._set.order, 4, 5, 6, 7)),
    Msp.FAILSAFE_CONFIG: lambda server: settings.encode_failsafe(server._set.failsafe),
    Msp.RXFAIL_CONFIG: lambda server: settings.encode_silent_channels(server._set.silent),
    Msp.ADVANCED_CONFIG: lambda server: settings.encode_motor_idle(server._set.motor_idle),
    Msp.PID_ADVANCED: lambda server: settings.encode_angle_limit(server._set.angle_limit),
    Msp.RAW_IMU: BetaflightServer._inertial,
    Msp.RC: lambda server: reports.encode_channels(server._firmware.receiver.channels),
    Msp.ATTITUDE: BetaflightServer._attitude,
    Msp.ALTITUDE: lambda server: bytes(6),
    Msp.ANALOG: BetaflightServer._analog,
    Msp.RC_TUNING: lambda server: settings.encode_tuning(server._set.tuning),
    Msp.BOXIDS: lambda server: bytes(server._firmware.boxes),
    Msp.RC_DEADBAND: lambda server: packed(
        (server._set.deadband, 1), (server._set.yaw_deadband, 1), (0, 1), (50, 2)
    ),
    Msp.BATTERY_STATE: BetaflightServer._battery,
    Msp.STATUS: BetaflightServer._status,
    Msp.STATUS_EX: BetaflightServer._status,
}
"""What is answered to each question."""


class _Client(asyncio.Protocol):
    """One stream."""

    def __init__(self, server: BetaflightServer) -> None:
        self._server, self._reader = server, MspReader()
        self._waiting: deque[MspFrame] = deque()
        self._transport: asyncio.Transport | None = None
        self._obey = server._filters.uplink(self._take)
        self._send = server._filters.downlink(self._write)

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        assert isinstance(transport, asyncio.Transport)
        self._transport = transport
        self._server._clients.add(self)

    def connection_lost(self, exc: Exception | None) -> None:
        self._server._clients.discard(self)
        self._transport = None

    def data_received(self, data: bytes) -> None:
        self._obey(data)

    def end(self) -> None:
        if self._transport is not None:
            self._transport.abort()

    def look(self) -> None:
        """Take one command, as the firmware does each time it looks at the port."""
        if self._waiting:
            self._send(encode_msp(self._server.answer(self._waiting.popleft())))

    def _take(self, data: bytes) -> None:
        broken = self._reader.broken
        for frame in self._reader.feed(data):
            if frame.direction is not MspDirection.REQUEST:
                continue
            if len(self._waiting) < _QUEUE_MAX:
                self._waiting.append(frame)
            else:
                self._server.dropped += 1
        self._server.malformed += self._reader.broken - broken

    def _write(self, data: bytes) -> None:
        if self._transport is not None:
            self._transport.write(data)
