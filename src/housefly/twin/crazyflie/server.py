"""A simulated Crazyflie on UDP port 19850 of one address: each datagram is one CRTP packet.

Bitcraze's own library scans it, connects to it and flies it (tests/peers). As the drone itself it
has one client: who spoke last gets what it sends by itself. The server does not advance the world.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import cast

from housefly.errors import ConfigError, LinkError, WireError
from housefly.twin.address import PeerAddress, check_address
from housefly.twin.contracts import TwinDrone
from housefly.twin.crazyflie.firmware import CrazyflieFirmware
from housefly.twin.crazyflie.log_service import LogService
from housefly.twin.crazyflie.variables import (
    LOG_ENTRIES,
    PARAMETER_ENTRIES,
    default_parameters,
)
from housefly.twin.link_filters import UNFILTERED, LinkFilters
from housefly.wires.crazyflie import high_level, localization, log_blocks, parameters, tables
from housefly.wires.crazyflie import supervisor as words
from housefly.wires.crazyflie.crtp import (
    NULL_PACKET,
    UDP_PORT,
    Packet,
    Port,
    decode_crtp,
    encode_crtp,
    is_null,
)
from housefly.wires.crazyflie.setpoints import decode_setpoint, is_notify_stop

PROTOCOL, FIRMWARE, DEVICE = 12, "2026.08", "CF2.1"
"""Versions that it tells."""
KALMAN = 2.0
"""The estimator that takes poses; the drone starts with another."""
_LOG_PERIOD = 0.005
"""How often it looks whether a log block is due [s]."""
_MEMORY_COUNT = 1


class CrazyflieServer(asyncio.DatagramProtocol):
    """Serves one drone of the room; all calls belong to one asyncio loop.

    Args:
        drone: what flies.
        address: IP address whose port is taken.
        beyond_loopback: allow an address that other machines can reach.
        filters: what stands between the client and the drone.

    Attributes:
        malformed: datagrams that were dropped.
        values: parameters, by name.

    Raises:
        ConfigError: an address that is not loopback, without ``beyond_loopback``; a drone that is
            no Crazyflie.
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
        if not isinstance(drone.firmware, CrazyflieFirmware):
            raise ConfigError("drone.kind", "is no Crazyflie; its wire has nothing to say to it")
        self._drone, self._address, self._firmware = drone, address, drone.firmware
        self._log, self.values = LogService(), default_parameters()
        self.malformed = 0
        self._client: PeerAddress | None = None
        self._link: asyncio.DatagramTransport | None = None
        self._logging: asyncio.Task[None] | None = None
        self._obey = filters.uplink(self._hear)
        self._send = filters.downlink(self._transmit)
        self._ports: dict[int, Callable[[Packet], None]] = {
            Port.PARAMETERS: self._parameter,
            Port.MEMORY: self._memory,
            Port.LOG: self._logged,
            Port.LOCALIZATION: self._told,
            Port.GENERIC_SETPOINT: self._setpoint,
            Port.HIGH_LEVEL: self._high_level,
            Port.SUPERVISOR: self._supervisor,
            Port.PLATFORM: self._platform,
            Port.LINK: self._linked,
        }

    async def start(self) -> None:
        """Open the port; raises LinkError when it cannot be had."""
        there, loop = (self._address, UDP_PORT), asyncio.get_running_loop()
        try:
            await loop.create_datagram_endpoint(lambda: self, there)
        except OSError as error:
            raise LinkError(f"cannot serve a Crazyflie at {there}: {error.strerror}") from error
        self._logging = asyncio.create_task(self._send_logs(), name="crazyflie log")

    async def stop(self) -> None:
        """Close it."""
        if self._logging is not None:
            self._logging.cancel()
            await asyncio.gather(self._logging, return_exceptions=True)
        if self._link is not None:
            self._link.abort()
            self._link = None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Answer over this socket."""
        self._link = cast(asyncio.DatagramTransport, transport)

    def datagram_received(self, data: bytes, addr: PeerAddress) -> None:
        """Obey; a null packet is answered to whoever sends it, anything else makes a client."""
        if data == NULL_PACKET:
            if self._link is not None:
                self._link.sendto(NULL_PACKET, addr)
            return
        self._client = addr
        self._obey(data)

    def error_received(self, exc: Exception) -> None:
        """Ignore that a client is gone."""

    def _hear(self, datagram: bytes) -> None:
        try:
            packet = decode_crtp(datagram)
            if is_null(packet):
                return
            obey = self._ports.get(packet.port)
            if obey is not None:
                obey(packet)
        except WireError:
            self.malformed += 1

    def _answer(self, packet: Packet) -> None:
        self._send(encode_crtp(packet))

    def _transmit(self, datagram: bytes) -> None:
        if self._link is not None and self._client is not None:
            self._link.sendto(datagram, self._client)

    async def _send_logs(self) -> None:
        while True:
            for packet in self._log.due((self._firmware, self._drone.onboard()), self._drone.now):
                self._answer(packet)
            await asyncio.sleep(_LOG_PERIOD)

    def _setpoint(self, packet: Packet) -> None:
        self._drone.keep_alive()
        if is_notify_stop(packet):
            self._drone.later(self._firmware.stop_setpoints)
            return
        setpoint = decode_setpoint(packet)
        self._drone.later(lambda: self._firmware.give(setpoint))

    def _high_level(self, packet: Packet) -> None:
        order = high_level.decode_high_level(packet)
        self._drone.keep_alive()

        def obey() -> None:
            self._answer(high_level.high_level_answer(packet, self._firmware.obey(order)))

        self._drone.later(obey)

    def _told(self, packet: Packet) -> None:
        stops = localization.emergency_of(packet)
        if stops is not None:
            order = words.SupervisorOrder
            self._order(order.EMERGENCY_STOP if stops else order.EMERGENCY_WATCHDOG, True)
            return
        for told in localization.decode_poses(packet):
            is_own = told.drone in (None, localization.OWN_ID)
            if is_own and self.values["stabilizer.estimator"] == KALMAN:
                self._tell(told)

    def _tell(self, told: localization.ToldPose) -> None:
        self._drone.later(lambda: self._firmware.tell(told))

    def _supervisor(self, packet: Packet) -> None:
        if packet.channel == words.INFO:
            question = packet.data[0] if packet.data else 0
            self._answer(words.encode_info(question, self._firmware.info))
            return
        order, on = words.decode_order(packet)
        answer = self._order(order, on)
        if answer is not None:
            self._answer(words.encode_order_answer(answer))

    def _order(self, order: words.SupervisorOrder, on: bool) -> words.OrderAnswer | None:
        supervisor = self._firmware.supervisor
        match order:
            case words.SupervisorOrder.ARM:
                return words.OrderAnswer(order, supervisor.arm(on), supervisor.is_armed)
            case words.SupervisorOrder.RECOVER:
                is_done = supervisor.recover()
                is_crashed = words.SupervisorInfo.IS_CRASHED in supervisor.info
                return words.OrderAnswer(order, is_done, not is_crashed)
            case words.SupervisorOrder.EMERGENCY_STOP:
                supervisor.stop()
            case words.SupervisorOrder.EMERGENCY_WATCHDOG:
                supervisor.feed_watchdog()
        return None

    def _platform(self, packet: Packet) -> None:
        if packet.channel == 0:
            order, on = words.decode_order(packet)
            if order in (words.SupervisorOrder.ARM, words.SupervisorOrder.RECOVER):
                self._order(order, on)
            return
        told: dict[words.VersionQuestion, int | str] = {
            words.VersionQuestion.PROTOCOL: PROTOCOL,
            words.VersionQuestion.FIRMWARE: FIRMWARE,
            words.VersionQuestion.DEVICE: DEVICE,
        }
        try:
            question = words.VersionQuestion(packet.data[0])
        except (IndexError, ValueError) as error:
            raise WireError(f"no question for a version: {packet.data.hex()}") from error
        self._answer(words.version_answer(question, told[question]))

    def _linked(self, packet: Packet) -> None:
        if packet.channel == 0:
            self._answer(packet)
        elif packet.channel == 1:
            self._answer(words.source_answer())

    def _memory(self, packet: Packet) -> None:
        """It has no memory that can be read: neither decks nor trajectories."""
        if packet.channel == 0 and packet.data[:1] == bytes((_MEMORY_COUNT,)):
            self._answer(Packet(Port.MEMORY, 0, bytes((_MEMORY_COUNT, 0))))

    def _logged(self, packet: Packet) -> None:
        if packet.channel == tables.TOC_CHANNEL:
            extra = log_blocks.BLOCKS_MAX, log_blocks.VARIABLES_MAX
            self._answer(_table_answer(Port.LOG, packet, LOG_ENTRIES, extra))
        elif packet.channel == log_blocks.CONTROL:
            self._answer(self._log.obey(log_blocks.decode_block_request(packet), self._drone.now))

    def _parameter(self, packet: Packet) -> None:
        if packet.channel == tables.TOC_CHANNEL:
            self._answer(_table_answer(Port.PARAMETERS, packet, PARAMETER_ENTRIES, (0, 0)))
            return
        number = parameters.number_of(packet)
        if number >= len(PARAMETER_ENTRIES):
            raise WireError(f"no parameter {number}")
        entry = PARAMETER_ENTRIES[number]
        if packet.channel == parameters.WRITE:
            value = parameters.written_value(packet, entry.kind)
            if not entry.read_only:
                self._set(entry.name, value)
            value = self.values[entry.name]
            self._answer(parameters.encode_write(number, entry.kind, value))
            return
        self._answer(parameters.parameter_answer(number, entry.kind, self.values[entry.name]))

    def _set(self, name: str, value: float) -> None:
        self.values[name] = value
        if name == "kalman.resetEstimation" and value:
            self._drone.later(self._firmware.estimator.reset)
        if name == "stabilizer.stop" and value:
            self._firmware.supervisor.stop()


def _table_answer(
    port: Port,
    packet: Packet,
    entries: tuple[tables.TableEntry, ...],
    extra: tuple[int, int],
) -> Packet:
    number = tables.read_question(packet)
    if number is None:
        return tables.info_answer(port, entries, extra)
    return tables.item_answer(port, number, entries)
