"""UDP 5556 of the simulated drone: turns AT commands into calls.

A command counts when its number is above the last one; number 1, or two seconds of silence,
restarts the sequence (docs/wires.md, section 4). The emergency bit acts on its rising edge, so that
a client may repeat it; the other REF bit acts each time.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Any

from housefly.twin.address import PeerAddress
from housefly.twin.ardrone.config_store import ConfigStore
from housefly.twin.ardrone.link import LINK_LOST_AFTER, Link
from housefly.twin.contracts import TwinDrone
from housefly.twin.link_filters import UNFILTERED, Deliver
from housefly.wires.ardrone import at
from housefly.wires.ardrone.config import MulticonfigIds
from housefly.wires.ardrone.conversions import stick_from_pcmd

_NO_SEQUENCE = -1
_FIRST_SEQUENCE = 1


class CommandServer(asyncio.DatagramProtocol):
    """Understands datagrams of commands from any source port.

    Args:
        drone: what flies.
        link: acknowledge bit, silence, counters.
        config: what CONFIG writes.
        send_config: called for ``CTRL 4`` and, with True, for ``CTRL 6``.
        uplink: what the client's datagrams pass on their way.
    """

    def __init__(
        self,
        drone: TwinDrone,
        link: Link,
        config: ConfigStore,
        send_config: Callable[[bool], None],
        uplink: Callable[[Deliver], Deliver] = UNFILTERED.uplink,
    ) -> None:
        self._drone = drone
        self._link = link
        self._config = config
        self._send_config = send_config
        self._deliver = uplink(self.receive)
        self._last_sequence = _NO_SEQUENCE
        self._emergency_held = False
        self._ids: MulticonfigIds | None = None
        self._transport: asyncio.DatagramTransport | None = None
        self._actions: dict[type, Callable[[Any], None]] = {
            at.Ref: self._on_ref,
            at.Pcmd: self._on_move,
            at.PcmdMag: self._on_move_by_heading,
            at.FlatTrim: lambda command: self._drone.flat_trim(),
            at.Config: self._on_config,
            at.ConfigIds: self._on_config_ids,
            at.Control: self._on_control,
            at.Led: self._on_led,
        }

    async def start(self, address: str) -> None:
        """Open the port; raises OSError when the address is taken."""
        loop = asyncio.get_running_loop()
        self._transport, _ = await loop.create_datagram_endpoint(
            lambda: self, local_addr=(address, at.COMMAND_PORT)
        )

    async def stop(self) -> None:
        """Close the port."""
        if self._transport is not None:
            self._transport.abort()

    def datagram_received(self, data: bytes, addr: PeerAddress) -> None:
        """Obey a datagram from any client."""
        self._deliver(data)

    def receive(self, datagram: bytes) -> None:
        """Obey the good commands of a datagram and count the bad ones; never raises."""
        counters = self._link.counters
        counters.datagrams += 1
        commands, rejects = at.parse_datagram(datagram)
        counters.malformed += len(rejects)
        for sequence, command in commands:
            if self._is_new(sequence):
                counters.commands += 1
                self._obey(command)
            else:
                counters.stale_commands += 1

    def _is_new(self, sequence: int) -> bool:
        if self._link.silent_since(self._drone.now, LINK_LOST_AFTER):
            self._last_sequence = _NO_SEQUENCE
            self._emergency_held = False
        if sequence <= self._last_sequence and sequence != _FIRST_SEQUENCE:
            return False
        self._last_sequence = sequence
        return True

    def _obey(self, command: at.AtCommand) -> None:
        self._link.last_command_at = self._drone.now
        self._drone.keep_alive()
        action = self._actions.get(type(command))
        if action is not None:
            action(command)

    def _on_ref(self, command: at.Ref) -> None:
        emergency = at.RefBits.EMERGENCY in command.bits
        if emergency and not self._emergency_held:
            self._drone.toggle_emergency()
        self._emergency_held = emergency
        if at.RefBits.TAKE_OFF in command.bits:
            self._drone.request_take_off()
        else:
            self._drone.request_land()

    def _on_move(self, command: at.Pcmd) -> None:
        self._drone.set_stick(stick_from_pcmd(command))

    def _on_move_by_heading(self, command: at.PcmdMag) -> None:
        """Take the sticks as of PCMD: the simulated drone has no client's heading to fly by."""
        self._on_move(at.Pcmd(command.flags, command.roll, command.pitch, command.gaz, command.yaw))

    def _on_led(self, command: at.Led) -> None:
        self._drone.play_leds(command.animation, command.frequency_hz, command.seconds)

    def _on_config_ids(self, command: at.ConfigIds) -> None:
        self._ids = MulticonfigIds(command.session, command.user, command.application)

    def _on_config(self, command: at.Config) -> None:
        ids, self._ids = self._ids, None
        if not self._config.write(command.key, command.value, ids):
            self._link.counters.refused_settings += 1
        self._link.acknowledged = True

    def _on_control(self, command: at.Control) -> None:
        if command.mode == at.ControlMode.CLEAR_ACK:
            self._link.acknowledged = False
        elif command.mode in (at.ControlMode.SEND_CONFIG, at.ControlMode.SEND_CUSTOM_CONFIGS):
            self._link.acknowledged = True
            self._send_config(command.mode == at.ControlMode.SEND_CUSTOM_CONFIGS)
