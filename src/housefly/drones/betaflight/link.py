"""The wire to a flight controller: TCP, UDP or a serial port; frames out, frames in."""

from __future__ import annotations

import asyncio
import os
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from math import inf
from typing import NamedTuple, cast

from housefly.clock import Clock
from housefly.drones.betaflight.serial_port import SerialPort
from housefly.errors import LinkError, WireError
from housefly.wires.betaflight.endpoint import Carrier, MspEndpoint
from housefly.wires.betaflight.framing import MspDirection, MspFrame, MspReader, encode_msp

_RECONNECT_PAUSE = 0.2
_UNANSWERED_MAX, _QUESTIONS_MAX = 4, 2
"""So many orders and so many questions may be under way. Sticks that wait behind others come late:
twenty of them let a simulated drone swing into a wall where a busy controller took 40 a second.
Neither kind waits for the other: where answers are lost, both would.
"""
_ANSWER_TIMEOUT: dict[Carrier, float] = {Carrier.TCP: 0.5, Carrier.UDP: 0.4, Carrier.SERIAL: 0.4}
"""An answer is lost after so long [s]; over TCP only a bridge to a serial port loses any."""
_OVERTAKEN_AFTER = (0.1, 0.2)
"""Shortest and longest time [s] without any answer after which one is lost already: lost sticks
keep no others waiting. It is twice what an answer takes. While others are answered the controller
is only slow: what was sent on then waited there, 1.4 s old.
"""
_AMBIGUITY = 0.5
"""An answer says how long it took where the same was not sent for so long before [s]: commands have
no numbers (Karn and Partridge 1987).
"""
_QUIET, _PAUSE_MAX = 0.06, 0.5
"""Nothing waits in a controller that has answered nothing for the first [s]; nothing is sent for
the second at most [s]: meanwhile it flies by the sticks that wait there.
"""
_PAUSE_AGAIN = 10.0
"""After a pause in which answers did not end, they are somebody else's for so long [s]."""
_SLOW_FOR, _SLOWEST = 2.0, 0.8
"""One that was slow may be slow again for so long [s]; none is waited for longer [s]."""
_BACKLOG_MAX = 4096
_FRAMES_MAX = 400
"""More answers in a second are thrown away unread; 100 are asked for."""


@dataclass(slots=True)
class LinkCounters:
    """What happened on the wire.

    Attributes:
        sent, answered: commands, and answers to them.
        refused: of these, those that it would not do, or does not know.
        held_back: commands that were not sent, because too many were unanswered.
        broken: answers that could not be read.
        unread: answers of a flood.
        connects: how often the wire was opened.
    """

    sent: int = 0
    answered: int = 0
    refused: int = 0
    held_back: int = 0
    broken: int = 0
    unread: int = 0
    connects: int = 0


class _UnderWay(NamedTuple):
    sent_at: float
    command: int
    is_order: bool
    """Whether it carries something; a question does not."""
    is_alone: bool
    """Whether no answer to an earlier one can be taken for its own."""


