"""The Crazyflie as a ``DroneDriver``: CRTP over UDP, port 19850 of its address, or over a radio.

It takes off only once it was set to take poses, its limits were read back, and it believes to be
where tracking sees it.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from contextlib import suppress
from math import dist
from typing import TYPE_CHECKING

from housefly.bus.rate import Frequency
from housefly.clock import Clock
from housefly.config.drone import DroneConfig
from housefly.config.limits import LimitsConfig
from housefly.drones.crazyflie.link import CrtpLink
from housefly.drones.crazyflie.manoeuvres import DISAGREES, Manoeuvres
from housefly.drones.crazyflie.reports import OwnState, complaints
from housefly.drones.crazyflie.settings import (
    flight_settings,
    found_decks,
    read_setting,
    reset_estimator,
    start_logs,
    write_settings,
)
from housefly.drones.crazyflie.tables import Table, read_table
from housefly.drones.repeating_driver import RepeatingDriver
from housefly.errors import LinkError, MissingPartError, WireError
from housefly.messages import (
    Sighting,
    Telemetry,
    VideoFrame,
)
from housefly.messages.sensing import AIRBORNE_STATUSES, REPORT_AGE_MAX
from housefly.messages.words import UNSAID, Words, error_words, figure, joined
from housefly.wires.crazyflie.crtp import Packet, Port
from housefly.wires.crazyflie.high_level import Land, encode_high_level, is_land_answer
from housefly.wires.crazyflie.localization import encode_told_pose
from housefly.wires.crazyflie.log_blocks import DATA
from housefly.wires.crazyflie.setpoints import notify_setpoints_stop
from housefly.wires.crazyflie.supervisor import (
    VersionQuestion,
    is_source,
    read_version,
    source_question,
    version_question,
)

if TYPE_CHECKING:
    from housefly.drones.contract import DroneDriver

PROTOCOL_MIN = 9
"""Older firmware turns yaw rates round, and has shorter tables."""
FIRST_REPORT_TIMEOUT = 2.0
"""How long ``connect`` waits for the first report [s]."""
BLIND_LANDING = Land(0.0, 3.0)
"""What is ordered once where nobody knows what to send any more."""
_GREETINGS = 5
_LOST_AFTER = 1.0
"""Reports that stay away for so long are asked for anew: the drone may have been restarted [s]."""


class Crazyflie(RepeatingDriver):
    """Flies one Crazyflie, real or simulated.

    Args:
        config: where it answers.
        limits: what it may do.
        clock: for ages and rates.
    """

    def __init__(self, config: DroneConfig, limits: LimitsConfig, clock: Clock) -> None:
        super().__init__(config, limits.tilt_max, clock)
        self._limits = limits
        self._link = CrtpLink(config.address, self._hear)
        by_state = config.airframe.capabilities.is_told_full_state
        self._manoeuvres = Manoeuvres(by_state=by_state)
        self._state = OwnState()
        self._report: Telemetry | None = None
        self._seen: Sighting | None = None
        self._log_table: Table | None = None
        self._parameters: Table | None = None
        self._is_configured, self._problem = False, UNSAID
        self._decks: tuple[str, ...] = ()
        self._lands_blindly = False
        self._handler: Callable[[], None] = lambda: None
        self._heard = asyncio.Event()
        self._reports = Frequency()
        self.firmware = ""

    async def connect(self) -> None:
        """Open the wire, read the tables, set the drone; may be called again after a failure.

        Raises:
            LinkError: it does not answer, its firmware is too old, or it keeps other settings.
            MissingPartError: it is reached by radio, and cflib is not installed.
        """
        try:
            await self._link.open()
            self._start_repeating()
            await self._set_up()
        except (LinkError, MissingPartError) as error:
            self._problem = error_words(error)
            raise
        self._start("keep", self._keep)

    async def close(self) -> None:
        """Release the wire. Does not land: the pilot does that before."""
        await self._end_tasks()
        await self._link.close()

    def send_pose(self, seen: Sighting) -> None:
        """Tell the drone where it is; its wire has no word for how long ago."""
        self._seen = seen
        with suppress(WireError):
            self._link.send(encode_told_pose(seen.pose.position, seen.pose.orientation))

    @property
    def telemetry(self) -> Telemetry | None:
        """The newest report, or None before the first."""
        return self._report

    @property
    def notes(self) -> tuple[Words, ...]:
        """What is not as it should be."""
        return (*complaints(self._state.info), *self._misplaced(), *self._permit_notes)

    @property
    def decks(self) -> tuple[str, ...]:
        """Decks on the drone that tell it where it is."""
        return self._decks

    @property
    def problem(self) -> Words:
        """What is wrong with drone or link; UNSAID for nothing."""
        return self._problem or joined("; ", self.notes)

    @property
    def telemetry_rate_hz(self) -> float:
        """Reports per second over the last second."""
        return self._reports.rate_hz(self._clock.now())

    @property
    def connected(self) -> bool:
        """Whether reports arrive."""
        return self._clock.now() - self._state.at < REPORT_AGE_MAX

    def show_recording(self, records: bool) -> None:
        """It has no light of ours."""

    def on_video(self, handler: Callable[[VideoFrame], None]) -> None:
        """It has no camera of ours."""

    def on_report(self, handler: Callable[[], None]) -> None:
        """Call the handler after each report of the drone."""
        self._handler = handler

    async def _set_up(self) -> None:
        """Greet the drone, read its tables, set it, and let it send its logs."""
        link = self._link
        try:
            await link.ask(source_question(), is_source, _GREETINGS)
        except LinkError as error:
            raise LinkError(
                link.problem
                or Words(
                    "nobody answers at {name}; is it switched on, and in this network?",
                    name=link.name,
                )
            ) from error
        await self._read_versions()
        self._log_table = await read_table(link, Port.LOG, self._log_table)
        table = await read_table(link, Port.PARAMETERS, self._parameters)
        self._parameters = table
        wanted = flight_settings(self._limits.tilt_max)
        if (
            not self._flies
            and await read_setting(link, table, "stabilizer.estimator")
            != (wanted["stabilizer.estimator"])
        ):
            await write_settings(link, table, wanted)
            await reset_estimator(link, table)
        await write_settings(link, table, wanted)
        self._decks = await found_decks(link, table)
        self._heard.clear()
        await start_logs(link, self._log_table)
        try:
            async with asyncio.timeout(FIRST_REPORT_TIMEOUT):
                await self._heard.wait()
        except TimeoutError as error:
            raise LinkError(Words("it answers, but sends no reports")) from error
        self._is_configured, self._problem = True, UNSAID

    async def _read_versions(self) -> None:
        told = {}
        for question in (VersionQuestion.PROTOCOL, VersionQuestion.FIRMWARE):
            answer = await self._link.ask(
                version_question(question),
                lambda packet, asked=question: _is_version(packet, asked),  # type: ignore[misc]
            )
            told[question] = read_version(answer)[1]
        protocol = told[VersionQuestion.PROTOCOL]
        self.firmware = str(told[VersionQuestion.FIRMWARE])
        if not isinstance(protocol, int) or protocol < PROTOCOL_MIN:
            raise LinkError(
                Words(
                    "what answers at {name} does not speak {protocol} ({error})",
                    name=self._link.name,
                    protocol=f"CRTP {PROTOCOL_MIN}",
                    error=f"CRTP {protocol}",
                )
            )
        self._manoeuvres.protocol = protocol

    @property
    def _flies(self) -> bool:
        report = self._report
        return report is not None and report.status in AIRBORNE_STATUSES

    def _misplaced(self) -> tuple[Words, ...]:
        """Return that the drone believes to be elsewhere, while it stands."""
        seen = self._seen
        is_seen = seen is not None and self._clock.now() - seen.captured_at < REPORT_AGE_MAX
        if seen is None or not is_seen or self._flies or not self._state.has_state:
            return ()
        off = dist(seen.pose.position, self._state.place)
        if off < DISAGREES:
            return ()
        return (
            Words(
                "the drone believes to be {d} m from where tracking sees it: do poses reach it?",
                d=figure(off, ".1f"),
            ),
        )

    def _hear(self, packet: Packet) -> None:
        if packet.port == Port.LOG and packet.channel == DATA:
            self._take_in(packet)
        elif packet.port == Port.HIGH_LEVEL and is_land_answer(packet):
            self._lands_blindly = True
            self._manoeuvres.hear_landing()

    def _take_in(self, packet: Packet) -> None:
        now = self._clock.now()
        before, self._state = self._state, self._state.taken_in(packet, now)
        if self._state.at == before.at or not self._state.has_state:
            return
        self._reports.add(now)
        self._report = self._state.report(
            self._manoeuvres.status(self._state), configured=self._is_configured, notes=self.notes
        )
        self._heard.set()
        self._handler()

    def _transmit(self, now: float) -> None:
        if not self._link.is_open:
            return
        self._sent_at = now
        told = self._failsafe.decide(now, self._report)
        self._link.send(*self._manoeuvres.packets(told, self._state, self._seen, now))

    def _transmit_again(self, now: float) -> None:
        super()._transmit_again(now)
        self._lands_blindly = False

    def _land_blindly(self) -> None:
        """Have its own commander land it: until it answers, then that setpoints stop.

        An order to land behind the end would start the motors.
        """
        if self._state.is_flying:
            order = encode_high_level(BLIND_LANDING)
            self._link.send(notify_setpoints_stop() if self._lands_blindly else order)

    async def _keep(self) -> None:
        """Ask for reports anew when they stay away."""
        while True:
            await asyncio.sleep(_LOST_AFTER)
            if self._clock.now() - self._state.at < _LOST_AFTER:
                continue
            try:
                await self._set_up()
            except LinkError as error:
                self._problem = error_words(error)


def _is_version(packet: Packet, question: VersionQuestion) -> bool:
    return packet.port == Port.PLATFORM and read_version(packet)[0] is question


if TYPE_CHECKING:
    _MEETS_THE_CONTRACT: type[DroneDriver] = Crazyflie
