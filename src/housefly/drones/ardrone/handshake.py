"""Writing and reading the drone's configuration.

Each CONFIG is acknowledged by state bit 6, which is cleared again with CTRL 5; one at a time. Keys
of sessions, users and applications count only with our three ids, named right before (Parrot
ARDroneLib SDK 2.0.1).
"""

from __future__ import annotations

import asyncio
import contextlib

from housefly.drones.ardrone.link import CommandLink
from housefly.drones.ardrone.telemetry import Condition, NavdataPort
from housefly.errors import LinkError, WireError
from housefly.wires.ardrone import at
from housefly.wires.ardrone.config import (
    CONTROL_PORT,
    DUMP_END,
    MAX_DUMP,
    Dump,
    Ids,
    Value,
    config_id,
    format_value,
    key_named,
)
from housefly.wires.ardrone.config import parse_dump as parse
from housefly.wires.ardrone.config_keys import Category
from housefly.wires.ardrone.navdata import DroneState, NavdataPacket

REPEAT = 0.1
"""A step of the dance is sent again when the drone has not answered for this long [s]."""
PATIENCE = 3.0
"""When a step is given up [s]."""
READ_REPEAT = 0.5
"""The request for the configuration is sent again after this long [s]."""

OURS = Ids(
    session=config_id("housefly session"),
    user=config_id("housefly user"),
    application=config_id("housefly"),
)
"""The same on every run, so that a drone does not fill up with sessions."""

LOGIN = (
    ("custom:session_id", OURS.session),
    ("custom:profile_id", OURS.user),
    ("custom:application_id", OURS.application),
    ("custom:session_desc", "Housefly session"),
    ("custom:profile_desc", "Housefly user"),
    ("custom:application_desc", "Housefly"),
)


class Configurator:
    """Talks about configuration over an open command link and an open navdata port."""

    def __init__(self, address: str, commands: CommandLink, navdata: NavdataPort) -> None:
        self._address = address
        self._commands = commands
        self._navdata = navdata
        self._one_at_a_time = asyncio.Lock()

    async def log_in(self) -> None:
        """Make our session, user and application those in force; raises LinkError when the drone
        does not answer.
        """
        for key, value in LOGIN:
            await self.write(key, value)

    async def write(self, name: str, value: Value) -> None:
        """Set a key.

        Raises:
            LinkError: the drone did not acknowledge in time.
            WireError: no such key, or a value of another type.
        """
        key = key_named(name)
        setting: tuple[at.Command, ...] = (at.Config(name, format_value(key, value)),)
        if key.category is not Category.COMMON:
            setting = (at.ConfigIds(*OURS), *setting)
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
                async with asyncio.timeout(PATIENCE):
                    return parse(await self._download())
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
            with contextlib.suppress(OSError):
                await writer.wait_closed()

    async def _ask_for_dump(self) -> None:
        while True:
            self._commands.send(at.Control(at.ControlMode.SEND_CONFIG))
            await asyncio.sleep(READ_REPEAT)

    async def _clear_acknowledge(self, what: str) -> None:
        packet = self._navdata.reports.packet
        if packet is None or _is_acknowledged(packet):
            clear = (at.Control(at.ControlMode.CLEAR_ACK),)
            await self._repeat_until(
                clear, lambda packet: not _is_acknowledged(packet), f"does not get ready for {what}"
            )

    async def _repeat_until(
        self, commands: tuple[at.Command, ...], condition: Condition, complaint: str
    ) -> None:
        for _ in range(round(PATIENCE / REPEAT)):
            self._commands.send(*commands)
            if await self._navdata.wait_for(condition, REPEAT) is not None:
                return
        raise LinkError(f"the drone at {self._address} {complaint} within {PATIENCE:g} s")


def _is_acknowledged(packet: NavdataPacket) -> bool:
    return packet.has(DroneState.COMMAND_ACK)
