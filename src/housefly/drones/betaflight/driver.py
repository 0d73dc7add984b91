"""A flight controller with Betaflight as a ``DroneDriver``: MSP over TCP, UDP or a serial port.

It is steered by sticks in ANGLE mode. Its height, its take-off and its landing are ours, by what
tracking sees: without poses it does not take off, and sinks. It takes off only once everything on
it was found to be set as it must be, and the channels that it flies by were seen to be ours.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import TYPE_CHECKING

from housefly.clock import Clock, RealClock
from housefly.config.drone import DroneConfig
from housefly.config.limits import LimitsConfig
from housefly.drones.betaflight.checks import lacking_channels, lacking_settings, refusal
from housefly.drones.betaflight.controller import Controller, Questions
from housefly.drones.betaflight.echo import Echo
from housefly.drones.betaflight.height import height_model
from housefly.drones.betaflight.link import LinkCounters, MspLink
from housefly.drones.betaflight.manoeuvres import FcState, StickManoeuvres
from housefly.drones.repeating_driver import RepeatingDriver
from housefly.errors import LinkError
from housefly.geometry import GRAVITY
from housefly.messages import DroneStatus, Sighting, Telemetry, VideoFrame
from housefly.messages.sensing import REPORT_AGE_MAX
from housefly.messages.words import UNSAID, Words, error_words, joined
from housefly.wires.betaflight.commands import VARIANT, Msp
from housefly.wires.betaflight.endpoint import msp_endpoint_of
from housefly.wires.betaflight.framing import MspFrame
from housefly.wires.betaflight.reports import encode_channels
from housefly.wires.betaflight.settings import Box, FcSettings
from housefly.wires.betaflight.sticks import RadioSticks, flight_channels, raw_channels
from housefly.wires.betaflight.switches import STICKS, Switches, switches_of

if TYPE_CHECKING:
    from housefly.drones.contract import DroneDriver

FIRST_REPORT_TIMEOUT = 5.0
"""How long ``connect`` waits until everything was told [s]."""
BLIND_THRUST = 0.95
"""Over weight: what it is told where nobody knows what to send any more, level."""
_NAME = "Betaflight"


class Betaflight(RepeatingDriver):
    """Flies one drone with Betaflight, real or simulated.

    Args:
        config: its airframe, and where it answers: ``HOST``, ``tcp:HOST:PORT``, ``udp:HOST:PORT``
            or ``serial:FILE:BAUD``.
        limits: what it may do.
        clock: for ages and rates.
    """

    def __init__(
        self, config: DroneConfig, limits: LimitsConfig, clock: Clock | None = None
    ) -> None:
        super().__init__(config, limits.tilt_max, clock or RealClock())
        self._tilt_max = limits.tilt_max
        self._controller, self._questions = Controller(), Questions()
        self._set: FcSettings | None = None
        self._switches: Switches | Box = Box.ARM
        self._echo = Echo(frozenset())
        self._model = height_model(config.airframe, FcSettings().motor_idle)
        standing = config.airframe.body.standing_height
        self._manoeuvres = StickManoeuvres(self._model, limits.tilt_max, standing)
        self._link: MspLink | None = None
        self._report: Telemetry | None = None
        self._is_ours = False
        self._lacking: tuple[Words, ...] = ()
        self._trouble = UNSAID
        self._heard = asyncio.Event()
        self._handler: Callable[[], None] = lambda: None

    async def connect(self) -> None:
        """Open the wire and read how it is set; may be called again after a failure.

        Raises:
            LinkError: no way there, nobody answers, or what answers is no Betaflight.
        """
        endpoint = msp_endpoint_of(self._config.address)
        self._link = self._link or MspLink(endpoint, self._clock, self._hear, self._opened)
        try:
            await self._link.open()
        except LinkError as error:
            self._trouble = error_words(error)
            raise
        self._start_repeating()
        try:
            async with asyncio.timeout(FIRST_REPORT_TIMEOUT):
                await self._heard.wait()
            stranger = self._stranger()
            if stranger is not None:
                raise LinkError(stranger)
        except TimeoutError as error:
            self._trouble = Words(
                "nobody answers at {name}; is {what} running, and does it stream?",
                name=str(endpoint),
                what=_NAME,
            )
            raise LinkError(self._trouble) from error
        self._trouble = UNSAID

    async def close(self) -> None:
        """Release the wire. Does not land: the pilot does that before."""
        await self._end_tasks()
        if self._link is not None:
            await self._link.close()

    def send_pose(self, seen: Sighting) -> None:
        """Know where it is: its height loop is here, the controller wants no pose."""
        self._manoeuvres.see(seen)

    @property
    def telemetry(self) -> Telemetry | None:
        """The newest report, or None before the first."""
        return self._report

    @property
    def telemetry_rate_hz(self) -> float:
        """Reports per second over the last second."""
        return self._controller.rate_hz(self._clock.now())

    @property
    def connected(self) -> bool:
        """Whether reports arrive."""
        report = self._report
        return report is not None and self._clock.now() - report.received_at < REPORT_AGE_MAX

    @property
    def firmware(self) -> str:
        """Its version, "" before it told that."""
        version = self._controller.firmware
        return f"{_NAME} {version}" if version else ""

    @property
    def counters(self) -> LinkCounters:
        """What happened on the wire."""
        return LinkCounters() if self._link is None else self._link.counters

    @property
    def notes(self) -> tuple[Words, ...]:
        """What is not as it should be, and why it does not arm, in its own words."""
        stranger = self._stranger()
        if stranger is not None:
            return (stranger,)
        controller = self._controller
        if not controller.is_known:
            return self._permit_notes
        found = (*self._lacking, *self._permit_notes)
        if controller.is_armed:
            return (*found, *self._taken())
        why = refusal(controller.blocked)
        return (*found, *self._not_ours(), *((why,) if why is not None else ()))

    @property
    def problem(self) -> Words:
        """What is wrong with drone or link; UNSAID for nothing."""
        return joined("; ", self.notes) if self._heard.is_set() else self._trouble

    def show_recording(self, records: bool) -> None:
        """It has no light of ours."""

    def on_report(self, handler: Callable[[], None]) -> None:
        """Call the handler after each report of the drone."""
        self._handler = handler

    def on_video(self, handler: Callable[[VideoFrame], None]) -> None:
        """It has no camera of ours."""

    def _stranger(self) -> Words | None:
        variant = self._controller.variant
        if variant in (b"", VARIANT):
            return None
        return Words(
            "what answers at {name} does not speak {protocol} ({error})",
            name=self._config.address,
            protocol=_NAME,
            error=variant.decode("ascii", "replace"),
        )

    def _not_ours(self) -> tuple[Words, ...]:
        """Return which channels do not come back as we sent them."""
        lacking = self._echo.lacking(self._clock.now())
        if lacking is None:
            if self._is_ours:
                return ()
            setting = Words("the drone does not tell its {setting} yet", setting="MSP_RC")
            return (setting,)
        fc = self._controller.settings
        return (lacking_channels(lacking, fc),) if lacking else ()

    def _taken(self) -> tuple[Words, ...]:
        """Return that somebody else flies it."""
        if not self._echo.is_taken():
            return ()
        mode = "MSP OVERRIDE"
        return (Words("somebody else flies it, or it does by itself (mode {mode})", mode=mode),)

    @property
    def _is_configured(self) -> bool:
        lacking = self._echo.lacking(self._clock.now())
        if lacking is not None and not self._controller.is_armed:
            self._is_ours = not lacking
        is_known = self._controller.is_known and self._stranger() is None
        return is_known and self._is_ours and not self._lacking

    @property
    def _state(self) -> FcState:
        controller = self._controller
        phi, theta = controller.lean
        return FcState(controller.is_armed, not controller.blocked, phi, theta)

    def _hear(self, frame: MspFrame) -> None:
        now = self._clock.now()
        controller = self._controller
        was_armed = controller.is_armed
        is_motion = controller.hear(frame, now)
        if was_armed and not controller.is_armed:
            self._echo.begin_anew()
        if controller.settings is not self._set:
            self._take_over(controller.settings)
        if frame.command == Msp.RC and controller.hears_us:
            # what stands in for sticks that it does not hear says nothing of whose they are
            self._echo.heard(controller.channels, now)
        if not controller.is_known or not controller.is_heard(now):
            self._ask_missing()
        if self._stranger() is not None:
            self._heard.set()
        if not is_motion or not controller.is_known:
            return
        self._report = controller.report(
            self._status(now), configured=self._is_configured, notes=self.notes
        )
        self._heard.set()
        self._handler()

    def _status(self, now: float) -> DroneStatus:
        if not self._controller.is_heard(now):
            return DroneStatus.UNKNOWN
        return self._manoeuvres.status(self._state)

    def _take_over(self, fc: FcSettings) -> None:
        """Use settings that were told."""
        self._set = fc
        switches = switches_of(fc.ranges)
        if switches != self._switches:
            self._switches = switches
            own = switches.own if isinstance(switches, Switches) else frozenset[int]()
            self._echo = Echo(frozenset(range(STICKS)) | {STICKS + one for one in own})
        self._model = height_model(self._config.airframe, fc.motor_idle)
        self._manoeuvres.use(self._model)
        self._lacking = lacking_settings(fc, switches, self._model, self._tilt_max)

    def _opened(self) -> None:
        """Begin on a wire that was opened: another controller may answer, unless one is flown."""
        self._is_ours &= self._controller.is_armed
        self._ask_missing()

    def _ask_missing(self) -> None:
        if self._link is None:
            return
        question = self._questions.missing(self._controller.told, self._clock.now())
        if question is not None:
            self._link.send(question)

    def _transmit(self, now: float) -> None:
        link, controller = self._link, self._controller
        if link is None or not link.is_open:
            return
        self._sent_at = now
        if not controller.is_known or not isinstance(self._switches, Switches):
            # a stick that arms nothing, or stops motors in the air, is worse than none
            self._ask_missing()
            self._ask(now)
            return
        told = self._failsafe.decide(now, self._report)
        leaves = self._manoeuvres.told(told, self._state, now)
        self._send(leaves.sticks, now, arms=leaves.arms)
        self._ask(now)

    def _send(self, sticks: RadioSticks, now: float, *, arms: bool) -> None:
        switches, fc = self._switches, self._controller.settings
        assert self._link is not None and isinstance(switches, Switches)
        positions = switches.armed if arms else switches.disarmed
        channels = (*flight_channels(sticks, fc), *positions)
        if not arms and not self._controller.is_armed:
            channels = self._echo.moved(channels, now)
        roll, pitch, yaw, throttle = channels[:STICKS]
        raw = raw_channels((roll, pitch, yaw, throttle), channels[STICKS:], fc)
        if self._link.send(Msp.SET_RAW_RC, encode_channels(raw)):
            self._echo.sent(channels, now)

    def _ask(self, now: float) -> None:
        link = self._link
        if link is None or not link.may_ask:
            return
        question = self._questions.due(now, stands=not self._controller.is_armed)
        if question is not None:
            link.send(question)
            if question is Msp.RC:
                self._echo.asked(now)

    def _land_blindly(self) -> None:
        """Sink level by what its hover throttle was learned to be."""
        if not self._controller.is_armed or not isinstance(self._switches, Switches):
            return
        carried = 1.0 - self._manoeuvres.height.state.push / GRAVITY
        throttle = self._model.throttle(BLIND_THRUST * carried)
        self._send(RadioSticks(throttle=throttle), self._clock.now(), arms=True)


if TYPE_CHECKING:
    _MEETS_THE_CONTRACT: type[DroneDriver] = Betaflight
