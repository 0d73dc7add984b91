"""Datagrams on a link that loses, delays, repeats or reorders them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from random import Random
from typing import Generic, TypeVar

from housefly.numeric import running_sum
from housefly.twin.faults.fault import Fault, FaultSchedule
from housefly.twin.faults.slots import Slots
from housefly.twin.faults.vocabulary import FaultComponent, FaultKind

Packet = TypeVar("Packet")


@dataclass(frozen=True, slots=True)
class PacketCodec(Generic[Packet]):
    """What faults may do to the content of a packet.

    Attributes:
        garbled: makes noise of a packet, given its number; None when nobody would read that.
        repeated: the content of an old packet with the number of a new one.
    """

    garbled: Callable[[Fault, Packet, int], Packet | None]
    repeated: Callable[[Packet, Packet], Packet]


class PacketStream(Generic[Packet]):
    """One direction of a link; what is active when a packet leaves befalls it.

    Args:
        component: whose faults count.
        codec: what is inside a packet.
    """

    def __init__(self, component: FaultComponent, codec: PacketCodec[Packet]) -> None:
        self._component, self._codec = component, codec
        self._number = 0
        self._last_due = 0.0
        self._slots = Slots()
        self._frozen: dict[Fault, Packet] = {}
        self._before: Packet | None = None
        self._overtaken: Packet | None = None

    def sent(
        self, packet: Packet, schedule: FaultSchedule, now: float
    ) -> tuple[tuple[float, Packet], ...]:
        """Return what becomes of a packet that leaves now: arrival [s] and packet, in order."""
        active = schedule.active(now, self._component)
        self._number += 1
        changed: Packet | None = packet
        for fault in active:
            if changed is None or self._loses(fault, now):
                return ()
            changed = self._changed(fault, changed)
        if not active:
            self._before = packet
        if changed is None:
            return ()
        delay = running_sum(fault.size for fault in active if fault.kind is FaultKind.DELAYED)
        self._last_due = max(self._last_due, now + delay)
        return tuple((self._last_due, each) for each in self._ordered(changed, active))

    def _loses(self, fault: Fault, now: float) -> bool:
        if fault.kind is FaultKind.SLOW:
            return not self._slots.opens(fault, now)
        return fault.kind is FaultKind.OFF or (
            fault.kind is FaultKind.INTERMITTENT and fault.strikes(self._number)
        )

    def _changed(self, fault: Fault, packet: Packet) -> Packet | None:
        if fault.kind is FaultKind.STUCK:
            before = packet if self._before is None else self._before
            return self._codec.repeated(self._frozen.setdefault(fault, before), packet)
        if fault.kind is FaultKind.GARBAGE:
            return self._codec.garbled(fault, packet, self._number)
        return packet

    def _ordered(self, packet: Packet, active: tuple[Fault, ...]) -> tuple[Packet, ...]:
        if self._overtaken is not None:
            late, self._overtaken = self._overtaken, None
            return packet, late
        if _strikes(active, "order", self._number):
            self._overtaken = packet
            return ()
        return (packet, packet) if _strikes(active, "copies", self._number) else (packet,)


def _strikes(active: tuple[Fault, ...], aspect: str, number: int) -> bool:
    return any(fault.aspect == aspect and fault.strikes(number) for fault in active)


def noise_bytes(fault: Fault, packet: bytes, number: int) -> bytes:
    """Return as many bytes at random as a packet has; seed and number decide them."""
    return Random(f"{fault.seed} {number}").randbytes(len(packet))
