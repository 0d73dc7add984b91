"""A Kite's driver: it carries what the failsafe decides, and what the drone reports."""

import asyncio
from collections.abc import Callable
from contextlib import suppress

from housefly import (
    Capabilities,
    Clock,
    Command,
    DroneConfig,
    Failsafe,
    KnownMotion,
    LimitsConfig,
    LinkError,
    Sighting,
    Telemetry,
    VideoFrame,
    WireError,
)
from kite import wire


class Driver(asyncio.DatagramProtocol):
    """Implements ``housefly.DroneDriver``."""

    video_connected, problem, firmware, notes = False, "", "1.0", ()

    def __init__(self, config: DroneConfig, limits: LimitsConfig, clock: Clock) -> None:
        self._address, self._airframe, self._clock = config.address, config.airframe, clock
        self._failsafe = Failsafe(clock.now(), limits.tilt_max, config.airframe)
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
        """Reports per second: it answers each command."""
        return 1.0 / self._airframe.link.interval if self.connected else 0.0

    async def connect(self) -> None:
        """Open the wire; it is told something from then on, at its own rate."""
        if self._sending is None:
            there, loop = (self._address, wire.PORT), asyncio.get_running_loop()
            self._link, _ = await loop.create_datagram_endpoint(lambda: self, remote_addr=there)
            self._sending = asyncio.create_task(self._send_for_ever())
        try:
            await asyncio.wait_for(self._heard.wait(), 2.0)
        except TimeoutError as error:
            raise LinkError(f"no Kite answers at {self._address}: is it on?") from error

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
        """Tell it where it was, and how long ago."""
        if self._sending is not None:
            self._link.sendto(wire.pose_line(seen, self._clock.now()))

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
            await asyncio.sleep(self._airframe.link.interval)

    def _transmit(self) -> None:
        if self._sending is not None:
            told = self._failsafe.decide(self._clock.now(), self.telemetry).command
            self._link.sendto(wire.command_line(told))

    def datagram_received(self, data: bytes, addr: tuple[str, int]) -> None:
        """Take in a report; anything else is none."""
        with suppress(WireError):
            self.telemetry = wire.report_of(data, self._clock.now())
            self._heard.set()
            self._handler()
