"""How many commands may wait in a controller: sticks that wait behind others come late."""

from __future__ import annotations

import asyncio
import struct

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
        pause: that each one takes [s].
        ages: how old sticks were when their turn came [s].
    """

    def __init__(self) -> None:
        self.pause, self.ages = QUICK, list[float]()
        self._waiting: asyncio.Queue[tuple[bytes, object]] = asyncio.Queue()

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        self.transport = transport

    def datagram_received(self, data: bytes, addr: object) -> None:
        self._waiting.put_nowait((data, addr))

    async def work(self) -> None:
        while True:
            data, addr = await self._waiting.get()
            await asyncio.sleep(self.pause)
            for frame in MspReader().feed(data):
                if frame.command == Msp.SET_RAW_RC:
                    self.ages.append(RealClock().now() - struct.unpack("<d", frame.payload)[0])
                answer = MspFrame(frame.command, b"", MspDirection.ANSWER)
                self.transport.sendto(encode_msp(answer), addr)  # type: ignore[attr-defined]


@pytest.mark.parametrize("answers_hz", [30, 40])
async def test_sticks_come_in_time_to_a_controller_that_becomes_busy(
    loopback: str, answers_hz: int
) -> None:
    loop, clock = asyncio.get_running_loop(), RealClock()
    transport, controller = await loop.create_datagram_endpoint(
        SlowController, local_addr=(loopback, PORT)
    )
    work = asyncio.create_task(controller.work())
    link = MspLink(msp_endpoint_of(f"udp:{loopback}:{PORT}"), clock, lambda _: None, lambda: None)
    await link.open()
    asked = dict.fromkeys(PERIODS, 0.0)
    oldest, taken = [], []
    for controller.pause in (QUICK, 1.0 / answers_hz, QUICK):
        for _ in range(300):
            now = clock.now()
            link.send(Msp.SET_RAW_RC, struct.pack("<d", now))
            for question, at in asked.items():
                if now - at >= PERIODS[question] and link.may_ask:
                    asked[question] = now
                    link.send(question)
            await asyncio.sleep(0.01)
        oldest.append(max(controller.ages))
        taken.append(len(controller.ages))
        controller.ages.clear()
    work.cancel()
    await link.close()
    transport.close()
    assert oldest[0] < 0.02 and oldest[1] < 0.5 and oldest[2] < 0.25, oldest
    assert taken[0] > 290 and taken[1] > 1.8 * answers_hz and taken[2] > 280, taken
