"""A rate that has fallen: one frame or packet a slot passes."""

from __future__ import annotations

from math import floor

from housefly.twin.faults.fault import Fault

_ROUNDING = 1e-6


class Slots:
    """Remembers the last slot used of each slow fault."""

    def __init__(self) -> None:
        self._last: dict[Fault, int] = {}

    def opens(self, fault: Fault, at: float) -> bool:
        """Return whether what comes at a time [s] is the first of its slot; size is in Hz."""
        slot = floor((at - fault.start) * fault.size + _ROUNDING)
        is_first = slot > self._last.get(fault, -1)
        self._last[fault] = max(slot, self._last.get(fault, -1))
        return is_first