class _AnswerTime:
    """What answers tell of how long commands wait in the controller, which takes one by one.

    Commands have no numbers: an answer may belong to any of the same kind. What is believed lost
    and waits there all the same would be forgotten, and followed by more. So when that shows,
    nothing is sent until nothing is left to answer.
    """

    def __init__(self) -> None:
        self._sent_at: dict[int, float] = {}
        self._heard_at = self._slow_until = -inf
        self._pauses_from = self._pauses_until = -inf
        self._lost_after = _OVERTAKEN_AFTER[1]

    def is_lost(self, one: _UnderWay, now: float, timeout: float) -> bool:
        """Return whether no answer to a command is waited for any more.

        Answers come in order: a controller that answers others is at work, and only slow.
        """
        quiet_since = max(one.sent_at, self._heard_at)
        return now - one.sent_at > timeout or now - quiet_since > self._lost_after

    def pauses(self, now: float) -> bool:
        """Return whether the controller must answer what waits there before more is sent."""
        return now < self._pauses_until

    def is_alone(self, command: int, now: float) -> bool:
        """Note that a command is sent now [s]; return whether it is alone on the wire."""
        before = self._sent_at.get(command, -inf)
        self._sent_at[command] = now
        return now - before > _AMBIGUITY

    def answered(self, one: _UnderWay | None, now: float) -> None:
        """Take in an answer that came now [s], and to what; None: to what was believed lost."""
        self._heard_at = now
        shortest, longest = _OVERTAKEN_AFTER
        if one is None:
            self._was_late(now)
        elif one.is_alone and now > self._slow_until:
            self._lost_after = min(max(2.0 * (now - one.sent_at), shortest), longest)
        if self.pauses(now):
            self._pauses_until = min(now + _QUIET, self._pauses_from + _PAUSE_MAX)

    def _was_late(self, now: float) -> None:
        was_in_vain = self._pauses_until >= self._pauses_from + _PAUSE_MAX
        if self.pauses(now) or (was_in_vain and now - self._pauses_from < _PAUSE_AGAIN):
            return
        self._pauses_from, self._pauses_until = now, now + _QUIET
        self._slow_until = now + _SLOW_FOR
        self._lost_after = min(max(_OVERTAKEN_AFTER[1], 2.0 * self._lost_after), _SLOWEST)


