"""What waits for a slow radio: of what grows old only the newest, of all else each, in order."""

from __future__ import annotations

from collections import deque
from threading import Condition

from housefly.wires.crazyflie.crtp import Packet, Port
from housefly.wires.crazyflie.localization import emergency_of

LIMIT = 64
"""Packets that wait at most: no more questions are asked at once."""


class Outbox:
    """Packets from one thread to another.

    Attributes:
        dropped: packets that found no room; the oldest went.
    """

    def __init__(self) -> None:
        self.dropped = 0
        self._waiting: deque[Packet] = deque()
        self._changed = Condition()

    def put(self, packet: Packet) -> None:
        """Let a packet wait behind all others, in the place of none but an older one of it."""
        with self._changed:
            kind = _kind(packet)
            if kind is not None:
                kept = [one for one in self._waiting if _kind(one) != kind]
                self._waiting = deque(kept)
            if len(self._waiting) >= LIMIT:
                self._waiting.popleft()
                self.dropped += 1
            self._waiting.append(packet)
            self._changed.notify()

    def take(self, patience: float) -> Packet | None:
        """Return the packet that is next; None where none comes within a time [s]."""
        with self._changed:
            self._changed.wait_for(lambda: bool(self._waiting), patience)
            return self._waiting.popleft() if self._waiting else None

    def clear(self) -> None:
        """Forget what waits."""
        with self._changed:
            self._waiting.clear()


def _kind(packet: Packet) -> Port | None:
    """Return what a packet is one of that is worth nothing once there is a newer one.

    That are setpoints and poses; a stop of either port is none, and takes the place of none.
    """
    if packet.port == Port.GENERIC_SETPOINT and packet.channel == 0 and packet.data[:1] != b"\x00":
        return Port.GENERIC_SETPOINT
    if packet.port == Port.LOCALIZATION and emergency_of(packet) is None:
        return Port.LOCALIZATION
    return None
