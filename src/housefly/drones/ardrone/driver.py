"""The AR.Drone 2.0 as a ``DroneDriver``: its four ports."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

from housefly.clock import Clock, RealClock
from housefly.config.drone import DroneConfig
from housefly.config.limits import LimitsConfig
from housefly.drones.ardrone.handshake import Configurator
from housefly.drones.ardrone.limits_keeper import LimitsKeeper
from housefly.drones.ardrone.link import CommandLink, led_value
from housefly.drones.ardrone.recording_light import RecordingLight
from housefly.drones.ardrone.telemetry import NavdataLink
from housefly.drones.ardrone.video import VideoLink
from housefly.drones.repeating_driver import RepeatingDriver
from housefly.errors import LinkError
from housefly.messages import (
    DroneStatus,
    Sighting,
    Telemetry,
    VideoFrame,
)
from housefly.messages.words import Words, error_words, figure, joined
from housefly.wires.ardrone import at
from housefly.wires.ardrone.command_encoder import CommandEncoder
from housefly.wires.ardrone.config import VideoChannel
from housefly.wires.ardrone.navdata import NAVDATA_PORT

if TYPE_CHECKING:
    from housefly.drones.contract import DroneDriver

FIRST_REPORT_TIMEOUT = 5.0
"""How long ``connect`` waits for the first report [s]."""


class ArDrone(RepeatingDriver):
    """Flies one AR.Drone 2.0, real or simulated.

    Args:
        config: where it answers and whether it has a camera.
        limits: what it may do; written into the drone's own configuration.
        clock: for ages and rates.
        full_navdata: 200 full reports a second (0.4 MB/s; about 2 % of one core more), or 15 short
            ones for a weak radio link.

    It takes off only once its limits were written, acknowledged, and read back equal. A drone that
    is found in the air only hovers and lands.
    """

    def __init__(
        self,
        config: DroneConfig,
        limits: LimitsConfig,
        clock: Clock | None = None,
        *,
        full_navdata: bool = True,
    ) -> None:
        super().__init__(config, limits.tilt_max, clock or RealClock())
        self._commands = CommandLink(config.address, self._clock)
        self._navdata = NavdataLink(config.address, self._clock)
        self._video = VideoLink(config.address, self._clock)
        self._light = RecordingLight()
        self._configurator = Configurator(config.address, self._commands, self._navdata)
        self._limits = LimitsKeeper(
            limits, self._configurator, self._navdata, full_navdata=full_navdata
        )
        self._failsafe.tilt_max = self._limits.maxima.tilt
        self._encoder = CommandEncoder(self._limits.maxima)
        self._told: tuple[Telemetry, Telemetry] | None = None

    async def connect(self) -> None:
        """Open the wire and configure the drone; may be called again after a failure.

        Raises:
            LinkError: no report came, or the configuration was not acknowledged; says which and
                what to look for.
        """
        await self._commands.open()
        await self._navdata.open()
        self._start_repeating()
        try:
            await self._greet()
        except LinkError as error:
            self._limits.problem = error_words(error)
            raise

    async def _greet(self) -> None:
        if await self._navdata.wait_for(lambda packet: True, FIRST_REPORT_TIMEOUT) is None:
            raise LinkError(
                Words(
                    "no drone answers at {name} within {n} s: is it switched on, and is your"
                    " computer in the drone's Wi-Fi?",
                    name=f"{self._config.address}:{NAVDATA_PORT}",
                    n=figure(FIRST_REPORT_TIMEOUT, "g"),
                )
            )
        await self._limits.write()
        self._use_limits()
        self._start("keep limits", self._keep_limits)
        if self._config.has_video:
            self._video.start()

    async def close(self) -> None:
        """Release the wire. Does not land: the pilot does that before."""
        await self._end_tasks()
        await self._video.close()
        await self._navdata.close()
        self._commands.close()

    def send_pose(self, seen: Sighting) -> None:
        """It wants none."""

    @property
    def telemetry(self) -> Telemetry | None:
        """The newest report, or None before the first."""
        report, configured = self._navdata.reports.telemetry, self._limits.confirmed
        if report is None:
            return None
        told = self._told
        if told is None or told[0] is not report or told[1].configured is not configured:
            told = report, replace(report, configured=configured, notes=self.notes)
            self._told = told
        return told[1]

    @property
    def notes(self) -> tuple[Words, ...]:
        """What is not as it should be with the drone's settings."""
        return (*self._limits.notes, *self._permit_notes)

    @property
    def configuration(self) -> dict[str, str]:
        """What the drone reported of its configuration, texts by key; empty before ``connect``."""
        return self._limits.texts

    @property
    def firmware(self) -> str:
        """The version of its firmware as it reported it; "" before ``connect``."""
        return self._limits.texts.get("general:num_version_soft", "")

    @property
    def problem(self) -> Words:
        """What is wrong with drone or link; UNSAID for nothing."""
        is_known = self._failsafe.permit is not None
        return joined("; ", self.notes) if is_known else self._limits.problem

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

    def show_recording(self, records: bool) -> None:
        """Blink red while the camera is recorded; goes out 1.5 s after the last time."""
        self._light.ask(records, self._clock.now())

    def on_report(self, handler: Callable[[], None]) -> None:
        """Call the handler after each report of the drone."""
        self._navdata.on_report = handler

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

    async def _keep_limits(self) -> None:
        await self._limits.keep(self._use_limits)

    def _use_limits(self) -> None:
        self._encoder.maxima = self._limits.maxima
        self._failsafe.tilt_max = self._limits.maxima.tilt

    def _transmit(self, now: float) -> None:
        if not self._commands.is_open:
            return
        self._sent_at = now
        hears = self._navdata.hears_us
        self._commands.numbers.report_reception(hears, now)
        report = self.telemetry
        told = self._failsafe.decide(now, report)
        commands = self._encoder.encoded(told, now, report)
        if not hears and at.ComWatchdog() not in commands:
            commands = (*commands, at.ComWatchdog())
        self._commands.send(*commands)
        # Behind the commands and never without them: to the drone it is a sign of life, too.
        if (led := self._light.due(now)) is not None:
            self._commands.send(led)

    def _land_blindly(self) -> None:
        self._commands.send(at.Ref(at.RefBits.LAND), at.Pcmd())


if TYPE_CHECKING:
    _MEETS_THE_CONTRACT: type[DroneDriver] = ArDrone
