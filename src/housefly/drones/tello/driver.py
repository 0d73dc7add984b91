"""The DJI Tello as a ``DroneDriver``: its three UDP ports.

It flies velocities: full sticks ahead are 1.5 m/s, reached in about a second (its airframe says who
measured that). The last sticks hold for 15 s, so they are said again at the drone's own rate, and a
command of another kind leaves in the same call.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from math import inf
from typing import TYPE_CHECKING

from housefly.bus.rate import Frequency
from housefly.clock import Clock, RealClock
from housefly.config.drone import DroneConfig
from housefly.config.limits import LimitsConfig
from housefly.drones.repeating_driver import RepeatingDriver
from housefly.drones.tello.flight_watch import FlightWatch
from housefly.drones.tello.pictures import Pictures
from housefly.drones.tello.sockets import local_address, open_socket
from housefly.drones.tello.talk import STATE_AGE_MAX, Talk
from housefly.errors import LinkError, WireError
from housefly.messages import (
    Action,
    Sighting,
    Telemetry,
    VideoFrame,
)
from housefly.messages.sensing import REPORT_AGE_MAX
from housefly.messages.words import Words, error_words, figure, joined, literal
from housefly.wires.tello.answers import decode_tello_answer
from housefly.wires.tello.conversions import full_sticks_of, telemetry_of_state
from housefly.wires.tello.lines import COMMAND_PORT, STATE_PORT, VIDEO_PORT, Word, encode_line
from housefly.wires.tello.state import TelloState, decode_state

if TYPE_CHECKING:
    from housefly.drones.contract import DroneDriver

FIRST_STATE_TIMEOUT = 3.0
"""How long ``connect`` waits for the first state [s]."""
HOT = 90
"""Above that it may cut its motors soon [degC]."""
_STATES_MAX = 100
"""More states or answers in a second are thrown away unread; it sends 10."""


class Tello(RepeatingDriver):
    """Flies one Tello, real or simulated.

    Args:
        config: its address, the network interface that leads to it, whether its camera is wanted.
        limits: what it may do; it takes none itself, so they are kept here.
        clock: for ages and rates.
    """

    def __init__(
        self, config: DroneConfig, limits: LimitsConfig, clock: Clock | None = None
    ) -> None:
        super().__init__(config, limits.tilt_max, clock or RealClock())
        self._watch = FlightWatch()
        self._talk = Talk(full_sticks_of(config.airframe.response))
        camera = config.airframe.capabilities.camera
        self._pictures = Pictures(config.address, camera, self._clock) if camera else None
        self._links: list[asyncio.DatagramTransport] = []
        self._on_report: Callable[[], None] = lambda: None
        self._first = asyncio.Event()
        self._heard_at = self._looked_at = -inf
        self._ours = ""
        self._state: TelloState | None = None
        self._arrivals = Frequency()
        self._problem: Words | None = None
        self._broken = 0
        self._counted_since, self._counted = -inf, 0

    async def connect(self) -> None:
        """Open the wire and enter SDK mode; may be called again after a failure.

        Raises:
            LinkError: no way there, or no state came; says what to look for.
        """
        try:
            await self._open()
            async with asyncio.timeout(FIRST_STATE_TIMEOUT):
                await self._first.wait()
        except (LinkError, TimeoutError) as error:
            failed = error if isinstance(error, LinkError) else self._nobody()
            self._problem = error_words(failed)
            raise failed from error
        self._problem = None

    def _nobody(self) -> LinkError:
        """Return why no state came: nothing at all, or what is no state of a Tello."""
        where = f"{self._config.address}:{STATE_PORT}"
        if self._broken:
            return LinkError(f"what comes from {where} is no state of a Tello")
        return LinkError(
            Words(
                "no drone answers at {name} within {n} s: is it switched on, and is your"
                " computer in the drone's Wi-Fi?",
                name=where,
                n=figure(FIRST_STATE_TIMEOUT, "g"),
            )
        )

    async def _open(self) -> None:
        if not self._links:
            await self._open_links()
        self._start_repeating()
        self._start("follow its Wi-Fi", self._follow_wifi)

    async def _open_links(self) -> None:
        where = self._config.address, self._config.interface
        try:
            self._links.append(await open_socket(_Ear(self._hear_answer), *where))
            self._links.append(await open_socket(_Ear(self._hear_state), *where, STATE_PORT))
            if self._pictures is not None and self._config.has_video:
                self._links.append(await open_socket(self._pictures, *where, VIDEO_PORT))
        except LinkError:
            self._shut()
            raise
        self._ours = self._links[0].get_extra_info("sockname")[0]

    async def _follow_wifi(self) -> None:
        while True:
            await asyncio.sleep(self._config.airframe.link.repeat_after)
            await self._follow_address(self._clock.now())

    async def _follow_address(self, now: float) -> None:
        """Open the sockets anew where a silent drone's Wi-Fi gave us another address meanwhile."""
        is_lost = now - self._heard_at > STATE_AGE_MAX and now - self._looked_at > 1.0
        if not is_lost or self._config.interface:
            return
        self._looked_at = now
        with suppress(OSError, LinkError):
            if not self._links or local_address(self._config.address) != self._ours:
                self._shut()
                await self._open_links()

    async def close(self) -> None:
        """Release the wire. Does not land: the pilot does that before."""
        await self._end_tasks()
        self._shut()

    def _shut(self) -> None:
        for link in self._links:
            link.abort()
        self._links.clear()

    def send_pose(self, seen: Sighting) -> None:
        """It wants none."""

    @property
    def telemetry(self) -> Telemetry | None:
        """The newest report, or None before the first."""
        if self._state is None:
            return None
        report = telemetry_of_state(self._state, self._watch.status(), self._heard_at)
        return replace(report, configured=self._talk.is_open, notes=self.notes)

    @property
    def notes(self) -> tuple[Words, ...]:
        """What is not as it should be."""
        found = list(self._permit_notes)
        if self._state is not None and self._state.temph >= HOT:
            found.append(literal(f"it is hot inside: {self._state.temph} degrees"))
        if self._watch.refusal:
            found.append(Words("{asked} refused: {why}", asked="takeoff", why=self._watch.refusal))
        return tuple(found)

    @property
    def firmware(self) -> str:
        """The version of its SDK as it reported it; "" before it did."""
        return f"SDK {self._talk.sdk}" if self._talk.sdk else ""

    @property
    def problem(self) -> Words:
        """What is wrong with drone or link; UNSAID for nothing."""
        is_known = self._failsafe.permit is not None
        if self._problem is not None and not is_known:
            return self._problem
        return joined("; ", self.notes)

    @property
    def telemetry_rate_hz(self) -> float:
        """States per second over the last second."""
        return self._arrivals.rate_hz(self._clock.now())

    @property
    def connected(self) -> bool:
        """Whether states arrive."""
        return self._clock.now() - self._heard_at < REPORT_AGE_MAX

    @property
    def video_connected(self) -> bool:
        """Whether pictures arrive."""
        return self._pictures is not None and self._pictures.connected

    def show_recording(self, records: bool) -> None:
        """It has no light of ours."""

    def on_report(self, handler: Callable[[], None]) -> None:
        """Call the handler after each state of the drone."""
        self._on_report = handler

    def on_video(self, handler: Callable[[VideoFrame], None]) -> None:
        """Call the handler with each picture from the first key frame on."""
        if self._pictures is not None:
            self._pictures.handlers.append(handler)

    def _transmit(self, now: float) -> None:
        self._sent_at = now
        if not self._links:
            return
        told = self._failsafe.decide(now, self.telemetry)
        if told.command.action is Action.RESET:
            self._watch.reset()
        wanted = self._config.has_video and self._pictures is not None
        due = self._talk.lines(
            told,
            self._watch.status(),
            now,
            state_age=now - self._heard_at,
            wants_pictures=wanted and not self.video_connected,
        )
        for line in due:
            self._watch.sent(line, now)
            self._say(encode_line(line))

    def _land_blindly(self) -> None:
        self._say(encode_line(Word.LAND))

    def _say(self, data: bytes) -> None:
        if self._links:
            self._links[0].sendto(data, (self._config.address, COMMAND_PORT))

    def _hear_answer(self, data: bytes, sender: tuple[str, int]) -> None:
        if not self._is_from_drone(sender):
            return
        with suppress(WireError):
            answer = decode_tello_answer(data)
            self._talk.hear(answer)
            self._watch.hear(answer, self._clock.now())

    def _hear_state(self, data: bytes, sender: tuple[str, int]) -> None:
        if not self._is_from_drone(sender):
            return
        try:
            state = decode_state(data)
        except WireError:
            self._broken += 1
            return
        now = self._clock.now()
        self._state, self._heard_at = state, now
        self._watch.see(state, now)
        self._arrivals.add(now)
        self._first.set()
        self._on_report()

    def _is_from_drone(self, sender: tuple[str, int]) -> bool:
        """Return whether the drone itself speaks, and not too much."""
        now = self._clock.now()
        if now - self._counted_since > 1.0:
            self._counted_since, self._counted = now, 0
        if sender[0] != self._config.address:
            return False
        self._counted += 1
        return self._counted <= _STATES_MAX


class _Ear(asyncio.DatagramProtocol):
    """Passes on what comes."""

    def __init__(self, hear: Callable[[bytes, tuple[str, int]], None]) -> None:
        self._hear = hear

    def datagram_received(self, data: bytes, addr: tuple[str, int]) -> None:
        """Pass on a datagram."""
        self._hear(data, addr)

    def error_received(self, exc: Exception) -> None:
        """Ignore that nobody listens yet: we ask again."""


if TYPE_CHECKING:
    _MEETS_THE_CONTRACT: type[DroneDriver] = Tello
