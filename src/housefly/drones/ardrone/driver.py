"""The AR.Drone 2.0 as a ``Drone``: its four ports and the watchdog over the pilot.

A command whose action differs from the one before leaves in the same call. FLY setpoints leave at
the drone's rate, timed so that a regular pilot's setpoint leaves as soon as it comes; when the
pilot pauses, the newest command is repeated.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable, Coroutine

from housefly.clock import Clock, RealClock
from housefly.config.drone import DroneConfig
from housefly.config.limits import LimitsConfig
from housefly.drones.ardrone.handshake import Configurator
from housefly.drones.ardrone.link import CommandLink, led_value
from housefly.drones.ardrone.settings import (
    maxima_in,
    maxima_of,
    setting_mismatches,
    wanted_settings,
)
from housefly.drones.ardrone.telemetry import NavdataLink
from housefly.drones.ardrone.video import VideoLink
from housefly.errors import LinkError
from housefly.messages import Command, DroneStatus, Telemetry, VideoFrame
from housefly.wires.ardrone import at
from housefly.wires.ardrone.command_sequencer import (
    REPEAT_AFTER,
    SEND_INTERVAL_MIN,
    CommandSequencer,
)
from housefly.wires.ardrone.config import VideoChannel
from housefly.wires.ardrone.navdata import NAVDATA_PORT, StateBits

FIRST_REPORT_TIMEOUT = 5.0
"""How long ``connect`` waits for the first report [s]."""
_CONFIGURE_PAUSE = 1.0
"""Pause before a rebooted drone is configured again after a failure [s]."""


class ArDrone:
    """Flies one AR.Drone 2.0, real or simulated.

    Args:
        config: where it answers and whether it has a camera.
        limits: what it may do; written into the drone's own configuration.
        clock: for ages and rates.
        full_navdata: 200 full reports a second (0.4 MB/s; about 2 % of one core more), or 15 short
            ones for a weak radio link.

    Attributes:
        notes: settings that the drone did not accept, in words.
        configuration: as the drone reported it, texts by key; empty before ``connect``.
    """

    def __init__(
        self,
        config: DroneConfig,
        limits: LimitsConfig,
        clock: Clock | None = None,
        *,
        full_navdata: bool = True,
    ) -> None:
        self.notes: tuple[str, ...] = ()
        self.configuration: dict[str, str] = {}
        self._config = config
        self._limits = limits
        self._clock = clock or RealClock()
        self._full_navdata = full_navdata
        self._commands = CommandLink(config.address, self._clock)
        self._navdata = NavdataLink(config.address, self._clock)
        self._video = VideoLink(config.address, self._clock)
        self._configurator = Configurator(config.address, self._commands, self._navdata)
        self._sequencer = CommandSequencer(maxima_of(limits), self._clock.now())
        self._sent_at = float("-inf")
        self._tasks: dict[str, asyncio.Task[None]] = {}

    async def connect(self) -> None:
        """Open the wire and configure the drone; may be called again after a failure.

        Raises:
            LinkError: no report came, or the configuration was not acknowledged; says which and
                what to look for.
        """
        await self._commands.open()
        await self._navdata.open()
        self._start("repeat commands", self._repeat)
        if await self._navdata.wait_for(lambda packet: True, FIRST_REPORT_TIMEOUT) is None:
            raise LinkError(
                f"no drone answers at {self._config.address}:{NAVDATA_PORT} within"
                f" {FIRST_REPORT_TIMEOUT:g} s: is it switched on, and is your computer in the"
                " drone's Wi-Fi?"
            )
        await self._configure()
        self._start("configure after reboot", self._configure_after_reboot)
        if self._config.has_video:
            self._video.start()

    async def close(self) -> None:
        """Release the wire. Does not land: the pilot does that before."""
        for task in self._tasks.values():
            task.cancel()
        await asyncio.gather(*self._tasks.values(), return_exceptions=True)
        self._tasks.clear()
        await self._video.close()
        await self._navdata.close()
        self._commands.close()

    def send(self, command: Command) -> None:
        """Hand over the command in force from now on; returns at once."""
        now = self._clock.now()
        action_changed = self._sequencer.update(command, now)
        if action_changed or now - self._sent_at >= SEND_INTERVAL_MIN:
            self._transmit(now)

    @property
    def telemetry(self) -> Telemetry | None:
        """The newest report, or None before the first."""
        return self._navdata.reports.telemetry

    @property
    def telemetry_rate_hz(self) -> float:
        """Reports per second over the last second."""
        return self._navdata.reports.rate_hz(self._clock.now())

    @property
    def connected(self) -> bool:
        """Whether reports arrive."""
        return self._navdata.connected

    @property
    def video_connected(self) -> bool:
        """Whether pictures arrive."""
        return self._video.connected

    def on_video(self, handler: Callable[[VideoFrame], None]) -> None:
        """Call the handler with each picture from the first key frame on."""
        self._video.handlers.append(handler)

    async def select_camera(self, channel: VideoChannel) -> None:
        """Show the front or the bottom camera; raises LinkError when the drone does not answer."""
        await self._configurator.write("video:video_channel", int(channel))

    async def leds(self, animation: int, frequency_hz: float = 2.0, seconds: int = 2) -> None:
        """Play a light animation (0 to 20); raises LinkError when the drone does not answer."""
        await self._configurator.write(
            "leds:leds_anim", led_value(animation, frequency_hz, seconds)
        )

    def flat_trim(self) -> None:
        """Take the present attitude as level; raises LinkError unless the drone is landed."""
        report = self.telemetry
        if report is None or report.status is not DroneStatus.LANDED:
            state = "unknown" if report is None else report.status.value
            raise LinkError(f"flat trim needs a drone on the ground; this one's state is: {state}")
        self._commands.send(at.FlatTrim())

    async def _configure(self) -> None:
        # each acknowledgement takes two reports; full ones come 5 ms apart, so this is quick even
        # where short ones follow
        await self._configurator.write("general:navdata_demo", False)
        await self._configurator.log_in()
        for name, value in wanted_settings(self._limits):
            await self._configurator.write(name, value)
        dump = await self._configurator.read()
        self.configuration = dump.texts
        self.notes = setting_mismatches(dump, self._limits)
        self._sequencer.maxima = maxima_in(dump, maxima_of(self._limits))
        if not self._full_navdata:
            await self._configurator.write("general:navdata_demo", True)

    async def _configure_after_reboot(self) -> None:
        while True:
            await self._navdata.wait_for(
                lambda packet: packet.has(StateBits.NAVDATA_BOOTSTRAP), None
            )
            with contextlib.suppress(LinkError):
                await self._configure()
                continue
            await asyncio.sleep(_CONFIGURE_PAUSE)

    async def _repeat(self) -> None:
        while True:
            now = self._clock.now()
            if now - self._sent_at >= REPEAT_AFTER:
                self._transmit(now)
            await asyncio.sleep(max(0.001, self._sent_at + REPEAT_AFTER - self._clock.now()))

    def _transmit(self, now: float) -> None:
        if not self._commands.is_open:
            return
        self._sent_at = now
        hears = self._navdata.hears_us
        self._commands.numbers.report_reception(hears, now)
        commands = self._sequencer.next_commands(now, self.telemetry)
        if not hears and at.ComWatchdog() not in commands:
            commands = (*commands, at.ComWatchdog())
        self._commands.send(*commands)

    def _start(self, name: str, work: Callable[[], Coroutine[None, None, None]]) -> None:
        if name not in self._tasks:
            self._tasks[name] = asyncio.create_task(work(), name=name)
