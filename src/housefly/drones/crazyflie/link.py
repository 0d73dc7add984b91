"""The UDP socket to a Crazyflie: packets out, packets in, and questions that are asked again."""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from housefly.errors import LinkError, WireError
from housefly.wires.crazyflie.crtp import UDP_PORT, Packet, decode_crtp, encode_crtp

ANSWER_TIMEOUT = 0.2
"""How long an answer is waited for before the question is asked again [s]."""
TRIES = 10


class CrtpLink(asyncio.DatagramProtocol):
    """Speaks with one drone; all calls belong to one asyncio loop.

    Args:
        address: IP address of the drone.
        hear: what takes every packet of the drone.

    Attributes:
        broken: datagrams that were no packets.
    """

    def __init__(self, address: str, hear: Callable[[Packet], None]) -> None:
        self.broken = 0
        self._address, self._hear = address, hear
        self._transport: asyncio.DatagramTransport | None = None
        self._waiting: list[tuple[Callable[[Packet], bool], asyncio.Future[Packet]]] = []

    @property
    def is_open(self) -> bool:
        """Whether ``send`` goes anywhere."""
        return self._transport is not None

    async def open(self) -> None:
        """Open the socket; raises LinkError when the address cannot be used."""
        if self._transport is not None:
            return
        there, loop = (self._address, UDP_PORT), asyncio.get_running_loop()
        try:
            self._transport, _ = await loop.create_datagram_endpoint(
                lambda: self, remote_addr=there
            )
        except OSError as error:
            raise LinkError(
                f"cannot open a socket to {self._address}:{UDP_PORT}: {error.strerror or error}"
            ) from error

    def close(self) -> None:
        """Close the socket."""
        if self._transport is not None:
            self._transport.abort()
            self._transport = None

    def send(self, *packets: Packet) -> None:
        """Send packets at once, each as a datagram; without a socket they are dropped."""
        if self._transport is not None:
            for packet in packets:
                self._transport.sendto(encode_crtp(packet))

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
            f"the Crazyflie at {self._address}:{UDP_PORT} does not answer a question of port"
            f" {question.port}, channel {question.channel}, asked {tries} times"
        )

    def datagram_received(self, data: bytes, addr: tuple[str, int]) -> None:
        """Take in a packet of the drone; anything else is counted."""
        try:
            packet = decode_crtp(data)
        except WireError:
            self.broken += 1
            return
        for is_answer, answer in tuple(self._waiting):
            if not answer.done() and _fits(is_answer, packet):
                answer.set_result(packet)
        try:
            self._hear(packet)
        except WireError:
            self.broken += 1

    def error_received(self, exc: Exception) -> None:
        """Ignore that nobody listens yet: we ask again."""


def _fits(is_answer: Callable[[Packet], bool], packet: Packet) -> bool:
    try:
        return is_answer(packet)
    except WireError:
        return False
