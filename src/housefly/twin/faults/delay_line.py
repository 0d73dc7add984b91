"""What is late: it arrives after its delay, in the order in which it left."""

from __future__ import annotations

from collections import deque
from typing import Generic, TypeVar

from housefly.numeric import running_sum
from housefly.twin.faults.fault import Fault
from housefly.twin.faults.vocabulary import FaultKind

Late = TypeVar("Late")
_ROUNDING = 1e-9


class DelayLine(Generic[Late]):
    """What has left and not arrived; nothing overtakes."""

    def __init__(self) -> None:
        self._waiting: deque[tuple[float, float, Late]] = deque()

    def put(self, item: Late, active: tuple[Fault, ...], now: float) -> None:
        """Let something leave now [s]; the delays of the faults that are active add up."""
        delay = running_sum(fault.size for fault in active if fault.kind is FaultKind.DELAYED)
        behind = self._waiting[-1][0] if self._waiting else now
        self._waiting.append((max(behind, now + delay), now, item))

    def arrived(self, now: float) -> tuple[tuple[float, Late], ...]:
        """Return what has arrived by now [s], oldest first: when it left, and what it is."""
        found = []
        while self._waiting and self._waiting[0][0] <= now + _ROUNDING:
            _, left_at, item = self._waiting.popleft()
            found.append((left_at, item))
        return tuple(found)
