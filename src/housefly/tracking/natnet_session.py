"""One session with a NatNet server, from the greeting to its silence."""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from housefly.clock import Clock
from housefly.config.tracking import TrackingConfig
from housefly.errors import LinkError, WireError
from housefly.messages.words import UNSAID, Words, figure, literal
from housefly.tracking.contracts import SightingSink
from housefly.tracking.counts import FrameCounts
from housefly.tracking.datagrams import DatagramReceiver, SocketAddress, multicast_receiver
from housefly.tracking.natnet_frames import NatNetFrames
from housefly.tracking.rate_limit import FRAMES_PER_SECOND_MAX, FrameLimiter
from housefly.tracking.software import software_at
from housefly.wires.natnet import (
    CommandRequest,
    CommandResponse,
    Connect,
    KeepAlive,
    ModelDef,
    NatNetFrame,
    NatNetMessage,
    NatNetVersion,
    RequestModelDef,
    ServerInfo,
    decode_natnet,
    encode_natnet,
)

_NEWEST_VERSION: NatNetVersion = (4, 1)
"""The newest version that was checked against others; newer servers are asked for it."""
_SILENCE_TIMEOUT = 5.0
"""After this long without a frame [s] a new session begins: the server may have been replaced."""
_GREET_AGAIN = 1.0
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
    """

    def __init__(
        self, config: TrackingConfig, clock: Clock, sink: SightingSink, counts: FrameCounts
    ) -> None:
        self._frame_at = float("-inf")
        self._config = config
        self._clock = clock
        self._sink = sink
        self._counts = counts
        self._limiter = FrameLimiter()
        self._flooded_at = self._arrived_at = self._greeted_at = float("-inf")
        self._version: NatNetVersion = (3, 1)
        self._info: ServerInfo | None = None
        self._frames: NatNetFrames | None = None
        self._response: int | None = None
        self._replaced = False
        self._other_host = self._malformed = self._host = self._interface = ""
        self._changed = asyncio.Event()
        self._transports: list[asyncio.DatagramTransport] = []
        self._receiver = DatagramReceiver(self._on_datagram)

    @property
    def greeted(self) -> bool:
        """Whether the server said who it is."""
        return self._frames is not None

    @property
    def flood_problem(self) -> Words:
        """That more arrives than any tracking system sends; UNSAID where it does not."""
        flooded = self._clock.now() - self._flooded_at <= _GREET_AGAIN
        return (
            Words(
                "{name} sends more than {n} frames a second; the rest is dropped",
                name=self._where,
                n=figure(FRAMES_PER_SECOND_MAX),
            )
            if flooded
            else UNSAID
        )

    @property
    def silence(self) -> Words:
        """Why no new frame comes."""
        now = self._clock.now()
        if now - self._arrived_at <= _GREET_AGAIN:
            return Words(
                "frames arrive from {name}, but their time stands still; is {what} paused?",
                name=self._where,
                what=software_at(self._config.address, "Motive"),
            )
        if self._malformed:
            return Words(
                "what answers at {name} does not speak {protocol} ({error})",
                name=self._where,
                protocol=f"NatNet {self._version[0]}.{self._version[1]}",
                error=self._malformed,
            )
        if self._other_host:
            return Words(
                "frames do not come from {name}; set tracking.address to {other}",
                name=self._host,
                other=self._other_host,
            )
        if self._info is not None and self._info.multicast:
            return literal(
                f"{self._where} streams to the multicast group"
                f" {self._info.group}:{self._info.data_port}, but nothing arrives at"
                f" {self._interface}; let firewall and switch pass it, or choose unicast in Motive"
            )
        return Words(
            "connected to {name}, but nothing new arrives; is {what} live, not paused?",
            name=self._where,
            what=software_at(self._config.address, "Motive"),
        )

    async def run(self) -> None:
        """Listen until the server falls silent; raises LinkError."""
        try:
            await self._open()
            info = await self._greet()
            await self._negotiate_version(info)
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
                lambda: self._receiver, remote_addr=target
            )
        except (OSError, UnicodeError) as error:
            raise LinkError(f"{self._where} cannot be reached ({error})") from error
        self._transports.append(transport)
        self._host = transport.get_extra_info("peername")[0]
        self._interface = transport.get_extra_info("sockname")[0]

    async def _greet(self) -> ServerInfo:
        for _ in range(_GREETINGS):
            self._send(Connect(_NEWEST_VERSION))
            if (
                await self._wait_for(lambda: self._info is not None, _GREETING_PERIOD)
                and self._info is not None
            ):
                return self._info
        if self._malformed:
            raise LinkError(
                Words(
                    "what answers at {name} does not speak {protocol} ({error})",
                    name=self._where,
                    protocol="NatNet",
                    error=self._malformed,
                )
            )
        raise LinkError(
            Words(
                "nobody answers at {name}; is {what} running, and does it stream?",
                name=self._where,
                what=software_at(self._config.address, "Motive"),
            )
        )

    async def _negotiate_version(self, info: ServerInfo) -> None:
        """Use the server's version, or ``_NEWEST_VERSION`` if a newer server agrees."""
        major, minor, *_ = info.version
        if major not in (3, 4):
            application = ".".join(map(str, info.application_version[:2]))
            raise LinkError(
                f"{info.application or 'a server'} {application} at {self._where} speaks NatNet"
                f" {major}.{minor}; Housefly reads 3.0 to 4.x (Motive 2.0 to 3.x): update it, or"
                " use its VRPN stream"
            )
        self._version = (major, minor)
        if self._version > _NEWEST_VERSION and not info.multicast:
            self._send(CommandRequest(f"Bitstream,{_NEWEST_VERSION[0]}.{_NEWEST_VERSION[1]}"))
            if (
                await self._wait_for(lambda: self._response is not None, _TICK)
                and self._response == 0
            ):
                self._version = _NEWEST_VERSION

    async def _join(self, info: ServerInfo) -> None:
        loop = asyncio.get_running_loop()
        try:
            receiver = multicast_receiver(info.group, info.data_port, self._interface)
        except OSError as error:
            raise LinkError(
                f"cannot join the multicast group {info.group}:{info.data_port} at"
                f" {self._interface} ({error.strerror}); choose unicast in Motive"
            ) from error
        transport, _ = await loop.create_datagram_endpoint(
            lambda: DatagramReceiver(self._on_datagram), sock=receiver
        )
        self._transports.append(transport)

    async def _listen(self, frames: NatNetFrames, multicast: bool) -> None:
        """Keep the session alive; frames arrive by ``_on_datagram``."""
        while True:
            quiet = self._clock.now() - max(self._frame_at, self._greeted_at)
            if quiet > _SILENCE_TIMEOUT:
                raise LinkError(self.silence)
            if self._replaced:
                raise LinkError(f"another server answers at {self._where} now")
            if self._receiver.refused and quiet > _GREET_AGAIN:
                raise LinkError(
                    Words(
                        "nobody answers at {name}; is {what} running, and does it stream?",
                        name=self._where,
                        what=software_at(self._config.address, "Motive"),
                    )
                )
            if quiet > _GREET_AGAIN:
                self._send(Connect(_NEWEST_VERSION))
            elif not multicast:
                self._send(KeepAlive())
            if frames.wants_names:
                self._send(RequestModelDef())
            await asyncio.sleep(_TICK)

    def _send(self, item: NatNetMessage) -> None:
        self._transports[0].sendto(encode_natnet(item, self._version))

    async def _wait_for(self, condition: Callable[[], bool], seconds: float) -> bool:
        """Wait until a message makes the condition true; return whether one did in time."""
        try:
            async with asyncio.timeout(seconds):
                while not condition():
                    self._changed.clear()
                    await self._changed.wait()
        except TimeoutError:
            return False
        return True

    def _on_datagram(self, datagram: bytes, sender: SocketAddress) -> None:
        now = self._clock.now()
        if sender[0] != self._host:
            self._counts.other_hosts += 1
            self._other_host = sender[0]
            return
        if not self._limiter.admits(now):
            self._counts.flooded += 1
            self._flooded_at = now
            return
        try:
            item = decode_natnet(datagram, self._version)
        except WireError as error:
            self._counts.malformed += 1
            self._malformed = str(error)
            return
        self._malformed = ""
        self._on_message(item, now)
        self._changed.set()

    def _on_message(self, item: NatNetMessage, now: float) -> None:
        match item:
            case NatNetFrame() if self._frames is not None:
                self._arrived_at = now
                sightings = self._frames.read(item, now)
                if sightings is not None:
                    self._frame_at = now
                    self._sink(sightings)
            case ModelDef() if self._frames is not None:
                self._frames.learn_names(item)
            case CommandResponse(code):
                self._response = code
            case ServerInfo() if self._info is None:
                self._info = item
            case ServerInfo() if self._frames is not None:
                self._replaced = item != self._info
                self._frames.forget_names()