class MspLink(asyncio.DatagramProtocol, asyncio.Protocol):
    """Speaks with one controller; all calls belong to one asyncio loop.

    Args:
        endpoint: where it answers.
        clock: for ages.
        hear: takes every answer.
        opened: called each time the wire is open.

    Attributes:
        counters: what happened.
    """

    def __init__(
        self,
        endpoint: MspEndpoint,
        clock: Clock,
        hear: Callable[[MspFrame], None],
        opened: Callable[[], None],
    ) -> None:
        self._endpoint, self._clock = endpoint, clock
        self._hear, self._opened = hear, opened
        self._transport: asyncio.Transport | asyncio.DatagramTransport | SerialPort | None = None
        self._reader, self.counters = MspReader(), LinkCounters()
        self._under_way: deque[_UnderWay] = deque()
        self._answer_time = _AnswerTime()
        self._keeping: asyncio.Task[None] | None = None
        self._lost = asyncio.Event()
        self._second, self._frames = 0.0, 0

    @property
    def is_open(self) -> bool:
        """Whether what is sent goes anywhere."""
        return self._transport is not None

    @property
    def may_ask(self) -> bool:
        """Whether few enough questions are under way to ask another."""
        return self._count(False) < _QUESTIONS_MAX

    def _count(self, is_order: bool) -> int:
        return sum(one.is_order is is_order for one in self._under_way)

    async def open(self) -> None:
        """Open the wire; one that is lost is opened again.

        Raises:
            LinkError: it cannot be opened now; says why. It is not tried again then.
        """
        if self._keeping is not None:
            return
        await self._connect()
        self._keeping = asyncio.create_task(self._keep(), name="betaflight link")

    async def close(self) -> None:
        """Release the wire."""
        if self._keeping is not None:
            self._keeping.cancel()
            await asyncio.gather(self._keeping, return_exceptions=True)
            self._keeping = None
        if self._transport is not None:
            self._transport.abort()
            self._transport = None

    def send(self, command: int, payload: bytes = b"") -> bool:
        """Send a command at once; return whether it left: without a wire, or stuck, it does not."""
        link, now = self._transport, self._clock.now()
        self._forget_lost()
        if link is None:
            return False
        is_stuck = (
            isinstance(link, asyncio.Transport) and link.get_write_buffer_size() > _BACKLOG_MAX
        )
        is_order = bool(payload)
        most = _UNANSWERED_MAX if is_order else _QUESTIONS_MAX
        is_full = self._answer_time.pauses(now) or self._count(is_order) >= most
        if is_stuck or is_full:
            self.counters.held_back += 1
            return False
        data = encode_msp(MspFrame(command, payload))
        if self._endpoint.carrier is Carrier.UDP:  # asyncio's own is no DatagramTransport in 3.11
            cast(asyncio.DatagramTransport, link).sendto(data)
        else:
            cast(asyncio.Transport, link).write(data)
        is_alone = self._answer_time.is_alone(command, now)
        self._under_way.append(_UnderWay(now, command, is_order, is_alone))
        self.counters.sent += 1
        return True

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Use a wire."""
        self._use(cast(asyncio.Transport | asyncio.DatagramTransport, transport))

    def _use(self, transport: asyncio.Transport | asyncio.DatagramTransport | SerialPort) -> None:
        self._transport, self._reader = transport, MspReader()
        self._under_way.clear()
        self._answer_time = _AnswerTime()
        self._lost.clear()
        self.counters.connects += 1
        self._opened()

    def connection_lost(self, exc: Exception | None) -> None:
        """Forget it."""
        self._transport = None
        self._lost.set()

    def error_received(self, exc: Exception) -> None:
        """Ignore that nobody listens yet: we ask again."""

    def datagram_received(self, data: bytes, addr: object) -> None:
        """Take in a datagram: bytes of the same stream."""
        self.data_received(data)

    def data_received(self, data: bytes) -> None:
        """Take in the next bytes."""
        broken = self._reader.broken
        for frame in self._reader.feed(data):
            self._take(frame)
        self.counters.broken += self._reader.broken - broken

    def _take(self, frame: MspFrame) -> None:
        now = self._clock.now()
        if now - self._second > 1.0:
            self._second, self._frames = now, 0
        self._frames += 1
        if self._frames > _FRAMES_MAX:
            self.counters.unread += 1
            return
        if frame.direction is MspDirection.REQUEST:
            return
        self._settle(frame.command)
        self.counters.answered += 1
        self.counters.refused += frame.direction is MspDirection.REFUSAL
        try:
            self._hear(frame)
        except WireError:
            self.counters.broken += 1

    def _settle(self, command: int) -> None:
        """Forget a command that is answered, and those before it: answers come in order."""
        answered = None
        if any(one.command == command for one in self._under_way):
            while (answered := self._under_way.popleft()).command != command:
                pass
        self._answer_time.answered(answered, self._clock.now())
        if self._answer_time.pauses(self._clock.now()):
            self._under_way.clear()
        self._forget_lost()

    def _forget_lost(self) -> None:
        now, timeout = self._clock.now(), _ANSWER_TIMEOUT[self._endpoint.carrier]
        while self._under_way and self._answer_time.is_lost(self._under_way[0], now, timeout):
            self._under_way.popleft()

    async def _keep(self) -> None:
        while True:
            await self._lost.wait()
            await asyncio.sleep(_RECONNECT_PAUSE)
            if self._transport is None:
                with suppress(LinkError):
                    await self._connect()

    async def _connect(self) -> None:
        end, loop = self._endpoint, asyncio.get_running_loop()
        if end.carrier is Carrier.SERIAL:
            self._use(
                SerialPort(
                    end.place, end.number, self.data_received, lambda: self.connection_lost(None)
                )
            )
            return
        try:
            if end.carrier is Carrier.TCP:
                async with asyncio.timeout(2.0):
                    await loop.create_connection(lambda: self, end.place, end.number)
            else:
                await loop.create_datagram_endpoint(
                    lambda: self, remote_addr=(end.place, end.number)
                )
        except (OSError, TimeoutError) as error:
            number = error.errno or 0  # asyncio puts words of its own into strerror
            known = os.strerror(number) if number > 0 else error.strerror
            why = known or str(error) or "no answer"
            raise LinkError(f"cannot open {end}: {why}") from error
