"""CRTP over Bitcraze's USB radio, by the link drivers of PyPI ``cflib``: GPL, an optional part.

Of cflib only its link is used, which hands packets over; all that is said is ours. It is loaded
when a radio is first opened. Its calls block, so two threads make them.
"""

from __future__ import annotations

import asyncio
import re
from collections.abc import Callable
from importlib import import_module
from threading import Event, Thread
from typing import Any

from housefly.drones.crazyflie.outbox import Outbox
from housefly.errors import ConfigError, LinkError, MissingPartError, WireError
from housefly.wires.crazyflie.crtp import Packet, decode_crtp, encode_crtp, is_null

PART = "cflib (the USB radio of a Crazyflie)"
INSTALL = "pip install 'housefly[crazyradio]'"
LINK_DRIVERS = {
    "radio": ("cflib.crtp.radiodriver", "RadioDriver"),
    "udp": ("cflib.crtp.udpdriver", "UdpDriver"),
}
"""Module and class of cflib by how an address begins; the second stands in for a radio in tests."""
_FORM = re.compile(r"radio://[0-9A-Fa-f]+/(\d{1,3})/(250K|1M|2M)(/[0-9A-Fa-f]{1,10})?", re.ASCII)
_CHANNEL_MAX = 125
_PATIENCE = 0.1
"""How long the threads wait for a packet before they look whether it is over [s]."""
_SILENT_AFTER = 1.0
"""A radio that hands over nothing for so long is opened anew [s]: even an idle drone answers."""
_AGAIN_AFTER = 0.5
"""After a radio could not be opened [s]."""


def is_for_radio(address: str) -> bool:
    """Return whether a drone's address leads over cflib.

    Raises:
        ConfigError: it begins as a radio's, and names no channel or rate.
    """
    scheme, sign, _ = address.partition("://")
    if not sign:
        return False
    found = _FORM.fullmatch(address)
    is_radio = found is not None and int(found[1]) <= _CHANNEL_MAX
    if scheme not in LINK_DRIVERS or (scheme == "radio" and not is_radio):
        raise ConfigError(
            "drone.address",
            f"is {address!r}; allowed: an IP address, or radio://RADIO/CHANNEL/RATE/ADDRESS with a"
            f" channel of 0 to {_CHANNEL_MAX} and a rate of 250K, 1M or 2M, as"
            " radio://0/80/2M/E7E7E7E7E7",
        )
    return True


class RadioWire:
    """One drone's packets over a radio; calls belong to one asyncio loop, where ``hear`` runs.

    Args:
        address: ``radio://0/80/2M/E7E7E7E7E7``.
        hear: what takes every packet of the drone.

    Attributes:
        name: where the drone is.
        broken: packets that were none.
        problem: what is wrong with the radio; "" for nothing.
    """

    def __init__(self, address: str, hear: Callable[[Packet], None]) -> None:
        self.name, self.broken, self.problem = address, 0, ""
        self._hear = hear
        self._outbox = Outbox()
        self._ends, self._fails = Event(), Event()
        self._threads: tuple[Thread, ...] = ()
        self._link: Any = None

    @property
    def is_open(self) -> bool:
        """Whether ``send`` goes anywhere."""
        return bool(self._threads)

    async def open(self) -> None:
        """Open the radio; it is opened anew by itself from then on.

        Raises:
            MissingPartError: cflib is not installed.
            LinkError: there is no such radio, or another program has it.
        """
        if self._threads:
            return
        loop = asyncio.get_running_loop()
        await asyncio.to_thread(self._open)
        self._ends.clear()
        self._outbox.clear()
        self._threads = (
            Thread(target=self._receive, args=(loop,), name="crazyflie radio in", daemon=True),
            Thread(target=self._transmit, name="crazyflie radio out", daemon=True),
        )
        for thread in self._threads:
            thread.start()

    async def close(self) -> None:
        """Close the radio."""
        self._ends.set()
        threads, self._threads = self._threads, ()
        for thread in threads:
            await asyncio.to_thread(thread.join)

    def send(self, packet: Packet) -> None:
        """Send a packet when the radio takes it; without a radio it is dropped."""
        if self._threads:
            self._outbox.put(packet)

    def _open(self) -> None:
        module, name = LINK_DRIVERS[self.name.partition("://")[0]]
        try:
            driver = getattr(import_module(module), name)()
        except ImportError as error:
            raise MissingPartError(PART, INSTALL) from error
        self._fails.clear()
        try:
            driver.connect(self.name, None, self._fail)
        # cflib raises plain exceptions, and libusb its own
        except Exception as error:
            self.problem = f"cannot open {self.name}: {error}"
            raise LinkError(self.problem) from error
        self.problem, self._link = "", driver

    def _fail(self, words: str) -> None:
        """Let the link be opened anew, whatever cflib complains of."""
        self._fails.set()

    def _close(self) -> None:
        link, self._link = self._link, None
        if link is not None:
            link.close()

    def _receive(self, loop: asyncio.AbstractEventLoop) -> None:
        """Hand over what comes; open the radio anew when it fails or says nothing any more."""
        quiet = 0.0
        while not self._ends.is_set():
            if self._fails.is_set() or quiet > _SILENT_AFTER:
                self._close()
            if self._link is None:
                try:
                    self._open()
                except LinkError:
                    self._ends.wait(_AGAIN_AFTER)
                    continue
                quiet = 0.0
            try:
                heard = self._link.receive_packet(_PATIENCE)
            except Exception as error:
                self._fail(str(error))
                continue
            quiet = quiet + _PATIENCE if heard is None else 0.0
            if heard is not None:
                self._take_in(bytes((heard.header, *heard.data)), loop)
        self._close()

    def _take_in(self, data: bytes, loop: asyncio.AbstractEventLoop) -> None:
        try:
            packet = decode_crtp(data)
        except WireError:
            self.broken += 1
            return
        if not is_null(packet) and not loop.is_closed():
            loop.call_soon_threadsafe(self._hear, packet)

    def _transmit(self) -> None:
        stack = import_module("cflib.crtp.crtpstack")
        while not self._ends.is_set():
            packet, link = self._outbox.take(_PATIENCE), self._link
            if packet is not None and link is not None:
                header, *data = encode_crtp(packet)
                try:
                    link.send_packet(stack.CRTPPacket(header, data))
                except Exception as error:
                    self._fail(str(error))
