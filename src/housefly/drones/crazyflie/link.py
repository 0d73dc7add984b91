"""What is asked of a Crazyflie: packets out, packets in, and questions that are asked again."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Protocol

from housefly.drones.crazyflie.radio_wire import RadioWire, is_for_radio
from housefly.drones.crazyflie.udp_wire import UdpWire
from housefly.errors import LinkError, WireError
from housefly.wires.crazyflie.crtp import Packet

ANSWER_TIMEOUT = 0.2
"""How long an answer is waited for before the question is asked again [s]."""
TRIES = 10


class CrtpWire(Protocol):
    """What carries packets to one drone and back; all calls belong to one asyncio loop."""

    broken: int
    """What came and was no packet."""

    @property
    def name(self) -> str:
        """Where the drone is."""
        ...

    @property
    def problem(self) -> str:
        """What is wrong with the wire itself; "" for nothing."""
        ...

    @property
    def is_open(self) -> bool:
        """Whether ``send`` goes anywhere."""
        ...

    async def open(self) -> None:
        """Open it; raises LinkError or MissingPartError where that cannot be."""
        ...

    async def close(self) -> None:
        """Close it."""
        ...

    def send(self, packet: Packet) -> None:
        """Send a packet; returns at once."""
        ...


def wire_to(address: str, hear: Callable[[Packet], None]) -> CrtpWire:
    """Return what leads to a drone's address, not yet open; raises ConfigError for none."""
    return RadioWire(address, hear) if is_for_radio(address) else UdpWire(address, hear)


class CrtpLink:
    """Speaks with one drone; all calls belong to one asyncio loop.

    Args:
        address: of the drone, IP or a radio's.
        hear: what takes every packet of the drone.

    Attributes:
        broken: packets that nobody could read.
    """

    def __init__(self, address: str, hear: Callable[[Packet], None]) -> None:
        self.broken = 0
        self._hear = hear
        self._wire = wire_to(address, self._take_in)
        self._waiting: list[tuple[Callable[[Packet], bool], asyncio.Future[Packet]]] = []

    @property
    def name(self) -> str:
        """Where the drone is."""
        return self._wire.name

    @property
    def problem(self) -> str:
        """What is wrong with the wire itself; "" for nothing."""
        return self._wire.problem

    @property
    def is_open(self) -> bool:
        """Whether ``send`` goes anywhere."""
        return self._wire.is_open

    async def open(self) -> None:
        """Open the wire; raises LinkError or MissingPartError where that cannot be."""
        await self._wire.open()

    async def close(self) -> None:
        """Close the wire."""
        await self._wire.close()

    def send(self, *packets: Packet) -> None:
        """Send packets at once, in order; without a wire they are dropped."""
        for packet in packets:
            self._wire.send(packet)

    async def ask(
        self, question: Packet, is_answer: Callable[[Packet], bool], tries: int = TRIES
    ) -> Packet:
        """Return the answer to a question, asked again until it comes.

        Args:
            question: what is sent.
            is_answer: whether a packet is it.
            tries: how often it is sent at most.

        Raises:
            LinkError: none came.
        """
        answer: asyncio.Future[Packet] = asyncio.get_running_loop().create_future()
        waiting = is_answer, answer
        self._waiting.append(waiting)
        try:
            for _ in range(tries):
                self.send(question)
                done, _ = await asyncio.wait((answer,), timeout=ANSWER_TIMEOUT)
                if done:
                    return answer.result()
        finally:
            self._waiting.remove(waiting)
            answer.cancel()
        raise LinkError(
            f"the Crazyflie at {self.name} does not answer a question of port"
            f" {question.port}, channel {question.channel}, asked {tries} times"
        )

    def _take_in(self, packet: Packet) -> None:
        for is_answer, answer in tuple(self._waiting):
            if not answer.done() and _fits(is_answer, packet):
                answer.set_result(packet)
        try:
            self._hear(packet)
        except WireError:
            self.broken += 1


def _fits(is_answer: Callable[[Packet], bool], packet: Packet) -> bool:
    try:
        return is_answer(packet)
    except WireError:
        return False
