"""How many commands may wait in a controller: sticks that wait behind others come late."""

from __future__ import annotations

import asyncio
import random
import struct
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

import pytest

from housefly.clock import RealClock
from housefly.drones.betaflight.controller import PERIODS
from housefly.drones.betaflight.link import MspLink
from housefly.wires.betaflight.commands import Msp
from housefly.wires.betaflight.endpoint import msp_endpoint_of
from housefly.wires.betaflight.framing import MspDirection, MspFrame, MspReader, encode_msp

pytestmark = pytest.mark.virtual_time

PORT = 5761
QUICK = 0.001


class SlowController(asyncio.DatagramProtocol):
    """Takes one command after the other.

    Attributes:
        pause: that each one takes [s], a fifth more or less.
        ages: how old sticks were when their turn came [s].
    """

    def __init__(self) -> None:
        self.pause, self.ages = QUICK, list[float]()
        self._dice = random.Random(4)
        self._waiting: asyncio.Queue[tuple[bytes, object]] = asyncio.Queue()

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        self.transport = transport

    def datagram_received(self, data: bytes, addr: object) -> None:
        self.client = addr
        self._waiting.put_nowait((data, addr))

    async def answer_others(self) -> None:
        while True:
            answer = MspFrame(Msp.STATUS_EX, b"", MspDirection.ANSWER)
            self.transport.sendto(encode_msp(answer), self.client)  # type: ignore[attr-defined]
            await asyncio.sleep(0.005)

    async def work(self) -> None:
        while True:
            data, addr = await self._waiting.get()
            await asyncio.sleep(self.pause * self._dice.uniform(0.8, 1.2))
            for frame in MspReader().feed(data):
                if frame.command == Msp.SET_RAW_RC:
                    self.ages.append(RealClock().now() - struct.unpack("<d", frame.payload)[0])
                answer = MspFrame(frame.command, b"", MspDirection.ANSWER)
                self.transport.sendto(encode_msp(answer), addr)  # type: ignore[attr-defined]


class Sticks:
    """Sends sticks and asks as the driver does."""

    def __init__(self, link: MspLink) -> None:
        self.link, self.clock, self.asked = link, RealClock(), dict.fromkeys(PERIODS, 0.0)

    async def send(self, seconds: float) -> None:
        for _ in range(round(100 * seconds)):
            now = self.clock.now()
            self.link.send(Msp.SET_RAW_RC, struct.pack("<d", now))
            for question, at in self.asked.items():
                if now - at >= PERIODS[question] and self.link.may_ask:
                    self.asked[question] = now
                    self.link.send(question)
            await asyncio.sleep(0.01)


@asynccontextmanager
async def driven(host: str) -> AsyncIterator[tuple[SlowController, Sticks]]:
    loop = asyncio.get_running_loop()
    transport, controller = await loop.create_datagram_endpoint(
        SlowController, local_addr=(host, PORT)
    )
    work = asyncio.create_task(controller.work())
    endpoint = msp_endpoint_of(f"udp:{host}:{PORT}")
    link = MspLink(endpoint, RealClock(), lambda _: None, lambda: None)
    await link.open()
    yield controller, Sticks(link)
    work.cancel()
    await link.close()
    transport.close()


@pytest.mark.parametrize(("answers_hz", "age"), [(20, 0.4), (30, 0.25), (40, 0.2)])
async def test_sticks_come_in_time_to_a_controller_that_becomes_busy(
    loopback: str, answers_hz: int, age: float
) -> None:
    oldest, taken = [], []
    async with driven(loopback) as (controller, sticks):
        for controller.pause in (QUICK, 1.0 / answers_hz, QUICK):
            await sticks.send(3.0)
            oldest.append(max(controller.ages))
            taken.append(len(controller.ages))
            controller.ages.clear()
    assert oldest[0] < 0.02 and max(oldest) < age, oldest
    assert taken[0] > 290 and taken[1] > 1.8 * answers_hz and taken[2] > 280, taken


async def test_answers_to_somebody_else_keep_no_sticks_for_long(loopback: str) -> None:
    async with driven(loopback) as (controller, sticks):
        await sticks.send(1.0)
        controller.ages.clear()
        others = asyncio.create_task(controller.answer_others())
        await sticks.send(8.0)
        others.cancel()
    assert len(controller.ages) > 600
