"""One conversation with a NatNet server, from the greeting to its silence."""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from housefly.clock import Clock
from housefly.config.site import TrackingConfig
from housefly.errors import LinkError, WireError
from housefly.tracking.contracts import Sink
from housefly.tracking.counts import FrameCounts
from housefly.tracking.datagrams import Address, Ear, multicast_receiver
from housefly.tracking.flood import MOST, FloodGate
from housefly.tracking.natnet_frames import NatNetFrames
from housefly.wires.natnet import (
    Connect,
    Frame,
    Item,
    KeepAlive,
    ModelDef,
    Request,
    RequestModelDef,
    Response,
    ServerInfo,
    Version,
    decode_message,
    encode_message,
)

WISH: Version = (4, 1)
"""The newest version that was checked against others; servers that speak a newer one are asked for
it.
"""
SILENCE = 5.0
"""A server silent for this long [s] is greeted anew, by a new session: it may have come back as
another.
"""
QUIET = 1.0
"""After this long without a frame [s] a server is greeted again: it may have forgotten us."""
_GREETINGS, _GREETING_PERIOD = 8, 0.25
_TICK = 0.5


class NatNetSession:
    """Greets a server, joins its group if it has one, and passes sightings on.

    Args:
        config: where the server is.
        clock: for arrival times.
        sink: gets each frame's sightings.
        counts: kept up to date.

    Attributes:
        frame_at: when the last new frame came [s].
    """

    def __init__(
        self, config: TrackingConfig, clock: Clock, sink: Sink, counts: FrameCounts
    ) -> None:
        self.frame_at = float("-inf")
        self._config = config
        self._clock = clock
        self._sink = sink
        self._counts = counts
        self._gate = FloodGate()
        self._flooded_at = self._arrived_at = self._greeted_at = float("-inf")
        self._version: Version = (3, 1)
        self._info: ServerInfo | None = None
        self._frames: NatNetFrames | None = None
        self._response: int | None = None
        self._another = False
        self._stranger = self._garbage = self._host = self._interface = ""
        self._news = asyncio.Event()
        self._transports: list[asyncio.DatagramTransport] = []
        self._ear = Ear(self._heard)

    @property
    def greeted(self) -> bool:
        """Whether the server said who it is."""
        return self._frames is not None

    @property
    def flood_problem(self) -> str:
        """Whether more comes than can be, in words, or ""."""
        flooded = self._clock.now() - self._flooded_at <= QUIET
        return (
            f"{self._where} sends more than {MOST} datagrams a second; the others are dropped"
            if flooded
            else ""
        )

    @property
    def silence(self) -> str:
        """Why no new frame comes, in words."""
        now = self._clock.now()
        if now - self._arrived_at <= QUIET:
            return (
                f"frames arrive from {self._where}, but their time stands still; is Motive paused?"
            )
        if self._garbage:
            return (
                f"what arrives from {self._where} is not NatNet"
                f" {self._version[0]}.{self._version[1]} ({self._garbage})"
            )
        if self._stranger:
            return (
                f"frames come from {self._stranger}, not from {self._host}; set tracking.address to"
                f" {self._stranger}"
            )
        if self._info is not None and self._info.multicast:
            return (
                f"{self._where} streams to the multicast group"
                f" {self._info.group}:{self._info.data_port}, but nothing arrives at"
                f" {self._interface}; let firewall and switch pass it, or choose unicast in Motive"
            )
        return f"connected to {self._where}, but it is silent; is Motive live, not paused?"

    async def run(self) -> None:
        """Listen until the server falls silent; raises LinkError."""
        try:
            await self._open()
            info = await self._greet()
            await self._settle_version(info)
            if info.multicast:
                await self._join(info)
            self._greeted_at = self._clock.now()
            self._frames = NatNetFrames(
                info.clock_hz, self._config.latency, self._config.y_up, self._counts
            )
            await self._listen(self._frames, info.multicast)
        finally:
            for transport in self._transports:
                transport.abort()

    @property
    def _where(self) -> str:
        return f"{self._config.address}:{self._config.natnet_port}"

    async def _open(self) -> None:
        loop = asyncio.get_running_loop()
        target = (self._config.address, self._config.natnet_port)
        try:
            transport, _ = await loop.create_datagram_endpoint(
                lambda: self._ear, remote_addr=target
            )
        except (OSError, UnicodeError) as error:
            raise LinkError(f"{self._where} cannot be reached ({error})") from error
        self._transports.append(transport)
        self._host = transport.get_extra_info("peername")[0]
        self._interface = transport.get_extra_info("sockname")[0]

    async def _greet(self) -> ServerInfo:
        for _ in range(_GREETINGS):
            self._send(Connect(WISH))
            if (
                await self._comes(lambda: self._info is not None, _GREETING_PERIOD)
                and self._info is not None
            ):
                return self._info
        if self._garbage:
            raise LinkError(
                f"what answers at {self._where} does not speak NatNet ({self._garbage})"
            )
        raise LinkError(
            f"nobody answers at {self._where}; is Motive running, with streaming switched on?"
        )

    async def _settle_version(self, info: ServerInfo) -> None:
        """Use the server's version, or the one that we wish for where it is newer and the server
        lets us.
        """
        major, minor, *_ = info.version
        if major not in (3, 4):
            raise LinkError(
                f"{self._where} speaks NatNet {major}.{minor}; Housefly reads 3.0 to 4.x (Motive"
                " 2.0 to 3.x)"
            )
        self._version = (major, minor)
        if self._version > WISH and not info.multicast:
            self._send(Request(f"Bitstream,{WISH[0]}.{WISH[1]}"))
            if await self._comes(lambda: self._response is not None, _TICK) and self._response == 0:
                self._version = WISH

    async def _join(self, info: ServerInfo) -> None:
        loop = asyncio.get_running_loop()
        try:
            receiver = multicast_receiver(info.group, info.data_port, self._interface)
        except OSError as error:
            raise LinkError(
                f"cannot join the multicast group {info.group}:{info.data_port} at"
                f" {self._interface} ({error.strerror}); choose unicast in Motive"
            ) from error
        transport, _ = await loop.create_datagram_endpoint(lambda: Ear(self._heard), sock=receiver)
        self._transports.append(transport)

    async def _listen(self, frames: NatNetFrames, multicast: bool) -> None:
        """Keep the conversation going; frames arrive by ``_heard``."""
        while True:
            quiet = self._clock.now() - max(self.frame_at, self._greeted_at)
            if quiet > SILENCE:
                raise LinkError(self.silence)
            if self._another:
                raise LinkError(f"another server answers at {self._where} now")
            if self._ear.refused and quiet > QUIET:
                raise LinkError(
                    f"the server at {self._where} is gone; is Motive running, with streaming"
                    " switched on?"
                )
            if quiet > QUIET:
                self._send(Connect(WISH))
            elif not multicast:
                self._send(KeepAlive())
            if frames.wants_names:
                self._send(RequestModelDef())
            await asyncio.sleep(_TICK)

    def _send(self, item: Item) -> None:
        self._transports[0].sendto(encode_message(item, self._version))

    async def _comes(self, condition: Callable[[], bool], seconds: float) -> bool:
        """Wait until a message makes the condition true; tell whether it did in time."""
        try:
            async with asyncio.timeout(seconds):
                while not condition():
                    self._news.clear()
                    await self._news.wait()
        except TimeoutError:
            return False
        return True

    def _heard(self, datagram: bytes, sender: Address) -> None:
        now = self._clock.now()
        if sender[0] != self._host:
            self._counts.strangers += 1
            self._stranger = sender[0]
            return
        if not self._gate.admits(now):
            self._counts.flooded += 1
            self._flooded_at = now
            return
        try:
            item = decode_message(datagram, self._version)
        except WireError as error:
            self._counts.malformed += 1
            self._garbage = str(error)
            return
        self._garbage = ""
        self._use(item, now)
        self._news.set()

    def _use(self, item: Item, now: float) -> None:
        match item:
            case Frame() if self._frames is not None:
                self._arrived_at = now
                sightings = self._frames.read(item, now)
                if sightings is not None:
                    self.frame_at = now
                    self._sink(sightings)
            case ModelDef() if self._frames is not None:
                self._frames.use_names(item)
            case Response(code):
                self._response = code
            case ServerInfo() if self._info is None:
                self._info = item
            case ServerInfo() if self._frames is not None:
                self._another = item != self._info
                self._frames.forget_names()
