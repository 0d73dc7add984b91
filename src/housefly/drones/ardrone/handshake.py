"""Writing and reading the drone's configuration.

One CONFIG at a time: state bit 6 acknowledges it, CTRL 5 clears the bit. Keys of sessions, users
and applications count only when our three ids come right before (Parrot ARDroneLib SDK 2.0.1).
"""

from __future__ import annotations

import asyncio

from housefly.drones.ardrone.link import CommandLink
from housefly.drones.ardrone.telemetry import NavdataLink, PacketCondition
from housefly.errors import LinkError, WireError
from housefly.wires.ardrone import at
from housefly.wires.ardrone.config import (
    CONTROL_PORT,
    DUMP_END,
    MAX_DUMP,
    ConfigValue,
    Dump,
    MulticonfigIds,
    config_id,
    format_value,
    key_named,
    parse_dump,
)
from housefly.wires.ardrone.config_keys import Category
from housefly.wires.ardrone.navdata import NavdataPacket, StateBits

_RESEND_INTERVAL = 0.1
"""A step is sent again when the drone has not answered for this long [s]."""
_STEP_TIMEOUT = 3.0
"""Longest time for one step of the handshake [s]."""
_REQUEST_INTERVAL = 0.5
"""Time between requests for the configuration [s]."""

_CLIENT_IDS = MulticonfigIds(
    session=config_id("housefly session"),
    user=config_id("housefly user"),
    application=config_id("housefly"),
)
"""The same on every run, so that a drone does not fill up with sessions."""

_LOGIN = (
    ("custom:session_id", _CLIENT_IDS.session),
    ("custom:profile_id", _CLIENT_IDS.user),
    ("custom:application_id", _CLIENT_IDS.application),
    ("custom:session_desc", "Housefly session"),
    ("custom:profile_desc", "Housefly user"),
    ("custom:application_desc", "Housefly"),
)


class Configurator:
    """Reads and writes the configuration over open command and navdata links."""

    def __init__(self, address: str, commands: CommandLink, navdata: NavdataLink) -> None:
        self._address = address
        self._commands = commands
        self._navdata = navdata
        self._one_at_a_time = asyncio.Lock()

    async def log_in(self) -> None:
        """Activate our session, user and application; raises LinkError without an answer."""
        for key, value in _LOGIN:
            await self.write(key, value)

    async def write(self, name: str, value: ConfigValue) -> None:
        """Set a key.

        Raises:
            LinkError: the drone did not acknowledge in time.
            WireError: no such key, or a value of another type.
        """
        key = key_named(name)
        setting: tuple[at.AtCommand, ...] = (at.Config(name, format_value(key, value)),)
        if key.category is not Category.COMMON:
            setting = (at.ConfigIds(*_CLIENT_IDS), *setting)
        async with self._one_at_a_time:
            await self._clear_acknowledge(name)
            await self._repeat_until(setting, _is_acknowledged, f"did not acknowledge {name}")
            await self._clear_acknowledge(name)

    async def read(self) -> Dump:
        """Return the configuration in force; raises LinkError when it does not come."""
        where = f"{self._address}:{CONTROL_PORT}"
        async with self._one_at_a_time:
            await self._clear_acknowledge("the request for its configuration")
            try:
                async with asyncio.timeout(_STEP_TIMEOUT):
                    return parse_dump(await self._download())
            except (OSError, TimeoutError) as error:
                raise LinkError(
                    f"the drone does not tell its configuration at {where}: {error or 'no answer'}"
                ) from error
            except WireError as error:
                raise LinkError(
                    f"the drone's configuration at {where} cannot be read: {error}"
                ) from error

    async def _download(self) -> bytes:
        reader, writer = await asyncio.open_connection(self._address, CONTROL_PORT)
        asking = asyncio.create_task(self._ask_for_dump())
        try:
            received = b""
            while (
                DUMP_END not in received
                and len(received) <= MAX_DUMP
                and (chunk := await reader.read(4096))
            ):
                received += chunk
            return received
        finally:
            asking.cancel()
            writer.close()

    async def _ask_for_dump(self) -> None:
        while True:
            self._commands.send(at.Control(at.ControlMode.SEND_CONFIG))
            await asyncio.sleep(_REQUEST_INTERVAL)

    async def _clear_acknowledge(self, what: str) -> None:
        packet = self._navdata.reports.packet
        if packet is None or _is_acknowledged(packet):
            clear = (at.Control(at.ControlMode.CLEAR_ACK),)
            await self._repeat_until(
                clear, lambda packet: not _is_acknowledged(packet), f"does not get ready for {what}"
            )

    async def _repeat_until(
        self, commands: tuple[at.AtCommand, ...], condition: PacketCondition, complaint: str
    ) -> None:
        for _ in range(round(_STEP_TIMEOUT / _RESEND_INTERVAL)):
            self._commands.send(*commands)
            if await self._navdata.wait_for(condition, _RESEND_INTERVAL) is not None:
                return
        raise LinkError(f"the drone at {self._address} {complaint} within {_STEP_TIMEOUT:g} s")


def _is_acknowledged(packet: NavdataPacket) -> bool:
    return packet.has(StateBits.COMMAND_ACK)
